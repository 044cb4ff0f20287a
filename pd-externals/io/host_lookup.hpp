// A host's address by its name, without waiting: a thread of its own asks, for names can take many
// seconds.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace percussionist::io {

class HostLookup {
  public:
    /// Numbers and localhost are known at once.
    explicit HostLookup(const std::string& host);

    bool done() const { return answer_->done.load(std::memory_order_acquire); }
    /// Once done(): 0 if there is no such host.
    std::uint32_t address() const { return answer_->address; }

  private:
    struct Answer {
        std::atomic<bool> done{false};
        std::uint32_t address = 0;
    };
    std::shared_ptr<Answer> answer_ = std::make_shared<Answer>();
};

}  // namespace percussionist::io
