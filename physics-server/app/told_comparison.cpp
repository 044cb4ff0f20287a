#include "app/told_comparison.hpp"

#include <fmt/format.h>

namespace percussionist::app {

using files::RecordKind;

ToldComparison::ToldComparison(const files::Recording& recording) : recording_(recording) {
    from_ = recording.end + 1;
    for (const files::Record& record : recording.records) {
        if (record.kind != RecordKind::told) continue;
        if (recorded_++ == 0) from_ = record.step;
    }
}

void ToldComparison::told(std::int64_t step, const osc::Packet& packet) {
    const auto& records = recording_.records;
    if (step < from_) return;
    while (next_ < records.size() && records[next_].kind != RecordKind::told) ++next_;
    // What is cut off in a file may be told all the same.
    if (next_ == records.size() && recording_.cut) return;
    ++compared_;
    const bool same =
        next_ < records.size() && records[next_].step == step && records[next_].bytes == packet;
    if (next_ < records.size()) ++next_;
    if (same) return;
    if (differing_++ == 0) first_difference_ = step;
}

std::string ToldComparison::describe() const {
    if (recorded_ == 0) return "told               nothing was recorded\n";
    if (same())
        return fmt::format("told               {} of {} the same to the last bit\n", compared_,
                           recorded_);
    return fmt::format("told               {} of {}, {} of them otherwise, the first at step {}\n",
                       compared_, recorded_, differing_, first_difference_);
}

}  // namespace percussionist::app
