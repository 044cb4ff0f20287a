#include "files/midi_track.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace percussionist::files {

namespace {

constexpr std::size_t kMostOddities = 8;

std::string hex(unsigned byte) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%02X", byte);
    return text.data();
}

class TrackReader {
  public:
    TrackReader(ByteReader& reader, score::Tick start) : reader_(reader) { track_.end = start; }

    MidiTrack read() {
        try {
            while (!track_.has_end && reader_.left() > 0) {
                track_.end += reader_.variable_length();
                event();
            }
        } catch (const UnexpectedByte& unexpected) {
            track_.stopped = unexpected;
        }
        return std::move(track_);
    }

  private:
    void event() {
        const std::size_t at = reader_.at();
        if (reader_.peek() >= 0x80) {
            const unsigned status = reader_.u8();
            if (status >= 0xF0) {
                system(status, at);
                return;
            }
            running_ = status;
        } else if (running_ == 0) {
            throw UnexpectedByte(at, "expected a status byte, found " + hex(reader_.peek()));
        }
        channel_message(running_);
    }

    unsigned data() {
        const unsigned byte = reader_.u8();
        if (byte >= 0x80) {
            throw UnexpectedByte(reader_.at() - 1, "expected a data byte, found " + hex(byte));
        }
        return byte;
    }

    void channel_message(unsigned status) {
        const unsigned kind = status & 0xF0U;
        const unsigned first = data();
        if (kind == 0xC0 || kind == 0xD0) {
            return;
        }
        const unsigned second = data();
        // A note-on of velocity 0 is a note-off.
        if (kind == 0x90 && second > 0) {
            track_.notes.push_back({track_.end, static_cast<int>(first), static_cast<int>(second),
                                    static_cast<int>(status & 0x0FU), false});
        }
    }

    // Running status outlives meta events and system exclusive here: the standard ends it, but
    // there are files that count on it, and none that is read wrongly for it.
    void system(unsigned status, std::size_t at) {
        switch (status) {
            case 0xFF:
                meta(at);
                break;
            case 0xF0:
                exclusive(reader_.take(reader_.variable_length()));
                break;
            case 0xF7:
                reader_.take(reader_.variable_length());
                break;
            case 0xF2:
                reader_.take(2);
                break;
            case 0xF1:
            case 0xF3:
                reader_.take(1);
                break;
            case 0xF4:
            case 0xF5:
                throw UnexpectedByte(at, "expected an event, found " + hex(status));
            default:
                break;  // a real-time message: one byte
        }
    }

    void meta(std::size_t at) {
        const unsigned type = data();
        const auto content = reader_.take(reader_.variable_length());
        switch (type) {
            case 0x03:
                name(content);
                break;
            case 0x2F:
                track_.has_end = true;
                break;
            case 0x51:
                tempo(content, at);
                break;
            case 0x58:
                metre(content, at);
                break;
            default:
                break;
        }
    }

    void name(std::span<const std::uint8_t> content) {
        constexpr std::size_t kLongest = 100;
        if (track_.name.empty()) {
            track_.name = printable(content.first(std::min(content.size(), kLongest)));
        }
    }

    void tempo(std::span<const std::uint8_t> content, std::size_t at) {
        if (content.size() != 3) {
            odd(at, "expected a tempo of 3 bytes, found " + std::to_string(content.size()));
            return;
        }
        const unsigned microseconds = content[0] << 16U | content[1] << 8U | content[2];
        if (microseconds == 0) {
            odd(at, "expected a tempo above 0, found 0 microseconds a quarter note");
            return;
        }
        track_.tempos.push_back({track_.end, 1e-6 * microseconds});
    }

    void metre(std::span<const std::uint8_t> content, std::size_t at) {
        constexpr unsigned kShortestBeat = 6;  // a 64th note
        if (content.size() < 2 || content[0] == 0 || content[1] > kShortestBeat) {
            odd(at, "expected a time signature, found " +
                        (content.size() < 2 ? std::to_string(content.size()) + " bytes"
                                            : std::to_string(content[0]) + " beats of 1/2^" +
                                                  std::to_string(content[1])));
            return;
        }
        track_.metres.push_back({track_.end, content[0], 1 << content[1]});
    }

    /// Roland GS: 41 device 42 12, address 40 1x 15, 0 for a melodic part or the number of a drum
    /// map. The address 40 00 7F resets all parts, and so does "General MIDI on", 7E device 09 01.
    void exclusive(std::span<const std::uint8_t> d) {
        const bool gs = d.size() >= 8 && d[0] == 0x41 && d[2] == 0x42 && d[3] == 0x12;
        if (gs && d[4] == 0x40 && (d[5] & 0xF0U) == 0x10 && d[6] == 0x15) {
            track_.drum_parts.push_back({track_.end, channel_of_part(d[5] & 0x0FU), d[7] != 0});
        }
        const bool gs_reset = gs && d[4] == 0x40 && d[5] == 0x00 && d[6] == 0x7F;
        const bool gm_on = d.size() >= 4 && d[0] == 0x7E && d[2] == 0x09 && d[3] == 0x01;
        if (gs_reset || gm_on) {
            track_.drum_parts.push_back({track_.end, -1, false});
        }
    }

    /// GS counts the drum part as block 0 and the others around it.
    static int channel_of_part(unsigned block) {
        const int part = static_cast<int>(block);
        return part == 0 ? 9 : part <= 9 ? part - 1 : part;
    }

    void odd(std::size_t at, const std::string& what) {
        if (track_.oddities.size() < kMostOddities) {
            track_.oddities.emplace_back(at, what);
        }
    }

    ByteReader& reader_;
    MidiTrack track_;
    unsigned running_ = 0;
};

}  // namespace

MidiTrack read_track(ByteReader& reader, score::Tick start) {
    return TrackReader(reader, start).read();
}

}  // namespace percussionist::files
