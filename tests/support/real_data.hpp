// Real material for tests, which is no part of the project: in the folder that the environment
// variable PERCUSSIONIST_DATA names, or beside the project in ../shared/data.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace percussionist::test {

/// The files in a folder of the material, in order; none, with a message, where it is missing.
inline std::vector<std::filesystem::path> real_files(const std::string& folder,
                                                     const std::string& extension) {
    const char* named = std::getenv("PERCUSSIONIST_DATA");
    const std::filesystem::path root =
        named != nullptr ? std::filesystem::path(named)
                         : std::filesystem::path(PROJECT_FOLDER) / ".." / "shared" / "data";
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(root / folder, missing)) {
        if (entry.path().extension() == extension) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    if (files.empty()) {
        MESSAGE("skipped: no " << extension << " files in " << (root / folder).string());
    }
    return files;
}

}  // namespace percussionist::test
