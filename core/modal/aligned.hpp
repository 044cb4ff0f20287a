// Arrays that begin where a line of the cache begins, so that no vector of numbers straddles two.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace percussionist::modal {

template <class T>
struct CacheAligned {
    using value_type = T;
    static constexpr std::align_val_t kLine{64};

    CacheAligned() = default;
    template <class U>
    CacheAligned(const CacheAligned<U>& /*other*/) noexcept {}

    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), kLine)); }
    void deallocate(T* memory, std::size_t /*n*/) noexcept { ::operator delete(memory, kLine); }
    bool operator==(const CacheAligned& /*other*/) const { return true; }
};

using Values = std::vector<double, CacheAligned<double>>;

}  // namespace percussionist::modal
