// What the simulated FASTRAK does with what it is told.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/linear/euler.hpp"
#include "core/motion/fastrak_items.hpp"
#include "physics-server/tracker/fastrak_unit.hpp"

namespace percussionist::tracker {

using motion::kFastrakStations;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSaving = 3.0;  // how long ^K takes [s]

/// A setting of one station: its letter, how many numbers, of what width it tells them, their unit.
struct Setting {
    enum class Unit { kLength, kAngle, kNone };
    char letter;
    std::size_t count;
    int width;
    double most;  // of the unit's own units
    Unit unit;
};

constexpr std::array kSettings = {
    Setting{'A', 9, 7, 999, Setting::Unit::kLength},
    Setting{'G', 3, 7, 180, Setting::Unit::kAngle},
    Setting{'H', 3, 7, 999, Setting::Unit::kNone},
    Setting{'I', 1, 7, 999, Setting::Unit::kLength},
    Setting{'N', 3, 7, 999, Setting::Unit::kLength},
    Setting{'r', 3, 8, 180, Setting::Unit::kAngle},
    Setting{'Q', 6, 7, 180, Setting::Unit::kAngle},
    Setting{'V', 6, 7, 999, Setting::Unit::kLength},
};

const Setting* find_setting(char letter) {
    for (const Setting& setting : kSettings) {
        if (setting.letter == letter) {
            return &setting;
        }
    }
    return nullptr;
}

double unit_of(const Setting& setting, bool centimetres) {
    switch (setting.unit) {
        case Setting::Unit::kLength:
            return centimetres ? 0.01 : 0.0254;
        case Setting::Unit::kAngle:
            return kDegree;
        default:
            return 1.0;
    }
}

std::string fixed(double value, int width, int decimals) {
    char text[32];
    std::snprintf(text, sizeof text, "%*.*f", width, decimals, value);
    return text;
}

bool is_flag(const std::optional<double>& value) {
    return value == 0.0 || value == 1.0;
}

}  // namespace

void FastrakUnit::power_up() {
    binary_ = centimetres_ = continuous_ = paused_ = compensation_ = false;
    error_ = ' ';
    filters_['x'] = filters_['v'] = {1.0, 1.0, 0.0, 0.0};
    for (std::size_t i = 0; i < stations_.size(); ++i) {
        Station& station = stations_[i];
        station = Station();
        station.on = static_cast<int>(i) < settings_.receivers;
        for (const Setting& setting : kSettings) {
            station.values[setting.letter].assign(setting.count, 0.0);
        }
        station.values['H'] = {1.0, 0.0, 0.0};
        station.values['A'] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    }
}

void FastrakUnit::receive(std::span<const std::uint8_t> bytes, double now) {
    if (now < deaf_until_) {
        return;
    }
    for (const std::uint8_t byte : bytes) {
        const auto result = reader_.receive(byte);
        if (!result) {
            continue;
        }
        if (const auto* const refused = std::get_if<RefusedCommand>(&*result)) {
            refuse(refused->text, refused->reason, now);
        } else {
            obey(std::get<FastrakCommand>(*result), now);
        }
    }
}

void FastrakUnit::obey(const FastrakCommand& command, double now) {
    command.at_once ? act(command.letter, now) : set(command, now);
}

void FastrakUnit::act(char letter, double now) {
    switch (letter) {
        case 'P':
            for (int i = 0; i < kFastrakStations; ++i) {
                Station& station = stations_[static_cast<std::size_t>(i)];
                if (station.on) {
                    measure(station, i + 1, now - motion::kFastrakLatency);
                    send(station, now);
                }
            }
            return;
        case 'C':
        case 'c':
            continuous_ = letter == 'C';
            return;
        case 'F':
        case 'f':
            binary_ = letter == 'f';
            return;
        case 'U':
        case 'u':
            centimetres_ = letter == 'U';
            return;
        case 'D':
        case 'd':
            compensation_ = letter == 'D';
            return;
        case 'S':
            return tell_status(now);
        case 'T':
            error_ = ' ';
            return;
        case '\x13':
        case '\x11':
            paused_ = letter == '\x13';
            return;
        case 'W':
            return power_up();
        case '\x0b':
            deaf_until_ = now + kSaving;
            return;
        case '\x19':
            power_up();
            wire_.clear();
            deaf_until_ = now + settings_.restart;
            return;
        default:
            return;
    }
}

void FastrakUnit::set(const FastrakCommand& command, double now) {
    const char letter = command.letter;
    if (letter == 'x' || letter == 'v') {
        return set_filter(command, now);
    }
    if (letter == 'o') {
        return set_line(command, now);
    }
    if (command.values.empty() || !command.values[0]) {
        return refuse(command.text, Refusal::kMissing, now);
    }
    const double first = *command.values[0];
    if (letter == 'y') {
        if (first != 0 && first != 1 && first != 2) {
            refuse(command.text, Refusal::kOutOfRange, now);
        }
        return;
    }
    const int number = first >= 1 && first <= kFastrakStations ? static_cast<int>(first) : 0;
    if (number == 0 || number != first) {
        return refuse(command.text, Refusal::kOutOfRange, now);
    }
    set_station(command, stations_[static_cast<std::size_t>(number - 1)], number, now);
}

