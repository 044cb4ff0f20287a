// A serial port: bytes in and out, and an end to waiting. 8 data bits, no parity, 1 stop bit.
//
// libserialport sets it up; pseudo-terminals, which it does not know, are set up here. For the
// thread that does the I/O.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

struct sp_port;

namespace percussionist::io {

/// The line is gone: unplugged.
struct LineLost : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What another thread uses to end a wait() early.
class Waker {
  public:
    Waker();
    ~Waker();
    Waker(const Waker&) = delete;
    Waker& operator=(const Waker&) = delete;
    void wake() const;    ///< any thread; never blocks
    void settle() const;  ///< the waiting thread
    int descriptor() const { return descriptor_; }

  private:
    int descriptor_;
};

/// Waits so long [s], or until woken.
void wait(const Waker& waker, double seconds);

class SerialPort {
  public:
    /// Throws std::runtime_error: the port and why.
    SerialPort(const std::string& device, int baud);
    ~SerialPort();
    SerialPort(const SerialPort&) = delete;
    SerialPort& operator=(const SerialPort&) = delete;

    void set_baud(int baud);
    int baud() const { return baud_; }
    void write(std::string_view bytes);
    /// Appends what has come; waits for it so long [s], or until woken. Throws LineLost.
    void read(std::vector<std::uint8_t>& in, double seconds, const Waker& waker);

  private:
    void take(std::vector<std::uint8_t>& in);

    std::string device_;
    sp_port* port_ = nullptr;  // null: a pseudo-terminal
    int descriptor_ = -1;
    int baud_ = 0;
};

struct SerialDevice {
    std::string name, description;
};
std::vector<SerialDevice> list_serial_devices();

}  // namespace percussionist::io
