#include "app/kit_server.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "app/body_messages.hpp"
#include "app/kit_messages.hpp"
#include "app/kit_sound.hpp"
#include "app/named_file.hpp"
#include "app/route_file.hpp"
#include "app/score_loader.hpp"
#include "files/kit_file.hpp"
#include "files/text_file.hpp"

namespace percussionist::app {

namespace {

constexpr double kStep = 0.002;  // of key frames [s]
constexpr double kTickInterval = 0.1;
/// From /play to the score's time 0: he takes up his sticks [s].
constexpr double kLeadIn = 1.0;
constexpr double kRingOut = 3.0;  // after the last stroke [s]
/// Where no stroke is: he rests.
constexpr double kBeforeAll = -10.0;
/// A tag farther from now comes from a clock that is not ours [s].
constexpr double kSameClock = 1.0;
constexpr double kOldest = 10.0;  // place told [s]

}  // namespace

KitServer::KitServer(const KitServeOptions& options, WallClock& clock)
    : options_(options),
      kit_text_(kit_text(options.kit)),
      drummer_(load_kit(options.kit)),
      endpoint_(options.endpoint, [&clock] { return clock.now(); }),
      loading_(endpoint_, "another score is being read"),
      saving_(endpoint_, "a file is being written"),
      step_(options.simulated ? sim::SimulatedDrummer::kStep : kStep),
      pace_(clock, step_) {
    if (options.simulated) {
        body_ = std::make_unique<sim::SimulatedDrummer>(
            drummer_, kit_bodies(drummer_.kit(), options.kit.parent_path()));
    }
    song_.hold(kBeforeAll);
    use(load_kit_score(options.score, drummer_.kit()));
}

body::LiveKit& KitServer::player() {
    if (body_) return *body_;
    return drummer_;
}

const body::LiveKit& KitServer::player() const {
    if (body_) return *body_;
    return drummer_;
}

void KitServer::use(KitScore loaded) {
    print_account(in_brief(loaded), loaded.remarks);
    player().load(loaded.strokes);
    score_ = std::move(loaded);
    stop_playing();
}

template <class Message>
void KitServer::tell(Message message) {
    message.wall = pace_.wall(message.wall);
    endpoint_.tell(std::move(message));
}

void KitServer::run(const std::atomic<bool>& stop) {
    pace_.begin();
    if (options_.play) play();
    while (!stop && !ended_) {
        for (const osc::Heard& heard : endpoint_.take_commands()) hear(heard);
        take_errands();
        pace_.catch_up([this] {
            step();
            return !ended_;
        });
        pace_.wait();
    }
    if (options_.log_folder.empty()) return;
    std::filesystem::create_directories(options_.log_folder);
    log_.write_csv(options_.log_folder / "contacts.csv");
}

void KitServer::step() {
    time_ = static_cast<double>(++steps_) * step_;
    player().step(time_, song_.advance(time_));
    for (const body::KitContact& contact : player().contacts()) tell_contact(contact);
    tell_due();
    check_end();
}

void KitServer::tell_due() {
    if (time_ >= next_pose_) tell_pose();
    if (time_ >= next_tick_) {
        next_tick_ += kTickInterval;
        tell(osc::TickMessage{time_, time_ + options_.endpoint.lookahead, song_.position()});
    }
    if (changed_ || time_ >= next_status_) tell_state();
    if (time_ >= next_status_) {
        tell_scene();
        tell_status();
    }
}

void KitServer::hear(const osc::Heard& heard) {
    const auto refuse = [&](const std::string& reason) {
        endpoint_.answer(heard.sender, "/error", {heard.address, reason});
    };
    try {
        if (!obey(heard)) refuse("not at a kit; /describe lists what is");
    } catch (const std::exception& error) {
        refuse(error.what());
    }
}

bool KitServer::obey(const osc::Heard& heard) {
    const osc::Command& command = heard.command;
    if (std::holds_alternative<osc::Play>(command)) {
        play();
    } else if (std::holds_alternative<osc::Stop>(command)) {
        stop_playing();
    } else if (const auto* tempo = std::get_if<osc::Tempo>(&command)) {
        song_.tempo().glide(time_, tempo->factor, tempo->seconds);
    } else if (const auto* rubato = std::get_if<osc::Rubato>(&command)) {
        song_.tempo().sway(time_, rubato->depth, rubato->period);
    } else if (const auto* place = std::get_if<osc::SongPosition>(&command)) {
        follow(*place, heard);
        return true;  // it comes often: no reason to tell all
    } else if (const auto* pause = std::get_if<osc::SongPause>(&command)) {
        song_.hold(pause->position);
    } else if (const auto* note = std::get_if<osc::Note>(&command)) {
        answer_note(*note, heard);
        return true;
    } else if (const auto* score = std::get_if<osc::LoadScore>(&command)) {
        begin_loading(heard, score->path);
    } else if (const auto* routes = std::get_if<osc::SaveRoutes>(&command)) {
        save_routes(saving_, heard, options_.score_folder, routes->file, endpoint_.routes());
    } else if (const auto* kit = std::get_if<osc::SaveKit>(&command)) {
        save_kit(heard, kit->file);
    } else {
        return edit(command);
    }
    changed_ = true;
    return true;
}

void KitServer::play() {
    song_.play(time_, -kLeadIn);
    performing_ = true;
    asked_ = 0;
    log_.clear();
    tell(osc::StartedMessage{song_.tempo().time_of(0.0),
                             static_cast<float>(song_.tempo().factor(time_))});
}

void KitServer::stop_playing() {
    song_.hold(kBeforeAll);
    performing_ = false;
    changed_ = true;
}

void KitServer::follow(const osc::SongPosition& told, const osc::Heard& heard) {
    double at = pace_.time(heard.wall);
    if (told.heard_at) {
        at = *told.heard_at;
    } else if (heard.tag && std::abs(*heard.tag - heard.wall) < kSameClock) {
        at = pace_.time(*heard.tag);
    }
    at -= options_.endpoint.lookahead;
    if (std::abs(at - time_) > kOldest) {
        throw std::invalid_argument(
            fmt::format("AT: expected the time that /tick tells, within {} s of {:.3f}, got {:.3f}",
                        kOldest, time_, at));
    }
    if (song_.course() == score::SongClock::Course::alone || !performing_) {
        if (song_.position() <= kBeforeAll) {
            asked_ = 0;
            log_.clear();
        }
        changed_ = true;
    }
    performing_ = true;
    song_.told(time_, at, told.position);
}

void KitServer::answer_note(const osc::Note& note, const osc::Heard& heard) {
    if (note.velocity <= 0.0) return;  // let go
    const score::Kit& kit = drummer_.kit();
    const int event = kit.keys[static_cast<std::size_t>(note.key)];
    if (event == score::kNotOfTheKit) {
        throw std::invalid_argument(fmt::format("key {} is none of the kit's", note.key));
    }
    const auto struck = static_cast<std::size_t>(event);
    const bool at_once = note.sound == osc::NoteSound::now;
    const body::LiveStroke stroke =
        player().strike(struck, note.velocity, note.sound != osc::NoteSound::contact);
    // With nobody to strike it, it sounds all the same.
    if (at_once || (!stroke.limb && note.sound == osc::NoteSound::contact)) {
        const score::KitEvent& e = kit.events[struck];
        const score::Limb limb = stroke.limb.value_or(e.foot.value_or(score::Limb::right_hand));
        tell_contact({time_, limb, struck, note.velocity, -1, false});
    }
    const double waited = pace_.wall(time_) - heard.wall;
    tell(osc::NotedMessage{time_, note.key, stroke.limb ? static_cast<int>(*stroke.limb) : -1,
                           static_cast<int>(kit.events[struck].object),
                           static_cast<float>(stroke.time - time_ + waited)});
}

bool KitServer::edit(const osc::Command& command) {
    if (const auto* show = std::get_if<osc::ShowPose>(&command)) {
        drummer_.show(shown_pose(*show, drummer_.kit()));
    } else if (const auto* turn = std::get_if<osc::TurnJoint>(&command)) {
        const auto& shown = drummer_.shown();
        if (!shown) throw std::invalid_argument("no pose is shown; /pose/show chooses one");
        drummer_.edit(score::PoseEdit{shown->limb,
                                      shown->event,
                                      shown->up,
                                      turn->joint,
                                      {turn->angles[0], turn->angles[1], turn->angles[2]}});
    } else if (const auto* script = std::get_if<osc::SetScript>(&command)) {
        drummer_.edit(files::parse_script(script->line));
    } else {
        return false;
    }
    changed_ = true;
    return true;
}

void KitServer::begin_loading(const osc::Heard& heard, const std::string& name) {
    loading_.begin(
        heard,
        [folder = options_.score_folder, name, kit = drummer_.kit()] {
            return load_kit_score(score_in_folder(folder, name), kit);
        },
        in_brief<KitScore>);
}

void KitServer::save_kit(const osc::Heard& heard, const std::string& file) {
    saving_.begin(
        heard,
        [folder = options_.score_folder, file, text = kit_text_with(kit_text_, drummer_.kit())] {
            const std::filesystem::path path = named_file(folder, file, ".kit");
            require_room(path);
            files::replace_text(path, text);
            return path.filename().string();
        },
        std::identity());
}

void KitServer::take_errands() {
    saving_.take([](const std::string&) {});
    loading_.take([this](KitScore read) { use(std::move(read)); });
}

void KitServer::tell_contact(const body::KitContact& contact) {
    if (contact.sounded) return;
    if (contact.stroke >= 0) ++asked_;
    osc::ContactMessage message = contact_message(contact, drummer_.kit());
    message.sequence = sequence_++;
    log_.add(logged_contact(message, contact));
    tell(std::move(message));
}

void KitServer::tell_pose() {
    next_pose_ += kPoseInterval;
    tell(pose_message(time_, player().skeleton(), player().placement()));
    tell(objects_message(time_, player()));
}

void KitServer::tell_scene() {
    tell(scene_message(time_, drummer_.skeleton()));
    tell(kit_message(time_, drummer_.kit()));
}

void KitServer::tell_state() {
    changed_ = false;
    osc::StateMessage state;
    state.wall = time_;
    const double length = score_.strokes.empty() ? 0.0 : score_.strokes.back().time;
    state.items = {{"tempo", {song_.tempo().factor(time_), song_.tempo().goal()}},
                   {"rubato", {song_.tempo().depth(), song_.tempo().period()}},
                   {"playing", {song_.course() == score::SongClock::Course::still ? 0.0 : 1.0}},
                   {"song", {score_.title, length}},
                   {"kit", {drummer_.kit().name}}};
    for (auto& item : pose_items(drummer_)) state.items.push_back(std::move(item));
    tell(std::move(state));
}

void KitServer::tell_status() {
    next_status_ += kStatusInterval;
    osc::StatusMessage status;
    status.wall = status.time = time_;
    status.load = static_cast<float>(pace_.take_busy() / kStatusInterval);
    status.late_steps = pace_.late_steps();
    status.strokes = asked_ + player().passed_over();
    status.contacts = static_cast<int>(log_.contacts().size());
    tell(status);
}

void KitServer::check_end() {
    const double last = score_.strokes.empty() ? 0.0 : score_.strokes.back().time;
    if (!performing_ || song_.position() < last + kRingOut) return;
    performing_ = false;
    changed_ = true;
    tell(osc::FinishedMessage{time_, asked_, static_cast<int>(log_.contacts().size())});
    ended_ = options_.quit_at_end;
    if (song_.course() == score::SongClock::Course::alone) stop_playing();
}

}  // namespace percussionist::app
