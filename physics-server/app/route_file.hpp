// Routes in a file: one a line, as osc/route.hpp has them; empty lines and what follows # are
// passed over.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/errand.hpp"

namespace percussionist::app {

/// Throws std::runtime_error naming file and line.
std::vector<std::string> read_routes(const std::filesystem::path& path);

/// Writes NAME.routes into `folder` and returns that name. Throws std::runtime_error if NAME is no
/// plain name (letters, digits, - and _) or the file cannot be written; what was in it stays then.
std::string write_routes(const std::filesystem::path& folder, const std::string& name,
                         const std::vector<std::pair<int, std::string>>& routes);

/// The same by an errand. Throws as Errand::begin().
void save_routes(Errand<std::string>& errand, const osc::Heard& wish,
                 const std::filesystem::path& folder, const std::string& name,
                 const std::vector<std::pair<int, std::string>>& routes);

}  // namespace percussionist::app
