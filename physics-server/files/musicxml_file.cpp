#include "files/musicxml_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "files/musicxml_part.hpp"
#include "files/mxl_file.hpp"

namespace percussionist::files {

namespace {

constexpr std::uintmax_t kLargestFile = 16'000'000;

std::string line_of(std::span<const char> bytes, std::ptrdiff_t offset) {
    const auto end = bytes.begin() + std::clamp<std::ptrdiff_t>(
                                         offset, 0, static_cast<std::ptrdiff_t>(bytes.size()));
    return "line " + std::to_string(1 + std::count(bytes.begin(), end, '\n'));
}

/// General MIDI keys by instrument id, of one <score-part>. MusicXML counts them from 1.
std::map<std::string, int> instruments_of(const pugi::xml_node& score_part) {
    std::map<std::string, int> all;
    for (const pugi::xml_node& midi : score_part.children("midi-instrument")) {
        const int key = midi.child("midi-unpitched").text().as_int(0) - 1;
        if (key >= 0 && key <= 127) all[midi.attribute("id").as_string()] = key;
    }
    return all;
}

std::string title_of(const pugi::xml_node& root) {
    const std::string work = root.child("work").child("work-title").text().as_string();
    return work.empty() ? root.child("movement-title").text().as_string() : work;
}

}  // namespace

score::Score parse_musicxml(std::span<const char> bytes, std::string_view name) {
    const std::string file(name);
    if (is_mxl(bytes)) {
        const std::vector<char> unpacked = unpack_mxl(bytes, name, kLargestFile);
        if (is_mxl(unpacked)) throw MusicXmlError(file + ": expected MusicXML, found an archive");
        return parse_musicxml(unpacked, name);
    }
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed) {
        throw MusicXmlError(file + ": " + line_of(bytes, parsed.offset) +
                            ": expected MusicXML, found: " + parsed.description());
    }
    const pugi::xml_node root = document.child("score-partwise");
    if (!root) {
        throw MusicXmlError(file + ": expected <score-partwise>, found <" +
                            document.document_element().name() + ">");
    }

    score::Score score;
    score.title = title_of(root).empty() ? file : title_of(root);
    std::vector<MusicXmlNote> notes;
    std::vector<score::TempoChange> tempos;
    std::vector<score::MetreChange> metres;
    score::Tick end = 0;
    for (const pugi::xml_node& part : root.children("part")) {
        const pugi::xml_node described =
            root.child("part-list")
                .find_child_by_attribute("score-part", "id", part.attribute("id").as_string());
        MusicXmlPart read = read_part(part, instruments_of(described));
        notes.insert(notes.end(), read.notes.begin(), read.notes.end());
        tempos.insert(tempos.end(), read.tempos.begin(), read.tempos.end());
        if (metres.empty()) metres = std::move(read.metres);
        end = std::max(end, read.end);
    }
    std::stable_sort(tempos.begin(), tempos.end(),
                     [](const auto& a, const auto& b) { return a.tick < b.tick; });
    score.tempo = score::TempoMap({kMusicXmlTicks, 0.0}, tempos, metres);
    score.duration = score.tempo.seconds(end);
    for (const MusicXmlNote& n : notes) {
        score::Note note;
        note.time = std::max(0.0, score.tempo.seconds(n.tick) - n.ahead);
        note.instrument = n.instrument;
        note.velocity = n.velocity;
        note.position = score.tempo.position(n.tick);
        note.nuance = n.nuance;
        score.notes.push_back(note);
    }
    std::stable_sort(score.notes.begin(), score.notes.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
    return score;
}

score::Score read_musicxml_file(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream in(path, std::ios::binary);
    if (error || !in) throw MusicXmlError(path.string() + ": cannot be opened");
    if (size > kLargestFile) throw MusicXmlError(path.string() + ": expected at most 16 MB");
    const std::vector<char> bytes((std::istreambuf_iterator<char>(in)),
                                  std::istreambuf_iterator<char>());
    return parse_musicxml(bytes, path.filename().string());
}

}  // namespace percussionist::files
