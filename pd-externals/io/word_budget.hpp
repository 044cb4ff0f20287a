// Bounds how many different words come in: Pd keeps each for ever, as a symbol, so that whoever
// sends ever new ones could fill the machine's memory.
//
// Words are known again by their hash; two of one hash count once. One thread at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <unordered_set>

namespace percussionist::io {

class WordBudget {
  public:
    static constexpr std::size_t kMostBytes = 8U << 20U;  ///< of all words, and of keeping them
    static constexpr std::size_t kKeeping = 64;  ///< about what Pd needs beside its letters

    /// Whether the word has come before, or there is room for it.
    bool allows(std::string_view word) {
        const std::size_t hash = std::hash<std::string_view>()(word);
        if (known_.contains(hash)) {
            return true;
        }
        if (bytes_ + word.size() + kKeeping > kMostBytes) {
            return false;
        }
        bytes_ += word.size() + kKeeping;
        known_.insert(hash);
        return true;
    }

  private:
    std::unordered_set<std::size_t> known_;
    std::size_t bytes_ = 0;
};

}  // namespace percussionist::io
