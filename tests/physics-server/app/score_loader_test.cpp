#include "app/score_loader.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace percussionist::app;
namespace fs = std::filesystem;

TEST_CASE(
    "score loader: a file inside the folder is found, nothing outside of it, nor what is no "
    "file") {
    const fs::path root = fs::temp_directory_path() / "percussionist-score-folder";
    fs::remove_all(root);
    const fs::path folder = root / "scores";
    fs::create_directories(folder / "more");
    fs::create_directories(root / "scores-not");  // begins with the folder's name
    for (const fs::path& file : {folder / "a.mid", folder / "more/b.mid", root / "secret.mid",
                                 root / "scores-not/c.mid"}) {
        std::ofstream(file) << "x";
    }
    fs::create_symlink(folder / "a.mid", folder / "good-link.mid");
    fs::create_symlink(root / "secret.mid", folder / "link.mid");
    fs::create_directory_symlink(root, folder / "up");
    REQUIRE(mkfifo((folder / "pipe.mid").c_str(), 0600) == 0);

    CHECK(score_in_folder(folder, "built-in").empty());
    for (const char* name : {"a.mid", "more/b.mid", "more/../a.mid", "good-link.mid"}) {
        CAPTURE(name);
        CHECK_NOTHROW(score_in_folder(folder, name));
    }
    const std::string absolute = (root / "secret.mid").string();
    for (const std::string name :
         {"../secret.mid", "more/../../secret.mid", "link.mid", "up/secret.mid",
          "../scores-not/c.mid", "nowhere.mid", "pipe.mid", "more", ".", "/dev/zero", "/etc/passwd",
          absolute.c_str()}) {
        CAPTURE(name);
        CHECK_THROWS_AS(score_in_folder(folder, name), std::runtime_error);
    }
    fs::remove_all(root);
}
