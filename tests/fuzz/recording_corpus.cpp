// Writes the recordings and compressed scores that the fuzzers start from into a folder.
#include <filesystem>

#include "files/recording_file.hpp"
#include "files/text_file.hpp"
#include "support/zip_writer.hpp"

using namespace percussionist;

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    files::RecordingWriter writer(folder / "take.recording");
    writer.add(files::RecordKind::settings, 0, {});
    writer.add(files::RecordKind::score, 0, files::pack_score("a.mid", std::vector<char>{'M'}));
    writer.add(files::RecordKind::heard, 3, std::vector<char>{'/', 'p', 0, 0, ',', 0, 0, 0});
    writer.add(files::RecordKind::told, 4, {});
    writer.finish(9);
    const std::string score =
        "<score-partwise><part-list><score-part id=\"P\"/></part-list><part "
        "id=\"P\"><measure><note>"
        "<unpitched/><duration>1</duration></note></measure></part></score-partwise>";
    const std::vector<char> packed =
        test::zip_of({{"META-INF/container.xml", test::container_of("s.xml")}, {"s.xml", score}});
    files::write_text(folder / "score.mxl", {packed.begin(), packed.end()});
    return 0;
}
