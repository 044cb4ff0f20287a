// [fastrak~ DEVICE BAUD]: a Polhemus FASTRAK; see io/fastrak_tracker.hpp and core/motion.
#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "core/linear/euler.hpp"
#include "core/motion/pose_table.hpp"
#include "core/motion/pose_trail.hpp"
#include "io/clock_map.hpp"
#include "io/fastrak_tracker.hpp"
#include "pdx/object.hpp"

namespace {

using namespace percussionist::pdx;
namespace io = percussionist::io;
namespace linear = percussionist::linear;
namespace motion = percussionist::motion;
using motion::Vector3;

constexpr std::size_t kPoseOutlet = 3, kStatusOutlet = 4;
constexpr double kPoll = 2e-3;     // [s]
constexpr double kFarAhead = 1.0;  // [s]: no pose is; the clocks have been set anew

class Fastrak : public Object {
  public:
    Fastrak(Box& box, const Arguments& creation)
        : Object(box), poll_(*this, [this] { poll(); }), due_(*this, [this] { send_due(); }) {
        if (*creation.word(0) != '\0') {
            open(creation);
        }
        poll_.delay(0);
    }

    void open(const Arguments& a) {
        io::TrackerOrder order;
        order.kind = io::TrackerOrder::Kind::kOpen;
        order.text = io::fixed_text<sizeof(io::PathText)>(a.word(0));
        order.baud = a.integer(1);
        give(order);
        settle();
    }
    void close(const Arguments&) { order(io::TrackerOrder::Kind::kClose); }
    void devices(const Arguments&) { order(io::TrackerOrder::Kind::kDevices); }

    void station(const Arguments& a) {
        station_ = a.integer(0);
        trail_.clear();
    }
    void delay(const Arguments& a) { delay_ = a.number(0); }

    void stations(const Arguments& a) {
        decltype(settings_.wanted) wanted{};
        for (const Atom& atom : a.atoms()) {
            const double* const number = std::get_if<double>(&atom);
            if (!number || !(*number >= 1 && *number <= motion::kFastrakStations)) {
                throw std::invalid_argument("expected numbers from 1 to 4, got " + to_string(atom));
            }
            wanted.at(static_cast<std::size_t>(*number) - 1) = true;
        }
        settings_.wanted = wanted;
        settle();
    }
    void format(const Arguments& a) {
        settings_.encoding =
            choose<motion::Encoding>(a.word(0), {{"ascii", motion::Encoding::kAscii},
                                                 {"float32", motion::Encoding::kFloat32},
                                                 {"16bit", motion::Encoding::k16Bit}});
        settle();
    }
    void attitude(const Arguments& a) {
        settings_.attitude =
            choose<motion::Attitude>(a.word(0), {{"quaternion", motion::Attitude::kQuaternion},
                                                 {"euler", motion::Attitude::kEuler},
                                                 {"cosines", motion::Attitude::kCosines}});
        settle();
    }
    void twice(const Arguments& a) {
        settings_.twice = a.number(0) != 0.0;
        settle();
    }
    void hemisphere(const Arguments& a) {
        at(a).hemisphere = vector(a, 1);
        settle();
    }
    void tip(const Arguments& a) {
        at(a).tip = vector(a, 1);
        settle();
    }
    void align(const Arguments& a) {
        if (a.has(1) && !a.has(9)) {
            throw std::invalid_argument(
                "expected nine numbers [m]: origin, a point on x, one on y");
        }
        std::optional<motion::Alignment> frame;
        if (a.has(9)) {
            frame = {vector(a, 1), vector(a, 4), vector(a, 7)};
            const Vector3 x = frame->on_x - frame->origin, y = frame->on_y - frame->origin;
            if (!(x.cross(y).norm() > 1e-6)) {
                throw std::invalid_argument("expected three points that are not on one line");
            }
        }
        at(a).alignment = frame;
        settle();
    }
    void boresight(const Arguments& a) {
        turn(a, linear::to_quaternion({a.number(1), a.number(2), a.number(3)}));
    }
    void unboresight(const Arguments& a) { turn(a, std::nullopt); }
    void filter(const Arguments& a) {
        auto& filter = *choose<std::optional<motion::Filter>*>(
            a.word(0),
            {{"position", &settings_.position_filter}, {"attitude", &settings_.attitude_filter}});
        filter.reset();
        if (a.has(1)) {
            filter = {a.number(1), a.number(2), a.number(3), a.number(4)};
        }
        settle();
    }
    void reset(const Arguments&) { command("\x19"); }

