#include "net/process.hpp"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
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
constexpr int kFailed = 127;

[[noreturn]] void run(char** command, const std::string& network) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (!network.empty()) {
        const int handle = open(network.c_str(), O_RDONLY | O_CLOEXEC);
        if (handle < 0 || setns(handle, CLONE_NEWNET) != 0) {
            _exit(kFailed);
        }
    }
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    execvp(command[0], command);
    _exit(kFailed);
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const std::string& network) {
    std::vector<std::string> words = command;
    std::vector<char*> pointers;
    for (auto& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    id_ = fork();
    if (id_ == 0) {
        run(pointers.data(), network);
    }
}

Process::~Process() {
    if (id_ > 0) {
        signal(SIGKILL);
        waitpid(id_, nullptr, 0);
    }
}

void Process::signal(int number) const {
    if (id_ > 0) {
        kill(id_, number);
    }
}

bool Process::ended(double seconds) {
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

std::vector<std::string> pd_command(const std::string& pd,
                                    const std::vector<std::string>& arguments) {
    std::vector<std::string> all{pd,        "-noprefs", "-nrt",  "-nogui",      "-noaudio",
                                 "-stderr", "-r",       "48000", "-sleepgrain", "0.5"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return all;
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
