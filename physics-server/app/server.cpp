#include "app/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <type_traits>

#include "app/body_messages.hpp"
#include "app/gesture_library.hpp"
#include "app/route_file.hpp"
#include "osc/wire.hpp"

namespace percussionist::app {

namespace {

/// A step this much behind the clock counts as late [s].
constexpr double kLate = 0.005;
/// Behind by more than this, simulated time pauses rather than rushes [s].
constexpr double kGiveUp = 0.5;
constexpr double kPoseInterval = 1.0 / 60.0;
constexpr double kStatusInterval = 1.0;

/// As a recording holds it. Nothing of what depends on how busy the machine is (the status), or is
/// told by routes alone.
template <class Message>
osc::Packet recorded(const Message& message) {
    if constexpr (std::is_same_v<Message, osc::ContactMessage>) {
        return osc::encode(message, {}, 0.0);
    } else if constexpr (requires { osc::encode(message, 0.0); }) {
        return osc::encode(message, 0.0);
    } else {
        return {};
    }
}

}  // namespace

Server::Server(const ServeOptions& options, WallClock& clock)
    : options_(options),
      clock_(clock),
      performance_(options.simulation),
      steering_(performance_, load_gestures(options.gestures)),
      endpoint_(options.endpoint, [&clock] { return clock.now(); }),
      tape_(options.settings) {
    if (!options.recording.empty()) tape_.begin(options.recording);
    if (!options.replay) use(load_score(options.score));
}

void Server::use(LoadedScore loaded) {
    constexpr std::size_t kMostRemarks = 50;  // printing takes time
    const std::size_t shown = std::min(loaded.remarks.size(), kMostRemarks);
    for (std::size_t i = 0; i < shown; ++i) fmt::print(stderr, "{}\n", loaded.remarks[i]);
    if (shown < loaded.remarks.size()) {
        fmt::print(stderr, "and {} more remarks\n", loaded.remarks.size() - shown);
    }
    fmt::print("score: {}: {} of {} notes as strokes\n", loaded.title, loaded.strokes.size(),
               loaded.notes);
    std::fflush(stdout);
    tape_.loaded(steps(), loaded.source);
    performance_.load(std::move(loaded.strokes));
}

/// What a message says of the wall clock is simulated time until it leaves.
template <class Message>
void Server::tell(Message message) {
    if (tape_.recording() || options_.told) {
        const osc::Packet packet = recorded(message);
        if (options_.told && !packet.empty()) options_.told(steps(), packet);
        if (!packet.empty()) tape_.told(steps(), packet);
    }
    message.wall = wall(message.wall);
    endpoint_.tell(std::move(message));
}

void Server::run(const std::atomic<bool>& stop) {
    start_ = clock_.now();
    if (options_.play) hear({osc::Play{}, "/play", {}, {}});
    while (!stop && !ended_) {
        for (const osc::Heard& heard : endpoint_.take_commands()) hear(heard);
        take_loaded_score();
        catch_up(clock_.now());
        clock_.sleep_until(wall(next_step_end()));
    }
    if (tape_.recording()) {
        const std::string fault = tape_.end(steps());
        if (!fault.empty()) fmt::print(stderr, "{}\n", fault);
    }
    write_log();
}

void Server::write_log() const {
    if (options_.log_folder.empty()) return;
    std::filesystem::create_directories(options_.log_folder);
    performance_.log().write_csv(options_.log_folder / "contacts.csv");
}

void Server::catch_up(double now) {
    const double behind = now - wall(next_step_end());
    if (behind > kGiveUp) {
        start_ += behind;
        late_steps_ += static_cast<int>(behind / performance_.simulation().step_length());
        fmt::print(stderr, "held up for {:.2f} s: simulated time paused\n", behind);
    }
    while (wall(next_step_end()) <= now && !ended_) {
        if (now - wall(next_step_end()) > kLate) ++late_steps_;
        step();
    }
    busy_ += clock_.now() - now;
}

double Server::next_step_end() const {
    const sim::Simulation& simulation = performance_.simulation();
    return simulation.time() + simulation.step_length();
}

void Server::step() {
    if (options_.replay) play_again();
    if (ended_) return;
    if (steering_.take_changed()) tell_state();
    const bool playing = performance_.playing();
    for (const LoggedContact& contact : performance_.step()) tell_contact(contact);
    for (const Asked& given : performance_.player().given()) tell_strike(given);
    const double time = performance_.simulation().time();
    if (time >= next_pose_) tell_pose();
    if (time >= next_status_) {
        tell_scene();
        tell_state();
        tell_status();
    }
    if (playing && !performance_.playing()) tell_finished();
    if (options_.stepped) options_.stepped(performance_);
}

void Server::obey(const osc::Command& command) {
    if (std::holds_alternative<osc::Play>(command)) {
        play();
    } else if (std::holds_alternative<osc::Stop>(command)) {
        performance_.stop();
    } else if (const auto* score = std::get_if<osc::LoadScore>(&command)) {
        begin_loading(*score);
    } else if (const auto* save = std::get_if<osc::SaveRoutes>(&command)) {
        save_routes(*save);
    } else if (const auto* wish = std::get_if<osc::Record>(&command)) {
        record(*wish);
    } else {
        steer(command);
    }
}

void Server::steer(const osc::Command& command) {
    try {
        steering_.obey(command);
    } catch (const std::invalid_argument& error) {
        // Only of names is it not known before whether there is such a thing.
        const auto* nuance = std::get_if<osc::SetNuance>(&command);
        if (nuance != nullptr) endpoint_.answer(nuance->asker, "/error", {"/nuance", error.what()});
    }
}

void Server::begin_loading(const osc::LoadScore& wish) {
    if (loading_.valid()) {
        endpoint_.answer(wish.asker, "/error", {"/score", "another score is being read"});
        return;
    }
    // Reading a file takes longer than a step: another thread does it.
    loading_ = std::async(std::launch::async, [this, wish] {
        try {
            LoadedScore loaded = load_score(score_in_folder(options_.score_folder, wish.path));
            endpoint_.answer(wish.asker, "/reply",
                             {"/score", fmt::format("{}: {} of {} notes", loaded.title,
                                                    loaded.strokes.size(), loaded.notes)});
            return loaded;
        } catch (const std::exception& error) {
            endpoint_.answer(wish.asker, "/error", {"/score", error.what()});
            throw;
        }
    });
}

void Server::play() {
    performance_.play();
    const Player& player = performance_.player();
    const double factor = player.tempo().factor(performance_.simulation().time());
    tell(osc::StartedMessage{player.origin(), static_cast<float>(factor)});
}

void Server::save_routes(const osc::SaveRoutes& wish) {
    if (saving_.valid() && saving_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        endpoint_.answer(wish.asker, "/error", {"/route/save", "routes are being written"});
        return;
    }
    saving_ = std::async(std::launch::async, [this, wish] {
        try {
            write_routes(options_.score_folder, wish.file, endpoint_.routes());
            endpoint_.answer(wish.asker, "/reply", {"/route/save", wish.file + ".routes"});
        } catch (const std::exception& error) {
            endpoint_.answer(wish.asker, "/error", {"/route/save", error.what()});
        }
    });
}

void Server::take_loaded_score() {
    if (!loading_.valid() ||
        loading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return;
    }
    try {
        use(loading_.get());
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());  // what was loaded before plays on
    }
}

