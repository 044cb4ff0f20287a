// Writes the OSC packets that the server's fuzzer starts from into a folder: each of its addresses
// with arguments that fit, and a bundle of some.
#include <filesystem>

#include "osc/address_table.hpp"
#include "support/corpus.hpp"
#include "support/osc_writer.hpp"

using namespace percussionist;
using namespace percussionist::test;

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    int number = 0;
    for (const osc::Address& address : osc::address_table()) {
        std::string types;
        std::vector<OscBytes> values;
        for (const osc::Parameter& p : address.parameters) {
            types += p.text ? 's' : 'd';
            values.push_back(p.text ? osc_text("sound") : osc_double(p.least));
        }
        write_input(folder / std::to_string(number++), osc_message(address.path, types, values));
    }
    write_input(folder / "rich", rich_packet());
    write_input(folder / "route",
                osc_message("/route/add", "s", {osc_text("contact to 127.0.0.1:9000 /a x")}));
}