void FastrakUnit::set_station(const FastrakCommand& command, Station& station, int number,
                              double now) {
    switch (command.letter) {
        case 'O':
            return set_output_list(command, station, number, now);
        case 'l':
            if (command.values.size() == 1) {
                return reply("2" + std::to_string(number) + "l" + states(), now);
            }
            if (!is_flag(command.values[1])) {
                return refuse(command.text, Refusal::kOutOfRange, now);
            }
            station.on = command.values[1] == 1.0 && number <= settings_.receivers;
            return;
        case 'R':
            station.aligned = false;
            station.measured = false;
            return;
        case 'B': {
            const auto& g = station.values['G'];
            station.boresight =
                station.raw.orientation.conjugate() * linear::to_quaternion({g[0], g[1], g[2]});
            return;
        }
        case 'b':
            station.boresight = motion::Quaternion::Identity();
            return;
        case 'e':
            if (command.values.size() > 1 && !is_flag(command.values[1])) {
                refuse(command.text, Refusal::kOutOfRange, now);
            }
            return;
        default:
            return set_values(command, station, number, now);
    }
}

void FastrakUnit::set_values(const FastrakCommand& command, Station& station, int number,
                             double now) {
    const Setting& setting = *find_setting(command.letter);
    const double unit = unit_of(setting, centimetres_);
    std::vector<double>& values = station.values[setting.letter];
    if (command.values.size() == 1) {
        std::string text = "2" + std::to_string(number) + setting.letter;
        for (const double value : values) {
            text += fixed(value / unit, setting.width, 2);
        }
        return reply(text, now);
    }
    if (command.values.size() > setting.count + 1) {
        return refuse(command.text, Refusal::kOutOfRange, now);
    }
    std::vector<double> changed = values;
    for (std::size_t i = 1; i < command.values.size(); ++i) {
        if (command.values[i]) {
            if (std::abs(*command.values[i]) > setting.most) {
                return refuse(command.text, Refusal::kOutOfRange, now);
            }
            changed[i - 1] = *command.values[i] * unit;
        }
    }
    values = changed;
    station.aligned = station.aligned || setting.letter == 'A';
    station.measured = false;
}

void FastrakUnit::set_output_list(const FastrakCommand& command, Station& station, int number,
                                  double now) {
    if (command.values.size() == 1) {
        std::string text = "2" + std::to_string(number) + "O";
        for (const int item : station.layout.items) {
            text += ' ' + std::to_string(item);
        }
        return reply(text, now);
    }
    motion::FastrakLayout layout{
        .items = {}, .binary = false, .centimetres = false, .cosine_rows = false};
    for (std::size_t i = 1; i < command.values.size(); ++i) {
        const double value = command.values[i].value_or(-1.0);
        const int item = value >= 0 && value <= 99 ? static_cast<int>(value) : -1;
        const motion::Item* const known = motion::find_item(item);
        if (item != value || !known || (known->is_16bit && !settings_.has_16bit)) {
            return refuse(command.text, Refusal::kOutOfRange, now);
        }
        layout.items.push_back(item);
    }
    if (!record_size(layout)) {
        return refuse(command.text, Refusal::kOutOfRange, now);
    }
    station.layout = layout;
}

void FastrakUnit::set_filter(const FastrakCommand& command, double now) {
    std::vector<double>& filter = filters_[command.letter];
    if (command.values.empty()) {
        std::string text = std::string("2 ") + command.letter;
        for (const double value : filter) {
            text += fixed(value, 7, 3);
        }
        return reply(text, now);
    }
    if (command.values.size() == 1 && command.values[0] && *command.values[0] >= 2) {
        // The macros 2 to 5, from none to heavy.
        constexpr std::array kSensitivity = {1.0, 0.8, 0.4, 0.2};
        const auto macro = static_cast<std::size_t>(std::min(*command.values[0], 5.0)) - 2;
        filter = {kSensitivity[macro], kSensitivity[macro], 0.8, 0.8};
        return;
    }
    for (std::size_t i = 0; i < command.values.size(); ++i) {
        const double value = command.values[i].value_or(0.0);
        if (i >= filter.size() || value < 0 || value > 1) {
            return refuse(command.text, Refusal::kOutOfRange, now);
        }
    }
    for (std::size_t i = 0; i < command.values.size(); ++i) {
        filter[i] = command.values[i].value_or(filter[i]);
    }
    if (filter[1] == 1.0 || filter[0] == 0.0) {
        filter[0] = 1.0;  // a lowest value of 1 leaves nothing to filter
    }
}

void FastrakUnit::set_line(const FastrakCommand& command, double now) {
    constexpr std::array kCodes = {24, 48, 96, 192, 384, 576, 1152};
    const double code = command.values.empty() ? -1 : command.values[0].value_or(-1);
    for (const int known : kCodes) {
        if (known == code) {
            baud_ = known * 100;
            wire_.set_baud(baud_);
            return;
        }
    }
    refuse(command.text, Refusal::kOutOfRange, now);
}

void FastrakUnit::reply(const std::string& text, double now) {
    const std::string line = text + "\r\n";
    wire_.send({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, now);
}

void FastrakUnit::refuse(const std::string& command, Refusal reason, double now) {
    reply("2 E*ERROR*" + command + "*ERROR* EC" + std::to_string(static_cast<int>(reason)), now);
}

std::string FastrakUnit::states() const {
    std::string text;
    for (const Station& station : stations_) {
        text += station.on ? '1' : '0';
    }
    return text;
}

void FastrakUnit::tell_status(double now) {
    unsigned map = 0;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
        map |= (static_cast<int>(i) < settings_.receivers ? 1U : 0U) << i;
    }
    const unsigned flags = 0x3F0U | (binary_ ? 1U : 0U) | (centimetres_ ? 2U : 0U) |
                           (compensation_ ? 4U : 0U) | (continuous_ ? 8U : 0U);
    char text[64];
    std::snprintf(text, sizeof text, "21S%03X%c   F3%X  %-6s%-32s", flags, error_, map, " 2.00",
                  "3SPACE FASTRAK, simulated");
    reply(text, now);
}

}  // namespace percussionist::tracker
