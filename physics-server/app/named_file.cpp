#include "app/named_file.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace percussionist::app {

std::filesystem::path named_file(const std::filesystem::path& folder, const std::string& name,
                                 const std::string& ending) {
    constexpr std::size_t kLongest = 64;
    const bool plain = !name.empty() && name.size() <= kLongest &&
                       std::all_of(name.begin(), name.end(), [](unsigned char c) {
                           return std::isalnum(c) != 0 || c == '-' || c == '_';
                       });
    if (!plain) {
        throw std::runtime_error("expected a name of letters, digits, - and _, got '" +
                                 name.substr(0, kLongest) + "'");
    }
    return folder / (name + ending);
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

void require_room(const std::filesystem::path& path) {
    constexpr std::ptrdiff_t kMostFiles = 100;
    if (std::filesystem::exists(path)) return;
    const std::filesystem::path folder = folder_of(path), ending = path.extension();
    std::error_code error;
    const std::filesystem::directory_iterator entries(folder, error);
    const auto there = std::count_if(begin(entries), end(entries), [&](const auto& entry) {
        return entry.path().extension() == ending;
    });
    if (there >= kMostFiles) {
        throw std::runtime_error(folder.string() + ": holds 100 files *" + ending.string() +
                                 " already");
    }
}

}  // namespace percussionist::app
