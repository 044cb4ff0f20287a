#include <fmt/format.h>

#include <cmath>

#include "osc/address_table.hpp"

namespace percussionist::osc {

namespace {

using Arguments = std::span<const Argument>;

double number(Arguments arguments, std::size_t index) {
    return std::get<double>(arguments[index]);
}

std::optional<double> given(Arguments arguments, std::size_t index) {
    if (index >= arguments.size()) return std::nullopt;
    return number(arguments, index);
}

std::string word(Arguments arguments, std::size_t index) {
    return index < arguments.size() ? std::get<std::string>(arguments[index]) : "";
}

NoteSound sound(const std::string& name) {
    if (name == "contact") return NoteSound::contact;
    return name == "none" ? NoteSound::none : NoteSound::now;
}

std::string line(Arguments arguments) {
    std::string text;
    for (const Argument& a : arguments) {
        const auto* number = std::get_if<double>(&a);
        text +=
            number != nullptr ? fmt::format("{:.6g} ", *number) : std::get<std::string>(a) + ' ';
    }
    return text;
}

constexpr double kLongestSong = 4 * 3600.0;  // [s]
constexpr double kMidiVelocities = 127.0;
constexpr Parameter kPlace{"SECONDS", "s", false, true, -10.0, kLongestSong};
constexpr Parameter kAngle{"", "rad", false, true, -3.15, 3.15};

Parameter angle(const char* axis) {
    Parameter p = kAngle;
    p.name = axis;
    return p;
}

std::vector<Address> with_the_music() {
    return {
        {"/song/position",
         "at a kit: a song that plays elsewhere is at SECONDS, and goes on; AT is when, as /tick "
         "tells the time; without it when the message is tagged, or comes",
         {kPlace, {"AT", "s", false, false, 0.0, 1e9}},
         [](Arguments a) -> Command {
             return SongPosition{number(a, 0), given(a, 1)};
         }},
        {"/song/pause",
         "at a kit: the song stands, where it is or at SECONDS, until its next position",
         {{"SECONDS", "s", false, false, -10.0, kLongestSong}},
         [](Arguments a) -> Command { return SongPause{given(a, 0)}; }},
        {"/note",
         "at a kit: a MIDI key is struck as soon as a limb can be there; it sounds now (after the "
         "lookahead), at the contact, or none: it has sounded already; answered by /noted",
         {{"KEY", "", false, true, 0, 127},
          {"VELOCITY", "", false, true, 0, 127},
          {"SOUND", "", true, false, 0, 0, false, "now contact none"}},
         [](Arguments a) -> Command {
             return Note{static_cast<int>(std::lround(number(a, 0))),
                         number(a, 1) / kMidiVelocities, sound(word(a, 2))};
         }},
    };
}

std::vector<Address> poses() {
    return {
        {"/pose/show",
         "at a kit: a limb's pose for an event, held to be looked at; off: he plays on",
         {{"LIMB", "", true, true, 0, 0, false, "left-hand right-hand left-foot right-foot off"},
          {"EVENT", "", true, false},
          {"POSE", "", true, false, 0, 0, false, "up down"}},
         [](Arguments a) -> Command {
             const bool off = word(a, 0) == "off";
             return ShowPose{off ? "" : word(a, 0), word(a, 1), word(a, 2) == "up"};
         }},
        {"/pose/joint",
         "at a kit: turns a joint of the pose that is shown: Euler angles",
         {{"JOINT", "", true, true}, angle("Z"), angle("Y"), angle("X")},
         [](Arguments a) -> Command {
             return TurnJoint{word(a, 0), {number(a, 1), number(a, 2), number(a, 3)}};
         }},
        {"/script",
         "at a kit: how a joint goes between key frames: JOINT PHASE SHARE..., as in a kit file",
         {{"SCRIPT", "", true, true, 0, 0, true}},
         [](Arguments a) -> Command { return SetScript{line(a)}; }},
        {"/kit/save",
         "write the kit with its poses and scripts to FILE.kit in the server's folder",
         {{"FILE", "", true, true}},
         [](Arguments a) -> Command { return SaveKit{word(a, 0)}; }},
    };
}

}  // namespace

std::vector<Address> kit_addresses() {
    std::vector<Address> all = with_the_music();
    const std::vector<Address> more = poses();
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace percussionist::osc
