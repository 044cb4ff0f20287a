// What an object's table says stands word for word in its help patch, under [pd reference].
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "objects/matrix_objects.hpp"
#include "pdx/object.hpp"

extern "C" void setup_drum0x2dlisten_tilde();
extern "C" void setup_modal0x2ddrum_tilde();
extern "C" void setup_osc0x2dreceive();
extern "C" void fastrak_tilde_setup();
extern "C" void setup_gesture0x2dfeatures();

using namespace percussionist::pdx;

namespace {

/// A patch's text as one line, its escapes undone, so that comments can be searched.
std::string read_patch(const std::string& name) {
    std::ifstream file(PERCUSSIONIST_SOURCE_DIR "/help/" + name + "-help.pd");
    const std::string raw(std::istreambuf_iterator<char>(file), {});
    std::string text;
    for (const char c : raw) {
        if (c == '\\') {
            continue;
        }
        const bool joins = (c == ',' || c == ';') && !text.empty() && text.back() == ' ';
        if (joins) {
            text.pop_back();
        }
        text += c == '\n' ? ' ' : c;
    }
    return text;
}

void check_page(const std::string& name) {
    CAPTURE(name);
    const Description* const table = find_class(name);
    REQUIRE(table);
    const std::string page = read_patch(name);
    REQUIRE(!page.empty());
    CHECK(page.find(usage(name, table->creation_arguments)) != std::string::npos);
    for (const auto& message : table->messages) {
        const std::string line =
            usage(message.selector, message.arguments) + ": " + message.description;
        CAPTURE(line);
        CHECK(page.find(line) != std::string::npos);
    }
    for (const auto& inlet : table->message_inlets) {
        CAPTURE(inlet.description);
        CHECK(page.find(inlet.description) != std::string::npos);
    }
    for (const auto& outlet : table->outlets) {
        CAPTURE(outlet.description);
        CHECK(page.find(outlet.description) != std::string::npos);
    }
    for (const char* meta : {"KEYWORDS ", "LICENSE BSD-3-Clause", "DESCRIPTION ", "INLET_0 ",
                             "OUTLET_0 ", "AUTHOR the Percussionist authors", "declare -path"}) {
        CAPTURE(meta);
        CHECK(page.find(meta) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("a help patch says what its object's table says") {
    const std::pair<const char*, void (*)()> objects[] = {
        {"modal-drum~", setup_modal0x2ddrum_tilde},
        {"fastrak~", fastrak_tilde_setup},
        {"gesture-features", setup_gesture0x2dfeatures},
        {"osc-receive", setup_osc0x2dreceive},
        {"drum-listen~", setup_drum0x2dlisten_tilde}};
    for (const auto& [name, setup] : objects) {
        if (!find_class(name)) {
            setup();
        }
        check_page(name);
    }
}

TEST_CASE("so do those of the matrix objects") {
    for (const std::string& name : percussionist::objects::matrix_object_names()) {
        if (!find_class(name)) {
            percussionist::objects::add_matrix_object(name.c_str());
        }
        check_page(name);
    }
}
