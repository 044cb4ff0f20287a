#include "app/kit_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percussionist::app {

namespace {

using body::Vector3;

constexpr double kScale = 330.0;  // pixels a metre
constexpr double kWidth = 640, kHeight = 620;

/// One of the two views: where a point of the world is on paper, and how near it is.
struct View {
    double left;  ///< of the view on the paper
    bool above;
    [[nodiscard]] std::pair<double, double> at(const Vector3& p) const {
        if (above) return {left + kWidth / 2 - kScale * p.y(), kHeight - 120 - kScale * p.x()};
        return {left + kWidth / 2 + kScale * p.y(), kHeight - 40 - kScale * p.z()};
    }
    [[nodiscard]] double nearness(const Vector3& p) const { return above ? p.z() : p.x(); }
};

using Points = std::vector<std::pair<double, double>>;

struct Shape {
    double nearness;
    std::string svg;
};

class Drawing {
  public:
    explicit Drawing(const View& view) : view_(view) {}

    void add_object(const score::KitObject& object, const body::ObjectState& state) {
        const body::Quaternion turn = linear::quaternion_exp(state.turn) * object.orientation();
        const Vector3 up = turn * Vector3::UnitZ();
        const Vector3 middle = object.middle + state.lift * up;
        const bool metal = object.kind != score::ObjectKind::drum;
        if (object.depth > 0.0) {
            add_shell(middle, turn, object);
        }
        if (object.kind == score::ObjectKind::hi_hat) {
            add_disc(object.middle - 0.02 * up, turn, object.radius, "#b89a3c", 0.8);
        }
        const int flash = static_cast<int>(std::lround(255 * std::min(1.0, state.flash)));
        const std::string colour =
            metal ? fmt::format("#{:02x}{:02x}50", 205 + flash / 6, 175)
                  : fmt::format("#ff{:02x}{:02x}", 250 - flash / 2, 245 - flash);
        add_disc(middle, turn, object.radius, colour, metal ? 0.85 : 0.95);
    }

    void add_pedal(const score::Pedal& pedal, double up) {
        const double angle = pedal.down + up * (pedal.up - pedal.down);
        const Vector3 toe = pedal.heel + body::from_euler_zyx({pedal.direction, -angle, 0.0}) *
                                             Vector3(pedal.length, 0, 0);
        add_line(pedal.heel, toe, 0.08, "#606870");
    }

    void add_body(const body::Skeleton& skeleton, const body::Placement& placement) {
        for (int i = 0; i < skeleton.size(); ++i) {
            const body::Segment& s = skeleton.segments[i];
            const Vector3 end = placement.point(skeleton, i, s.end_rest);
            if (s.name.ends_with("stick")) {
                const Vector3 butt = placement.point(
                    skeleton, i, s.joint_rest - Vector3(skeleton.stick.held_at, 0, 0));
                add_line(butt, end, 0.016, "#8a5a20");
            } else if (s.name == "head") {
                add_ball(placement.com[i] + Vector3(0, 0, 0.02), 0.10, "#e8b890");
            } else if (s.name == "abdomen" || s.name == "chest" || s.name == "pelvis") {
                add_line(placement.joint[i], end, 0.26, "#4a6a9a");
            } else {
                const bool arm = s.name.ends_with("arm") || s.name.ends_with("hand");
                const bool left = s.name.starts_with("left");
                const double width = s.name.ends_with("thigh") ? 0.13 : arm ? 0.075 : 0.09;
                add_line(placement.joint[i], end, width,
                         arm ? (left ? "#d89870" : "#c87850") : (left ? "#40506a" : "#303c52"));
            }
        }
    }

    [[nodiscard]] std::string text() {
        std::stable_sort(shapes_.begin(), shapes_.end(),
                         [](const Shape& a, const Shape& b) { return a.nearness < b.nearness; });
        std::string all;
        for (const Shape& shape : shapes_) all += shape.svg;
        return all;
    }

  private:
    void add_disc(const Vector3& middle, const body::Quaternion& turn, double radius,
                  const std::string& colour, double opacity) {
        shapes_.push_back(
            {view_.nearness(middle),
             fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{}\" "
                         "stroke=\"#404040\" stroke-width=\"1.2\"/>\n",
                         text_of(circle_points(middle, turn, radius)), colour, opacity)});
    }

