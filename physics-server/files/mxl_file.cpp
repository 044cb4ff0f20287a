#include "files/mxl_file.hpp"

#include <zip.h>

#include <algorithm>
#include <array>
#include <memory>
#include <pugixml.hpp>
#include <string>

#include "files/musicxml_file.hpp"

namespace percussionist::files {

namespace {

struct Close {
    void operator()(zip_t* archive) const { zip_discard(archive); }
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, Close>;
using File = std::unique_ptr<zip_file_t, Close>;

constexpr const char* kContainer = "META-INF/container.xml";
constexpr std::size_t kLargestContainer = 65536;

class Mxl {
  public:
    Mxl(std::span<const char> bytes, std::string_view name) : name_(name) {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
        if (source != nullptr) archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
        const std::string reason = zip_error_strerror(&error);
        if (!archive_ && source != nullptr) zip_source_free(source);
        zip_error_fini(&error);
        if (!archive_) fail("expected a zip archive, found: " + reason);
    }

    /// The path that the container names first.
    [[nodiscard]] std::string score_path() const {
        const std::vector<char> container = read(kContainer, kLargestContainer);
        pugi::xml_document document;
        if (!document.load_buffer(container.data(), container.size())) {
            fail(std::string("expected XML in ") + kContainer);
        }
        const std::string path = document.child("container")
                                     .child("rootfiles")
                                     .child("rootfile")
                                     .attribute("full-path")
                                     .as_string();
        if (path.empty()) fail(std::string("expected a rootfile with full-path in ") + kContainer);
        return path;
    }

    [[nodiscard]] std::vector<char> read(const std::string& path, std::size_t most) const {
        const File file(zip_fopen(archive_.get(), path.c_str(), 0));
        if (!file) fail("expected " + path + " in it, found: " + zip_strerror(archive_.get()));
        std::vector<char> content;
        std::array<char, 16384> piece;
        while (true) {
            const zip_int64_t got = zip_fread(file.get(), piece.data(), piece.size());
            if (got < 0) fail(path + " in it is damaged");
            if (got == 0) return content;
            content.insert(content.end(), piece.begin(), piece.begin() + got);
            if (content.size() > most) {
                fail("expected at most " + std::to_string(most) + " bytes of " + path +
                     ", found more");
            }
        }
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw MusicXmlError(name_ + ": " + what);
    }

    std::string name_;
    Archive archive_;
};

}  // namespace

bool is_mxl(std::span<const char> bytes) {
    constexpr std::string_view kMark = "PK";
    return bytes.size() >= kMark.size() && std::equal(kMark.begin(), kMark.end(), bytes.begin());
}

std::vector<char> unpack_mxl(std::span<const char> bytes, std::string_view name, std::size_t most) {
    const Mxl archive(bytes, name);
    return archive.read(archive.score_path(), most);
}

}  // namespace percussionist::files
