// Writes a performance to a file while it is played: records are handed over, a thread of its own
// writes them.
//
// add() never waits for the disk. Where the disk is nearly full or far too slow, the recording
// stops there, as one that was cut; finish() tells. Simulating thread.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "files/recording_file.hpp"

namespace percussionist::app {

class Recorder {
  public:
    /// On a disk with less than `spare` bytes left nothing more is written.
    static constexpr std::uintmax_t kSpare = 256U << 20U;

    /// `before`: the first records, however many. Throws std::runtime_error if the file cannot be
    /// written.
    explicit Recorder(const std::filesystem::path& path, std::uintmax_t spare = kSpare,
                      std::vector<files::Record> before = {});
    /// Completes the file, if finish() was not called, at the last step it was told of.
    ~Recorder();

    void add(files::Record record);
    /// Completes the file and waits for it; the fault, or an empty text.
    std::string finish(std::int64_t step);

  private:
    static constexpr std::size_t kCheckEach = 8U << 20U;

    void write();
    void write(const std::vector<files::Record>& records);
    bool disk_is_full(std::size_t more);

    std::filesystem::path path_;
    std::uintmax_t spare_;
    files::RecordingWriter writer_;
    std::mutex mutex_;  ///< guards what follows
    std::condition_variable wake_;
    std::vector<files::Record> waiting_;
    std::size_t waiting_bytes_ = 0;
    bool ending_ = false;
    bool stopped_ = false;  ///< for a fault
    std::string fault_;     ///< read when the thread has ended

    std::int64_t last_ = 0;               ///< writing thread: the last step
    std::size_t unchecked_ = kCheckEach;  ///< writing thread: bytes since the disk was looked at
    std::thread thread_;
};

}  // namespace percussionist::app
