// describe-objects TOPIC: what is written out of the tables of all objects.
//   readme        the table of README.md
//   deken         the list of a package: name TAB what it is
//   names         the names, a line each
//   abuse-patch, abuse-story COPIES  a patch that misuses them all, and what it plays
#include <iostream>
#include <string>

#include "objects/describe/abuse_patch.hpp"
#include "pdx/object.hpp"

extern "C" void percussionist_setup();

namespace {

using percussionist::pdx::all_classes;

void print_readme() {
    std::cout << "| object | what it is |\n|---|---|\n";
    for (const auto* table : all_classes()) {
        std::cout << "| [`[" << table->name << "]`](help/" << table->name << "-help.pd) | "
                  << table->summary << " |\n";
    }
}

void print_deken() {
    for (const auto* table : all_classes()) {
        std::cout << table->name << '\t' << table->summary << '\n';
    }
}

void print_names() {
    for (const auto* table : all_classes()) {
        std::cout << table->name << '\n';
    }
}

}  // namespace

int main(int count, char** words) {
    percussionist_setup();
    const std::string topic = count > 1 ? words[1] : "";
    if (topic == "readme") {
        print_readme();
    } else if (topic == "deken") {
        print_deken();
    } else if (topic == "names") {
        print_names();
    } else if (topic == "abuse-patch") {
        std::cout << percussionist::objects::abuse_patch();
    } else if (topic == "abuse-story" && count > 2) {
        std::cout << percussionist::objects::abuse_story(std::stoi(words[2]));
    } else {
        std::cerr << "usage: describe-objects readme|deken|names|abuse-patch|abuse-story COPIES\n";
        return 2;
    }
    return 0;
}
