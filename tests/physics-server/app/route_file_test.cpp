#include "app/route_file.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace percussionist::app;
namespace fs = std::filesystem;

namespace {

const std::vector<std::pair<int, std::string>> kOne{{1, "status to 127.0.0.1:9000 /s load"}};
const std::vector<std::pair<int, std::string>> kOther{{1, "status to 127.0.0.1:9000 /s time"}};

/// A folder of its own, and another beside it that nobody may touch.
struct Folders {
    fs::path root = fs::temp_directory_path() / "percussionist-route-file";
    fs::path inside = root / "inside", outside = root / "outside";
    Folders() {
        fs::remove_all(root);
        fs::create_directories(inside);
        fs::create_directories(outside);
        std::ofstream(outside / "kept") << "as it was";
    }
    ~Folders() { fs::remove_all(root); }
    std::string kept() const {
        std::ifstream in(outside / "kept");
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

/// No file can grow, as on a full disk.
struct FullDisk {
    rlimit before{};
    void (*handler)(int);
    FullDisk() : handler(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before);
        const rlimit none{0, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &none);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, handler);
    }
};

}  // namespace

TEST_CASE("route file: only a plain name in the folder is written") {
    const Folders folders;
    for (const std::string name : {"../escape", "/tmp/escape", "a/b", ".", "", "a.b", "a b"}) {
        CAPTURE(name);
        CHECK_THROWS_AS(write_routes(folders.inside, name, kOne), std::runtime_error);
    }
    CHECK_THROWS_AS(write_routes(folders.inside, std::string(65, 'a'), kOne), std::runtime_error);
    CHECK(fs::is_empty(folders.inside));
}

TEST_CASE("route file: links that lead outside are replaced, not followed") {
    const Folders folders;
    for (const char* link : {"mine.routes", "mine.routes.new"}) {
        fs::create_symlink(folders.outside / "kept", folders.inside / link);
    }
    write_routes(folders.inside, "mine", kOne);
    CHECK(folders.kept() == "as it was");
    CHECK(read_routes(folders.inside / "mine.routes").at(0) == kOne[0].second);
    CHECK_FALSE(fs::exists(fs::symlink_status(folders.inside / "mine.routes.new")));
}

TEST_CASE("route file: on a full disk there is one clear error and what was there stays") {
    const Folders folders;
    write_routes(folders.inside, "mine", kOne);
    {
        const FullDisk full;
        CHECK_THROWS_WITH_AS(
            write_routes(folders.inside, "mine", kOther),
            ((folders.inside / "mine.routes").string() + ": cannot be written").c_str(),
            std::runtime_error);
    }
    CHECK(read_routes(folders.inside / "mine.routes").at(0) == kOne[0].second);
    CHECK_FALSE(fs::exists(folders.inside / "mine.routes.new"));
    write_routes(folders.inside, "mine", kOther);
    CHECK(read_routes(folders.inside / "mine.routes").at(0) == kOther[0].second);
}

TEST_CASE("route file: no more than a hundred files; those there can still be changed") {
    const Folders folders;
    for (int i = 0; i < 100; ++i) write_routes(folders.inside, "r" + std::to_string(i), kOne);
    CHECK_THROWS_AS(write_routes(folders.inside, "one-more", kOne), std::runtime_error);
    CHECK_NOTHROW(write_routes(folders.inside, "r7", kOther));
}
