// What a run of the server was told, all of it, and a recording of what it tells while one is made.
//
// A run follows from how it was made and what it was told at which step: with that, kept from the
// start, a recording that begins late can be played again too. Of a run that was told more than
// 128 MB (scores, and two hours of controls at 250 a second) nothing is kept. Simulating thread.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/recorder.hpp"
#include "app/score_loader.hpp"
#include "osc/endpoint.hpp"

namespace percussionist::app {

/// True for commands that change what is played or how; others would do harm, or nothing, in a
/// replay.
bool shapes_performance(const osc::Command& command);

class Tape {
  public:
    static constexpr std::size_t kMostKept = 128U << 20U;  ///< [bytes]

    /// `settings`: flags of the command line, one a line.
    explicit Tape(const std::string& settings);

    void loaded(std::int64_t step, const ScoreSource& score);
    void heard(std::int64_t step, const osc::Heard& heard);
    void told(std::int64_t step, osc::Packet packet);

    /// Throws std::runtime_error if a recording is being made, or more has been told than is kept.
    void require_idle() const;
    /// The same, and throws std::runtime_error if the file cannot be written.
    void begin(const std::filesystem::path& path);
    /// Completes the recording; the fault, or an empty text.
    std::string end(std::int64_t step);
    [[nodiscard]] bool recording() const { return recorder_ != nullptr; }

  private:
    void keep(files::Record record);

    std::vector<files::Record> history_;
    std::size_t kept_ = 0;  ///< [bytes]
    bool whole_ = true;
    std::unique_ptr<Recorder> recorder_;
};

}  // namespace percussionist::app
