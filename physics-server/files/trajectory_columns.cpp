#include "files/trajectory_columns.hpp"

#include <cctype>
#include <numbers>
#include <utility>

namespace percussionist::files {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMillimetre = 1e-3;

enum class Side { none, left, right };

/// A name taken apart: "left_x_mm" is the left side's x in millimetres.
struct ColumnName {
    std::string base;  ///< small letters and digits only
    Side side = Side::none;
    std::optional<double> unit;
};

std::string small_letters(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0) out += static_cast<char>(std::tolower(byte));
    }
    return out;
}

ColumnName take_apart(std::string_view name) {
    ColumnName out;
    // A unit is the last word, in brackets or not: "x (mm)", "x[mm]", "x_mm".
    const std::size_t before = name.find_last_of("([_ ");
    if (before != std::string_view::npos) {
        out.unit = unit_named(small_letters(name.substr(before)));
        if (out.unit) name = name.substr(0, before);
    }
    out.base = small_letters(name);
    for (const auto& [side, word] : {std::pair{Side::left, std::string_view("left")},
                                     std::pair{Side::right, std::string_view("right")}}) {
        const std::size_t at = out.base.find(word);
        if (at == std::string::npos) continue;
        out.side = side;
        out.base.erase(at, word.size());
    }
    return out;
}

/// 0, 1 or 2 if `base` is one of these followed by x, y or z.
template <std::size_t N>
std::optional<int> axis_after(std::string_view base, const std::array<std::string_view, N>& stems,
                              bool whole) {
    if (base.empty() || base.back() < 'x' || base.back() > 'z') return std::nullopt;
    const int axis = base.back() - 'x';
    base.remove_suffix(1);
    for (const std::string_view stem : stems) {
        if (whole ? base == stem : base.ends_with(stem)) return axis;
    }
    return std::nullopt;
}

std::optional<int> position_axis(std::string_view base) {
    static constexpr std::array<std::string_view, 4> kShort{"", "p", "t", "tip"};
    static constexpr std::array<std::string_view, 4> kLong{"position", "pos", "translation",
                                                           "tran"};
    const auto axis = axis_after(base, kShort, true);
    return axis ? axis : axis_after(base, kLong, false);
}

std::optional<int> rotation_axis(std::string_view base) {
    static constexpr std::array<std::string_view, 3> kShort{"r", "a", "w"};
    static constexpr std::array<std::string_view, 3> kLong{"rotation", "rot", "angle"};
    const auto axis = axis_after(base, kShort, true);
    return axis ? axis : axis_after(base, kLong, false);
}

std::optional<int> quaternion_index(std::string_view base) {
    static constexpr std::string_view kNames = "wxyz";
    if (base.size() != 2 || base[0] != 'q') return std::nullopt;
    const std::size_t at = kNames.find(base[1]);
    return at == std::string_view::npos ? std::nullopt : std::optional(static_cast<int>(at));
}

std::optional<int> matrix_index(std::string_view base) {
    if (base.size() != 3 || base[0] != 'm') return std::nullopt;
    const int row = base[1] - '0';
    const int column = base[2] - '0';
    if (row < 0 || row > 2 || column < 0 || column > 2) return std::nullopt;
    return 3 * row + column;
}

/// The columns of one side while they are found.
struct Found {
    PathColumns path;
    std::array<int, 3> vector{-1, -1, -1};
    std::array<int, 4> quaternion{-1, -1, -1, -1};
    std::array<int, 9> matrix{-1, -1, -1, -1, -1, -1, -1, -1, -1};
    std::optional<double> length_unit, angle_unit;

    void take(const ColumnName& name, int column) {
        if (const auto axis = position_axis(name.base)) {
            path.position[*axis] = column;
            if (name.unit) length_unit = name.unit;
        } else if (const auto turn = rotation_axis(name.base)) {
            vector[*turn] = column;
            if (name.unit) angle_unit = name.unit;
        } else if (const auto q = quaternion_index(name.base)) {
            quaternion[*q] = column;
        } else if (const auto m = matrix_index(name.base)) {
            matrix[*m] = column;
        }
    }

    [[nodiscard]] PathColumns finished(bool counts_frames) const {
        PathColumns out = path;
        out.length_unit = length_unit.value_or(counts_frames ? kMillimetre : 1.0);
        out.angle_unit = angle_unit.value_or(counts_frames ? kDegree : 1.0);
        const auto take_all = [&out](const auto& columns) {
            for (const int c : columns) {
                if (c < 0) return;
            }
            out.rotation.assign(columns.begin(), columns.end());
        };
        take_all(matrix);
        take_all(quaternion);
        take_all(vector);
        return out;
    }
};

}  // namespace

std::optional<double> unit_named(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, double>, 11> kUnits{
        {{"m", 1.0},
         {"cm", 1e-2},
         {"mm", kMillimetre},
         {"in", 0.0254},
         {"inch", 0.0254},
         {"s", 1.0},
         {"ms", 1e-3},
         {"us", 1e-6},
         {"rad", 1.0},
         {"deg", kDegree},
         {"degrees", kDegree}}};
    for (const auto& [unit, size] : kUnits) {
        if (name == unit) return size;
    }
    return std::nullopt;
}

std::optional<TableColumns> columns_named(const std::vector<std::string_view>& names,
                                          const std::vector<std::string_view>& units) {
    TableColumns table;
    std::array<Found, 3> sides;
    for (std::size_t i = 0; i < names.size(); ++i) {
        ColumnName name = take_apart(names[i]);
        if (!name.unit && i < units.size()) name.unit = unit_named(small_letters(units[i]));
        const int column = static_cast<int>(i);
        if (name.base == "t" || name.base == "time" || name.base == "seconds") {
            table.time = column;
            table.counts_frames = false;
            table.time_unit = name.unit.value_or(1.0);
        } else if (name.base.starts_with("frame") && table.time < 0) {
            table.time = column;
            table.counts_frames = true;
        } else {
            sides[static_cast<std::size_t>(name.side)].take(name, column);
        }
    }
    for (const Found& side : sides) {
        if (side.path.complete()) table.paths.push_back(side.finished(table.counts_frames));
    }
    if (table.time < 0 || table.paths.empty()) return std::nullopt;
    return table;
}

std::optional<TableColumns> columns_counted(std::size_t count, bool counts_frames) {
    TableColumns table;
    table.time = 0;
    table.counts_frames = counts_frames;
    const auto path = [&](int rotation, int rotations, int position) {
        PathColumns p;
        for (int i = 0; i < rotations; ++i) p.rotation.push_back(rotation + i);
        p.position = {position, position + 1, position + 2};
        if (counts_frames) {
            p.length_unit = kMillimetre;
            p.angle_unit = kDegree;
        }
        table.paths.push_back(p);
    };
    if (counts_frames) {
        if (count == 7) {
            path(1, 3, 4);
        } else if (count == 8) {  // a column of sub-frames beside the frames
            path(2, 3, 5);
        } else if (count == 13) {
            path(1, 3, 4);
            path(7, 3, 10);
        } else {
            return std::nullopt;
        }
        return table;
    }
    if (count == 4) {
        path(0, 0, 1);
    } else if (count == 7 || count == 8 || count == 13) {
        path(4, static_cast<int>(count) - 4, 1);
    } else {
        return std::nullopt;
    }
    return table;
}

}  // namespace percussionist::files
