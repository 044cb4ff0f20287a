// A serial port without hardware: the device's end of a pseudo-terminal. Who opens name() has what
// looks like a serial port, its rate included. Never blocks.
#pragma once

#include <span>
#include <string>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::tracker {

class PseudoTerminal {
  public:
    /// Throws std::runtime_error. A link, where given, is made to point to it (an old link is
    /// replaced, any other file is an error) and removed at the end.
    explicit PseudoTerminal(std::string link);
    ~PseudoTerminal();
    PseudoTerminal(const PseudoTerminal&) = delete;
    PseudoTerminal& operator=(const PseudoTerminal&) = delete;

    const std::string& name() const { return name_; }
    int descriptor() const { return master_; }
    /// What the other end has set [bit/s]; 0 if it is none of the usual rates.
    int baud() const;
    /// Appends what has come.
    void read(motion::Bytes& in);
    /// What does not fit yet goes with the next call; beyond some seconds no one reads, and it is
    /// lost, as on a line.
    void write(std::span<const std::uint8_t> bytes);

  private:
    int master_ = -1;
    int slave_ = -1;  // kept open: the port stays there while no one else has it open
    motion::Bytes waiting_;
    std::string name_, link_;
};

}  // namespace percussionist::tracker
