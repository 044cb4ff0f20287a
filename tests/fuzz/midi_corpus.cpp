// Writes the MIDI files that the fuzzer starts from into a folder.
#include <filesystem>
#include <fstream>
#include <string>

#include "support/midi_writer.hpp"

using namespace percussionist::test;

namespace {

void write(const std::filesystem::path& path, const Bytes& bytes) {
    std::ofstream stream(path, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    for (const int format : {0, 1, 2}) {
        write(folder / ("rich" + std::to_string(format) + ".mid"), rich_midi_file(format));
    }
    const Track note = Track().note(0, 38).end();
    write(folder / "smpte.mid", midi_file(0, 0xE728, {note}));
    Bytes riff = {'R', 'I', 'F', 'F', 0, 0, 0, 0, 'R', 'M', 'I', 'D', 'd', 'a', 't', 'a'};
    const Bytes plain = midi_file(0, 96, {note});
    append(riff, {static_cast<std::uint8_t>(plain.size()), 0, 0, 0});
    append(riff, plain);
    write(folder / "riff.mid", riff);
}
