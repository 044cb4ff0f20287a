#include "core/motion/fastrak_settings.hpp"

#include <charconv>
#include <cmath>

namespace percussionist::motion {

namespace {

constexpr double kCentimetres = 100.0;

void append(std::string& command, double value) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 3);
    command += ',';
    command.append(text.data(), end.ptr);
}

std::string command(char letter, int station, const std::vector<Vector3>& triples, double unit) {
    std::string text = letter + std::to_string(station);
    for (const Vector3& triple : triples) {
        for (int i = 0; i < 3; ++i) {
            append(text, triple[i] * unit);
        }
    }
    return text + '\r';
}

std::string filter_command(char letter, const std::optional<Filter>& filter) {
    std::string text(1, letter);
    if (!filter) {
        return text + ",1\r";
    }
    for (const double value : *filter) {
        append(text, value);
    }
    text.erase(1, 1);  // the comma before the first
    return text + '\r';
}

std::vector<int> attitude_items(Attitude attitude) {
    switch (attitude) {
        case Attitude::kEuler:
            return {4};
        case Attitude::kCosines:
            return {5, 6, 7};
        default:
            return {11};
    }
}

}  // namespace

FastrakLayout layout_for(const FastrakSettings& settings) {
    std::vector<int> items{2};
    if (settings.encoding == Encoding::k16Bit) {
        items = {18, settings.attitude == Attitude::kEuler ? 19 : 20};
    } else {
        const auto attitude = attitude_items(settings.attitude);
        items.insert(items.end(), attitude.begin(), attitude.end());
    }
    if (settings.twice) {
        const auto once = items;
        items.insert(items.end(), once.begin(), once.end());
    }
    items.push_back(1);
    return {.items = items,
            .binary = settings.encoding != Encoding::kAscii,
            .centimetres = true,
            .cosine_rows = false};
}

std::string output_list_command(int station, const FastrakLayout& layout) {
    std::string text = 'O' + std::to_string(station);
    for (const int item : layout.items) {
        text += ',' + std::to_string(item);
    }
    return text + '\r';
}

std::vector<std::string> station_commands(int station, const StationSettings& settings) {
    std::vector<std::string> commands = {
        command('H', station, {settings.hemisphere}, 1.0),
        command('N', station, {settings.tip}, kCentimetres),
        'R' + std::to_string(station) + '\r',
        'b' + std::to_string(station) + '\r',
    };
    if (settings.alignment) {
        const Alignment& a = *settings.alignment;
        commands.push_back(command('A', station, {a.origin, a.on_x, a.on_y}, kCentimetres));
    }
    return commands;
}

std::vector<std::string> set_up_commands(const FastrakSettings& settings,
                                         const std::array<bool, kFastrakStations>& on) {
    std::vector<std::string> commands = {"U", settings.encoding == Encoding::kAscii ? "F" : "f",
                                         filter_command('x', settings.position_filter),
                                         filter_command('v', settings.attitude_filter)};
    for (int station = 1; station <= kFastrakStations; ++station) {
        const auto i = static_cast<std::size_t>(station - 1);
        if (on[i]) {
            const auto more = station_commands(station, settings.stations[i]);
            commands.insert(commands.end(), more.begin(), more.end());
        }
    }
    return commands;
}

}  // namespace percussionist::motion
