#include "files/midi_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>

#include "files/byte_reader.hpp"
#include "files/midi_header.hpp"
#include "files/midi_track.hpp"

namespace percussionist::files {

namespace {

constexpr std::size_t kLargestFile = 16'000'000;
constexpr std::size_t kMostWarnings = 32;
constexpr std::size_t kChunkHeader = 8;
constexpr int kDrumChannel = 9;

std::string at_byte(std::size_t at) {
    return "byte " + std::to_string(at) + ": ";
}

class FileReader {
  public:
    FileReader(std::span<const std::uint8_t> bytes, std::string_view name) : reader_(bytes) {
        file_.name = name;
    }

    MidiFile read() {
        try {
            unwrap();
            header_ = read_header(reader_);
            if (!header_.warning.empty()) {
                warn(header_.warning);
            }
            file_.format = header_.format;
            file_.division = header_.division;
            tracks();
        } catch (const UnexpectedByte& unexpected) {
            throw MidiError(file_.name + ": " + at_byte(unexpected.at) + unexpected.what());
        }
        compare_counts();
        find_percussion();
        return std::move(file_);
    }

  private:
    void warn(const std::string& what) {
        if (file_.warnings.size() < kMostWarnings) {
            file_.warnings.push_back(file_.name + ": " + what);
        }
    }

    void go_to(std::size_t at) { reader_ = reader_.part(at, reader_.bytes().size()); }

    /// RIFF RMID: a MIDI file as the "data" chunk of another file, whose numbers are
    /// little-endian.
    void unwrap() {
        if (!reader_.comes("RIFF")) {
            return;
        }
        reader_.take(kChunkHeader);
        if (!reader_.comes("RMID")) {
            throw reader_.expected("'RMID' in a RIFF file");
        }
        reader_.take(4);
        while (!reader_.comes("data")) {
            if (reader_.left() < kChunkHeader) {
                throw reader_.expected("a 'data' chunk with a MIDI file in it");
            }
            const std::size_t length = riff_length();
            reader_.take(std::min(reader_.left(), length + length % 2));
        }
        const std::size_t length = riff_length();
        if (length > reader_.left()) {
            warn("the file is cut: its MIDI data say " + std::to_string(length) +
                 " bytes and there are " + std::to_string(reader_.left()));
        }
        reader_ = reader_.part(reader_.at(), reader_.at() + std::min(length, reader_.left()));
    }

    std::size_t riff_length() {
        reader_.take(4);
        const auto b = reader_.take(4);
        return b[0] | b[1] << 8U | b[2] << 16U | static_cast<std::size_t>(b[3]) << 24U;
    }

    void tracks() {
        const ByteReader first_chunk = reader_;
        while (reader_.left() > 0) {
            if (reader_.comes("MTrk")) {
                track();
            } else if (!skip_alien_chunk() && !skip_to_track()) {
                break;
            }
        }
        if (file_.tracks == 0) {
            throw first_chunk.expected("a track chunk 'MTrk'");
        }
    }

    /// Chunks of other kinds have a name of four printable characters and end within the file.
    bool skip_alien_chunk() {
        if (!chunk_comes(reader_) || reader_.comes("MTrk")) {
            return false;
        }
        reader_.take(4);
        reader_.take(reader_.u32());
        return true;
    }

    [[nodiscard]] static bool chunk_comes(ByteReader reader) {
        if (reader.left() < kChunkHeader) {
            return false;
        }
        const auto name = reader.take(4);
        const bool printed = std::all_of(name.begin(), name.end(), [](std::uint8_t byte) {
            return byte >= 0x20 && byte < 0x7F;
        });
        return printed && (printable(name) == "MTrk" || reader.u32() <= reader.left());
    }

    /// From bytes that are no chunk to the next track, if there is one.
    bool skip_to_track() {
        const auto bytes = reader_.bytes();
        constexpr std::string_view kTrack = "MTrk";
        const auto found =
            std::search(bytes.begin() + reader_.at(), bytes.end(), kTrack.begin(), kTrack.end());
        if (found == bytes.end() && file_.tracks == 0) {
            return false;
        }
        warn(at_byte(reader_.at()) + "expected a track chunk 'MTrk', found " +
             reader_.four_letters() + "; skipped " +
             std::to_string(found - bytes.begin() - reader_.at()) + " bytes");
        go_to(found - bytes.begin());
        return true;
    }

    void track() {
        const std::size_t chunk = reader_.at();
        reader_.take(4);
        if (reader_.left() < 4) {
            warn(at_byte(chunk) + "the file is cut in the header of a track");
            go_to(reader_.bytes().size());
            return;
        }
        const std::size_t length = reader_.u32();
        const std::size_t end = end_of_track(chunk, length);
        ++file_.tracks;
        const score::Tick start = file_.format == 2 ? file_.end : 0;
        ByteReader events = reader_.part(reader_.at(), end);
        const MidiTrack read = read_track(events, start);
        report(read, chunk, end);
        add(read, start);
        go_to(end);
        // A length that reaches into the next track would swallow it.
        const ByteReader after = reader_.part(events.at(), reader_.bytes().size());
        if (read.has_end && events.at() < end && after.comes("MTrk")) {
            warn(at_byte(chunk + 4) + "the length of track " + std::to_string(file_.tracks) +
                 " says " + std::to_string(length) + " and it has " +
                 std::to_string(events.at() - chunk - kChunkHeader) + " bytes");
            go_to(events.at());
        }
    }

