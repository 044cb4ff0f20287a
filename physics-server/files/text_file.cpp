#include "files/text_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>

namespace percussionist::files {

namespace {

int open_new(const std::filesystem::path& path) {
    constexpr int kForAllToRead = 0644;
    return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kForAllToRead);
}

bool write_all(int handle, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t wrote = write(handle, text.data() + done, text.size() - done);
        if (wrote <= 0) return false;
        done += static_cast<std::size_t>(wrote);
    }
    return true;
}

}  // namespace

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

void replace_text(const std::filesystem::path& path, const std::string& text) {
    const std::filesystem::path fresh = path.string() + ".new";
    std::error_code error;
    std::filesystem::remove(fresh, error);
    const int handle = open_new(fresh);
    const bool written = handle >= 0 && write_all(handle, text) && fsync(handle) == 0;
    if (handle >= 0) close(handle);
    if (written) std::filesystem::rename(fresh, path, error);
    if (!written || error) {
        std::filesystem::remove(fresh, error);
        throw std::runtime_error(path.string() + ": cannot be written");
    }
}

void create_new(const std::filesystem::path& path) {
    const int handle = open_new(path);
    if (handle < 0) {
        throw std::runtime_error(path.string() +
                                 (errno == EEXIST ? ": is there already" : ": cannot be written"));
    }
    close(handle);
}

}  // namespace percussionist::files
