// percussionist animate: see commands.hpp.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "app/animate_files.hpp"
#include "app/bvh_writer.hpp"
#include "app/commands.hpp"
#include "app/film_pictures.hpp"
#include "app/kit_film.hpp"
#include "app/kit_gltf.hpp"
#include "app/kit_performance.hpp"
#include "app/kit_picture.hpp"
#include "app/kit_score.hpp"
#include "app/kit_sound.hpp"
#include "app/progress.hpp"
#include "app/score_loader.hpp"
#include "app/temporary_folder.hpp"
#include "files/kit_file.hpp"
#include "files/text_file.hpp"
#include "files/text_lines.hpp"

namespace percussionist::app {

namespace {

constexpr double kLongest = 4 * 3600.0;  // [s]
constexpr double kGlbInterval = 1.0 / 60.0;
constexpr double kRingOut = 3.0;  // after the last stroke [s]

struct AnimateOptions {
    std::filesystem::path score;
    std::filesystem::path folder;
    std::filesystem::path kit;
    std::filesystem::path write_kit;
    std::filesystem::path audio;
    double frames = 240.0;  ///< a second [Hz]
    int sample_rate = 48000;
    bool silent = false;
    bool film = false;
    bool simulated = false;
    std::vector<double> pictures;  ///< at these times [s]
};

/// The motion's files, frame by frame.
class MotionFiles {
  public:
    MotionFiles(const AnimateOptions& options, const body::Skeleton& skeleton,
                const score::Kit& kit)
        : glb_(options.folder / "motion.glb"),
          bvh_(options.folder / "motion.bvh", skeleton, 1.0 / options.frames),
          objects_(options.folder / "objects.csv", kit),
          gltf_(skeleton, kit) {}

    void add(double time, const body::Placement& placement,
             const std::vector<body::ObjectState>& states) {
        bvh_.add(placement);
        objects_.add(time, states);
        if (time < next_glb_) return;
        gltf_.add(time, placement, states);
        next_glb_ += kGlbInterval;
    }
    void finish() {
        bvh_.finish();
        objects_.finish();
        gltf_.write(glb_);
    }

  private:
    std::filesystem::path glb_;
    BvhWriter bvh_;
    ObjectsWriter objects_;
    KitGltf gltf_;
    double next_glb_ = 0.0;  ///< [s]
};

/// What was hit, what was left out and why, and how well.
struct Account {
    std::string text;
    void line(const std::string& what, const std::string& value) {
        text += fmt::format("{:<28} {}\n", what, value);
    }
};

class Animator {
  public:
    explicit Animator(const AnimateOptions& options)
        : options_(options), kit_(load_kit(options.kit)) {
        std::vector<std::string> warnings;
        score_ = read_score(options.score, warnings);
        for (const std::string& warning : warnings) fmt::print(stderr, "{}\n", warning);
        note_reach(body::KitPoses(skeleton_ = body::make_drummer(kit_.drummer), kit_), kit_);
        plan_ = score::plan_kit(score_, kit_);
        animation_ = std::make_unique<body::KitAnimation>(kit_, plan_.strokes);
        const double last = plan_.strokes.empty() ? 0.0 : plan_.strokes.back().time;
        duration_ = last + kRingOut;
        if (duration_ > kLongest) {
            throw std::runtime_error(
                fmt::format("{}: its last stroke is at {:.0f} s: expected at most 4 hours",
                            options.score.string(), last));
        }
    }

    void write() {
        std::filesystem::create_directories(options_.folder);
        if (options_.simulated) {
            write_performance();
        } else {
            write_motion();
            check_strokes();
            files::write_text(options_.folder / "strokes.csv",
                              strokes_csv(kit_, score_, plan_.strokes, checks_));
            for (const double time : options_.pictures) write_picture(time);
            if (!options_.silent) write_sound(plan_.strokes);
        }
        write_keys(options_.folder / "keys.csv", *animation_);
        if (!options_.write_kit.empty()) write_kit();
        if (options_.film) write_film();
        tell();
    }

