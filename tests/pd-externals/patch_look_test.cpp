// How every patch looks, measured: what Pd would draw over something else, or outside the window.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "support/pd_patch.hpp"

using namespace percussionist::test;
namespace fs = std::filesystem;

namespace {

const fs::path kRoot = PERCUSSIONIST_SOURCE_DIR;

std::vector<fs::path> patches_in(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".pd") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<fs::path> all_patches() {
    auto found = patches_in(kRoot / "help");
    const auto played = patches_in(kRoot / "patches");
    found.insert(found.end(), played.begin(), played.end());
    return found;
}

std::vector<PdWindow> windows_of(const fs::path& patch) {
    return read_pd_patch(patch, {kRoot / "patches"});
}

template <class Law>
void for_each_window(Law law) {
    for (const auto& patch : all_patches()) {
        for (const auto& window : windows_of(patch)) {
            CAPTURE(window.name);
            law(window);
        }
    }
}

/// A patch that a person opens, not one of which others are made.
bool is_page(const fs::path& patch) {
    const auto folder = patch.parent_path();
    const bool numbered = std::isdigit(patch.filename().string().front()) != 0;
    return folder == kRoot / "help" ||
           (folder == kRoot / "patches" && patch.stem() != "film" && patch.stem() != "preset" &&
            patch.stem() != "pose-row") ||
           (folder == kRoot / "patches/tour" && numbered);
}

}  // namespace

TEST_CASE("nothing in a patch lies on something else, bands apart") {
    for_each_window([](const PdWindow& window) {
        const auto& boxes = window.boxes;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t j = i + 1; j < boxes.size(); ++j) {
                if (boxes[i].band() || boxes[j].band()) continue;
                CAPTURE(boxes[i].text);
                CAPTURE(boxes[j].text);
                CHECK_FALSE(boxes[i].place.overlaps(boxes[j].place));
            }
        }
    });
}

TEST_CASE("a window holds all that is in it") {
    for_each_window([](const PdWindow& window) {
        const Rect whole{0, 0, window.width, window.height};
        for (const auto& box : window.boxes) {
            CAPTURE(box.text);
            CAPTURE(box.place.right);
            CAPTURE(box.place.bottom);
            CHECK(box.place.within(whole));
            CHECK(box.label.right <= window.width);
        }
    });
}

TEST_CASE("labels do not run into each other or out of their band") {
    for_each_window([](const PdWindow& window) {
        const auto& boxes = window.boxes;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (boxes[i].band() && boxes[i].label.right > 0) {
                CAPTURE(boxes[i].text);
                CHECK(boxes[i].label.right <= boxes[i].place.right);
            }
            for (std::size_t j = i + 1; j < boxes.size(); ++j) {
                CAPTURE(boxes[i].text);
                CAPTURE(boxes[j].text);
                CHECK_FALSE(boxes[i].label.overlaps(boxes[j].label));
            }
        }
    });
}

TEST_CASE("a page begins with a band, and a band is as wide as its window") {
    const auto head = [](const PdWindow& window) {
        return std::find_if(window.boxes.begin(), window.boxes.end(), [](const PdBox& box) {
            return box.band() && box.text.find("#305070 #ffffff") != std::string::npos;
        });
    };
    for (const auto& patch : all_patches()) {
        const auto windows = windows_of(patch);
        CAPTURE(patch);
        CHECK((head(windows.back()) != windows.back().boxes.end()) == is_page(patch));
        for (const auto& window : windows) {
            const auto band = head(window);
            if (band == window.boxes.end()) continue;
            CAPTURE(window.name);
            // With its outline within the window, or that gets scroll bars.
            CHECK(band->place.left == 1);
            CHECK(band->place.top == 1);
            CHECK(band->place.right == window.width - 2);
        }
    }
}

TEST_CASE("cords join what is there, and what prints hears something") {
    for_each_window([](const PdWindow& window) {
        for (const auto& cord : window.connections) {
            CHECK(cord.from < window.boxes.size());
            CHECK(cord.to < window.boxes.size());
        }
        for (std::size_t i = 0; i < window.boxes.size(); ++i) {
            const auto& box = window.boxes[i];
            if (box.kind != "obj" || !(box.text == "print" || box.text.starts_with("print "))) {
                continue;
            }
            CAPTURE(box.text);
            CHECK(std::any_of(window.connections.begin(), window.connections.end(),
                              [&](const PdConnection& cord) { return cord.to == i; }));
        }
    });
}

TEST_CASE("a patch names no folder of somebody's machine, and no number of its own opening") {
    const std::regex folder("(^|[ ,])(/(home|root|usr|opt|mnt|media|work|Users)/|~/|[A-Z]:/)");
    const std::regex unescaped("(^|[^\\\\])\\$0");
    for_each_window([&](const PdWindow& window) {
        for (const auto& box : window.boxes) {
            CAPTURE(box.text);
            CHECK_FALSE(std::regex_search(box.text, folder));
            // $0 without its backslash is replaced when the file is read, and saved as a number.
            CHECK_FALSE(std::regex_search(box.raw, unescaped));
        }
    });
}

TEST_CASE("a patch opened twice has arrays of its own each time") {
    const std::regex array("(array define( -k)?|table) ");
    for_each_window([&](const PdWindow& window) {
        for (const auto& box : window.boxes) {
            std::smatch found;
            if (!std::regex_search(box.text, found, array,
                                   std::regex_constants::match_continuous)) {
                continue;
            }
            CAPTURE(box.text);
            CHECK(found.suffix().str().starts_with("$0-"));
        }
    });
}

TEST_CASE("each page of the tour says what to click first, and leads to its neighbours") {
    std::vector<fs::path> pages;
    for (const auto& patch : patches_in(kRoot / "patches/tour")) {
        if (is_page(patch)) pages.push_back(patch);
    }
    REQUIRE(pages.size() == 10);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        CAPTURE(pages[i]);
        const auto boxes = windows_of(pages[i]).back().boxes;
        const auto has = [&](const std::string& kind, const std::string& text) {
            return std::any_of(boxes.begin(), boxes.end(), [&](const PdBox& box) {
                return box.kind == kind && box.text.find(text) != std::string::npos;
            });
        };
        CHECK(has("text", "Click this"));
        CHECK(has("obj", " tour-first "));
        const auto before = pages[(i + pages.size() - 1) % pages.size()].stem().string();
        const auto next = pages[(i + 1) % pages.size()].stem().string();
        CHECK(has("obj", "turn " + before + ' ' + next));
    }
}
