#include "support/pd_patch.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace percussionist::test {

namespace {

constexpr double kLetterWidth = 7, kLetterHeight = 15;
constexpr std::size_t kLineLength = 60;

using Words = std::vector<std::string>;

Words words_of(const std::string& record) {
    std::istringstream stream(record);
    return {std::istream_iterator<std::string>(stream), {}};
}

/// The words of a record: a space that is escaped is part of one.
Words record_words(const std::string& record) {
    Words words;
    bool within = false;
    for (std::size_t i = 0; i < record.size(); ++i) {
        const bool escaped = i > 0 && record[i - 1] == '\\';
        if (record[i] == ' ' && !escaped) {
            within = false;
            continue;
        }
        if (!within) words.emplace_back();
        within = true;
        words.back() += record[i];
    }
    return words;
}

/// The records of a file, which end with semicolons that are not escaped.
std::vector<std::string> records_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    const std::string all(std::istreambuf_iterator<char>(file), {});
    std::vector<std::string> records(1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i] == ';' && (i == 0 || all[i - 1] != '\\')) {
            records.emplace_back();
        } else {
            records.back() += all[i] == '\n' ? ' ' : all[i];
        }
    }
    return records;
}

/// What Pd shows of words: escapes undone, commas close to what is before, a line a semicolon.
std::string shown(const Words& words) {
    std::string text;
    for (const auto& word : words) {
        const bool closes = word == "\\," || word == "\\;";
        const bool breaks = text.ends_with(';');
        if (!text.empty() && !closes) text += breaks ? '\n' : ' ';
        for (std::size_t i = 0; i < word.size(); ++i) {
            if (word[i] == '\\' && i + 1 < word.size()) ++i;
            text += word[i];
        }
    }
    return text;
}

/// Columns and lines of a text that is broken between words.
std::pair<std::size_t, std::size_t> measure(const std::string& text, std::size_t limit) {
    std::size_t lines = 0, longest = 0;
    std::istringstream paragraphs(text);
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        std::size_t column = 0;
        ++lines;
        for (const auto& word : words_of(paragraph)) {
            if (column > 0 && column + 1 + word.size() > limit) {
                ++lines;
                column = 0;
            }
            column += (column > 0 ? 1 : 0) + word.size();
            longest = std::max(longest, column);
        }
    }
    return {longest, std::max<std::size_t>(lines, 1)};
}

Rect text_place(double x, double y, const PdBox& box, std::optional<std::size_t> given) {
    const auto [longest, lines] = measure(box.text, given.value_or(kLineLength));
    const std::size_t columns =
        given.value_or(std::max<std::size_t>(longest, box.kind == "text" ? 1 : 3));
    const double right = x + static_cast<double>(columns) * kLetterWidth + 4;
    const double bottom = y + static_cast<double>(lines) * kLetterHeight + 5;
    if (box.kind == "text") return {x, y + 3, right, bottom - 2};
    return {x, y, right + (box.kind == "msg" ? 6 : 0), bottom};
}

double number(const Words& w, std::size_t i) {
    return i < w.size() ? std::stod(w[i]) : 0.0;
}

/// A label's place, from its word and the numbers behind it: dx, dy, font, size.
Rect label_place(double x, double y, const Words& w, std::size_t at) {
    if (at + 4 >= w.size() || w[at] == "empty") return {};
    const std::string text = shown({w[at]});
    const double size = number(w, at + 4);
    const double left = x + number(w, at + 1), middle = y + number(w, at + 2);
    return {left, middle - 0.6 * size, left + 0.62 * size * static_cast<double>(text.size()),
            middle + 0.6 * size};
}

/// The controls that Pd draws itself: their place, out of their words (obj X Y NAME ...).
bool control_place(const Words& w, PdBox& box) {
    const double x = number(w, 2), y = number(w, 3);
    const std::string& name = w[4];
    if (name == "bng" || name == "tgl") {
        const double size = number(w, 5);
        box.place = {x, y, x + size, y + size};
        box.label = label_place(x, y, w, name == "bng" ? 11 : 9);
    } else if (name == "hsl" || name == "vsl") {
        const bool flat = name == "hsl";
        const double wide = number(w, 5), high = number(w, 6);
        box.place =
            flat ? Rect{x - 3, y, x + wide + 2, y + high} : Rect{x, y - 2, x + wide, y + high + 3};
        box.label = label_place(x, y, w, 13);
    } else if (name == "hradio" || name == "vradio") {
        const double size = number(w, 5), all = size * number(w, 8);
        box.place =
            name == "hradio" ? Rect{x, y, x + all, y + size} : Rect{x, y, x + size, y + all};
        box.label = label_place(x, y, w, 11);
    } else if (name == "nbx") {
        const double high = number(w, 6), font = number(w, 17);
        box.place = {x, y, x + std::floor(font * 31 * number(w, 5) / 36) + high / 2 + 4, y + high};
        box.label = label_place(x, y, w, 13);
    } else if (name == "vu") {
        box.place = {x - 1, y - 2, x + number(w, 5) + 1, y + number(w, 6) + 2};
    } else if (name == "cnv") {
        box.place = {x, y, x + number(w, 6), y + number(w, 7)};
        box.label = label_place(x, y, w, 10);
    } else {
        return false;
    }
    return true;
}

