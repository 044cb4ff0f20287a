#include "app/drum_midi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace percussionist::app {

namespace {

using listening::Beats;
using listening::DrumClass;
using listening::DrumStroke;
using score::Tick;

constexpr Tick kQuarter = 960;
constexpr int kDrumChannel = 9;

/// Beats, and their ticks, from the first sample on: before the first beat that was found as many
/// as fit, so that it keeps its place in time.
class Clock {
  public:
    explicit Clock(const Beats& beats) {
        const double usual = beats.seconds_per_beat();
        const double first = beats.times.empty() ? 0.0 : beats.times.front();
        // Less than half a beat is no beat: the first one is a little long then, or starts at 0.
        lead_in_ = first < 1e-3 ? 0 : std::max<Tick>(1, std::lround(first / usual));
        if (lead_in_ > 0) begin_piece(0, 0.0, first / static_cast<double>(lead_in_), lead_in_);
        for (std::size_t b = 0; b + 1 < beats.times.size(); ++b) {
            begin_piece(lead_in_ + static_cast<Tick>(b), beats.times[b],
                        beats.times[b + 1] - beats.times[b], 1);
        }
        if (pieces_.empty()) begin_piece(0, 0.0, usual, 1);
    }

    [[nodiscard]] Tick tick(double time) const {
        auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                      [](double t, const Piece& p) { return t < p.time; });
        if (piece != pieces_.begin()) --piece;
        const double quarters = (time - piece->time) / piece->seconds_per_quarter;
        return std::max<Tick>(0,
                              piece->tick + std::llround(quarters * static_cast<double>(kQuarter)));
    }
    [[nodiscard]] Tick lead_in() const { return lead_in_; }
    [[nodiscard]] std::vector<score::TempoChange> tempos() const {
        std::vector<score::TempoChange> changes;
        for (const Piece& piece : pieces_)
            changes.push_back({piece.tick, piece.seconds_per_quarter});
        return changes;
    }

  private:
    struct Piece {
        Tick tick;
        double time;
        double seconds_per_quarter;
    };
    /// A tempo is whole microseconds; what that rounds off does not add up.
    void begin_piece(Tick beat, double time, double length, Tick beats) {
        const double from = pieces_.empty() ? time : end_;
        const double wanted = time + length * static_cast<double>(beats);
        const double tempo =
            std::max(1e-6 * std::round(1e6 * (wanted - from) / static_cast<double>(beats)), 1e-6);
        pieces_.push_back({beat * kQuarter, from, tempo});
        end_ = from + tempo * static_cast<double>(beats);
    }

    std::vector<Piece> pieces_;
    double end_ = 0.0;
    Tick lead_in_ = 0;
};

/// Bars begin where a downbeat was found; what is before it is a bar of its own.
std::vector<score::MetreChange> metres(const Beats& beats, Tick lead_in) {
    const auto before =
        static_cast<int>((lead_in + static_cast<Tick>(beats.first_downbeat)) % beats.per_bar);
    std::vector<score::MetreChange> changes;
    if (before > 0) changes.push_back({0, before, 4});
    changes.push_back({before * kQuarter, beats.per_bar, 4});
    return changes;
}

int tom_key(double pitch) {
    constexpr double kFloor = 95.0, kLow = 125.0, kMiddle = 170.0;  // [Hz]
    return pitch < kFloor ? 43 : pitch < kLow ? 45 : pitch < kMiddle ? 47 : 50;
}

int midi_velocity(const DrumStroke& stroke) {
    return std::clamp(static_cast<int>(std::lround(127.0 * stroke.velocity)), 1, 127);
}

}  // namespace

int midi_key(const DrumStroke& stroke) {
    switch (stroke.drum) {
        case DrumClass::kick:
            return 36;
        case DrumClass::snare:
            return 38;
        case DrumClass::closed_hat:
            return 42;
        case DrumClass::open_hat:
            return 46;
        case DrumClass::tom:
            return tom_key(stroke.pitch);
        case DrumClass::crash:
            return 49;
        case DrumClass::ride:
            return 51;
        default:
            return 37;
    }
}

files::MidiFile to_midi(const listening::Transcription& transcription, const Beats& beats,
                        const std::string& title) {
    const Clock clock(beats);
    files::MidiFile file;
    file.title = title;
    file.tracks = 1;
    file.division.ticks_per_quarter = static_cast<double>(kQuarter);
    file.tempos = clock.tempos();
    file.metres = metres(beats, clock.lead_in());
    for (const DrumStroke& stroke : transcription.strokes) {
        file.notes.push_back({.tick = clock.tick(stroke.time),
                              .key = midi_key(stroke),
                              .velocity = midi_velocity(stroke),
                              .channel = kDrumChannel,
                              .percussion = true});
    }
    return file;
}

std::string to_csv(const listening::Transcription& transcription) {
    std::string text = "time_s,drum,key,velocity,confidence\n";
    for (const DrumStroke& stroke : transcription.strokes) {
        text += fmt::format("{:.4f},{},{},{},{:.3f}\n", stroke.time, listening::name(stroke.drum),
                            midi_key(stroke), midi_velocity(stroke), stroke.confidence);
    }
    return text;
}

}  // namespace percussionist::app
