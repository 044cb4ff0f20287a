// What the tracker's thread does. For fastrak_tracker.cpp alone.
#pragma once

#include <fstream>
#include <memory>
#include <optional>
#include <vector>

#include "core/motion/cycle_clock.hpp"
#include "core/motion/fastrak_stream.hpp"
#include "core/motion/pose_table.hpp"
#include "io/fastrak_dialogue.hpp"
#include "io/fastrak_tracker.hpp"
#include "io/pose_reports.hpp"

namespace percussionist::io {

class FastrakTracker::Worker {
  public:
    explicit Worker(FastrakTracker& tracker) : tracker_(tracker) {}
    void run();

  private:
    bool stopped() const { return tracker_.stop_.load(std::memory_order_relaxed); }
    void tell(const std::string& name, std::initializer_list<double> numbers = {},
              const std::string& words = "");
    void send(const motion::StationPose& pose);

    void obey_orders();
    void obey(const TrackerOrder& order);
    void set_boresight(const TrackerOrder& order);
    void open_recorder(const std::string& path);
    void open_player(const std::string& path);

    void connect();
    void set_up();
    void lose(const std::string& why);
    void listen(double seconds);
    void take(const motion::ArrivedReading& arrived);
    void report(double now);

    void play(double now);
    double until_next_played(double now) const;

    FastrakTracker& tracker_;
    std::string device_;
    int baud_ = 115200;
    motion::FastrakSettings settings_;
    std::unique_ptr<SerialPort> port_;
    bool streaming_ = false;
    bool told_lost_ = false;
    double next_try_ = 0.0;
    double last_record_ = 0.0;

    motion::FastrakStream stream_;
    motion::CycleClock cycles_{motion::kFastrakCycle};
    PoseReports reports_;
    std::size_t lost_told_ = 0;
    std::size_t overflowed_ = 0;
    std::array<char, motion::kFastrakStations> errors_{};

    /// Kept here and not in the unit, which forgets what it was turned by when it loses power.
    struct Boresight {
        std::optional<linear::Quaternion> last;  ///< as the unit says
        linear::Quaternion turn = linear::Quaternion::Identity();
    };
    std::array<Boresight, motion::kFastrakStations> boresights_;

    std::ofstream recorder_;
    double recording_since_ = 0.0;
    std::vector<motion::StationPose> played_;
    std::size_t next_played_ = 0;
    double playing_since_ = 0.0;
};

}  // namespace percussionist::io