    void record(const Arguments& a) { order(io::TrackerOrder::Kind::kRecord, path_of(a.word(0))); }
    void play(const Arguments& a) { order(io::TrackerOrder::Kind::kPlay, find_file(a.word(0))); }
    void stop(const Arguments&) { order(io::TrackerOrder::Kind::kStop); }

    /// The signals are as late as the messages and one record more, to have one on either side.
    void process(const Block& block) noexcept override {
        const double late = delay_ + spacing_;
        for (std::size_t i = 0; i < block.size; ++i) {
            const double time = block.start + static_cast<double>(i) / block.sample_rate - late;
            const Vector3 position = trail_.position(time);
            for (int axis = 0; axis < 3; ++axis) {
                block.outputs[static_cast<std::size_t>(axis)][i] =
                    static_cast<Sample>(position[axis]);
            }
        }
    }

  private:
    template <class T>
    static T choose(const std::string& word,
                    std::initializer_list<std::pair<const char*, T>> choices) {
        std::string names;
        for (const auto& [name, value] : choices) {
            if (word == name) {
                return value;
            }
            names += (names.empty() ? "" : ", ") + std::string(name);
        }
        throw std::invalid_argument("expected one of " + names + ", got " + word);
    }
    static Vector3 vector(const Arguments& a, std::size_t first) {
        return {a.number(first), a.number(first + 1), a.number(first + 2)};
    }
    motion::StationSettings& at(const Arguments& a) {
        return settings_.stations.at(static_cast<std::size_t>(a.integer(0)) - 1);
    }

    void give(const io::TrackerOrder& order) {
        if (!tracker_.order(order)) {
            throw std::runtime_error("too much at once for the unit");
        }
    }
    void order(io::TrackerOrder::Kind kind, const std::string& text = "") {
        io::TrackerOrder order;
        order.kind = kind;
        order.text = io::fixed_text<sizeof(io::PathText)>(text);
        order.settings = settings_;
        give(order);
    }
    void turn(const Arguments& a, const std::optional<linear::Quaternion>& shown) {
        io::TrackerOrder order;
        order.kind = io::TrackerOrder::Kind::kBoresight;
        order.station = a.integer(0);
        order.shown = shown;
        give(order);
    }
    void settle() { order(io::TrackerOrder::Kind::kSettings); }
    void command(const std::string& text) { order(io::TrackerOrder::Kind::kSend, text); }

    void poll() {
        clock_.observe(io::steady_now(), now());
        io::TrackerEvent event;
        while (tracker_.next(event)) {
            event.kind == io::TrackerEvent::Kind::kPose ? take(event) : tell(event);
        }
        send_due();
        poll_.delay(kPoll);
    }

    void take(const io::TrackerEvent& event) {
        const double instant = clock_.logical(event.time);
        const motion::StationPose pose{instant, event.station, event.pose};
        if (event.station == station_) {
            trail_.add(instant, event.pose.position);
        }
        const auto place = std::upper_bound(
            waiting_.begin(), waiting_.end(), instant,
            [](double time, const motion::StationPose& other) { return time < other.time; });
        waiting_.insert(place, pose);
    }

    /// Each pose at its logical time, which is its instant plus the delay; late ones at once.
    void send_due() {
        const double time = now();
        while (!waiting_.empty() && (waiting_.front().time + delay_ <= time + 1e-9 ||
                                     waiting_.front().time > time + kFarAhead)) {
            const motion::StationPose pose = waiting_.front();
            waiting_.pop_front();
            send_pose(pose);
        }
        if (!waiting_.empty()) {
            due_.at(waiting_.front().time + delay_);
        }
    }

