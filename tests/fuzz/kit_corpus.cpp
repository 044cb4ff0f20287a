// Writes the kit files that the fuzzer starts from into a folder.
#include <filesystem>
#include <string>
#include <string_view>

#include "files/kit_file.hpp"
#include "support/corpus.hpp"

int main(int argc, char** argv) {
    using namespace percussionist;
    if (argc != 2) return 1;
    const std::filesystem::path folder = argv[1];
    const auto write = [&](const char* name, std::string_view text) {
        test::write_input(folder / name, {text.begin(), text.end()});
    };
    write("standard.kit", files::standard_kit_text());
    write("small.kit",
          "percussionist kit 1\ndrummer stature 1.7 hips 0.6\nhands interval 0.1 speed 9\n"
          "object a drum at 0.5 0 0.7 tilt 10 0 radius 0.2 depth 0.1 sound snare\n"
          "object b hi-hat at 0.5 0.4 0.8 radius 0.2 sound cymbal level 0.5\n"
          "pedal b left-foot heel 0.3 0.3 0 length 0.3 direction 10 down 3 up 20\n"
          "event x on a spot 0.01 0 apart 0.05 prefers left elasticity 0.5\n"
          "event y on b by left-foot t60 0.1\nevent z on b hat open mass 0.01\n"
          "key 35 36 38 x\nkey 44 y\nkey 42 z\npair b a right crossed\n"
          "script wrist down 0 0.2 1\npose left-hand x up elbow 1 2 3\n");
}
