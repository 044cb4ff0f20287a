// A host's address by its name, without waiting: a thread of its own asks, for names can take many
// seconds.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace percussionist::io {

class HostLookup {
  public:
    /// The address of a host, 0 if there is none; however long it takes.
    using Ask = std::function<std::uint32_t(const std::string& host)>;
    static std::uint32_t ask_system(const std::string& host);

    /// Numbers and localhost are known at once.
    explicit HostLookup(const std::string& host, const Ask& ask = ask_system);

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
