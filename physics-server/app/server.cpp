#include "app/server.hpp"

#include <fmt/format.h>

#include <type_traits>
#include <utility>

#include "app/body_messages.hpp"
#include "app/gesture_library.hpp"
#include "app/route_file.hpp"
#include "osc/wire.hpp"

namespace percussionist::app {

namespace {

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
      performance_(options.simulation),
      pace_(clock, performance_.simulation().step_length()),
      steering_(performance_, load_gestures(options.gestures)),
      endpoint_(options.endpoint, [&clock] { return clock.now(); }),
      tape_(options.settings),
      loading_(endpoint_, "another score is being read"),
      saving_(endpoint_, "routes are being written") {
    if (!options.recording.empty()) tape_.begin(options.recording);
    if (!options.replay) use(load_score(options.score, options.simulation.person));
}

void Server::use(LoadedScore loaded) {
    print_account(in_brief(loaded), loaded.remarks);
    tape_.loaded(steps(), loaded.source);
    performance_.load(std::move(loaded.strokes), loaded.motion);
}

/// What a message says of the wall clock is simulated time until it leaves.
template <class Message>
void Server::tell(Message message) {
    if (tape_.recording() || options_.told) {
        const osc::Packet packet = recorded(message);
        if (options_.told && !packet.empty()) options_.told(steps(), packet);
        if (!packet.empty()) tape_.told(steps(), packet);
    }
    message.wall = pace_.wall(message.wall);
    endpoint_.tell(std::move(message));
}

void Server::run(const std::atomic<bool>& stop) {
    pace_.begin();
    if (options_.play) hear({osc::Play{}, "/play", {}, {}});
    while (!stop && !ended_) {
        for (const osc::Heard& heard : endpoint_.take_commands()) hear(heard);
        take_errands();
        pace_.catch_up([this] {
            step();
            return !ended_;
        });
        pace_.wait();
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

void Server::obey(const osc::Heard& heard) {
    const osc::Command& command = heard.command;
    if (std::holds_alternative<osc::Play>(command)) {
        play();
    } else if (std::holds_alternative<osc::Stop>(command)) {
        performance_.stop();
    } else if (const auto* score = std::get_if<osc::LoadScore>(&command)) {
        begin_loading(heard, score->path);
    } else if (const auto* routes = std::get_if<osc::SaveRoutes>(&command)) {
        save_routes(saving_, heard, options_.score_folder, routes->file, endpoint_.routes());
    } else if (const auto* wish = std::get_if<osc::Record>(&command)) {
        record(heard, wish->file);
    } else {
        steering_.obey(command);
    }
}

void Server::begin_loading(const osc::Heard& heard, const std::string& name) {
    loading_.begin(
        heard,
        [folder = options_.score_folder, name, person = options_.simulation.person] {
            return load_score(score_in_folder(folder, name), person);
        },
        in_brief<LoadedScore>);
}

void Server::take_errands() {
    saving_.take([](const std::string&) {});
    loading_.take([this](LoadedScore read) { use(std::move(read)); });
}

void Server::play() {
    performance_.play();
    const Player& player = performance_.player();
    const double factor = player.tempo().factor(performance_.simulation().time());
    tell(osc::StartedMessage{player.origin(), static_cast<float>(factor)});
}

void Server::tell_contact(const LoggedContact& contact) {
    const sim::ContactEvent& c = contact.event;
    osc::ContactMessage m;
    m.sequence = contact.sequence;
    m.hand = static_cast<int>(c.hand);
    m.drum = c.drum;
    m.stroke = contact.stroke;
    put_touch(c, m);
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
    status.load = static_cast<float>(pace_.take_busy() / kStatusInterval);
    status.late_steps = pace_.late_steps();
    status.strokes = performance_.player().asked();
    status.contacts = static_cast<int>(performance_.log().contacts().size());
    tell(status);
}

void Server::tell_finished() {
    const TimingSummary summary = performance_.summary();
    tell(osc::FinishedMessage{performance_.simulation().time(), summary.strokes, summary.contacts});
    ended_ = options_.quit_at_end;
}

}  // namespace percussionist::app
