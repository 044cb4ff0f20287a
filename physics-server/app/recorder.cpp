#include "app/recorder.hpp"

#include <exception>
#include <utility>

namespace percussionist::app {

Recorder::Recorder(const std::filesystem::path& path)
    : writer_(path), thread_([this] { write(); }) {}

Recorder::~Recorder() {
    if (thread_.joinable()) finish(0);
}

void Recorder::add(files::Record record) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(record));
    }
    wake_.notify_one();
}

std::string Recorder::finish(std::int64_t step) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back({files::RecordKind::end, step, {}});
        ending_ = true;
    }
    wake_.notify_one();
    thread_.join();
    return fault_;
}

void Recorder::write() {
    std::int64_t last = 0;
    while (true) {
        std::vector<files::Record> records;
        bool ending = false;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            records.swap(waiting_);
            ending = ending_;
        }
        for (const files::Record& record : records) {
            last = std::max(last, record.step);
            if (record.kind != files::RecordKind::end)
                writer_.add(record.kind, record.step, record.bytes);
        }
        if (!ending) continue;
        try {
            writer_.finish(last);
        } catch (const std::exception& error) {
            fault_ = error.what();
        }
        return;
    }
}

}  // namespace percussionist::app
