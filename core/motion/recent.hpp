// The last few of a row of things, the newest first. No allocation.
#pragma once

#include <array>
#include <cstddef>

namespace percussionist::motion {

template <class T, std::size_t Capacity>
class Recent {
  public:
    void add(const T& item) noexcept {
        newest_ = (newest_ + Capacity - 1) % Capacity;
        items_[newest_] = item;
        count_ = count_ < Capacity ? count_ + 1 : Capacity;
    }
    std::size_t size() const noexcept { return count_; }
    /// 0 is the newest.
    const T& operator[](std::size_t back) const noexcept {
        return items_[(newest_ + back) % Capacity];
    }
    void clear() noexcept { count_ = 0; }

  private:
    std::array<T, Capacity> items_{};
    std::size_t newest_ = 0;
    std::size_t count_ = 0;
};

}  // namespace percussionist::motion