    [[nodiscard]] Points circle_points(const Vector3& middle, const body::Quaternion& turn,
                                       double radius) const {
        constexpr int kCorners = 40;
        Points points;
        for (int i = 0; i < kCorners; ++i) {
            const double a = 2 * std::numbers::pi * i / kCorners;
            points.push_back(
                view_.at(middle + turn * Vector3(radius * std::cos(a), radius * std::sin(a), 0)));
        }
        return points;
    }
    static std::string text_of(const Points& points) {
        std::string text;
        for (const auto& [x, y] : points) text += fmt::format("{:.1f},{:.1f} ", x, y);
        return text;
    }

    void add_shell(const Vector3& middle, const body::Quaternion& turn,
                   const score::KitObject& object) {
        const Vector3 bottom = middle - turn * Vector3(0, 0, object.depth);
        Points rim = circle_points(middle, turn, object.radius);
        const Points lower = circle_points(bottom, turn, object.radius);
        rim.insert(rim.end(), lower.begin(), lower.end());
        shapes_.push_back({std::min(view_.nearness(middle), view_.nearness(bottom)) - 0.001,
                           fmt::format("<polygon points=\"{}\" fill=\"#a03c34\" "
                                       "stroke=\"#602018\"/>\n",
                                       text_of(hull(std::move(rim))))});
        add_disc(bottom, turn, object.radius, "#803028", 1.0);
    }

    /// The convex hull (Andrew's monotone chain).
    static Points hull(Points points) {
        std::sort(points.begin(), points.end());
        Points around;
        for (const bool back : {false, true}) {
            const std::size_t start = around.size();
            for (const auto& p : points) {
                while (around.size() >= start + 2 && !turns(around, p)) around.pop_back();
                around.push_back(p);
            }
            around.pop_back();
            if (!back) std::reverse(points.begin(), points.end());
        }
        return around;
    }
    static bool turns(const Points& line, const std::pair<double, double>& p) {
        const auto& a = line[line.size() - 2];
        const auto& b = line.back();
        return (b.first - a.first) * (p.second - a.second) >
               (b.second - a.second) * (p.first - a.first);
    }

    void add_line(const Vector3& from, const Vector3& to, double width, const std::string& colour) {
        const auto [x1, y1] = view_.at(from);
        const auto [x2, y2] = view_.at(to);
        const Vector3 middle = 0.5 * (from + to);
        shapes_.push_back(
            {view_.nearness(middle),
             fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" "
                         "stroke=\"{}\" stroke-width=\"{:.1f}\" stroke-linecap=\"round\"/>\n",
                         x1, y1, x2, y2, colour, kScale * width)});
    }

    void add_ball(const Vector3& middle, double radius, const std::string& colour) {
        const auto [x, y] = view_.at(middle);
        shapes_.push_back(
            {view_.nearness(middle), fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" "
                                                 "fill=\"{}\" stroke=\"#604020\"/>\n",
                                                 x, y, kScale * radius, colour)});
    }

    View view_;
    std::vector<Shape> shapes_;
};

}  // namespace

std::string kit_picture(const score::Kit& kit, const body::Skeleton& skeleton,
                        const body::Placement& placement,
                        const std::vector<body::ObjectState>& states, const std::string& title) {
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\" font-family=\"sans-serif\" font-size=\"15\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"#f4f2ee\"/>\n",
        2 * kWidth, kHeight);
    for (const View& view : {View{0.0, false}, View{kWidth, true}}) {
        Drawing drawing(view);
        for (std::size_t o = 0; o < kit.objects.size(); ++o) {
            drawing.add_object(kit.objects[o], states[o]);
        }
        for (const score::Pedal& pedal : kit.pedals) {
            drawing.add_pedal(pedal, states[pedal.object].pedal);
        }
        drawing.add_body(skeleton, placement);
        text += drawing.text();
        text += fmt::format("<text x=\"{}\" y=\"24\">{}</text>\n", view.left + 16,
                            view.above ? "from above" : title + ", from the front");
    }
    return text + "</svg>\n";
}

}  // namespace percussionist::app
