// A real Pd in real time, without sound card or window.
#pragma once

#include <string>
#include <vector>

namespace percussionist::test {

class PdProcess {
  public:
    PdProcess(const std::string& pd, const std::vector<std::string>& arguments);
    ~PdProcess();
    PdProcess(const PdProcess&) = delete;
    PdProcess& operator=(const PdProcess&) = delete;

    void signal(int number) const;
    /// Whether it ended by itself within this time [s], and well.
    bool ended(double seconds);

  private:
    int id_;
};

/// A port nobody listens to now.
int free_port();
/// Waits until somebody does; false after 20 s.
bool wait_for_listener(int port);

}  // namespace percussionist::test
