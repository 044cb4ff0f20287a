// A patch of Pd as a file: its windows, what is in each, and where Pd draws it.
//
// Sizes are those of Pd 0.53 with DejaVu Sans Mono at font size 12 (7 x 15 pixels a character): a
// box is its text and 4 x 5 pixels around it, a line breaks after 60 characters or where ", f N"
// says; a message has its flag besides, a comment no frame; a slider begins 3 pixels before its
// place, and ends 2 behind it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace percussionist::test {

struct Rect {
    double left = 0, top = 0, right = 0, bottom = 0;  // [pixels]
    bool within(const Rect& outer) const {
        return left >= outer.left && top >= outer.top && right <= outer.right &&
               bottom <= outer.bottom;
    }
    bool overlaps(const Rect& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

struct PdBox {
    std::string kind;  ///< obj, msg, text, floatatom, symbolatom, listbox, graph (a picture)
    std::string text;  ///< as Pd shows it: no escapes, the comma close behind its word
    std::string raw;   ///< as the file has it
    Rect place;
    Rect label;  ///< of a control or a band; nothing, if it has none
    bool band() const { return kind == "obj" && text.starts_with("cnv "); }
};

struct PdConnection {
    std::size_t from = 0, to = 0;
};

struct PdWindow {
    std::string name;  ///< the file's, and behind it the subpatch's
    double width = 0, height = 0;
    bool picture = false;  ///< drawn in the window above it
    Rect drawn;            ///< what of it is drawn there
    std::vector<PdBox> boxes;
    std::vector<PdConnection> connections;
};

/// All windows of a patch, the file's own last. Abstractions that are pictures are looked for
/// beside it and in `folders`. Throws std::runtime_error for what is no patch.
std::vector<PdWindow> read_pd_patch(const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& folders);

}  // namespace percussionist::test
