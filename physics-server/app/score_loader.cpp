#include "app/score_loader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "app/clip_loader.hpp"
#include "app/drum_midi.hpp"
#include "app/temporary_folder.hpp"
#include "core/listening/beats.hpp"
#include "core/listening/transcription.hpp"
#include "files/midi_file.hpp"
#include "files/musicxml_file.hpp"
#include "files/text_file.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

/// What is heard of drums in it.
score::Score listen_to(const std::filesystem::path& path) {
    const files::Audio audio = files::read_audio(path);
    const double duration = static_cast<double>(audio.samples.size()) / audio.channels / audio.rate;
    const listening::Transcription made =
        listening::transcribe(files::mono(audio), audio.rate, listening::learnt_drums());
    const listening::Beats beats = listening::find_beats(made.strokes, duration);
    return files::midi_to_score(to_midi(made, beats, path.filename().string()));
}

bool is_musicxml(const std::filesystem::path& path) {
    const std::string kind = path.extension().string();
    return kind == ".musicxml" || kind == ".xml" || kind == ".mxl";
}

ScoreSource source_of(const std::filesystem::path& path) {
    if (path.empty()) return {};
    std::ifstream in(path, std::ios::binary);
    return {path.filename().string(), {std::istreambuf_iterator<char>(in), {}}};
}

/// What is expected of it: a stroke where it has one.
score::Stroke stroke_of(const body::CapturedStroke& captured, std::size_t index) {
    score::Stroke stroke;
    stroke.time = captured.touch;
    stroke.hand = static_cast<int>(captured.hand);
    stroke.speed = captured.shape.impact;
    stroke.height = captured.shape.rise;
    stroke.velocity = score::velocity_of_impact(captured.shape.impact);
    stroke.note = index;
    stroke.position = score::TempoMap().position_at(captured.touch);
    return stroke;
}

LoadedScore load_motion(const std::filesystem::path& path, const body::Anthropometry& person) {
    ClipOptions options;
    options.files = {path};
    options.person = person;
    const LoadedClip clip = load_clip(options);
    std::vector<body::JointLimits> limits;
    for (const body::Segment& s : clip.skeleton.segments) limits.push_back(s.limits);
    const body::Skeleton skeleton = body::make_skeleton(person);
    LoadedScore loaded;
    loaded.motion = std::make_shared<const CapturedMotion>(clip.clip, skeleton, std::move(limits));
    const body::PlayableClip& played = loaded.motion->clip;
    for (std::size_t i = 0; i < played.strokes().size(); ++i) {
        loaded.strokes.push_back(stroke_of(played.strokes()[i], i));
    }
    loaded.remarks = clip.report;
    loaded.remarks.push_back(
        loaded.strokes.empty()
            ? "no strokes in it: it is followed, and the head stays where it is"
            : fmt::format(
                  "the head is put at {:.2f} m, where it strikes; strokes are bent by {:.1f} "
                  "mm at most to meet it",
                  played.place().z() - skeleton.stick.tip_radius, 1e3 * played.worst_lift()));
    loaded.title = path.filename().string();
    loaded.notes = loaded.strokes.size();
    loaded.source = source_of(path);
    return loaded;
}

}  // namespace

void print_account(const std::string& brief, const std::vector<std::string>& remarks) {
    constexpr std::size_t kMostRemarks = 50;  // printing takes time
    const std::size_t shown = std::min(remarks.size(), kMostRemarks);
    for (std::size_t i = 0; i < shown; ++i) fmt::print(stderr, "{}\n", remarks[i]);
    if (shown < remarks.size()) {
        fmt::print(stderr, "and {} more remarks\n", remarks.size() - shown);
    }
    fmt::print("score: {} as strokes\n", brief);
    std::fflush(stdout);
}

bool is_recording(const std::filesystem::path& path) {
    const std::string kind = path.extension().string();
    return kind == ".wav" || kind == ".flac" || kind == ".ogg" || kind == ".aif" || kind == ".aiff";
}

score::Score read_score(const std::filesystem::path& path, std::vector<std::string>& warnings) {
    if (path.empty()) return score::built_in_score();
    if (is_motion(path)) {
        throw std::runtime_error(path.filename().string() +
                                 ": expected a score or a recording of sound, got a motion");
    }
    if (is_recording(path)) return listen_to(path);
    if (is_musicxml(path)) return files::read_musicxml_file(path);
    const files::MidiFile file = files::read_midi_file(path);
    warnings = file.warnings;
    return files::midi_to_score(file);
}

bool is_motion(const std::filesystem::path& path) {
    const std::string kind = path.extension().string();
    return kind == ".bvh" || kind == ".csv";
}

LoadedScore load_score(const std::filesystem::path& path, const body::Anthropometry& person) {
    if (is_motion(path)) return load_motion(path, person);
    LoadedScore loaded;
    const score::Score score = read_score(path, loaded.remarks);
    score::StrokePlan plan = score::plan_strokes(score);
    for (const auto* list : {&plan.left_out, &plan.doubles}) {
        for (const score::LeftOut& note : *list) {
            loaded.remarks.push_back("left out: " + score::describe(note, score));
        }
    }
    loaded.title = score.title.empty() ? path.filename().string() : score.title;
    loaded.notes = score.notes.size();
    loaded.strokes = std::move(plan.strokes);
    loaded.source = source_of(path);
    return loaded;
}

LoadedScore load_kept_score(const ScoreSource& source, const body::Anthropometry& person) {
    if (source.name.empty()) return load_score(std::filesystem::path());
    // Readers of recordings want a file; the name's last part alone, whatever the recording says.
    const TemporaryFolder folder;
    const auto path = folder.path() / std::filesystem::path(source.name).filename();
    files::write_text(path, std::string(source.bytes.begin(), source.bytes.end()));
    return load_score(path, person);
}

std::filesystem::path score_in_folder(const std::filesystem::path& folder,
                                      const std::string& name) {
    namespace fs = std::filesystem;
    if (name.empty() || name == "built-in") return {};
    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error) throw std::runtime_error(folder.string() + ": no such folder");
    const fs::path file = fs::canonical(root / name, error);
    if (error) throw std::runtime_error(name + ": no such file in the score folder");
    const auto [end, unused] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (end != root.end()) {
        throw std::runtime_error(name + ": lies outside the score folder");
    }
    // A pipe would keep the reader waiting for ever.
    if (!fs::is_regular_file(file, error)) throw std::runtime_error(name + ": is no file");
    return file;
}

}  // namespace percussionist::app
