#include "net/hosts.hpp"

#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "net/process.hpp"

namespace percussionist::test {

namespace {

constexpr double kPatience = 10.0;  // [s]

void ip(const std::string& words, const std::string& network = "") {
    Process process({"sh", "-c", "exec ip " + words}, network);
    if (!process.ended(kPatience)) {
        throw std::runtime_error("ip " + words + " failed");
    }
}

void leave_network() {
    if (unshare(CLONE_NEWNET) == 0) {
        return;
    }
    const uid_t user = getuid();
    if (unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
        throw std::runtime_error(std::string("no network namespaces: ") + std::strerror(errno));
    }
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << getgid() << " 1";
}

/// A process that does nothing but keep a network.
pid_t hold_network() {
    std::array<int, 2> ready{};
    if (pipe(ready.data()) != 0) {
        throw std::runtime_error("no pipe");
    }
    const pid_t id = fork();
    if (id == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        const char done = unshare(CLONE_NEWNET) == 0 ? 1 : 0;
        [[maybe_unused]] const auto told = write(ready[1], &done, 1);
        pause();
        _exit(0);
    }
    char done = 0;
    [[maybe_unused]] const auto heard = read(ready[0], &done, 1);
    close(ready[0]);
    close(ready[1]);
    if (done == 0) {
        throw std::runtime_error("no further network namespace");
    }
    return id;
}

}  // namespace

std::string Hosts::network(pid_t holder) {
    return "/proc/" + std::to_string(holder) + "/ns/net";
}

Hosts::Hosts() {
    leave_network();
    ip("link set lo up");
    for (std::size_t i = 0; i < holders_.size(); ++i) {
        holders_[i] = hold_network();
        const std::string here = "net" + std::to_string(i + 1);
        const std::string prefix = "10.77." + std::to_string(i + 1) + ".";
        const std::string there = network(holders_[i]);
        ip("link add " + here + " type veth peer name eth0 netns " + std::to_string(holders_[i]));
        ip("addr add " + prefix + "1/24 dev " + here);
        ip("link set " + here + " up");
        ip("addr add " + prefix + "2/24 dev eth0", there);
        ip("link set eth0 up", there);
        ip("link set lo up", there);
    }
}

Hosts::~Hosts() {
    for (const pid_t holder : holders_) {
        kill(holder, SIGKILL);
        waitpid(holder, nullptr, 0);
    }
}

void Hosts::readdress(int last) {
    ip("addr flush dev net1");
    ip("addr add 10.77.1." + std::to_string(last) + "/24 dev net1");
}

}  // namespace percussionist::test