class Reader {
  public:
    Reader(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders)
        : file_(file), folders_(folders) {
        folders_.insert(folders_.begin(), file.parent_path());
    }

    std::vector<PdWindow> read() {
        for (const auto& record : records_of(file_)) {
            take(record_words(record));
        }
        if (open_.size() != 1) throw std::runtime_error(file_.string() + ": no whole patch");
        done_.push_back(open_.back());
        return done_;
    }

  private:
    void take(const Words& w) {
        if (w.size() < 2) return;
        if (w[0] == "#N") {
            PdWindow window;
            window.name = open_.empty() ? file_.filename().string() : open_.back().name;
            window.width = number(w, 4);
            window.height = number(w, 5);
            if (!open_.empty()) window.name += " / " + w[6];
            open_.push_back(window);
        } else if (open_.empty()) {
            throw std::runtime_error(file_.string() + ": begins with no window");
        } else if (w[1] == "connect") {
            open_.back().connections.push_back(
                {static_cast<std::size_t>(number(w, 2)), static_cast<std::size_t>(number(w, 4))});
        } else if (w[1] == "coords") {
            PdWindow& window = open_.back();
            window.picture = number(w, 8) > 0;
            window.drawn = {0, 0, number(w, 6), number(w, 7)};
        } else if (w[1] == "restore") {
            close(w);
        } else if (w[0] == "#X" && w[1] != "declare" && w[1] != "array" && w[1] != "f") {
            open_.back().boxes.push_back(box_of(w));
        }
    }

    void close(const Words& w) {
        const PdWindow window = open_.back();
        open_.pop_back();
        if (open_.empty()) throw std::runtime_error(file_.string() + ": ends too early");
        done_.push_back(window);
        Words as_object = w;
        as_object[1] = "obj";
        PdBox box = box_of(as_object);
        if (window.picture) {
            box.kind = "graph";
            box.place = picture_place(box.place, window);
        }
        open_.back().boxes.push_back(box);
    }

    static Rect picture_place(const Rect& box, const PdWindow& window) {
        return {box.left, box.top, box.left + window.drawn.right, box.top + window.drawn.bottom};
    }

    PdBox box_of(Words w) const {
        PdBox box;
        box.kind = w[1];
        std::optional<std::size_t> columns;
        if (w.size() > 4 && w[w.size() - 2] == "f" && w[w.size() - 3].ends_with(',')) {
            columns = static_cast<std::size_t>(number(w, w.size() - 1));
            w.resize(w.size() - 2);
            w.back().pop_back();
        }
        const Words rest(w.begin() + 4, w.end());
        for (const auto& word : rest) box.raw += word + ' ';
        box.text = shown(rest);
        const double x = number(w, 2), y = number(w, 3);
        if (box.kind == "floatatom" || box.kind == "symbolatom" || box.kind == "listbox") {
            box.text.clear();
            box.place = {x, y, x + number(w, 4) * kLetterWidth + 4, y + kLetterHeight + 5};
        } else if (box.kind != "obj" || rest.empty() || !control_place(w, box)) {
            box.place = text_place(x, y, box, columns);
            if (const auto picture = abstraction(box)) {
                box.place = picture_place(box.place, *picture);
            }
        }
        return box;
    }

    /// The window of an abstraction that shows its inside.
    std::optional<PdWindow> abstraction(const PdBox& box) const {
        if (box.kind != "obj") return {};
        const std::string name = box.text.substr(0, box.text.find(' '));
        for (const auto& folder : folders_) {
            const auto path = folder / (name + ".pd");
            if (name.empty() || !std::filesystem::exists(path)) continue;
            const auto window = Reader(path, folders_).read().back();
            if (window.picture) return window;
        }
        return {};
    }

    std::filesystem::path file_;
    std::vector<std::filesystem::path> folders_;
    std::vector<PdWindow> open_, done_;
};

}  // namespace

std::vector<PdWindow> read_pd_patch(const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& folders) {
    return Reader(file, folders).read();
}

}  // namespace percussionist::test