  private:
    void write_motion() {
        Progress progress("frames");
        MotionFiles files(options_, animation_->skeleton(), kit_);
        body::StickWatch watch(*animation_, kit_);
        body::Posture posture(animation_->skeleton());
        body::Placement placement(animation_->skeleton());
        std::vector<body::ObjectState> states;
        const auto count = static_cast<std::size_t>(std::ceil(duration_ * options_.frames)) + 1;
        for (std::size_t i = 0; i < count; ++i) {
            const double time = static_cast<double>(i) / options_.frames;
            animation_->at(time, posture, placement);
            animation_->kit_at(time, placement, states);
            watch.see(time, placement);
            files.add(time, placement, states);
            progress.tell(static_cast<double>(i) / static_cast<double>(count));
        }
        files.finish();
        progress.done();
        account_.line("fastest tip", fmt::format("{:.1f} m/s, at {:.3f} s", watch.top_speed(),
                                                 watch.top_speed_at()));
        account_.line("sticks through faces", std::to_string(watch.through().size()));
        through_ = watch.through();
    }

    /// The same out of the simulation.
    void write_performance() {
        Progress progress("simulated");
        MotionFiles files(options_, animation_->skeleton(), kit_);
        std::vector<body::ObjectState> states;
        std::vector<double> pictures = options_.pictures;
        std::size_t frames = 0;
        const KitPerformance performance = perform_on_kit(
            kit_, plan_.strokes, *animation_, kit_bodies(kit_, options_.kit.parent_path()),
            duration_, [&](const sim::KitSimulation& now) {
                const double half = 0.5 * now.step_length();
                const double time = static_cast<double>(frames) / options_.frames;
                if (now.time() + half >= time) {
                    now.kit_state(states);
                    files.add(time, now.placement(), states);
                    ++frames;
                    progress.tell(now.time() / duration_);
                }
                std::erase_if(pictures, [&](double at) {
                    if (at > now.time() + half) return false;
                    now.kit_state(states);
                    draw(at, now.placement(), states);
                    return true;
                });
            });
        files.finish();
        progress.done();
        if (!performance.sane) throw std::runtime_error("the simulation has gone astray");
        for (const auto& [what, value] : account_of(kit_, plan_.strokes, performance)) {
            account_.line(what, value);
        }
        files::write_text(options_.folder / "strokes.csv",
                          contacts_csv(kit_, score_, plan_.strokes, performance));
        files::write_text(options_.folder / "contacts.csv", all_contacts_csv(kit_, performance));
        if (!options_.silent) write_sound(heard(kit_, plan_.strokes, performance));
    }

    void check_strokes() {
        double off = 0.0, early = 0.0;
        for (const score::KitStroke& stroke : plan_.strokes) {
            checks_.push_back(check_stroke(*animation_, stroke));
            off = std::max(off, checks_.back().off);
            early = std::max(early, checks_.back().early);
        }
        account_.line("farthest from its spot", fmt::format("{:.2f} mm", 1e3 * off));
        account_.line("earliest contact", fmt::format("{:.1f} ms before its time", 1e3 * early));
    }

    void write_picture(double time) const {
        body::Posture posture(animation_->skeleton());
        body::Placement placement(animation_->skeleton());
        std::vector<body::ObjectState> states;
        animation_->at(time, posture, placement);
        animation_->kit_at(time, placement, states);
        draw(time, placement, states);
    }

    void draw(double time, const body::Placement& placement,
              const std::vector<body::ObjectState>& states) const {
        files::write_text(options_.folder / fmt::format("picture-{:.3f}.svg", time),
                          kit_picture(kit_, animation_->skeleton(), placement, states,
                                      fmt::format("{:.3f} s", time)));
    }

    void write_sound(const std::vector<score::KitStroke>& strokes) {
        const files::Audio audio = kit_sound_with(kit_, strokes,
                                                  {.kit_folder = options_.kit.parent_path(),
                                                   .recording = options_.audio,
                                                   .rate = options_.sample_rate});
        files::write_wav(options_.folder / "song.wav", audio);
        double peak = 0.0;
        for (const double sample : audio.samples) peak = std::max(peak, std::abs(sample));
        account_.line("peak level", fmt::format("{:.3f}", peak));
    }

