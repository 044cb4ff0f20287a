// Writes the sound files that the fuzzer starts from into a folder.
#include "files/wav_file.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    using namespace percussionist::files;
    const std::filesystem::path folder = argv[1];
    const Audio audio{.rate = 48000, .channels = 2, .samples = {0.0, 0.5, -0.5, 1.0, -1.0, 2.0}};
    write_wav(folder / "float.wav", audio, SampleFormat::float32);
    write_wav(folder / "pcm.wav", audio, SampleFormat::pcm16);
}
