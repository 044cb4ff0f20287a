#include "app/performance_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "core/listening/median.hpp"

namespace percussionist::app {

namespace {

/// Columns of the file that are read back.
constexpr std::size_t kStrokeColumn = 1, kAskedColumn = 4;

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> all;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) all.push_back(cell);
    return all;
}

double number(const std::string& cell, const std::string& place) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    if (end == cell.c_str() || *end != '\0') {
        throw std::runtime_error(place + ": expected a number, got '" + cell + "'");
    }
    return value;
}

}  // namespace

TimingSummary PerformanceLog::summary(int asked) const {
    TimingSummary s;
    s.strokes = asked;
    std::set<int> struck;
    std::vector<double> errors;
    for (const LoggedContact& c : contacts_) {
        if (c.stroke < 0 || !struck.insert(c.stroke).second) {
            ++s.uncalled;
        } else {
            errors.push_back(c.event.instant - c.asked_time);
        }
    }
    s.contacts = static_cast<int>(errors.size());
    s.missed = asked - s.contacts;
    s.offset = listening::median(errors);
    for (double& e : errors) {
        e = std::abs(e - s.offset);
        s.worst_error = std::max(s.worst_error, e);
    }
    s.median_error = listening::median(errors);
    return s;
}

void PerformanceLog::write_csv(const std::filesystem::path& path) const {
    std::ofstream out(path);
    out << "sequence,stroke,hand,drum,asked_s,asked_m_s,instant_s,x_m,y_m,r_m,theta_rad,vx_m_s,vy_"
           "m_s,"
           "vz_m_s,fx_N,fy_N,fz_N,impulse_N_s,duration_s,effective_mass_kg,recontact\n";
    for (const LoggedContact& c : contacts_) {
        const sim::ContactEvent& e = c.event;
        out << fmt::format(
            "{},{},{},{},{:.9f},{:.6f},{:.9f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:."
            "4f},"
            "{:.4f},{:.4f},{:.8f},{:.7f},{:.6f},{}\n",
            c.sequence, c.stroke, e.hand == body::Hand::left ? "left" : "right", e.drum,
            c.asked_time, c.asked_speed, e.instant, e.place.x(), e.place.y(),
            std::hypot(e.place.x(), e.place.y()), std::atan2(e.place.y(), e.place.x()),
            e.velocity.x(), e.velocity.y(), e.velocity.z(), e.peak_force.x(), e.peak_force.y(),
            e.peak_force.z(), e.impulse, e.duration, e.effective_mass, e.recontact ? 1 : 0);
    }
    out.flush();
    if (!out) throw std::runtime_error(path.string() + ": could not be written");
}

std::vector<double> read_asked_times(const std::filesystem::path& path) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error(path.string() + ": cannot be opened");
    std::string line;
    std::getline(in, line);
    std::map<int, double> asked;
    for (int row = 2; std::getline(in, line); ++row) {
        const std::string place = path.string() + ": line " + std::to_string(row);
        const std::vector<std::string> values = cells(line);
        if (values.size() <= kAskedColumn) {
            throw std::runtime_error(place + ": expected a line as this program writes it");
        }
        const int stroke = static_cast<int>(number(values[kStrokeColumn], place));
        if (stroke >= 0) asked.emplace(stroke, number(values[kAskedColumn], place));
    }
    std::vector<double> times;
    for (const auto& [stroke, time] : asked) times.push_back(time);
    std::sort(times.begin(), times.end());
    return times;
}

std::string describe(const TimingSummary& s) {
    std::string text = fmt::format(
        "strokes asked for  {}\n"
        "contacts made      {}\n"
        "contact timing     median {:.3f} ms, worst {:.3f} ms (after a constant {:+.3f} ms)\n",
        s.strokes, s.contacts, 1e3 * s.median_error, 1e3 * s.worst_error, 1e3 * s.offset);
    if (s.missed > 0) text += fmt::format("strokes missed     {}\n", s.missed);
    if (s.uncalled > 0) text += fmt::format("contacts uncalled  {}\n", s.uncalled);
    return text;
}

}  // namespace percussionist::app
