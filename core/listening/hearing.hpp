// What is usual in what is being heard: each band's mean, and how loud loud moments are.
//
// Levels are judged against these, so that neither the volume nor the equaliser of a recording
// matters much. Offline they are those of the whole recording, live those of the last seconds.
//
// Plain values; push() does not allocate, lock or throw.
#pragma once

#include <cstddef>
#include <span>

#include "core/listening/band_analyser.hpp"

namespace percussionist::listening {

struct Hearing {
    BandFrame mean;       ///< of each band, silences left out [nats]
    float loud = -12.0F;  ///< the power of loud moments, all bands together [nats]
};

/// Of a whole recording.
Hearing hearing_of(std::span<const BandFrame> frames);

/// Of what was heard lately: a mean over all at first, then fading over some 8 s.
class RunningHearing {
  public:
    RunningHearing();
    void push(const BandFrame& frame) noexcept;
    [[nodiscard]] const Hearing& now() const { return hearing_; }

  private:
    Hearing hearing_;
    double weight_ = 0.0;
};

/// The power of all bands together [nats].
float loudness(const BandFrame& frame) noexcept;

}  // namespace percussionist::listening
