// Writes a performance to a file while it is played: records are handed over, a thread of its own
// writes them.
//
// add() and end() never wait for the disk. Simulating thread.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "files/recording_file.hpp"

namespace percussionist::app {

class Recorder {
  public:
    /// Throws std::runtime_error if the file cannot be written.
    explicit Recorder(const std::filesystem::path& path);
    /// Completes the file, if end() was not called, at the last step it was told of.
    ~Recorder();

    void add(files::Record record);
    /// Completes the file and waits for it; the fault, or an empty text.
    std::string finish(std::int64_t step);

  private:
    void write();

    files::RecordingWriter writer_;
    std::mutex mutex_;  ///< guards what follows
    std::condition_variable wake_;
    std::vector<files::Record> waiting_;
    bool ending_ = false;
    std::string fault_;  ///< read when the thread has ended
    std::thread thread_;
};

}  // namespace percussionist::app
