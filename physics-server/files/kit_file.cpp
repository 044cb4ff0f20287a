#include "files/kit_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "files/kit_line.hpp"
#include "files/text_lines.hpp"

namespace percussionist::files {

namespace {

using score::Kit;
using score::Limb;

constexpr std::uintmax_t kLargestFile = 1'000'000;
constexpr std::size_t kMostLines = 5000;
constexpr std::string_view kBlank = " \t";

score::Script script_of(KitLine& l) {
    score::Script s;
    s.joint = l.word("a joint");
    s.phase = static_cast<score::Phase>(l.choice(score::kPhaseNames));
    while (!l.done()) s.curve.push_back(l.number());
    return s;
}

class KitReader {
  public:
    KitReader(std::string_view text, std::string_view name) : lines_(text), name_(name) {}

    Kit read() {
        read_version();
        std::size_t count = 0;
        while (next_line()) {
            if (++count > kMostLines) throw line().error("expected at most 5000 lines");
            read_line();
        }
        try {
            fill_pairs();
            score::check(kit_);
        } catch (const std::invalid_argument& fault) {
            throw KitError(std::string(name_) + ": " + fault.what());
        }
        return std::move(kit_);
    }

  private:
    /// False at the end; lines without words are skipped.
    bool next_line() {
        while (const auto text = lines_.next()) {
            split(text->substr(0, text->find('#')), kBlank, words_);
            if (!words_.empty()) return true;
        }
        return false;
    }
    [[nodiscard]] KitLine line() const { return {name_, lines_.number(), words_}; }

    void read_version() {
        const std::vector<std::string_view> wanted{"percussionist", "kit", "1"};
        if (!next_line() || words_ != wanted) {
            throw KitError(std::string(name_) + ": line " + std::to_string(lines_.number()) +
                           ": expected 'percussionist kit 1'");
        }
    }

    void read_line() {
        static constexpr std::array<std::string_view, 10> kWords{
            "name",  "drummer", "hands", "object", "pedal",
            "event", "key",     "pair",  "script", "pose"};
        static constexpr std::array<void (KitReader::*)(KitLine&), 10> kReaders{
            &KitReader::read_name,   &KitReader::read_drummer, &KitReader::read_hands,
            &KitReader::read_object, &KitReader::read_pedal,   &KitReader::read_event,
            &KitReader::read_key,    &KitReader::read_pair,    &KitReader::read_script,
            &KitReader::read_pose};
        KitLine l = line();
        (this->*kReaders[l.choice(kWords)])(l);
        if (!l.done()) throw l.expected("the end of the line");
    }

    void read_name(KitLine& l) {
        kit_.name.clear();
        while (!l.done()) kit_.name += (kit_.name.empty() ? "" : " ") + std::string(l.word(""));
    }

    void read_drummer(KitLine& l) {
        score::Drummer& d = kit_.drummer;
        l.fields({{"stature", [&] { d.stature = l.number(); }},
                  {"mass", [&] { d.mass = l.number(); }},
                  {"hips", [&] { d.hips = l.number(); }},
                  {"stick", [&] { d.stick_length = l.number(); }},
                  {"held", [&] { d.stick_held = l.number(); }},
                  {"stick-mass", [&] { d.stick_mass = l.number(); }},
                  {"rise", [&] { d.rise = l.number(); }}});
    }

    void read_hands(KitLine& l) {
        score::LimbLimits& limits = kit_.limits;
        l.fields({{"interval", [&] { limits.interval = l.number(); }},
                  {"bounce", [&] { limits.bounce = l.number(); }},
                  {"speed", [&] { limits.speed = l.number(); }},
                  {"settling", [&] { limits.settling = l.number(); }},
                  {"foot", [&] { limits.foot = l.number(); }}});
    }

    void read_object(KitLine& l) {
        score::KitObject o;
        o.name = fresh_name(l, "a name for the object");
        o.kind = static_cast<score::ObjectKind>(l.choice(score::kObjectKindNames));
        l.fields({{"at", [&] { o.middle = l.vector(); }},
                  {"tilt",
                   [&] {
                       o.lean_back = l.degrees();
                       o.lean_left = l.degrees();
                   }},
                  {"radius", [&] { o.radius = l.number(); }},
                  {"depth", [&] { o.depth = l.number(); }},
                  {"sound", [&] { o.sound = l.word("a drum or a mode file"); }},
                  {"level", [&] { o.level = l.number(); }},
                  {"wires", [&] { o.wires = l.number(); }}});
        kit_.objects.push_back(std::move(o));
    }

    void read_pedal(KitLine& l) {
        score::Pedal p;
        p.object = object(l);
        p.foot = limb(l);
        l.fields({{"heel", [&] { p.heel = l.vector(); }},
                  {"length", [&] { p.length = l.number(); }},
                  {"direction", [&] { p.direction = l.degrees(); }},
                  {"down", [&] { p.down = l.degrees(); }},
                  {"up", [&] { p.up = l.degrees(); }}});
        kit_.pedals.push_back(p);
    }

    void read_event(KitLine& l) {
        score::KitEvent e;
        e.name = fresh_name(l, "a name for the event");
        if (!l.comes("on")) throw l.expected("'on' and an object");
        e.object = object(l);
        l.fields({{"by", [&] { e.foot = limb(l); }},
                  {"spot",
                   [&] {
                       e.forward = l.number();
                       e.left = l.number();
                   }},
                  {"apart", [&] { e.apart = l.number(); }},
                  {"prefers", [&] { e.hand = hand(l); }},
                  {"elasticity", [&] { e.elasticity = l.number(); }},
                  {"hat",
                   [&] { e.hat = static_cast<score::HatState>(l.choice(score::kHatStateNames)); }},
                  {"mass", [&] { e.mass = l.number(); }},
                  {"stiffness", [&] { e.stiffness = l.number(); }},
                  {"t60", [&] { e.t60 = l.number(); }}});
        kit_.events.push_back(std::move(e));
    }

