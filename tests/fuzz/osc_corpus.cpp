// Writes the OSC packets that the fuzzer starts from into a folder.
#include <filesystem>
#include <fstream>

#include "support/osc_writer.hpp"

using namespace percussionist::test;

namespace {

void write(const std::filesystem::path& path, const OscBytes& bytes) {
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
    write(folder / "rich", rich_packet());
    write(folder / "contact", contact_packet({{3, 0.3}, {2, 0.2}, {1, 0.1}}, 0.03));
    write(folder / "clock", clock_packet(1.0, 0.03));
    write(folder / "plain", osc_message("/a", "if", {osc_int(1), osc_float(2)}));
}
