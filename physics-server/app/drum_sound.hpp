// The sound of a performance, made from its contacts as [modal-drum~] makes it in Pd: every contact
// throws a mallet of the tip's effective mass at the same drum.
#pragma once

#include "app/performance_log.hpp"
#include "files/wav_file.hpp"
#include "sim/drumhead.hpp"

namespace percussionist::app {

/// Mono, `duration` [s] at `rate` [Hz]; a contact's sound starts at the sample nearest its instant.
files::Audio drum_sound(const PerformanceLog& log, double duration, int rate,
                        const sim::DrumheadOptions& head);

/// The largest magnitude in it.
double peak(const files::Audio& audio);

}  // namespace percussionist::app
