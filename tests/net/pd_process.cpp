#include "net/pd_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "io/monotonic.hpp"
#include "io/udp_socket.hpp"

namespace percussionist::test {

namespace {

constexpr auto kPause = std::chrono::milliseconds(5);

}  // namespace

PdProcess::PdProcess(const std::string& pd, const std::vector<std::string>& arguments) {
    std::vector<std::string> all{pd,        "-noprefs", "-nrt",  "-nogui",      "-noaudio",
                                 "-stderr", "-r",       "48000", "-sleepgrain", "0.5"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (auto& argument : all) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    id_ = fork();
    if (id_ == 0) {
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
}

PdProcess::~PdProcess() {
    if (id_ > 0) {
        signal(SIGKILL);
        waitpid(id_, nullptr, 0);
    }
}

void PdProcess::signal(int number) const {
    kill(id_, number);
}

bool PdProcess::ended(double seconds) {
    for (const double end = io::monotonic_seconds() + seconds; io::monotonic_seconds() < end;) {
        int status = 0;
        if (waitpid(id_, &status, WNOHANG) == id_) {
            id_ = 0;
            return WIFEXITED(status) && WEXITSTATUS(status) == 0;
        }
        std::this_thread::sleep_for(kPause);
    }
    return false;
}

int free_port() {
    return io::UdpSocket("0.0.0.0", 0).port();
}

bool wait_for_listener(int port) {
    for (const double end = io::monotonic_seconds() + 20.0; io::monotonic_seconds() < end;) {
        try {
            const io::UdpSocket probe("0.0.0.0", port);
        } catch (const std::runtime_error&) {
            return true;
        }
        std::this_thread::sleep_for(kPause);
    }
    return false;
}

}  // namespace percussionist::test
