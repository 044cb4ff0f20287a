// Writes what the fuzzers of the FASTRAK start from into a folder: records and commands.
#include <filesystem>
#include <string>

#include "core/motion/fastrak_settings.hpp"
#include "support/corpus.hpp"

using namespace percussionist::motion;
using percussionist::test::write_input;

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    for (int choice = 0; choice < 9; ++choice) {
        for (const int twice : {0, 0x40}) {
            FastrakSettings settings;
            const int byte = choice | twice;
            settings.encoding = static_cast<Encoding>(byte % 3);
            settings.attitude = static_cast<Attitude>(byte / 3 % 3);
            settings.twice = twice != 0;
            Bytes bytes = {static_cast<std::uint8_t>(byte), 40};
            for (int station = 1; station <= kFastrakStations; ++station) {
                FastrakReading reading;
                reading.station = station;
                reading.pose.position = {0.1 * station, -0.2, 0.3};
                encode(reading, layout_for(settings), bytes);
            }
            write_input(folder / ("records" + std::to_string(byte)), bytes);
        }
    }
    FastrakSettings settings;
    settings.position_filter = Filter{0.2, 0.2, 0.8, 0.8};
    settings.stations[0].alignment = Alignment();
    std::string commands = "cSl1\rO1\rx\rP";
    for (const std::string& command : set_up_commands(settings, {true, true, true, true})) {
        commands += command;
    }
    commands += "G1,0,0,0\rB1\rC" + output_list_command(1, layout_for(settings)) + "\x13\x11T^W";
    write_input(folder / "commands", {commands.begin(), commands.end()});
    const std::string replies =
        "21l1010\r\n21O 2 4 1\r\n2 E*ERROR*O1,99*ERROR* EC-3\r\n21S3F1   F31   2.00 FASTRAK" +
        std::string(25, ' ') + "\r\n";
    write_input(folder / "replies", {replies.begin(), replies.end()});
}
