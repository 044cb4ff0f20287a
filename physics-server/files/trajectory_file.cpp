#include "files/trajectory_file.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "files/text_lines.hpp"
#include "files/trajectory_columns.hpp"

namespace percussionist::files {

namespace {

using linear::Matrix3;
using linear::Quaternion;
using linear::Vector3;

constexpr std::uintmax_t kMostBytes = 256U << 20U;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// Nothing recorded is farther off [m].
constexpr double kFarthest = 1e3;

/// The cells of a line, blanks around them and quotation marks taken off; empty ones count.
void cells(std::string_view line, std::vector<std::string_view>& out) {
    const char* kSeparators[] = {",", ";", "\t"};
    for (const char* separator : kSeparators) {
        if (line.find(separator) == std::string_view::npos) continue;
        out.clear();
        while (true) {
            const std::size_t end = line.find(separator);
            std::string_view cell = trimmed(line.substr(0, end));
            if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
                cell = cell.substr(1, cell.size() - 2);
            }
            out.push_back(cell);
            if (end == std::string_view::npos) return;
            line.remove_prefix(end + 1);
        }
    }
    split(line, " ", out);
}

struct Row {
    int line = 0;
    std::vector<double> values;
};

class TrajectoryReader {
  public:
    TrajectoryReader(std::string_view text, std::string_view name, const TrajectoryOptions& options)
        : lines_(text), name_(name), options_(options) {}

    std::vector<motion::Trajectory> read() {
        read_rows();
        choose_columns();
        std::vector<motion::Trajectory> paths;
        for (const PathColumns& path : columns_.paths) paths.push_back(make_path(path));
        return paths;
    }

  private:
    [[noreturn]] void fail(int line, const std::string& expected, const std::string& got) const {
        throw TrajectoryError(std::string(name_) + ": line " + std::to_string(line) +
                              ": expected " + expected + ", got " + got);
    }

    /// Numbers, where a gap is NaN; nothing if a cell is neither.
    static bool numbers(const std::vector<std::string_view>& cells, std::vector<double>& values,
                        std::string_view& culprit) {
        values.clear();
        for (const std::string_view cell : cells) {
            const auto value = cell.empty() ? std::optional(kNone) : number_in(cell);
            if (!value) {
                culprit = cell;
                return false;
            }
            values.push_back(*value);
        }
        return true;
    }

    void read_rows() {
        std::vector<std::string_view> row_cells;
        std::vector<double> values;
        while (const auto line = lines_.next()) {
            if (trimmed(*line).empty()) continue;
            cells(*line, row_cells);
            std::string_view culprit;
            const bool numeric = numbers(row_cells, values, culprit);
            const auto finite = std::count_if(values.begin(), values.end(),
                                              [](double v) { return std::isfinite(v); });
            constexpr int kFewest = 4;
            if (rows_.empty() && (!numeric || finite < kFewest)) {
                if (!numeric) header(row_cells);
                continue;
            }
            if (!numeric) fail(lines_.number(), "a number", in_quotes(culprit));
            if (finite > 0) rows_.push_back({lines_.number(), values});
        }
        if (rows_.size() < 2) {
            fail(lines_.number(), "at least two lines of 4 or more numbers",
                 std::to_string(rows_.size()));
        }
    }

    void header(const std::vector<std::string_view>& row_cells) {
        const bool units =
            !names_.empty() && std::any_of(row_cells.begin(), row_cells.end(),
                                           [](auto c) { return unit_named(c).has_value(); });
        // The last line of several words names the columns, a line of units under it theirs.
        if (units) {
            units_ = row_cells;
        } else if (row_cells.size() > 3) {
            names_ = row_cells;
            units_.clear();
        }
    }

