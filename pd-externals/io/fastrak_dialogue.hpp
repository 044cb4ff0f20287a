// The talk with a FASTRAK until it streams: find its rate, ask what it has, set it up, check.
//
// Quiet is waited for, not slept for; every answer is looked for anywhere in what comes; what the
// unit does not have is replaced by what it has, and said. For the thread that does the I/O.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/fastrak_replies.hpp"
#include "core/motion/fastrak_settings.hpp"
#include "io/serial_port.hpp"

namespace percussionist::io {

struct FastrakSession {
    motion::FastrakStatus status;
    std::array<bool, motion::kFastrakStations> on{};
    motion::FastrakLayout layout;
    std::vector<std::string> notes;  ///< what is not as it was asked for
};

class FastrakDialogue {
  public:
    /// `cancelled` ends all waiting; whoever turns it true wakes the waker.
    FastrakDialogue(SerialPort& port, const Waker& waker, std::function<bool()> cancelled)
        : port_(port), waker_(waker), cancelled_(std::move(cancelled)) {}

    /// Quiets the unit and asks for its status at the port's rate, then at all others; leaves the
    /// port at the rate that answered. Nothing if none did. Throws LineLost, as all of these.
    std::optional<motion::FastrakStatus> find_unit();

    /// Sets everything and starts the stream. Nothing if the unit does not answer.
    std::optional<FastrakSession> set_up(const motion::FastrakSettings& settings);

  private:
    template <class Find>
    auto ask(const std::string& command, Find find) -> decltype(find(std::string_view()));
    std::string drain();
    void read(double seconds);
    std::optional<motion::FastrakStatus> greet();
    enum class Answer { kYes, kNo, kNone };
    Answer takes(const motion::FastrakLayout& layout, int station);
    Answer all_take(const FastrakSession& session);
    void agree_on_layout(motion::FastrakSettings settings, FastrakSession& session);
    void settle_cosines(FastrakSession& session, int station);

    SerialPort& port_;
    const Waker& waker_;
    std::function<bool()> cancelled_;
    std::string text_;
};

}  // namespace percussionist::io