    void read_key(KitLine& l) {
        std::vector<int> keys;
        while (l.number_comes()) {
            const double key = l.number();
            if (key != std::floor(key) || key < 0 || key >= score::kKeys) {
                throw l.error("expected keys from 0 to 127");
            }
            keys.push_back(static_cast<int>(key));
        }
        if (keys.empty()) throw l.expected("a key from 0 to 127");
        const std::size_t event = one_event(l);
        for (const int key : keys) kit_.keys[key] = static_cast<int>(event);
    }

    void read_pair(KitLine& l) {
        pairs_.push_back({events(l), events(l), {}});
        pairs_.back().preference.hand = hand(l);
        pairs_.back().preference.may_cross = l.comes("crossed");
    }

    void read_script(KitLine& l) { kit_.scripts.push_back(script_of(l)); }

    void read_pose(KitLine& l) {
        static constexpr std::array<std::string_view, 2> kEnds{"down", "up"};
        score::PoseEdit pose;
        pose.limb = limb(l);
        pose.event = one_event(l);
        pose.up = l.choice(kEnds) == 1;
        pose.joint = l.word("a joint");
        for (double& angle : pose.angles) angle = l.degrees();
        kit_.poses.push_back(std::move(pose));
    }

    std::string fresh_name(KitLine& l, const std::string& what) const {
        const std::string name(l.word(what));
        if (number_in(name)) throw l.error("expected " + what + ", found a number");
        return name;
    }
    Limb limb(KitLine& l) const { return static_cast<Limb>(l.choice(score::kLimbNames)); }
    Limb hand(KitLine& l) const {
        static constexpr std::array<std::string_view, 2> kHands{"left", "right"};
        return static_cast<Limb>(l.choice(kHands));
    }
    std::size_t object(KitLine& l) const {
        const auto name = l.word("an object");
        const auto found = kit_.object_named(name);
        if (!found) throw l.error("no object " + in_quotes(name) + " in a line above");
        return *found;
    }
    std::size_t one_event(KitLine& l) const {
        const auto name = l.word("an event");
        const auto found = kit_.event_named(name);
        if (!found) throw l.error("no event " + in_quotes(name) + " in a line above");
        return *found;
    }
    /// All those on the object of that name; else the event.
    std::vector<std::size_t> events(KitLine& l) const {
        const auto name = l.word("an object or an event");
        const auto object = kit_.object_named(name);
        if (!object) {
            const auto event = kit_.event_named(name);
            if (!event) throw l.error("no object or event " + in_quotes(name) + " in a line above");
            return {*event};
        }
        std::vector<std::size_t> all;
        for (std::size_t e = 0; e < kit_.events.size(); ++e) {
            if (kit_.events[e].object == *object && !kit_.events[e].foot) all.push_back(e);
        }
        return all;
    }

    /// A pair holds in either order.
    void fill_pairs() {
        const std::size_t size = kit_.events.size();
        kit_.pairs.assign(size * size, std::nullopt);
        for (const PairLine& pair : pairs_) {
            score::PairPreference turned = pair.preference;
            turned.hand = score::other_hand(turned.hand);
            for (const std::size_t a : pair.first) {
                for (const std::size_t b : pair.second) {
                    kit_.pairs[a * size + b] = pair.preference;
                    if (a != b) kit_.pairs[b * size + a] = turned;
                }
            }
        }
    }

    struct PairLine {
        std::vector<std::size_t> first, second;
        score::PairPreference preference;
    };

    LineReader lines_;
    std::string_view name_;
    std::vector<std::string_view> words_;
    std::vector<PairLine> pairs_;
    Kit kit_;
};

}  // namespace

Kit parse_kit(std::string_view text, std::string_view name) {
    return KitReader(text, name).read();
}

Kit read_kit_file(const std::filesystem::path& path) {
    return parse_kit(read_text<KitError>(path, kLargestFile), path.filename().string());
}

Kit standard_kit() {
    return parse_kit(standard_kit_text(), "standard.kit");
}

score::Script parse_script(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        if (end > 0) words.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    KitLine line("script", 1, std::move(words));
    return script_of(line);
}

std::string script_lines(const Kit& kit) {
    std::string text;
    for (const score::Script& script : kit.scripts) {
        text += "script " + script.joint + ' ' +
                std::string(score::kPhaseNames[static_cast<std::size_t>(script.phase)]);
        for (const double share : script.curve) {
            std::array<char, 32> number{};
            std::snprintf(number.data(), number.size(), " %.6g", share);
            text += number.data();
        }
        text += '\n';
    }
    return text;
}

std::string pose_lines(const Kit& kit, const std::vector<score::PoseEdit>& poses) {
    std::string text;
    for (const score::PoseEdit& pose : poses) {
        constexpr double kDegree = std::numbers::pi / 180.0;
        std::array<char, 96> angles{};
        std::snprintf(angles.data(), angles.size(), " %.2f %.2f %.2f\n", pose.angles[0] / kDegree,
                      pose.angles[1] / kDegree, pose.angles[2] / kDegree);
        text += "pose " + std::string(name(pose.limb)) + " " + kit.events[pose.event].name +
                (pose.up ? " up " : " down ") + pose.joint + angles.data();
    }
    return text;
}

}  // namespace percussionist::files
