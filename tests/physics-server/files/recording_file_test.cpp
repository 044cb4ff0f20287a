#include "files/recording_file.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

using namespace percussionist::files;

namespace {

std::vector<char> bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

std::vector<char> written(const std::vector<Record>& records, std::int64_t end) {
    const auto path = std::filesystem::temp_directory_path() / "percussionist_recording_test";
    RecordingWriter writer(path);
    for (const Record& r : records) writer.add(r.kind, r.step, r.bytes);
    writer.finish(end);
    std::ifstream in(path, std::ios::binary);
    std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
    in.close();
    std::filesystem::remove(path);
    return bytes;
}

std::vector<char> sample() {
    return written({{RecordKind::settings, 0, bytes_of("--rate\n2000\n")},
                    {RecordKind::score, 0, pack_score("song.mid", bytes_of("MThd"))},
                    {RecordKind::heard, 7, bytes_of("/play")},
                    {RecordKind::told, 7, {}},
                    {RecordKind::told, 4'000'000'000, bytes_of("#bundle")}},
                   4'000'000'001);
}

std::string refusal(const std::vector<char>& bytes) {
    try {
        parse_recording(bytes, "take.recording");
    } catch (const RecordingError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("what is written is read") {
    const Recording take = parse_recording(sample(), "take");
    REQUIRE(take.records.size() == 5);
    CHECK(!take.cut);
    CHECK(take.end == 4'000'000'001);
    CHECK(take.records[0].bytes == bytes_of("--rate\n2000\n"));
    const PackedScore score = unpack_score(take.records[1].bytes);
    CHECK(score.name == "song.mid");
    CHECK(std::string(score.bytes.begin(), score.bytes.end()) == "MThd");
    CHECK(take.records[2].kind == RecordKind::heard);
    CHECK(take.records[4].step == 4'000'000'000);
    CHECK(take.records[4].bytes == bytes_of("#bundle"));
}

TEST_CASE("a file that is cut anywhere behind its settings is read up to the last whole record") {
    const auto whole = sample();
    const std::size_t settings_end = 26 + 16 + 12;
    std::size_t records = 0;
    for (std::size_t size = 26; size < whole.size(); ++size) {
        const std::vector<char> part(whole.begin(), whole.begin() + static_cast<long>(size));
        if (size < settings_end) {
            CHECK(refusal(part).find("settings first, found the end") != std::string::npos);
            continue;
        }
        const Recording take = parse_recording(part, "take");
        CHECK(take.cut);
        CHECK(take.records.size() >= records);
        records = take.records.size();
    }
    CHECK(records == 5);
}

TEST_CASE("what is no recording is refused with file, byte and what was expected") {
    CHECK(refusal({}) == "take.recording: byte 0: expected 'percussionist recording 1', found ''");
    CHECK(refusal(bytes_of("percussionist recording 2\n")).find("byte 0") != std::string::npos);
    auto bytes = sample();
    bytes[26] = 'x';
    CHECK(refusal(bytes) ==
          "take.recording: byte 26: expected sets, scor, hear, told or ends, found 'xets'");
    bytes = sample();
    bytes[26 + 4] = 0x7F;
    CHECK(refusal(bytes).find("at most 1 GB") != std::string::npos);
    bytes = sample();
    bytes.push_back('x');
    CHECK(refusal(bytes).find("nothing after the end") != std::string::npos);
    CHECK(refusal(written({{RecordKind::heard, 0, {}}}, 0)).find("settings first") !=
          std::string::npos);
    CHECK(refusal(written({{RecordKind::settings, 5, {}}, {RecordKind::heard, 4, {}}}, 5))
              .find("a step from 5, found 4") != std::string::npos);
    CHECK(refusal(written({{RecordKind::settings, 0, {}}, {RecordKind::score, 0, {}}}, 0))
              .find("a score's name") != std::string::npos);
    CHECK_THROWS_AS(read_recording("/nowhere/take.recording"), RecordingError);
    CHECK_THROWS_AS(RecordingWriter("/nowhere/take.recording"), std::runtime_error);
}

TEST_CASE("damage anywhere gives a recording or one error") {
    const auto sound = sample();
    std::mt19937 random(1);
    for (int trial = 0; trial < 5000; ++trial) {
        auto bytes = sound;
        for (int k = 0; k < 2; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
        try {
            parse_recording(bytes, "take");
        } catch (const RecordingError&) {
        }
    }
}
