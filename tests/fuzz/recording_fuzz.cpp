// Any bytes: a recording is read, in order, or one RecordingError comes.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "files/recording_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::files;
    try {
        const Recording take = parse_recording({reinterpret_cast<const char*>(data), size}, "fuzz");
        std::int64_t last = 0;
        for (const Record& record : take.records) {
            if (record.step < last || record.step > take.end) std::abort();
            last = record.step;
            if (record.kind == RecordKind::score) unpack_score(record.bytes);
        }
        if (take.records.empty() || take.records[0].kind != RecordKind::settings) std::abort();
    } catch (const RecordingError&) {
    }
    return 0;
}
