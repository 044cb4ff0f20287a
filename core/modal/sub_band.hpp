// A sub-band of a recording: shifted down to 0 Hz, filtered and taken at a lower rate, complex.
//
// The filter is a windowed sinc (Kaiser's window, 70 dB), flat within `width` / 2 of the centre and
// closed from `width` on, so that at a rate of twice `width` nothing folds over. A decaying sine in
// it stays one. Allocates.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace percussionist::modal {

struct SubBand {
    double centre = 0.0;  ///< [Hz]
    double rate = 0.0;    ///< samples a second
    double delay = 0.0;   ///< of the first sample after the recording's [s]
    std::vector<std::complex<double>> samples;
};

/// Filters of one width for recordings of one rate.
class BandFilter {
  public:
    BandFilter(double sample_rate, double width);

    SubBand apply(std::span<const double> signal, double centre) const;

    double width() const { return width_; }
    std::size_t length() const { return taps_.size(); }  ///< [samples]

  private:
    double sample_rate_;
    double width_;
    std::size_t step_;  // recording's samples to one of the band's
    std::vector<double> taps_;
};

}  // namespace percussionist::modal
