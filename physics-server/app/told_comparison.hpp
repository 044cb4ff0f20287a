// Whether a replay tells what its recording tells: the same bytes at the same steps.
#pragma once

#include <cstdint>
#include <string>

#include "files/recording_file.hpp"
#include "osc/wire.hpp"

namespace percussionist::app {

class ToldComparison {
  public:
    /// A recording may begin later than the run: what comes before its first record is passed over.
    explicit ToldComparison(const files::Recording& recording);

    void told(std::int64_t step, const osc::Packet& packet);

    /// True if all that was recorded came, and nothing else.
    [[nodiscard]] bool same() const { return differing_ == 0 && compared_ == recorded_; }
    /// A line.
    [[nodiscard]] std::string describe() const;

  private:
    const files::Recording& recording_;
    std::size_t next_ = 0;  ///< record
    std::int64_t from_ = 0;
    std::int64_t first_difference_ = 0;  ///< step
    int recorded_ = 0, compared_ = 0, differing_ = 0;
};

}  // namespace percussionist::app