    void send_pose(const motion::StationPose& pose) const {
        const auto& p = pose.pose.position;
        const auto& q = pose.pose.orientation;
        const Atom atoms[] = {
            static_cast<double>(pose.station), p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
        send(kPoseOutlet, "pose", atoms);
    }

    void tell(const io::TrackerEvent& event) {
        const std::string name = event.name.data(), text = event.words.data();
        if (name == "stations") {
            spacing_ = event.numbers[0] * motion::kFastrakCycle;
        }
        std::vector<Atom> atoms(event.numbers.begin(), event.numbers.begin() + event.number_count);
        std::istringstream stream(text);
        const std::vector<std::string> words(std::istream_iterator<std::string>(stream), {});
        for (const std::string& word : words) {
            atoms.emplace_back(word.c_str());
        }
        send(kStatusOutlet, name.c_str(), atoms);
        if (name == "failed" || name == "lost-device") {
            error(text);
        }
    }

    io::FastrakTracker tracker_;
    io::ClockMap clock_;
    motion::FastrakSettings settings_;
    motion::PoseTrail trail_;
    std::deque<motion::StationPose> waiting_;
    int station_ = 1;
    double delay_ = 0.015;
    double spacing_ = motion::kFastrakCycle;
    Clock poll_, due_;
};

}  // namespace

PDX_SETUP(fastrak_tilde_setup) {
    const auto station = number("station").from(1).to(4);
    const auto x = number("x"), y = number("y"), z = number("z");
    const auto metres = [](const char* name) { return number(name, "m").from(-3).to(3); };
    const auto baud = number("baud", "bit/s").from(2400).to(115200).by_default(115200);
    const auto angle = [](const char* name) {
        return number(name, "rad").from(-3.1416).to(3.1416).by_default(0);
    };
    const auto corner = [](const char* name) { return number(name, "m").from(-3).to(3).or_none(); };
    const auto part = [](const char* name, double standard) {
        return number(name).from(0).to(1).by_default(standard);
    };

    add_class(
        describe<Fastrak>("fastrak~", "a Polhemus FASTRAK: where up to four receivers are")
            .creation({word("device").by_default_word(""), baud})
            .message("open", {word("device"), baud},
                     "a serial port (if its rate is another, that is found)", &Fastrak::open)
            .message("close", {}, "lets the port go", &Fastrak::close)
            .message("devices", {}, "lists the serial ports at the right outlet", &Fastrak::devices)
            .message("station", {station}, "which receiver the signals follow", &Fastrak::station)
            .message("stations", {anything("numbers")},
                     "which receivers measure (none: all that are plugged in)", &Fastrak::stations)
            .message("format", {word("format")}, "ascii, float32 or 16bit", &Fastrak::format)
            .message("attitude", {word("attitude")}, "asked for as quaternion, euler or cosines",
                     &Fastrak::attitude)
            .message("twice", {number("on").from(0).to(1)},
                     "each number twice, so that a noisy line makes no false pose", &Fastrak::twice)
            .message("hemisphere", {station, x, y, z},
                     "where the receiver is, from the transmitter (0 0 0: follow it)",
                     &Fastrak::hemisphere)
            .message("tip", {station, metres("x"), metres("y"), metres("z")},
                     "the point that is measured, in the receiver's frame", &Fastrak::tip)
            .message("align",
                     {station, corner("ox"), corner("oy"), corner("oz"), corner("xx"), corner("xy"),
                      corner("xz"), corner("yx"), corner("yy"), corner("yz")},
                     "a frame: origin, a point on x, one on y (without: the transmitter's)",
                     &Fastrak::align)
            .message("boresight", {station, angle("azimuth"), angle("elevation"), angle("roll")},
                     "as it is now it is to show these angles", &Fastrak::boresight)
            .message("unboresight", {station}, "the receiver's own angles again",
                     &Fastrak::unboresight)
            .message("filter",
                     {word("which"), part("f", 0).or_none(), part("low", 0.2), part("high", 0.8),
                      part("factor", 0.8)},
                     "position or attitude: the unit's own (without numbers: off)",
                     &Fastrak::filter)
            .message("reset", {}, "the unit starts anew, in about 10 s", &Fastrak::reset)
            .message("record", {word("file")}, "poses to a file, until stop", &Fastrak::record)
            .message("play", {word("file")}, "poses from a file, in place of the unit's",
                     &Fastrak::play)
            .message("stop", {}, "ends recording and playing", &Fastrak::stop)
            .message("delay", {number("delay", "s").from(0).to(1)},
                     "from the instant of a pose to its message", &Fastrak::delay)
            .signal_outlet("x of the station [m]")
            .signal_outlet("y of the station [m]")
            .signal_outlet("z of the station [m]")
            .outlet("pose STATION x y z [m] qw qx qy qz, each at its time")
            .outlet("status: connected, rate, jitter, lost, error and more"));
}
