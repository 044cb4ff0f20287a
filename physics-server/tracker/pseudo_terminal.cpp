#include "tracker/pseudo_terminal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace percussionist::tracker {

namespace {

constexpr std::size_t kMostWaiting = 65536;

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what + ": " + std::strerror(errno));
}

void make_link(const std::string& target, const std::string& link) {
    struct stat status {};
    if (lstat(link.c_str(), &status) == 0 && !S_ISLNK(status.st_mode)) {
        throw std::runtime_error(link + ": is there and is no link");
    }
    unlink(link.c_str());
    if (symlink(target.c_str(), link.c_str()) != 0) {
        fail(link + ": cannot make the link");
    }
}

/// As a fresh serial port: raw, 9600.
void make_raw(int descriptor) {
    termios line{};
    tcgetattr(descriptor, &line);
    cfmakeraw(&line);
    cfsetspeed(&line, B9600);
    tcsetattr(descriptor, TCSANOW, &line);
}

}  // namespace

PseudoTerminal::PseudoTerminal(std::string link) : link_(std::move(link)) {
    master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    std::array<char, 128> name{};
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0 ||
        ptsname_r(master_, name.data(), name.size()) != 0) {
        fail("no pseudo-terminal");
    }
    name_ = name.data();
    slave_ = open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (slave_ < 0) {
        fail(name_);
    }
    make_raw(slave_);
    if (!link_.empty()) {
        make_link(name_, link_);
    }
}

PseudoTerminal::~PseudoTerminal() {
    if (!link_.empty()) {
        unlink(link_.c_str());
    }
    close(slave_);
    close(master_);
}

int PseudoTerminal::baud() const {
    termios line{};
    if (tcgetattr(master_, &line) != 0) {
        return 0;
    }
    constexpr std::array<std::pair<speed_t, int>, 7> kRates = {{{B2400, 2400},
                                                                {B4800, 4800},
                                                                {B9600, 9600},
                                                                {B19200, 19200},
                                                                {B38400, 38400},
                                                                {B57600, 57600},
                                                                {B115200, 115200}}};
    for (const auto& [code, rate] : kRates) {
        if (cfgetospeed(&line) == code) {
            return rate;
        }
    }
    return 0;
}

void PseudoTerminal::read(motion::Bytes& in) {
    std::array<std::uint8_t, 512> bytes{};
    ssize_t count = 0;
    while ((count = ::read(master_, bytes.data(), bytes.size())) > 0) {
        in.insert(in.end(), bytes.begin(), bytes.begin() + count);
    }
}

void PseudoTerminal::write(std::span<const std::uint8_t> bytes) {
    if (waiting_.size() + bytes.size() <= kMostWaiting) {
        waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    }
    const ssize_t count = waiting_.empty() ? 0 : ::write(master_, waiting_.data(), waiting_.size());
    if (count > 0) {
        waiting_.erase(waiting_.begin(), waiting_.begin() + count);
    }
}

}  // namespace percussionist::tracker
