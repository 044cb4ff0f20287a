#include "app/recorder.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/named_file.hpp"

namespace percussionist::app {

namespace {

/// Minutes of playing: a disk that does not write for that long is none to record on.
constexpr std::size_t kMostWaiting = 64U << 20U;  // [bytes]
/// That much of a record counts: a score comes in one piece, of any size.
constexpr std::size_t kMostOfOne = 1U << 20U;

}  // namespace

Recorder::Recorder(const std::filesystem::path& path, std::uintmax_t spare,
                   std::vector<files::Record> before)
    : path_(path), spare_(spare), writer_(path), waiting_(std::move(before)), thread_([this] {
          write();
      }) {}

Recorder::~Recorder() {
    if (thread_.joinable()) finish(0);
}

void Recorder::add(files::Record record) {
    {
        const std::lock_guard lock(mutex_);
        if (stopped_) return;
        waiting_bytes_ += std::min(sizeof(record) + record.bytes.size(), kMostOfOne);
        if (waiting_bytes_ > kMostWaiting) {
            stopped_ = true;
            fault_ = path_.string() + ": the disk is too slow; the recording ends early";
            return;
        }
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

bool Recorder::disk_is_full(std::size_t more) {
    unchecked_ += more;
    if (unchecked_ < kCheckEach) return false;
    unchecked_ = 0;
    std::error_code error;
    const auto space = std::filesystem::space(folder_of(path_), error);
    return !error && space.available < spare_;
}

void Recorder::write(const std::vector<files::Record>& records) {
    for (const files::Record& record : records) {
        last_ = std::max(last_, record.step);
        if (record.kind == files::RecordKind::end) return;
        if (disk_is_full(record.bytes.size())) {
            const std::lock_guard lock(mutex_);
            stopped_ = true;
            fault_ = path_.string() + ": the disk is nearly full; the recording ends early";
            return;
        }
        writer_.add(record.kind, record.step, record.bytes);
    }
}

void Recorder::write() {
    while (true) {
        std::vector<files::Record> records;
        bool ending = false, stopped = false;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            records.swap(waiting_);
            waiting_bytes_ = 0;
            ending = ending_;
            stopped = stopped_;
        }
        if (!stopped) write(records);
        if (!ending) continue;
        const std::lock_guard lock(mutex_);
        if (stopped_) return;
        try {
            writer_.finish(last_);
        } catch (const std::exception& error) {
            fault_ = error.what();
        }
        return;
    }
}

}  // namespace percussionist::app
