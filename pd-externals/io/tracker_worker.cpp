// The line: found, set up, listened to, lost.
#include "io/tracker_worker.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::io {

using motion::kFastrakStations;

namespace {

constexpr double kRetry = 0.5;        // [s] between attempts to find a lost line
constexpr double kSilent = 1.0;       // [s] without a record: something is wrong
constexpr double kLongestWait = 0.1;  // [s]

}  // namespace

void FastrakTracker::Worker::tell(const std::string& name, std::initializer_list<double> numbers,
                                  const std::string& words) {
    TrackerEvent event;
    event.kind = TrackerEvent::Kind::kStatus;
    event.name = fixed_text<sizeof(ShortText)>(name);
    event.words = fixed_text<sizeof(ShortText)>(words);
    for (const double number : numbers) {
        event.numbers.at(static_cast<std::size_t>(event.number_count++)) = number;
    }
    tracker_.events_.push(event);
}

void FastrakTracker::Worker::send(const motion::StationPose& pose) {
    TrackerEvent event;
    event.time = pose.time;
    event.station = pose.station;
    event.pose = pose.pose;
    overflowed_ += tracker_.events_.push(event) ? 0 : 1;
    if (recorder_.is_open()) {
        motion::StationPose row = pose;
        row.time -= recording_since_;
        recorder_ << motion::to_row(row) << '\n';
    }
}

void FastrakTracker::Worker::run() {
    while (!stopped()) {
        obey_orders();
        const double now = steady_now();
        play(now);
        const double pause = std::min(until_next_played(now), kLongestWait);
        if (streaming_) {
            listen(pause);
        } else if (!device_.empty() && played_.empty() && now >= next_try_) {
            connect();
        } else {
            wait(tracker_.waker_, pause);
        }
    }
}

void FastrakTracker::Worker::connect() {
    try {
        port_ = std::make_unique<SerialPort>(device_, baud_);
        FastrakDialogue dialogue(*port_, tracker_.waker_, [this] { return stopped(); });
        const auto status = dialogue.find_unit();
        if (!status) {
            return lose(device_ + ": no FASTRAK answers at any rate");
        }
        if (port_->baud() != baud_) {
            tell("baud", {static_cast<double>(port_->baud())},
                 "answered, " + std::to_string(baud_) + " did not");
            baud_ = port_->baud();
        }
        set_up();
    } catch (const std::runtime_error& e) {
        lose(e.what());
    }
}

/// Throws LineLost.
void FastrakTracker::Worker::set_up() {
    FastrakDialogue dialogue(*port_, tracker_.waker_, [this] { return stopped(); });
    const auto session = dialogue.set_up(settings_);
    if (!session) {
        return lose(device_ + ": no answer");
    }
    int count = 0;
    for (int station = 1; station <= kFastrakStations; ++station) {
        const bool on = session->on[static_cast<std::size_t>(station - 1)];
        count += on ? 1 : 0;
        stream_.expect(station, on ? std::optional(session->layout) : std::nullopt);
    }
    for (const std::string& note : session->notes) {
        tell("note", {}, note);
    }
    stream_.clear();
    cycles_ = motion::CycleClock(motion::kFastrakCycle);
    errors_ = {};
    lost_told_ = stream_.lost();
    last_record_ = steady_now();
    reports_.start(last_record_);
    streaming_ = true;
    told_lost_ = false;
    tell("stations", {static_cast<double>(count)});
    tell("connected", {static_cast<double>(port_->baud())}, device_);
}

void FastrakTracker::Worker::lose(const std::string& why) {
    streaming_ = false;
    port_.reset();
    next_try_ = steady_now() + kRetry;
    if (!told_lost_ && !stopped()) {
        tell("lost-device", {}, why);
        told_lost_ = true;
    }
}

void FastrakTracker::Worker::listen(double seconds) {
    motion::Bytes bytes;
    try {
        port_->read(bytes, seconds, tracker_.waker_);
        const double now = steady_now();
        for (const auto& arrived : stream_.receive(bytes, now, 10.0 / port_->baud())) {
            last_record_ = now;
            take(arrived);
        }
        if (reports_.due(now)) {
            report(now);
        }
        if (now > last_record_ + kSilent) {
            lose(device_ + ": silent");
        }
    } catch (const LineLost& e) {
        lose(e.what());
    }
}

void FastrakTracker::Worker::take(const motion::ArrivedReading& arrived) {
    const motion::FastrakReading& reading = arrived.reading;
    const double arrival = arrived.first_byte - motion::kFastrakLatency;
    const double instant = cycles_.smooth(arrival);
    reports_.add(reading.station, arrival - instant);
    char& error = errors_.at(static_cast<std::size_t>(reading.station - 1));
    if (reading.error != error && (reading.error != ' ' || error != 0)) {
        tell("error", {static_cast<double>(reading.station)}, motion::error_name(reading.error));
    }
    error = reading.error;
    Boresight& boresight = boresights_.at(static_cast<std::size_t>(reading.station - 1));
    boresight.last = reading.pose.orientation;
    if (played_.empty()) {
        const linear::Pose shown{reading.pose.position, reading.pose.orientation * boresight.turn};
        send({instant, reading.station, shown});
    }
}

void FastrakTracker::Worker::report(double now) {
    for (int station = 1; station <= kFastrakStations; ++station) {
        const auto report = reports_.report(station, now);
        if (report.rate > 0.0) {
            tell("rate", {static_cast<double>(station), report.rate});
            tell("jitter", {static_cast<double>(station), report.jitter});
        }
    }
    const std::size_t lost = stream_.lost() - lost_told_ + overflowed_;
    tell("lost", {static_cast<double>(lost)});
    lost_told_ = stream_.lost();
    overflowed_ = 0;
    recorder_.flush();
    reports_.start(now);
}

}  // namespace percussionist::io
