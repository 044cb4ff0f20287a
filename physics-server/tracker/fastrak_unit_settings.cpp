// What is set on the simulated FASTRAK, and read back.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/linear/euler.hpp"
#include "core/motion/fastrak_items.hpp"
#include "tracker/fastrak_setting.hpp"
#include "tracker/fastrak_unit.hpp"

namespace percussionist::tracker {

namespace {

std::string fixed(double value, int width, int decimals) {
    char text[32];
    std::snprintf(text, sizeof text, "%*.*f", width, decimals, value);
    return text;
}

bool is_flag(const std::optional<double>& value) {
    return value == 0.0 || value == 1.0;
}

}  // namespace

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

}  // namespace percussionist::tracker
