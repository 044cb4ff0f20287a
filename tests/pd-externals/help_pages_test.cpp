// What an object's table says stands word for word in its help patch, under [pd reference].
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "pdx/object.hpp"
#include "support/pd_patch.hpp"

extern "C" void percussionist_setup();

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

/// What boxes of Pd's own send, fastrak~ does, or a further inlet takes.
bool sent_otherwise(const Description& table, const std::string& selector) {
    const auto takes = [&](const MessageInlet& inlet) { return inlet.selector == selector; };
    return selector == "bang" || selector == "float" || selector == "list" || selector == "pose" ||
           std::any_of(table.message_inlets.begin(), table.message_inlets.end(), takes);
}

/// The line of META that begins so, to its end; nothing, if there is none.
std::string meta_line(const std::string& page, const std::string& begin) {
    const auto at = page.find(' ' + begin + ' ');
    return at == std::string::npos ? "" : page.substr(at, page.find(';', at) - at) + ' ';
}

/// META names every inlet and outlet, and at the first inlet every message.
void check_ports(const Description& table, const std::string& page) {
    const std::string first = meta_line(page, "INLET_0");
    for (const auto& message : table.messages) {
        CAPTURE(message.selector);
        CHECK(first.find(' ' + message.selector + ' ') != std::string::npos);
    }
    CHECK((first.find(" signal ") != std::string::npos) == !table.signal_inlets.empty());
    const auto signals = std::max<std::size_t>(table.signal_inlets.size(), 1);
    for (std::size_t i = 1; i < signals + table.message_inlets.size(); ++i) {
        CAPTURE(i);
        CHECK(!meta_line(page, "INLET_" + std::to_string(i)).empty());
    }
    for (std::size_t i = 0; i < table.outlets.size(); ++i) {
        CAPTURE(i);
        const std::string outlet = meta_line(page, "OUTLET_" + std::to_string(i));
        CHECK(!outlet.empty());
        CHECK((outlet.find(" signal ") != std::string::npos) == table.outlets[i].signal);
    }
    CHECK(meta_line(page, "OUTLET_N").empty() == !table.last_outlets);
}

/// Every message is somewhere in the page to be clicked.
void check_that_all_can_be_tried(const Description& table, const std::string& name) {
    std::vector<std::string> tried;
    for (const auto& window : percussionist::test::read_pd_patch(
             PERCUSSIONIST_SOURCE_DIR "/help/" + name + "-help.pd", {})) {
        for (const auto& box : window.boxes) {
            if (box.kind == "msg") tried.push_back(", " + box.text + ' ');
        }
    }
    for (const auto& message : table.messages) {
        if (sent_otherwise(table, message.selector)) continue;
        CAPTURE(message.selector);
        CHECK(std::any_of(tried.begin(), tried.end(), [&](const std::string& text) {
            return text.find(", " + message.selector + ' ') != std::string::npos ||
                   text.find(", " + message.selector + ',') != std::string::npos;
        }));
    }
}

void check_page(const Description& table) {
    const std::string& name = table.name;
    CAPTURE(name);
    const std::string page = read_patch(name);
    REQUIRE(!page.empty());
    CHECK(page.find(usage(name, table.creation_arguments)) != std::string::npos);
    for (const auto& message : table.messages) {
        const std::string line =
            usage(message.selector, message.arguments) + ": " + message.description;
        CAPTURE(line);
        CHECK(page.find(line) != std::string::npos);
    }
    for (const auto& inlet : table.signal_inlets) {
        CAPTURE(inlet.description);
        CHECK(page.find(inlet.description) != std::string::npos);
    }
    for (const auto& inlet : table.message_inlets) {
        CAPTURE(inlet.description);
        CHECK(page.find(inlet.description) != std::string::npos);
    }
    if (table.last_outlets) {
        CHECK(page.find(kOneCord) != std::string::npos);
    }
    for (const auto& outlet : table.outlets) {
        CAPTURE(outlet.description);
        CHECK(page.find(outlet.description) != std::string::npos);
    }
    for (const char* meta : {"KEYWORDS ", "LICENSE BSD-3-Clause", "DESCRIPTION ",
                             "AUTHOR the Percussionist authors", "declare -path", "see also:"}) {
        CAPTURE(meta);
        CHECK(page.find(meta) != std::string::npos);
    }
    check_ports(table, page);
    check_that_all_can_be_tried(table, name);
}

}  // namespace

TEST_CASE("a help patch says what its object's table says") {
    percussionist_setup();
    for (const Description* table : all_classes()) {
        if (table->name != "sampler~") {  // of another test
            check_page(*table);
        }
    }
}
