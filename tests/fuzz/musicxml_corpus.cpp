// Writes the MusicXML that the fuzzer starts from into a folder.
#include <filesystem>
#include <fstream>
#include <string>

namespace {

std::string document(const std::string& measures) {
    return R"(<score-partwise><part-list><score-part id="P"><midi-instrument id="I"><midi-unpitched>48)"
           "</midi-unpitched></midi-instrument></score-part></part-list><part id=\"P\">" +
           measures + "</part></score-partwise>";
}

std::string note(const std::string& content) {
    return "<note><unpitched/><duration>2</duration>" + content + "</note>";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    const std::string attributes =
        "<attributes><divisions>2</divisions><time><beats>4</beats><beat-type>4</beat-type></time>"
        "</attributes>";
    const std::string directions =
        "<direction><direction-type><dynamics><mf/></dynamics></direction-type><sound "
        "tempo=\"120\"/></direction><direction><direction-type><wedge type=\"crescendo\"/>"
        "</direction-type></direction><direction><direction-type><words>accel.</words>"
        "</direction-type><offset>1</offset></direction>";
    const auto write = [&](const char* name, const std::string& measures) {
        std::ofstream(folder / name) << document(measures);
    };
    // Each of them is short: what is fuzzed is faster for it.
    write("directions.musicxml", "<measure>" + directions + note("") + "</measure>");
    write("notations.musicxml",
          "<measure>" + attributes + "<note><grace/><unpitched/></note>" +
              note("<instrument id=\"I\"/><notations><articulations><accent/><staccato/>"
                   "</articulations></notations>") +
              note("<chord/><tie type=\"stop\"/>") + "</measure>");
    write("moves.musicxml",
          "<measure>" + note("<notations><ornaments><tremolo>3</tremolo></ornaments></notations>") +
              "<backup><duration>2</duration></backup><forward><duration>1</duration></forward>"
              "<direction><direction-type><metronome><beat-unit>half</beat-unit><beat-unit-dot/>"
              "<per-minute>60</per-minute></metronome></direction-type></direction></measure>");
    write("repeats.musicxml",
          "<measure><barline><repeat direction=\"forward\"/></barline>" + note("<rest/>") +
              "</measure><measure><barline><ending type=\"start\" number=\"1, 2\"/></barline>" +
              note("") +
              "<barline><repeat direction=\"backward\" times=\"3\"/></barline></measure><measure>"
              "<barline><ending type=\"start\" number=\"3\"/><ending type=\"stop\"/></barline>" +
              note("") + "</measure>");
}
