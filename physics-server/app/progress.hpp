// How far long work is, on one line of a terminal; nothing where the output goes elsewhere.
#pragma once

#include <functional>
#include <string>

namespace percussionist::app {

class Progress {
  public:
    explicit Progress(std::string what);

    /// done from 0 to 1; cheap to call often.
    void tell(double done, const std::string& detail = {});
    void done();  ///< the line is taken away
    [[nodiscard]] std::function<void(double)> teller() {
        return [this](double part) { tell(part); };
    }

  private:
    std::string what_;
    bool shown_;
    int told_ = -1;  ///< percent
};

}  // namespace percussionist::app
