// Orders, recordings, and the thread itself.
#include "io/fastrak_tracker.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "io/tracker_worker.hpp"

namespace percussionist::io {

double steady_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

FastrakTracker::FastrakTracker() : thread_([this] { Worker(*this).run(); }) {}

FastrakTracker::~FastrakTracker() {
    stop_ = true;
    waker_.wake();
    thread_.join();
}

bool FastrakTracker::order(const TrackerOrder& order) {
    const bool taken = orders_.push(order);
    waker_.wake();
    return taken;
}

void FastrakTracker::Worker::obey_orders() {
    TrackerOrder order;
    while (tracker_.orders_.pop(order)) {
        obey(order);
    }
}

void FastrakTracker::Worker::obey(const TrackerOrder& order) {
    const std::string text = order.text.data();
    switch (order.kind) {
        case TrackerOrder::Kind::kOpen:
        case TrackerOrder::Kind::kClose:
            streaming_ = told_lost_ = false;
            port_.reset();
            device_ = text;
            baud_ = order.baud;
            next_try_ = 0.0;
            return;
        case TrackerOrder::Kind::kSettings:
        case TrackerOrder::Kind::kSend:
            settings_ = order.settings;
            if (streaming_) {
                try {
                    text.empty() ? set_up() : port_->write(text);
                } catch (const LineLost& e) {
                    lose(e.what());
                }
            }
            return;
        case TrackerOrder::Kind::kBoresight:
            return set_boresight(order);
        case TrackerOrder::Kind::kRecord:
            return open_recorder(text);
        case TrackerOrder::Kind::kPlay:
            return open_player(text);
        case TrackerOrder::Kind::kStop:
            recorder_.close();
            played_.clear();
            return;
        case TrackerOrder::Kind::kDevices:
            for (const SerialDevice& device : list_serial_devices()) {
                tell("device", {}, device.name + " " + device.description);
            }
            tell("devices-end");
            return;
    }
}

void FastrakTracker::Worker::set_boresight(const TrackerOrder& order) {
    Boresight& boresight = boresights_.at(static_cast<std::size_t>(order.station - 1));
    if (!order.shown) {
        boresight.turn.setIdentity();
    } else if (boresight.last) {
        boresight.turn = boresight.last->conjugate() * *order.shown;
    } else {
        tell("failed", {},
             "boresight: station " + std::to_string(order.station) + ": no pose of it yet");
    }
}

void FastrakTracker::Worker::open_recorder(const std::string& path) {
    recorder_.close();
    recorder_.clear();
    recorder_.open(path);
    if (!recorder_) {
        return tell("failed", {}, "record: " + path + ": cannot be written");
    }
    recorder_ << motion::kPoseTableHeader << '\n';
    recording_since_ = steady_now();
    tell("recording", {}, path);
}

void FastrakTracker::Worker::open_player(const std::string& path) {
    std::ifstream file(path);
    std::vector<motion::StationPose> poses;
    std::string row;
    for (std::size_t line = 1; std::getline(file, row); ++line) {
        const auto pose = motion::from_row(row);
        if (pose) {
            poses.push_back(*pose);
        } else if (line > 1 || !row.starts_with("time")) {
            return tell("failed", {},
                        "play: " + path + ", line " + std::to_string(line) + ": expected " +
                            std::string(motion::kPoseTableHeader));
        }
    }
    if (poses.empty()) {
        return tell("failed", {}, "play: " + path + ": no poses in it");
    }
    std::stable_sort(poses.begin(), poses.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
    played_ = std::move(poses);
    next_played_ = 0;
    playing_since_ = steady_now() - played_.front().time;
    tell("playing", {static_cast<double>(played_.size())}, path);
}

void FastrakTracker::Worker::play(double now) {
    while (next_played_ < played_.size() && playing_since_ + played_[next_played_].time <= now) {
        motion::StationPose pose = played_[next_played_++];
        pose.time += playing_since_;
        send(pose);
    }
    if (!played_.empty() && next_played_ == played_.size()) {
        played_.clear();
        tell("played");
    }
}

double FastrakTracker::Worker::until_next_played(double now) const {
    return next_played_ < played_.size() ? playing_since_ + played_[next_played_].time - now
                                         : std::numeric_limits<double>::infinity();
}

}  // namespace percussionist::io
