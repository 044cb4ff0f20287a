#include "files/musicxml_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "files/musicxml_measures.hpp"

namespace percussionist::files {

using score::Nuance;
using score::Tick;

namespace {

constexpr std::size_t kMostMeasures = 20000;
// What a short file can ask for by repeats, tremolos and gradual changes has bounds too.
constexpr std::size_t kMostNotes = 500000;
constexpr std::size_t kMostTempos = 500000;
constexpr std::size_t kMostHairpins = 2000;
constexpr std::size_t kMostElements = 4000000;
constexpr Tick kMostTicks = 200000LL * kMusicXmlTicks;
constexpr int kSnare = 38;
/// Grace notes stand this far before their note and before each other [s].
constexpr double kGraceAhead = 0.028;
constexpr double kGraceLoudness = 0.6;
/// A gradual change of tempo is made in steps of this.
constexpr Tick kRampStep = kMusicXmlTicks / 8;

struct Mark {
    const char* name;
    double velocity;
};
constexpr std::array kDynamics{
    Mark{"pppp", 0.08}, Mark{"ppp", 0.13}, Mark{"pp", 0.26}, Mark{"p", 0.39},   Mark{"mp", 0.50},
    Mark{"mf", 0.63},   Mark{"f", 0.76},   Mark{"ff", 0.88}, Mark{"fff", 1.00}, Mark{"ffff", 1.00},
    Mark{"sf", 0.88},   Mark{"sfz", 0.88}, Mark{"fp", 0.76}, Mark{"fz", 0.88}};

bool is(const pugi::xml_node& node, const char* name) {
    return std::strcmp(node.name(), name) == 0;
}

double within(double value, double least, double most, double otherwise) {
    return value >= least && value <= most ? value : otherwise;
}

/// Quarters in a metronome's beat unit.
double beat_unit(const pugi::xml_node& metronome) {
    const std::string unit = metronome.child("beat-unit").text().as_string("quarter");
    double quarters = unit == "half" ? 2 : unit == "whole" ? 4 : unit == "eighth" ? 0.5 : 1;
    if (metronome.child("beat-unit-dot")) quarters *= 1.5;
    return quarters;
}

class PartReader {
  public:
    PartReader(const pugi::xml_node& part, const std::map<std::string, int>& instruments)
        : part_(part), instruments_(instruments) {}

    MusicXmlPart read() {
        std::vector<pugi::xml_node> measures;
        for (const pugi::xml_node& m : part_.children("measure")) measures.push_back(m);
        for (const std::size_t i : playing_order(measures, kMostMeasures)) {
            if (at_ > kMostTicks || full()) break;
            measure(measures[i]);
        }
        result_.end = at_;
        end_hairpins();
        return std::move(result_);
    }

  private:
    void measure(const pugi::xml_node& node) {
        start_ = at_;
        Tick furthest = at_;
        for (const pugi::xml_node& child : node.children()) {
            ++elements_;
            if (full()) break;
            if (is(child, "attributes")) attributes(child);
            if (is(child, "direction")) direction(child);
            if (is(child, "sound")) sound(child);
            if (is(child, "note")) note(child);
            if (is(child, "backup")) at_ = std::max(start_, at_ - duration(child));
            if (is(child, "forward")) at_ += duration(child);
            furthest = std::max(furthest, at_);
        }
        at_ = furthest;
    }

    [[nodiscard]] bool full() const {
        return result_.notes.size() >= kMostNotes || result_.tempos.size() >= kMostTempos ||
               elements_ >= kMostElements;
    }

    [[nodiscard]] Tick duration(const pugi::xml_node& node) const {
        const double divisions = node.child("duration").text().as_double(0.0);
        return static_cast<Tick>(
            std::llround(within(divisions / divisions_, 0.0, 64.0, 0.0) * kMusicXmlTicks));
    }

    void attributes(const pugi::xml_node& node) {
        divisions_ = within(node.child("divisions").text().as_double(divisions_), 1e-3, 1e6, 1.0);
        const pugi::xml_node time = node.child("time");
        const int beats = time.child("beats").text().as_int(0);
        const int unit = time.child("beat-type").text().as_int(0);
        if (beats > 0 && beats < 100 && unit > 0 && unit <= 64) {
            result_.metres.push_back({at_, beats, unit});
        }
    }

