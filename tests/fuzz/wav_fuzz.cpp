// Any bytes: a sound file is read as whole frames, or one AudioError comes.
#include "files/wav_file.hpp"
#include "fuzz/memory_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::files;
    const percussionist::test::MemoryFile file(data, size);
    try {
        const Audio audio = read_audio(file.path());
        const auto channels = static_cast<std::size_t>(audio.channels);
        if (audio.rate <= 0 || channels == 0 || audio.samples.size() % channels != 0) std::abort();
        if (mono(audio).size() != audio.samples.size() / channels) std::abort();
    } catch (const AudioError&) {
    }
    return 0;
}