    void choose_columns() {
        if (const auto named = columns_named(names_, units_)) {
            columns_ = *named;
            return;
        }
        std::size_t count = 0;
        for (const Row& row : rows_) count = std::max(count, row.values.size());
        // Frames are counted in ones; times are in fractions.
        std::size_t ones = 0;
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            const double step = rows_[i].values[0] - rows_[i - 1].values[0];
            if (step == std::floor(step) && rows_[i].values[0] == std::floor(rows_[i].values[0])) {
                ++ones;
            }
        }
        const bool frames = 2 * ones > rows_.size() - 1 && count > 4;
        const auto counted = columns_counted(count, frames);
        if (!counted) {
            fail(rows_.front().line,
                 "columns named in a header, or 4, 7, 8 or 13 of them (time or frame first)",
                 std::to_string(count));
        }
        columns_ = *counted;
    }

    static double cell(const Row& row, int column) {
        return column < static_cast<int>(row.values.size()) ? row.values[column] : kNone;
    }

    [[nodiscard]] double time_of(const Row& row) const {
        const double value = cell(row, columns_.time);
        return columns_.counts_frames ? value / options_.rate : value * columns_.time_unit;
    }

    motion::Trajectory make_path(const PathColumns& path) const {
        motion::Trajectory out;
        out.name = name_;
        out.has_rotation = !path.rotation.empty();
        int gaps = 0;
        int backwards = 0;
        Quaternion last = Quaternion::Identity();
        for (const Row& row : rows_) {
            motion::TrajectorySample sample;
            sample.time = time_of(row);
            for (int a = 0; a < 3; ++a) {
                sample.position[a] = path.length_unit * cell(row, path.position[a]);
            }
            if (!std::isfinite(sample.time) || !(sample.position.norm() < kFarthest)) {
                ++gaps;
                continue;
            }
            if (!out.samples.empty() && sample.time <= out.samples.back().time) {
                ++backwards;
                continue;
            }
            last = rotation_of(row, path, last);
            sample.rotation = last;
            sample.position += last * options_.tip_offset;
            out.samples.push_back(sample);
        }
        if (out.samples.size() < 2) {
            fail(rows_.back().line, "at least two samples with a time and a position",
                 std::to_string(out.samples.size()));
        }
        const auto warn = [&](int count, const char* what) {
            if (count == 0) return;
            out.warnings.push_back(std::string(name_) + ": " + std::to_string(count) + what);
        };
        warn(gaps, " samples are missing or no positions; bridged");
        warn(backwards, " samples are no later than those before; left out");
        const double start = out.samples.front().time;
        for (motion::TrajectorySample& sample : out.samples) sample.time -= start;
        return out;
    }

    /// The rotation in a row, or `last` if there is none.
    static Quaternion rotation_of(const Row& row, const PathColumns& path, const Quaternion& last) {
        std::array<double, 9> v{};
        for (std::size_t i = 0; i < path.rotation.size(); ++i) {
            v[i] = cell(row, path.rotation[i]);
            if (!(std::abs(v[i]) < 1e6)) return last;
        }
        if (path.rotation.size() == 3) {
            return linear::quaternion_exp(path.angle_unit * Vector3(v[0], v[1], v[2]));
        }
        if (path.rotation.size() == 4) {
            const Quaternion q(v[0], v[1], v[2], v[3]);
            return q.norm() > 0.1 ? q.normalized() : last;
        }
        if (path.rotation.size() == 9) {
            Matrix3 m;
            m << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
            const Eigen::JacobiSVD<Matrix3> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
            const Matrix3 r = svd.matrixU() * svd.matrixV().transpose();
            return r.determinant() > 0.0 ? Quaternion(r) : last;
        }
        return last;
    }

    LineReader lines_;
    std::string_view name_;
    const TrajectoryOptions& options_;
    std::vector<std::string_view> names_, units_;
    std::vector<Row> rows_;
    TableColumns columns_;
};

}  // namespace

std::vector<motion::Trajectory> parse_trajectories(std::string_view text, std::string_view name,
                                                   const TrajectoryOptions& options) {
    return TrajectoryReader(text, name, options).read();
}

std::vector<motion::Trajectory> read_trajectory_file(const std::filesystem::path& path,
                                                     const TrajectoryOptions& options) {
    return parse_trajectories(read_text<TrajectoryError>(path, kMostBytes),
                              path.filename().string(), options);
}

}  // namespace percussionist::files
