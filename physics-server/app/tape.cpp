#include "app/tape.hpp"

#include <stdexcept>
#include <utility>

#include "osc/wire.hpp"

namespace percussionist::app {

namespace {

std::size_t size(const files::Record& record) {
    return sizeof record + record.bytes.size();
}

template <class... Kinds>
bool is_one_of(const osc::Command& command) {
    return (std::holds_alternative<Kinds>(command) || ...);
}

}  // namespace

bool shapes_performance(const osc::Command& command) {
    // A score is recorded when it is in use: reading takes as long as it takes.
    return !is_one_of<osc::LoadScore, osc::SaveRoutes, osc::Record>(command);
}

Tape::Tape(const std::string& settings)
    : history_{{files::RecordKind::settings, 0, {settings.begin(), settings.end()}}},
      kept_(size(history_.front())) {}

void Tape::loaded(std::int64_t step, const ScoreSource& score) {
    keep({files::RecordKind::score, step, files::pack_score(score.name, score.bytes)});
}

void Tape::heard(std::int64_t step, const osc::Heard& heard) {
    if (!shapes_performance(heard.command)) return;
    keep({files::RecordKind::heard, step, osc::encode_exactly(heard.address, heard.arguments)});
}

void Tape::told(std::int64_t step, osc::Packet packet) {
    if (recorder_) recorder_->add({files::RecordKind::told, step, std::move(packet)});
}

void Tape::keep(files::Record record) {
    if (recorder_) recorder_->add(record);
    if (!whole_) return;
    kept_ += size(record);
    whole_ = kept_ <= kMostKept;
    if (whole_) {
        history_.push_back(std::move(record));
    } else {
        history_ = {};  // of no use any more
    }
}

void Tape::require_idle() const {
    if (recorder_) throw std::runtime_error("a recording is being made; /record ends it");
    if (!whole_) {
        throw std::runtime_error(
            "more has been told since the start than is kept; --record records from the start");
    }
}

void Tape::begin(const std::filesystem::path& path) {
    require_idle();
    recorder_ = std::make_unique<Recorder>(path, Recorder::kSpare, history_);
}

std::string Tape::end(std::int64_t step) {
    if (!recorder_) return "no recording is being made";
    const std::unique_ptr<Recorder> ending = std::move(recorder_);
    return ending->finish(step);
}

}  // namespace percussionist::app
