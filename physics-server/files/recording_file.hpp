// A recorded performance in a file: what happened, at which step of the simulation, in order.
//
//     percussionist recording 1\n
//     then records: kind (4 letters), size [u32], step [i64], and that many bytes; big-endian
//
// clang-format off
//     sets  how the body and the drum are made: flags of the command line, one a line
//     scor  a score that was loaded: its file's name, a zero, the file's bytes; "\0": the built-in one
//     hear  what the server was told: an OSC message, its numbers as doubles
//     told  what the server told: an OSC bundle, its time tag simulated time
//     ends  nothing more
// clang-format on
//
// A file that is cut, as by a crash, is read up to its last whole record. What cannot be understood
// gives one RecordingError with file, byte and what was expected there. Memory grows with what is
// there, never with what is promised.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace percussionist::files {

/// what(): "take.recording: byte 24: expected ..., found ..."
struct RecordingError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class RecordKind { settings, score, heard, told, end };

struct Record {
    RecordKind kind = RecordKind::end;
    std::int64_t step = 0;  ///< steps computed before it; never less than that of the one before
    std::vector<char> bytes;
};

struct Recording {
    std::vector<Record> records;  ///< the first holds the settings; without the end's
    std::int64_t end = 0;         ///< the step at which it ends
    bool cut = false;             ///< the end was missing
};

/// A score's file as a record holds it, and back.
std::vector<char> pack_score(std::string_view name, std::span<const char> bytes);
struct PackedScore {
    std::string name;  ///< empty: the built-in score
    std::span<const char> bytes;
};
/// Of bytes that came through parse_recording().
PackedScore unpack_score(std::span<const char> packed);

/// `name` is what errors call the file. Throws RecordingError.
Recording parse_recording(std::span<const char> bytes, std::string_view name);
/// Throws RecordingError, also for a file that cannot be opened or is above 4 GB.
Recording read_recording(const std::filesystem::path& path);

/// Writes record after record.
class RecordingWriter {
  public:
    /// Throws std::runtime_error if the file cannot be written.
    explicit RecordingWriter(const std::filesystem::path& path);
    void add(RecordKind kind, std::int64_t step, std::span<const char> bytes);
    /// Completes the file. Throws std::runtime_error if it could not be written.
    void finish(std::int64_t step);

  private:
    std::filesystem::path path_;
    std::ofstream out_;
};

}  // namespace percussionist::files