    /// Where the length says, if that can be; else as far as there are bytes.
    std::size_t end_of_track(std::size_t chunk, std::size_t length) {
        const std::size_t size = reader_.bytes().size();
        if (length > reader_.left()) {
            warn(at_byte(chunk + 4) + "track " + std::to_string(file_.tracks + 1) + " says " +
                 std::to_string(length) + " bytes and " + std::to_string(reader_.left()) +
                 " are there: read as far as they go");
            return size;
        }
        return reader_.at() + length;
    }

    void report(const MidiTrack& read, std::size_t chunk, std::size_t end) {
        const std::string track = "track " + std::to_string(file_.tracks);
        for (const UnexpectedByte& odd : read.oddities) {
            warn(at_byte(odd.at) + odd.what() + ": left out");
        }
        if (read.stopped) {
            warn(at_byte(read.stopped->at) + read.stopped->what() + ": the rest of " + track +
                 " is left out");
        } else if (!read.has_end && end > chunk + kChunkHeader) {
            warn(at_byte(end) + track + " has no end-of-track event");
        }
    }

    void add(const MidiTrack& read, score::Tick start) {
        if (file_.title.empty() && (file_.tracks == 1 || file_.format != 1)) {
            file_.title = read.name;
        }
        if (start > 0) {  // a new sequence starts in the standard's own tempo, metre and parts
            file_.tempos.push_back({start});
            file_.metres.push_back({start});
            drum_parts_.push_back({start});
        }
        const auto append = [](auto& to, const auto& from) {
            to.insert(to.end(), from.begin(), from.end());
        };
        append(file_.notes, read.notes);
        append(file_.tempos, read.tempos);
        append(file_.metres, read.metres);
        append(drum_parts_, read.drum_parts);
        file_.end = std::max(file_.end, read.end);
    }

    void compare_counts() {
        if (header_.tracks != file_.tracks) {
            warn("byte 10: the header says " + std::to_string(header_.tracks) +
                 " tracks and there are " + std::to_string(file_.tracks));
        }
        if (file_.format == 0 && file_.tracks > 1) {
            warn("byte 8: format 0 has one track, and there are " + std::to_string(file_.tracks) +
                 ": played together");
        }
        if (file_.format == 2 && file_.tracks > 1) {
            warn("format 2: " + std::to_string(file_.tracks) +
                 " independent sequences, laid one after another");
        }
    }

    /// At one tick a part is made drums before its notes sound, in whichever order the tracks are.
    void find_percussion() {
        const auto earlier = [](const auto& a, const auto& b) { return a.tick < b.tick; };
        std::stable_sort(file_.notes.begin(), file_.notes.end(), earlier);
        std::stable_sort(drum_parts_.begin(), drum_parts_.end(), earlier);
        std::array<bool, 16> drums{};
        drums[kDrumChannel] = true;
        auto change = drum_parts_.begin();
        bool any = false;
        for (MidiNote& note : file_.notes) {
            for (; change != drum_parts_.end() && change->tick <= note.tick; ++change) {
                if (change->channel < 0) {
                    drums.fill(false);
                    drums[kDrumChannel] = true;
                } else {
                    drums[change->channel] = change->drums;
                }
            }
            note.percussion = drums[note.channel];
            any = any || note.percussion;
        }
        if (!any && !file_.notes.empty()) {
            warn("no percussion channel: all " + std::to_string(file_.notes.size()) +
                 " notes are taken");
        }
    }

    ByteReader reader_;
    MidiFile file_;
    std::vector<DrumPart> drum_parts_;
    MidiHeader header_;
};

}  // namespace

MidiFile parse_midi(std::span<const std::uint8_t> bytes, std::string_view name) {
    return FileReader(bytes, name).read();
}

MidiFile read_midi_file(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::error_code error;
    if (!stream || std::filesystem::is_directory(path, error)) {
        throw MidiError(path.string() + ": cannot be opened");
    }
    std::vector<std::uint8_t> bytes;
    std::array<char, 65536> piece{};
    while (bytes.size() <= kLargestFile && stream) {
        stream.read(piece.data(), piece.size());
        bytes.insert(bytes.end(), piece.begin(), piece.begin() + stream.gcount());
    }
    if (bytes.size() > kLargestFile) {
        throw MidiError(path.string() + ": is larger than 16 MB: no MIDI file of a piece");
    }
    return parse_midi(bytes, path.filename().string());
}

}  // namespace percussionist::files
