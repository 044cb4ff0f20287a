// Measuring and sending; what it is told is in fastrak_unit_commands.cpp.
#include "tracker/fastrak_unit.hpp"

#include <cmath>

namespace percussionist::tracker {

using motion::kFastrakCycle;
using motion::kFastrakStations;
using motion::Pose;
using motion::Vector3;

namespace {

/// The frame with its origin, a point on +x and one on +y of A, in the transmitter's.
Pose alignment_frame(const std::vector<double>& v) {
    const Vector3 origin(v[0], v[1], v[2]);
    const Vector3 x = (Vector3(v[3], v[4], v[5]) - origin).normalized();
    const Vector3 towards_y = Vector3(v[6], v[7], v[8]) - origin;
    const Vector3 z = x.cross(towards_y).normalized();
    linear::Matrix3 axes;
    axes << x, z.cross(x), z;
    return {origin, motion::Quaternion(axes)};
}

Vector3 triple(const std::vector<double>& v) {
    return {v[0], v[1], v[2]};
}

}  // namespace

FastrakUnit::FastrakUnit(const FastrakUnitSettings& settings, Motion motion)
    : settings_(settings), motion_(std::move(motion)), wire_(settings.baud), baud_(settings.baud) {
    power_up();
}

void FastrakUnit::measure(Station& station, int number, double instant) {
    Pose pose = motion_(number, instant);
    pose.position = pose * triple(station.values['N']);
    // The field is the same at opposite places: it takes the one in its hemisphere.
    if (triple(station.values['H']).dot(pose.position) < 0.0) {
        pose.position = -pose.position;
    }
    const double keep_position = station.measured ? 1.0 - filters_['x'][0] : 0.0;
    const double keep_attitude = station.measured ? 1.0 - filters_['v'][0] : 0.0;
    station.filtered.position =
        pose.position + keep_position * (station.filtered.position - pose.position);
    station.filtered.orientation =
        linear::interpolate(pose, station.filtered, keep_attitude).orientation;
    station.measured = true;
    pose = station.filtered;
    if (station.aligned) {
        pose = alignment_frame(station.values['A']).inverse() * pose;
    }
    station.raw = pose;
    pose.orientation = (pose.orientation * station.boresight).normalized();
    station.last = {.station = number,
                    .error = ' ',
                    .pose = pose,
                    .relative = Vector3::Zero(),
                    .button = false,
                    .has_position = true,
                    .has_orientation = true};
}

void FastrakUnit::send(Station& station, double now) {
    motion::FastrakReading reading = station.last;
    reading.error = error_;
    reading.relative = reading.pose.position - station.last_sent;
    motion::FastrakLayout layout = station.layout;
    layout.binary = binary_;
    layout.centimetres = centimetres_;
    layout.cosine_rows = settings_.cosine_rows;
    motion::Bytes record;
    encode(reading, layout, record);
    if (wire_.backlog(now) > static_cast<double>(record.size()) * wire_.byte_time()) {
        ++dropped_;
        return;
    }
    if (settings_.damage) {
        settings_.damage(record);
    }
    wire_.send(record, now);
    station.last_sent = reading.pose.position;
    ++records_;
}

int FastrakUnit::next_station() const {
    for (int step = 1; step <= kFastrakStations; ++step) {
        const int i = (current_ + step) % kFastrakStations;
        if (stations_[static_cast<std::size_t>(i)].on) {
            return i;
        }
    }
    return -1;
}

void FastrakUnit::cycle(double instant, double now) {
    const int i = next_station();
    if (i < 0) {
        return;
    }
    current_ = i;
    Station& station = stations_[static_cast<std::size_t>(i)];
    const Vector3 before = station.last_sent;
    measure(station, i + 1, instant);
    const double increment = station.values['I'][0];
    const bool moved = increment == 0.0 || (station.last.pose.position - before).norm() > increment;
    if (continuous_ && !paused_ && moved) {
        send(station, now);
    }
}

void FastrakUnit::advance(double now, motion::Bytes& out) {
    if (!started_) {
        next_cycle_ = static_cast<long>(std::floor(now / kFastrakCycle));
        started_ = true;
    }
    for (;;) {
        const double instant = static_cast<double>(next_cycle_) * kFastrakCycle;
        const double ready = instant + motion::kFastrakLatency;
        if (ready > now) {
            break;
        }
        ++next_cycle_;
        if (ready >= deaf_until_) {
            cycle(instant, ready);
        }
    }
    wire_.arrive(now, out);
}

}  // namespace percussionist::tracker
