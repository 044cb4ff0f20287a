#include "app/route_file.hpp"

#include <fstream>
#include <functional>
#include <stdexcept>

#include "app/named_file.hpp"
#include "files/text_file.hpp"
#include "osc/route.hpp"

namespace percussionist::app {

std::vector<std::string> read_routes(const std::filesystem::path& path) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error(path.string() + ": cannot be opened");
    std::vector<std::string> routes;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        try {
            osc::parse_route(line);
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error(path.string() + ": line " + std::to_string(number) + ": " +
                                     error.what());
        }
        routes.push_back(line);
    }
    return routes;
}

std::string write_routes(const std::filesystem::path& folder, const std::string& name,
                         const std::vector<std::pair<int, std::string>>& routes) {
    const std::filesystem::path path = named_file(folder, name, ".routes");
    require_room(path);
    std::string text;
    for (const auto& [number, line] : routes) text += line + '\n';
    files::replace_text(path, text);
    return path.filename().string();
}

void save_routes(Errand<std::string>& errand, const osc::Heard& wish,
                 const std::filesystem::path& folder, const std::string& name,
                 const std::vector<std::pair<int, std::string>>& routes) {
    errand.begin(
        wish, [folder, name, routes] { return write_routes(folder, name, routes); },
        std::identity());
}

}  // namespace percussionist::app
