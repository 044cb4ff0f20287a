// A zip archive in memory, for tests of readers.
#pragma once

#include <zip.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace percussionist::test {

inline std::vector<char> zip_of(const std::vector<std::pair<std::string, std::string>>& files) {
    zip_source_t* whole = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    zip_source_keep(whole);
    zip_t* archive = zip_open_from_source(whole, ZIP_TRUNCATE, nullptr);
    if (archive == nullptr) throw std::runtime_error("no archive");
    for (const auto& [name, content] : files) {
        zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
        zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    }
    if (zip_close(archive) != 0) throw std::runtime_error("archive not written");
    zip_stat_t stat;
    zip_source_stat(whole, &stat);
    std::vector<char> bytes(stat.size);
    zip_source_open(whole);
    zip_source_read(whole, bytes.data(), bytes.size());
    zip_source_close(whole);
    zip_source_free(whole);
    return bytes;
}

inline std::string container_of(const std::string& path) {
    return "<?xml version=\"1.0\"?><container><rootfiles><rootfile full-path=\"" + path +
           "\"/></rootfiles></container>";
}

}  // namespace percussionist::test
