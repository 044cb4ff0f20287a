// A program that a test runs, in a network of its own if need be.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace percussionist::test {

class Process {
  public:
    /// `network`: the path of a network namespace (/proc/PID/ns/net) to run it in; empty: this
    /// one. Its standard output goes nowhere.
    explicit Process(const std::vector<std::string>& command, const std::string& network = "");
    /// Kills it.
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    pid_t id() const { return id_; }
    void signal(int number) const;
    /// Whether it ended by itself within this time [s], and well.
    bool ended(double seconds);

  private:
    pid_t id_;
};

/// A real Pd in real time, without sound card or window: the command for it.
std::vector<std::string> pd_command(const std::string& pd,
                                    const std::vector<std::string>& arguments);

/// A port nobody listens to now.
int free_port();
/// Waits until somebody does; false after 20 s.
bool wait_for_listener(int port);

}  // namespace percussionist::test