void Server::tell_contact(const LoggedContact& contact) {
    const sim::ContactEvent& c = contact.event;
    osc::ContactMessage m;
    m.sequence = contact.sequence;
    m.hand = static_cast<int>(c.hand);
    m.drum = c.drum;
    m.stroke = contact.stroke;
    m.wall = c.instant;
    m.instant = c.instant;
    m.place = floats<2>(c.place);
    m.velocity = floats<3>(c.velocity);
    m.force = floats<3>(c.peak_force);
    m.impulse = static_cast<float>(c.impulse);
    m.duration = static_cast<float>(c.duration);
    m.mass = static_cast<float>(c.effective_mass);
    m.recontact = c.recontact;
    tell(m);
}

void Server::tell_strike(const Asked& given) {
    const double now = performance_.simulation().time();
    tell(osc::StrikeMessage{now, static_cast<int>(given.hand), static_cast<int>(given.stroke),
                            static_cast<float>(given.time - now),
                            static_cast<float>(given.shape.impact),
                            static_cast<float>(given.shape.rise)});
}

void Server::tell_pose() {
    next_pose_ += kPoseInterval;
    const sim::Simulation& simulation = performance_.simulation();
    tell(pose_message(simulation.time(), simulation.skeleton(), simulation.placement()));
}

void Server::tell_scene() {
    const sim::Simulation& simulation = performance_.simulation();
    osc::SceneMessage scene = scene_message(simulation.time(), simulation.skeleton());
    scene.drums.push_back({0, floats<3>(simulation.head_centre()),
                           static_cast<float>(simulation.options().head.membrane.radius)});
    tell(std::move(scene));
}

void Server::tell_state() {
    tell(steering_.state(performance_.simulation().time()));
}

void Server::tell_status() {
    next_status_ += kStatusInterval;
    const double time = performance_.simulation().time();
    osc::StatusMessage status;
    status.wall = time;
    status.time = time;
    status.load = static_cast<float>(busy_ / kStatusInterval);
    status.late_steps = late_steps_;
    status.strokes = performance_.player().asked();
    status.contacts = static_cast<int>(performance_.log().contacts().size());
    busy_ = 0.0;
    tell(status);
}

void Server::tell_finished() {
    const TimingSummary summary = performance_.summary();
    tell(osc::FinishedMessage{performance_.simulation().time(), summary.strokes, summary.contacts});
    ended_ = options_.quit_at_end;
}

}  // namespace percussionist::app
