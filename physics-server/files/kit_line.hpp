// One line of a kit file, word by word: what is not as expected is an error that names the line.
#pragma once

#include <functional>
#include <initializer_list>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/linear/rotation.hpp"
#include "files/kit_file.hpp"
#include "files/text_lines.hpp"

namespace percussionist::files {

class KitLine {
  public:
    /// A field of a line: its name, and what reads the words after it.
    struct Field {
        std::string_view name;
        std::function<void()> read;
    };

    KitLine(std::string_view file, int number, std::vector<std::string_view> words)
        : file_(file), number_(number), words_(std::move(words)) {}

    [[nodiscard]] bool done() const { return next_ == words_.size(); }
    [[nodiscard]] KitError error(const std::string& what) const {
        return KitError(std::string(file_) + ": line " + std::to_string(number_) + ": " + what);
    }
    /// "expected ..., found ...", at the word that comes next.
    [[nodiscard]] KitError expected(const std::string& what) const {
        return error("expected " + what + ", found " +
                     (done() ? "the end of the line" : in_quotes(words_[next_])));
    }
    std::string_view word(const std::string& what) {
        if (done()) throw expected(what);
        return words_[next_++];
    }
    /// Which of the names comes.
    std::size_t choice(std::span<const std::string_view> names) {
        for (std::size_t i = 0; !done() && i < names.size(); ++i) {
            if (words_[next_] == names[i]) return ++next_, i;
        }
        std::string all;
        for (const std::string_view name : names)
            all += (all.empty() ? "" : ", ") + std::string(name);
        throw expected("one of " + all);
    }
    /// The next word if it is this one.
    bool comes(std::string_view name) {
        if (done() || words_[next_] != name) return false;
        ++next_;
        return true;
    }
    [[nodiscard]] bool number_comes() const { return !done() && number_in(words_[next_]); }
    double number() {
        const std::string after = next_ > 0 ? std::string(words_[next_ - 1]) : "";
        const auto value = done() ? std::nullopt : number_in(words_[next_]);
        if (!value || !std::isfinite(*value)) throw expected("a number after '" + after + "'");
        ++next_;
        return *value;
    }
    double degrees() { return number() * std::numbers::pi / 180.0; }
    linear::Vector3 vector() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    /// The rest of the line: fields in any order.
    void fields(std::initializer_list<Field> table) {
        std::vector<std::string_view> names;
        for (const Field& field : table) names.push_back(field.name);
        while (!done()) (table.begin() + choice(names))->read();
    }

  private:
    std::string_view file_;
    int number_;
    std::vector<std::string_view> words_;
    std::size_t next_ = 0;
};

}  // namespace percussionist::files
