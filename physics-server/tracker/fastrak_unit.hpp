// A FASTRAK without hardware: commands in, bytes out at their own times, the poses from a motion.
//
// It measures one station a cycle of 1/120 s, in their order; what it measured at an instant goes
// onto the wire 3.75 ms later, and takes the wire's own time. Where the line is too slow it drops
// solutions. Source: Polhemus, 3SPACE FASTRAK User's Manual (1993; Rev G 2012). Simplified: metal
// compensation, the transmitter's mounting frame and the envelopes are kept and told, but change no
// pose; the filters are single poles of sensitivity F. Time is an argument. One thread.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "tracker/fastrak_command.hpp"
#include "tracker/timed_wire.hpp"

namespace percussionist::tracker {

/// Where the receiver of a station is, in the transmitter's frame, at an instant [s].
using Motion = std::function<motion::Pose(int station, double time)>;

struct FastrakUnitSettings {
    int receivers = 1;  ///< plugged in, from station 1 on
    int baud = 115200;
    bool has_16bit = true;  ///< items 18 to 20, which newer units lack
    bool cosine_rows = false;
    double restart = 10.0;  ///< how long ^Y takes [s]
    /// What happens to a record on its way; for faults.
    std::function<void(motion::Bytes&)> damage = {};
};

class FastrakUnit {
  public:
    FastrakUnit(const FastrakUnitSettings& settings, Motion motion);

    void receive(std::span<const std::uint8_t> bytes, double now);
    /// Measures up to then, and appends the bytes that have left the line since the last call. The
    /// ends of records in `out` go to `ends`, where it is given.
    void advance(double now, motion::Bytes& out);

    int baud() const { return baud_; }
    double byte_time() const { return wire_.byte_time(); }
    /// Shown in every record until T clears it.
    void set_error(char error) { error_ = error; }
    std::size_t records() const { return records_; }
    std::size_t dropped() const { return dropped_; }

  private:
    struct Station {
        bool on = false;
        motion::FastrakLayout layout;
        std::map<char, std::vector<double>> values;  // of A G H I N r Q V, in SI
        bool aligned = false;
        motion::Quaternion boresight = motion::Quaternion::Identity();
        motion::Pose filtered;
        bool measured = false;
        motion::Pose raw;  // before boresight
        motion::FastrakReading last;
        motion::Vector3 last_sent = motion::Vector3::Zero();
    };

    void power_up();
    void obey(const FastrakCommand& command, double now);
    void act(char letter, double now);
    void set(const FastrakCommand& command, double now);
    void set_station(const FastrakCommand& command, Station& station, int number, double now);
    void set_values(const FastrakCommand& command, Station& station, int number, double now);
    void set_output_list(const FastrakCommand& command, Station& station, int number, double now);
    void set_filter(const FastrakCommand& command, double now);
    void set_line(const FastrakCommand& command, double now);
    void reply(const std::string& text, double now);
    void refuse(const std::string& command, Refusal reason, double now);
    void tell_status(double now);
    std::string states() const;

    void cycle(double instant, double now);
    void measure(Station& station, int number, double instant);
    void send(Station& station, double now);
    int next_station() const;

    FastrakUnitSettings settings_;
    Motion motion_;
    FastrakCommandReader reader_;
    TimedWire wire_;
    int baud_;
    std::array<Station, motion::kFastrakStations> stations_;
    std::map<char, std::vector<double>> filters_;  // x and v
    bool binary_ = false, centimetres_ = false, continuous_ = false, paused_ = false;
    bool compensation_ = false;
    char error_ = ' ';
    int current_ = 0;      // the station measured last
    long next_cycle_ = 0;  // number since time 0
    bool started_ = false;
    double deaf_until_ = -1.0;
    std::size_t records_ = 0, dropped_ = 0;
};

}  // namespace percussionist::tracker
