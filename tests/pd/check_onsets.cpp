// check_onsets FILE DELAY...: looks at a WAV of floats. Its first channel steps up at each stroke;
// each further channel has to fall silent, and sound again DELAY samples behind each step, exactly.
// Every sample has to be a number within -1 to 1, and each channel to reach 0.02.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Sound {
    std::size_t channels = 0;
    std::vector<float> samples;  // interleaved
    float at(std::size_t frame, std::size_t channel) const {
        return samples[frame * channels + channel];
    }
    std::size_t frames() const { return samples.size() / channels; }
};

template <class Number>
Number read(const std::string& bytes, std::size_t at) {
    Number number;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

Sound read_wav(const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    Sound sound;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const auto size = read<std::uint32_t>(bytes, at + 4);
        if (bytes.compare(at, 4, "fmt ") == 0) {
            sound.channels = read<std::uint16_t>(bytes, at + 10);
        } else if (bytes.compare(at, 4, "data") == 0) {
            const std::size_t count = std::min<std::size_t>(size, bytes.size() - at - 8) / 4;
            sound.samples.resize(count);
            std::memcpy(sound.samples.data(), bytes.data() + at + 8, count * 4);
        }
        at += 8 + size;
    }
    if (sound.channels == 0 || sound.samples.empty()) {
        throw std::runtime_error(std::string(path) + ": no sound in it");
    }
    return sound;
}

std::vector<std::size_t> steps(const Sound& sound) {
    std::vector<std::size_t> found;
    for (std::size_t i = 1; i < sound.frames(); ++i) {
        if (sound.at(i, 0) > 0.5F && sound.at(i - 1, 0) <= 0.5F) {
            found.push_back(i);
        }
    }
    return found;
}

/// Where it begins to sound after at least this much silence.
std::vector<std::size_t> onsets(const Sound& sound, std::size_t channel) {
    constexpr std::size_t kSilence = 500;
    std::vector<std::size_t> found;
    std::size_t silent = kSilence;
    for (std::size_t i = 0; i < sound.frames(); ++i) {
        if (sound.at(i, channel) == 0.0F) {
            ++silent;
            continue;
        }
        if (silent >= kSilence) {
            found.push_back(i);
        }
        silent = 0;
    }
    return found;
}

bool good(const Sound& sound, std::size_t channel, long delay) {
    float peak = 0.0F;
    for (std::size_t i = 0; i < sound.frames(); ++i) {
        if (!(std::abs(sound.at(i, channel)) <= 1.0F)) {
            std::cerr << "channel " << channel << ", frame " << i << ": not within -1 to 1\n";
            return false;
        }
        peak = std::max(peak, std::abs(sound.at(i, channel)));
    }
    const auto expected = steps(sound);
    const auto found = onsets(sound, channel);
    bool exact = found.size() == expected.size() && !expected.empty();
    std::cout << "channel " << channel << ": peak " << peak << ", strokes " << found.size()
              << " of " << expected.size() << ", late by";
    for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
        const long late = static_cast<long>(found[i]) - static_cast<long>(expected[i]);
        std::cout << ' ' << late;
        exact = exact && late == delay;
    }
    std::cout << " (expected " << delay << ")\n";
    return exact && peak > 0.02F;
}

}  // namespace

int main(int count, char** arguments) try {
    const Sound sound = read_wav(arguments[1]);
    bool all = sound.channels == static_cast<std::size_t>(count - 1);
    for (int i = 2; i < count && static_cast<std::size_t>(i - 1) < sound.channels; ++i) {
        all = good(sound, static_cast<std::size_t>(i - 1), std::atol(arguments[i])) && all;
    }
    return all ? 0 : 1;
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 2;
}
