// Writes the OSC packets that the fuzzer starts from into a folder.
#include <filesystem>

#include "support/corpus.hpp"
#include "support/dns_writer.hpp"
#include "support/osc_writer.hpp"

using namespace percussionist::test;

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    write_input(folder / "rich", rich_packet());
    write_input(folder / "contact", contact_packet({{3, 0.3}, {2, 0.2}, {1, 0.1}}, 0.03));
    write_input(folder / "clock", clock_packet(1.0, 0.03));
    write_input(folder / "dns", dns_answer());
    write_input(folder / "plain", osc_message("/a", "if", {osc_int(1), osc_float(2)}));
}
