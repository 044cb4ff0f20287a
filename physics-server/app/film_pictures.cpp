#include "app/film_pictures.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "files/text_file.hpp"

extern char** environ;

namespace percussionist::app {

namespace {

/// Runs a program to its end. Throws std::runtime_error if it cannot be run or fails.
void run(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int error =
        posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environ);
    if (error != 0) throw std::runtime_error(words[0] + ": " + std::strerror(error));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (status != 0) throw std::runtime_error("the film could not be made");
}

}  // namespace

std::filesystem::path project_folder() {
    std::error_code none;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
    const auto installed = program.parent_path().parent_path() / PERCUSSIONIST_PD_FOLDER;
    return std::filesystem::exists(installed / "scripts", none) ? installed : PERCUSSIONIST_FOLDER;
}

void make_film(const std::filesystem::path& work, int pictures, int rate,
               const std::filesystem::path& film, const std::filesystem::path& project) {
    files::write_text(work / "size.txt", std::to_string(pictures));
    run({(project / "scripts" / "film-pictures").string(), work.string(), std::to_string(rate),
         film.string()});
}

}  // namespace percussionist::app