    void direction(const pugi::xml_node& node) {
        const Tick offset = static_cast<Tick>(std::llround(
            within(node.child("offset").text().as_double(0.0) / divisions_, -64, 64, 0.0) *
            kMusicXmlTicks));
        const Tick here = std::max<Tick>(0, at_ + offset);
        bool tempo_said = false;
        for (const pugi::xml_node& type : node.children("direction-type")) {
            for (const pugi::xml_node& child : type.children()) {
                if (is(child, "dynamics")) dynamics(child, here);
                if (is(child, "wedge")) wedge(child, here);
                if (is(child, "words")) words(child.text().as_string(), here);
                if (is(child, "metronome") && !node.child("sound").attribute("tempo")) {
                    tempo(child.child("per-minute").text().as_double(0.0) * beat_unit(child), here);
                    tempo_said = true;
                }
            }
        }
        if (node.child("sound") && !tempo_said) sound(node.child("sound"));
    }

    void sound(const pugi::xml_node& node) {
        if (node.attribute("tempo")) tempo(node.attribute("tempo").as_double(), at_);
        if (node.attribute("dynamics")) {
            // Per cent of MIDI's velocity 90.
            level_ = within(node.attribute("dynamics").as_double() / 100.0 * 90.0 / 127.0, 0.01,
                            1.0, level_);
        }
    }

    void tempo(double quarters_per_minute, Tick tick) {
        if (!(quarters_per_minute > 1.0 && quarters_per_minute < 2000.0)) return;
        const double seconds = 60.0 / quarters_per_minute;
        if (ramp_) ramp_to(tick, seconds);
        ramp_.reset();
        result_.tempos.push_back({tick, seconds});
        seconds_per_quarter_ = seconds;
    }

    /// Steps from the beginning of the change to the new mark, linear in tempo.
    void ramp_to(Tick end, double seconds) {
        const double from = 1.0 / seconds_per_quarter_;
        const double to = 1.0 / seconds;
        for (Tick t = *ramp_ + kRampStep; t < end && !full(); t += kRampStep) {
            const double share =
                static_cast<double>(t - *ramp_) / static_cast<double>(end - *ramp_);
            result_.tempos.push_back({t, 1.0 / (from + share * (to - from))});
        }
    }

    void words(std::string text, Tick tick) {
        for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        for (const char* word : {"accel", "rit", "rall", "string"}) {
            if (text.find(word) != std::string::npos) ramp_ = tick;
        }
        if (text.find("a tempo") != std::string::npos) ramp_.reset();
    }

    void dynamics(const pugi::xml_node& node, Tick tick) {
        for (const Mark& mark : kDynamics) {
            if (!node.child(mark.name)) continue;
            level_ = mark.velocity;
            if (!hairpins_.empty() && hairpins_.back().end <= tick) {
                hairpins_.back().to = level_;
            }
        }
    }

    void wedge(const pugi::xml_node& node, Tick tick) {
        const std::string type = node.attribute("type").as_string();
        if (hairpins_.size() < kMostHairpins && (type == "crescendo" || type == "diminuendo")) {
            const double change = type == "crescendo" ? 0.25 : -0.25;
            hairpins_.push_back({tick, kMostTicks, level_, std::clamp(level_ + change, 0.08, 1.0),
                                 result_.notes.size()});
        } else if (type == "stop" && !hairpins_.empty()) {
            hairpins_.back().end = tick;
            level_ = hairpins_.back().to;
        }
    }

    void end_hairpins() {
        for (const Hairpin& h : hairpins_) {
            const auto length = static_cast<double>(h.end - h.start);
            for (std::size_t i = h.first_note; i < result_.notes.size(); ++i) {
                MusicXmlNote& n = result_.notes[i];
                if (n.tick < h.start || n.tick >= h.end || length <= 0.0) continue;
                const double share = static_cast<double>(n.tick - h.start) / length;
                n.velocity =
                    std::clamp(n.velocity + (h.from + share * (h.to - h.from)) - h.from, 0.01, 1.0);
            }
        }
    }

