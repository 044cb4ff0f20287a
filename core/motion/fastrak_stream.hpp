// Finds the records in what a serial line brings, damaged or not.
//
// Never thrown away to find the beat again: of the bytes at hand the first ones that are a whole
// record (see decode()) are taken, whatever stands before them is lost, and a beginning without its
// end waits for it. A record cut short so costs itself alone, and false beginnings in garbage delay
// no true record. Any bytes at all are good input; memory is bounded. One thread; allocates.
#pragma once

#include <array>
#include <optional>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::motion {

struct ArrivedReading {
    FastrakReading reading;
    double first_byte = 0.0;  ///< when the record's first byte was there [s]
};

class FastrakStream {
  public:
    /// What records of a station look like from now on; a station without is not listened to.
    void expect(int station, std::optional<FastrakLayout> layout);
    /// Forgets bytes that wait for more.
    void clear();

    /// The last of these bytes was there at `last_byte` [s], each took `byte_time` [s]. Valid until
    /// the next call.
    const std::vector<ArrivedReading>& receive(std::span<const std::uint8_t> bytes,
                                               double last_byte, double byte_time);

    /// Bytes that were part of no record, in all.
    std::size_t lost() const { return lost_; }

  private:
    struct Expected {
        FastrakLayout layout;
        std::size_t size;
    };
    std::size_t take_first();
    void drop(std::size_t count);

    std::array<std::optional<Expected>, kFastrakStations> expected_;
    Bytes bytes_;
    std::vector<double> times_;
    std::vector<ArrivedReading> arrived_;
    std::size_t longest_ = 0;
    std::size_t lost_ = 0;
};

}  // namespace percussionist::motion
