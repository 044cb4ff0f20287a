#include "files/text_file.hpp"

#include <fstream>
#include <stdexcept>

namespace percussionist::files {

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace percussionist::files