    [[nodiscard]] int instrument(const pugi::xml_node& node) const {
        const auto found = instruments_.find(node.child("instrument").attribute("id").as_string());
        return found == instruments_.end() ? default_instrument() : found->second;
    }
    [[nodiscard]] int default_instrument() const {
        return instruments_.size() == 1 ? instruments_.begin()->second : kSnare;
    }

    void note(const pugi::xml_node& node) {
        const Tick length = duration(node);
        const bool chord = node.child("chord");
        const Tick tick = chord ? chord_at_ : at_;
        if (!chord) {
            chord_at_ = at_;
            at_ += length;
        }
        if (node.child("rest") || node.child("cue")) return;

        MusicXmlNote n;
        n.tick = tick;
        n.instrument = instrument(node);
        n.velocity = level_;
        if (node.attribute("dynamics")) {
            n.velocity = within(node.attribute("dynamics").as_double() / 100.0 * 90.0 / 127.0, 0.01,
                                1.0, level_);
        }
        articulate(node, n);
        if (node.child("grace")) {
            n.velocity *= kGraceLoudness;
            graces_.push_back(n);
            return;
        }
        place_graces(n);
        if (!tied(node)) result_.notes.push_back(n);
        tremolo(node, n, length);
    }

    static bool tied(const pugi::xml_node& node) {
        for (const pugi::xml_node& tie : node.children("tie")) {
            if (std::strcmp(tie.attribute("type").as_string(), "stop") == 0) return true;
        }
        return false;
    }

    static void articulate(const pugi::xml_node& node, MusicXmlNote& n) {
        for (const pugi::xml_node& notations : node.children("notations")) {
            for (const pugi::xml_node& mark : notations.child("articulations").children()) {
                if (is(mark, "staccato")) n.nuance = Nuance::staccato;
                if (is(mark, "staccatissimo") || is(mark, "spiccato")) n.nuance = Nuance::piston;
                if (is(mark, "tenuto")) n.nuance = Nuance::tenuto;
                if (is(mark, "accent")) n.nuance = Nuance::accent;
                if (is(mark, "strong-accent")) n.nuance = Nuance::vertical_accent;
            }
        }
    }

    void place_graces(const MusicXmlNote& main) {
        double ahead = kGraceAhead * static_cast<double>(graces_.size());
        for (MusicXmlNote& grace : graces_) {
            grace.tick = main.tick;
            grace.ahead = ahead;
            ahead -= kGraceAhead;
            result_.notes.push_back(grace);
        }
        graces_.clear();
    }

    /// A tremolo of n marks: strokes each 1/2^n of a quarter, to the end of the note.
    void tremolo(const pugi::xml_node& node, const MusicXmlNote& first, Tick length) {
        const pugi::xml_node mark = node.child("notations").child("ornaments").child("tremolo");
        const int marks = mark.text().as_int(0);
        if (marks < 1 || marks > 5) return;
        const Tick step = kMusicXmlTicks >> marks;
        MusicXmlNote next = first;
        next.nuance = Nuance::legato;
        for (Tick t = tied(node) ? 0 : step; t < length && !full(); t += step) {
            next.tick = first.tick + t;
            result_.notes.push_back(next);
        }
    }

    struct Hairpin {
        Tick start = 0, end = 0;
        double from = 0.0, to = 0.0;
        std::size_t first_note = 0;
    };

    pugi::xml_node part_;
    const std::map<std::string, int>& instruments_;
    MusicXmlPart result_;
    double divisions_ = 1.0;
    double level_ = 0.63;
    double seconds_per_quarter_ = 0.5;
    std::size_t elements_ = 0;
    std::optional<Tick> ramp_;  ///< where a gradual change of tempo began
    Tick start_ = 0, at_ = 0, chord_at_ = 0;
    std::vector<Hairpin> hairpins_;
    std::vector<MusicXmlNote> graces_;
};

}  // namespace

MusicXmlPart read_part(const pugi::xml_node& part, const std::map<std::string, int>& instruments) {
    return PartReader(part, instruments).read();
}

}  // namespace percussionist::files
