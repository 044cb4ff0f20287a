// The server's recordings: what it is told, one that is made, one that is played again.
#include <stdexcept>

#include "app/named_file.hpp"
#include "app/server.hpp"
#include "files/text_file.hpp"
#include "osc/wire.hpp"

namespace percussionist::app {

void Server::hear(const osc::Heard& heard) {
    if (osc::needs_kit(heard.command)) {
        endpoint_.answer(heard.sender, "/error",
                         {heard.address, "expected a whole kit: percussionist serve --kit"});
        return;
    }
    // A replay goes its own way.
    if (options_.replay && shapes_performance(heard.command)) return;
    tape_.heard(steps(), heard);
    obey_or_refuse(heard);
}

void Server::obey_or_refuse(const osc::Heard& heard) {
    try {
        obey(heard);
    } catch (const std::exception& error) {
        endpoint_.answer(heard.sender, "/error", {heard.address, error.what()});
    }
}

void Server::play_again() {
    const files::Recording& take = *options_.replay;
    for (; replayed_ < take.records.size(); ++replayed_) {
        const files::Record& record = take.records[replayed_];
        if (record.step > steps()) break;
        if (record.kind == files::RecordKind::score) {
            const files::PackedScore score = files::unpack_score(record.bytes);
            use(load_kept_score({score.name, {score.bytes.begin(), score.bytes.end()}},
                                options_.simulation.person));
        } else if (record.kind == files::RecordKind::heard) {
            osc::decode(record.bytes, [this](const auto& path, const auto arguments) {
                const auto said = osc::understand(path, arguments);
                const auto* command = std::get_if<osc::Command>(&said);
                if (command == nullptr || !shapes_performance(*command)) return;
                const osc::Heard heard{*command, path, {arguments.begin(), arguments.end()}, {}};
                tape_.heard(steps(), heard);
                obey_or_refuse(heard);
            });
        }
    }
    ended_ = steps() >= take.end;
}

void Server::record(const osc::Heard& heard, const std::string& file) {
    std::string said = "ended";
    if (file.empty()) {
        const std::string fault = tape_.end(steps());
        if (!fault.empty()) throw std::runtime_error(fault);
    } else {
        const auto path = named_file(options_.score_folder, file, ".recording");
        require_room(path);
        tape_.require_idle();
        files::create_new(path);
        tape_.begin(path);
        said = file + ".recording";
    }
    endpoint_.answer(heard.sender, "/reply", {heard.address, said});
}

}  // namespace percussionist::app