    /// As `film --kit` makes it: of the key frames.
    void write_film() const {
        const TemporaryFolder work;
        const FilmOptions film;
        body::LiveDrummer drummer(kit_);
        const int pictures = film_strokes(
            drummer, plan_.strokes,
            {.score = options_.score, .kit = options_.kit.string(), .audio = options_.audio}, film,
            work.path());
        make_film(work.path(), pictures, film.rate, options_.folder / "film.mp4", project_folder());
    }

    void write_kit() const {
        const auto poses = all_poses(animation_->skeleton(), animation_->poses(), kit_);
        files::write_text(options_.write_kit,
                          kit_text(options_.kit) +
                              "\n# The poses, to be edited: Euler angles z y x.\n" +
                              files::pose_lines(kit_, poses));
    }

    void tell() {
        const score::KitAudit audit = score::audit(plan_, kit_);
        Account head;
        head.line("score", score_.title);
        head.line("kit", kit_.name);
        head.line("notes",
                  fmt::format("{} = {} strokes + {} left out + {} doubles", score_.notes.size(),
                              plan_.strokes.size(), plan_.left_out.size(), plan_.doubles.size()));
        head.line("hits of the hands",
                  fmt::format("{}: arms crossed unasked {}, too fast {}, too often {}", audit.hits,
                              audit.crossed, audit.too_fast, audit.too_often));
        const std::string text = head.text + account_.text;
        fmt::print("{}", text);
        std::string all = text;
        for (const auto& note : plan_.left_out) all += "left out: " + describe(note, score_) + "\n";
        for (const auto& note : plan_.doubles) all += "double: " + describe(note, score_) + "\n";
        for (const body::Through& t : through_) {
            all +=
                fmt::format("through {} at {:.3f} s: the {} stick\n", kit_.objects[t.object].name,
                            t.time, t.hand == body::Hand::left ? "left" : "right");
        }
        files::write_text(options_.folder / "report.txt", all);
    }

    const AnimateOptions& options_;
    score::Kit kit_;
    score::Score score_;
    body::Skeleton skeleton_;
    score::KitPlan plan_;
    std::unique_ptr<body::KitAnimation> animation_;
    std::vector<body::StrokeCheck> checks_;
    std::vector<body::Through> through_;
    Account account_;
    double duration_ = 0.0;  ///< [s]
};

void animate(const AnimateOptions& options) {
    try {
        Animator(options).write();
    } catch (const std::invalid_argument& error) {
        throw std::runtime_error(error.what());
    }
}

}  // namespace

void add_animate_command(CLI::App& program) {
    auto options = std::make_shared<AnimateOptions>();
    CLI::App& command = *program.add_subcommand(
        "animate",
        "a drummer plays a score on a whole kit, key-framed, into files: motion.bvh, motion.glb, "
        "objects.csv, strokes.csv, keys.csv, report.txt, song.wav");
    command.add_option("score", options->score,
                       "a MIDI or MusicXML file, or a recording whose drums are played");
    command.add_option("-o,--output", options->folder, "folder for the files")->required();
    command.add_option("--kit", options->kit, "a kit file; none: the standard kit");
    command.add_option("--write-kit", options->write_kit,
                       "also write the kit with all its poses into this file, to be edited");
    command.add_option("--frames", options->frames, "of the motion [Hz]")
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    command.add_option("--sample-rate", options->sample_rate, "of the sound [Hz]")
        ->check(CLI::Range(8000, 192000))
        ->capture_default_str();
    command
        .add_option("--pictures", options->pictures,
                    "drawings from the front and above, at these times [s]")
        ->delimiter(',');
    command.add_flag("--simulated", options->simulated,
                     "the body, its sticks and pedals as physics has them, at 1000 steps a second: "
                     "contacts and rebounds are real");
    command.add_option("--audio", options->audio,
                       "a recording that is in song.wav beside the kit, which has its sample rate; "
                       "without a score its drums are played");
    command.add_flag("--film", options->film,
                     "also film.mp4, which needs Pd, Gem, Xvfb and ffmpeg (`film --kit` has more "
                     "to choose)");
    command.add_flag("--silent", options->silent, "no song.wav");
    command.callback([options] {
        if (options->score.empty()) options->score = options->audio;
        animate(*options);
    });
}

}  // namespace percussionist::app
