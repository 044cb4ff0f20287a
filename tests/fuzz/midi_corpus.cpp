// Writes the MIDI files that the fuzzer starts from into a folder.
#include <filesystem>
#include <string>

#include "support/corpus.hpp"
#include "support/midi_writer.hpp"

using namespace percussionist::test;

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    for (const int format : {0, 1, 2}) {
        write_input(folder / ("rich" + std::to_string(format) + ".mid"), rich_midi_file(format));
    }
    const Track note = Track().note(0, 38).end();
    write_input(folder / "smpte.mid", midi_file(0, 0xE728, {note}));
    Bytes riff = {'R', 'I', 'F', 'F', 0, 0, 0, 0, 'R', 'M', 'I', 'D', 'd', 'a', 't', 'a'};
    const Bytes plain = midi_file(0, 96, {note});
    append(riff, {static_cast<std::uint8_t>(plain.size()), 0, 0, 0});
    append(riff, plain);
    write_input(folder / "riff.mid", riff);
}
