#include "io/serial_port.hpp"

#include <fcntl.h>
#include <libserialport.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace percussionist::io {

namespace {

[[noreturn]] void fail(const std::string& device, const std::string& why) {
    throw std::runtime_error(device + ": " + why);
}

speed_t speed(int baud) {
    constexpr std::array<std::pair<int, speed_t>, 7> kRates = {{{2400, B2400},
                                                                {4800, B4800},
                                                                {9600, B9600},
                                                                {19200, B19200},
                                                                {38400, B38400},
                                                                {57600, B57600},
                                                                {115200, B115200}}};
    for (const auto& [rate, code] : kRates) {
        if (rate == baud) {
            return code;
        }
    }
    throw std::runtime_error(std::to_string(baud) + ": no rate of a serial line");
}

void set_up_terminal(int descriptor, int baud) {
    termios line{};
    tcgetattr(descriptor, &line);
    cfmakeraw(&line);
    line.c_cflag |= CLOCAL | CREAD;
    cfsetspeed(&line, speed(baud));
    tcsetattr(descriptor, TCSANOW, &line);
}

std::string real_name(const std::string& device) {
    char* const resolved = realpath(device.c_str(), nullptr);
    if (!resolved) {
        fail(device, std::strerror(errno));
    }
    std::string name = resolved;
    std::free(resolved);
    return name;
}

timespec to_timespec(double seconds) {
    const double whole = seconds > 0.0 ? seconds : 0.0;
    timespec time{};
    time.tv_sec = static_cast<time_t>(whole);
    time.tv_nsec = static_cast<long>((whole - static_cast<double>(time.tv_sec)) * 1e9);
    return time;
}

}  // namespace

Waker::Waker() : descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (descriptor_ < 0) {
        throw std::runtime_error(std::string("no eventfd: ") + std::strerror(errno));
    }
}

Waker::~Waker() {
    close(descriptor_);
}

void Waker::wake() const {
    eventfd_write(descriptor_, 1);
}

void Waker::settle() const {
    eventfd_t count = 0;
    eventfd_read(descriptor_, &count);
}

void wait(const Waker& waker, double seconds) {
    pollfd item{waker.descriptor(), POLLIN, 0};
    const timespec time = to_timespec(seconds);
    ppoll(&item, 1, &time, nullptr);
    waker.settle();
}

SerialPort::SerialPort(const std::string& device, int baud) : device_(device) {
    speed(baud);
    const std::string name = real_name(device);
    if (name.starts_with("/dev/pts/")) {
        descriptor_ = open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        if (descriptor_ < 0) {
            fail(device, std::strerror(errno));
        }
    } else if (sp_get_port_by_name(name.c_str(), &port_) != SP_OK) {
        port_ = nullptr;
        fail(device, "no serial port");
    } else if (sp_open(port_, SP_MODE_READ_WRITE) != SP_OK) {
        const std::string why = std::strerror(errno);
        sp_free_port(port_);
        fail(device, why);
    } else {
        sp_get_port_handle(port_, &descriptor_);
    }
    set_baud(baud);
}

SerialPort::~SerialPort() {
    if (port_) {
        sp_close(port_);
        sp_free_port(port_);
    } else {
        close(descriptor_);
    }
}

void SerialPort::set_baud(int baud) {
    baud_ = baud;
    if (!port_) {
        return set_up_terminal(descriptor_, baud);
    }
    const bool good = sp_set_baudrate(port_, baud) == SP_OK && sp_set_bits(port_, 8) == SP_OK &&
                      sp_set_parity(port_, SP_PARITY_NONE) == SP_OK &&
                      sp_set_stopbits(port_, 1) == SP_OK &&
                      sp_set_flowcontrol(port_, SP_FLOWCONTROL_NONE) == SP_OK;
    if (!good) {
        throw LineLost(device_ + ": cannot be set to " + std::to_string(baud));
    }
}

void SerialPort::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
            continue;
        }
        pollfd item{descriptor_, POLLOUT, 0};
        if ((errno != EAGAIN && errno != EINTR) || poll(&item, 1, 200) <= 0) {
            throw LineLost(device_ + ": takes nothing");
        }
    }
}

void SerialPort::take(std::vector<std::uint8_t>& in) {
    std::array<std::uint8_t, 512> bytes{};
    for (;;) {
        const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
        if (count > 0) {
            in.insert(in.end(), bytes.begin(), bytes.begin() + count);
        }
        if (count == static_cast<ssize_t>(bytes.size())) {
            continue;
        }
        if (count < 0 && errno != EAGAIN && errno != EINTR) {
            throw LineLost(device_ + ": unplugged");
        }
        return;
    }
}

void SerialPort::read(std::vector<std::uint8_t>& in, double seconds, const Waker& waker) {
    pollfd items[] = {{descriptor_, POLLIN, 0}, {waker.descriptor(), POLLIN, 0}};
    const timespec time = to_timespec(seconds);
    ppoll(items, 2, &time, nullptr);
    if (items[1].revents != 0) {
        waker.settle();
    }
    if ((items[0].revents & POLLIN) != 0) {
        take(in);
    } else if ((items[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) {
        throw LineLost(device_ + ": unplugged");
    }
}

std::vector<SerialDevice> list_serial_devices() {
    std::vector<SerialDevice> devices;
    sp_port** ports = nullptr;
    if (sp_list_ports(&ports) != SP_OK) {
        return devices;
    }
    for (sp_port** port = ports; *port; ++port) {
        const char* const description = sp_get_port_description(*port);
        devices.push_back({sp_get_port_name(*port), description ? description : ""});
    }
    sp_free_port_list(ports);
    return devices;
}

}  // namespace percussionist::io
