#include "io/fastrak_dialogue.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/motion/fastrak_stream.hpp"

namespace percussionist::io {

using motion::FastrakLayout;
using motion::kFastrakStations;

namespace {

constexpr double kQuiet = 0.015;        // [s] no byte: it is silent
constexpr double kLongestNoise = 0.15;  // [s] it streams at another rate, or does not listen
constexpr double kAnswer = 0.1;         // [s] to think of an answer, besides sending it
constexpr int kTries = 3;

double steady() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

std::string station_text(int station) {
    return std::to_string(station);
}

}  // namespace

void FastrakDialogue::read(double seconds) {
    std::vector<std::uint8_t> bytes;
    port_.read(bytes, seconds, waker_);
    text_.append(bytes.begin(), bytes.end());
}

/// What comes until no more does.
std::string FastrakDialogue::drain() {
    const double end = steady() + kLongestNoise;
    std::size_t before = 0;
    text_.clear();
    do {
        before = text_.size();
        read(kQuiet);
    } while (text_.size() > before && steady() < end && !cancelled_());
    return std::exchange(text_, {});
}

template <class Find>
auto FastrakDialogue::ask(const std::string& command, Find find)
    -> decltype(find(std::string_view())) {
    text_.clear();
    port_.write(command);
    const double bytes = static_cast<double>(command.size() + motion::kFastrakStatusBytes);
    const double end = steady() + kAnswer + 10 * bytes / port_.baud();
    while (steady() < end && !cancelled_()) {
        read(end - steady());
        if (auto found = find(std::string_view(text_))) {
            return found;
        }
    }
    return {};
}

std::optional<motion::FastrakStatus> FastrakDialogue::greet() {
    port_.write("\rc");  // the first ends what may have been half a command
    drain();
    return ask("S", motion::find_status);
}

std::optional<motion::FastrakStatus> FastrakDialogue::find_unit() {
    std::vector<int> rates = {port_.baud()};
    for (const int rate : {115200, 57600, 38400, 19200, 9600, 4800, 2400}) {
        if (rate != rates.front()) {
            rates.push_back(rate);
        }
    }
    for (const int rate : rates) {
        port_.set_baud(rate);
        if (auto status = greet()) {
            return status;
        }
        if (cancelled_()) {
            break;
        }
    }
    port_.set_baud(rates.front());
    return std::nullopt;
}

FastrakDialogue::Answer FastrakDialogue::takes(const FastrakLayout& layout, int station) {
    for (int i = 0; i < kTries && !cancelled_(); ++i) {
        port_.write(motion::output_list_command(station, layout));
        const auto told = ask('O' + station_text(station) + '\r', [station](std::string_view text) {
            return motion::find_output_list(text, station);
        });
        if (told) {
            return *told == layout.items ? Answer::kYes : Answer::kNo;
        }
    }
    return Answer::kNone;
}

FastrakDialogue::Answer FastrakDialogue::all_take(const FastrakSession& session) {
    for (int station = 1; station <= kFastrakStations; ++station) {
        if (session.on[static_cast<std::size_t>(station - 1)]) {
            const Answer answer = takes(session.layout, station);
            if (answer != Answer::kYes) {
                return answer;
            }
        }
    }
    return Answer::kYes;
}

/// The layout asked for, or the nearest that the unit takes: no 16BIT, then nothing twice. A unit
/// that does not tell gets the plainest.
void FastrakDialogue::agree_on_layout(motion::FastrakSettings settings, FastrakSession& session) {
    const double cycle_bytes = motion::kFastrakCycle * port_.baud() / 10;
    if (settings.twice && static_cast<double>(*record_size(layout_for(settings))) > cycle_bytes) {
        settings.twice = false;
        session.notes.push_back("line too slow for everything twice");
    }
    session.layout = layout_for(settings);
    Answer answer = all_take(session);
    if (answer == Answer::kNo && settings.encoding == motion::Encoding::k16Bit) {
        settings.encoding = motion::Encoding::kFloat32;
        session.notes.push_back("unit has no 16BIT: float32 instead");
        session.layout = layout_for(settings);
        answer = all_take(session);
    }
    if (answer != Answer::kYes && settings.twice) {
        settings.twice = false;
        session.notes.push_back("unit sends nothing twice");
        session.layout = layout_for(settings);
        for (int station = 1; station <= kFastrakStations; ++station) {
            port_.write(motion::output_list_command(station, session.layout));
        }
    }
}

/// One record with cosines and quaternion tells whether the cosines are rows or columns.
void FastrakDialogue::settle_cosines(FastrakSession& session, int station) {
    FastrakLayout probe{.items = {5, 6, 7, 11, 1},
                        .binary = session.layout.binary,
                        .centimetres = true,
                        .cosine_rows = false};
    port_.write(motion::output_list_command(station, probe));
    drain();
    const std::size_t size = *record_size(probe);
    const auto record = ask("P", [size](std::string_view text) {
        return text.size() >= size ? std::optional(std::string(text)) : std::nullopt;
    });
    port_.write(motion::output_list_command(station, session.layout));
    if (!record) {
        return;
    }
    const auto bytes = std::span(reinterpret_cast<const std::uint8_t*>(record->data()), size);
    FastrakLayout cosines = probe, quaternion = probe;
    cosines.items = {5, 6, 7};
    quaternion.items = {11, 1};
    const std::size_t cosines_end = *record_size(cosines);
    motion::Bytes header_and_rest(bytes.begin(), bytes.begin() + 3);
    header_and_rest.insert(header_and_rest.end(),
                           bytes.begin() + static_cast<std::ptrdiff_t>(cosines_end), bytes.end());
    const auto as_columns = decode(bytes.first(cosines_end), cosines);
    const auto truth = decode(header_and_rest, quaternion);
    if (as_columns && truth) {
        const auto& columns = as_columns->pose.orientation;
        const auto& q = truth->pose.orientation;
        session.layout.cosine_rows =
            q.angularDistance(columns.conjugate()) < q.angularDistance(columns);
    }
}

std::optional<FastrakSession> FastrakDialogue::set_up(const motion::FastrakSettings& settings) {
    auto status = greet();
    if (!status) {
        return std::nullopt;
    }
    FastrakSession session{.status = *status, .on = {}, .layout = {}, .notes = {}};
    const bool choose = std::any_of(settings.wanted.begin(), settings.wanted.end(),
                                    [](bool wanted) { return wanted; });
    for (int station = 1; choose && station <= kFastrakStations; ++station) {
        const bool wanted = settings.wanted[static_cast<std::size_t>(station - 1)];
        port_.write('l' + station_text(station) + (wanted ? ",1\r" : ",0\r"));
    }
    std::array<bool, kFastrakStations> all{};
    all.fill(true);
    session.on = ask("l1\r", motion::find_stations).value_or(choose ? settings.wanted : all);
    agree_on_layout(settings, session);
    for (const std::string& command : set_up_commands(settings, session.on)) {
        port_.write(command);
    }
    if (const auto complaint = motion::find_complaint(drain())) {
        session.notes.push_back("unit refuses " + *complaint);
    }
    if (settings.attitude == motion::Attitude::kCosines) {
        const auto first = std::find(session.on.begin(), session.on.end(), true);
        if (first != session.on.end()) {
            settle_cosines(session, static_cast<int>(first - session.on.begin()) + 1);
        }
    }
    port_.write("C");
    return session;
}

}  // namespace percussionist::io
