#include "files/mxl_file.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>

#include "files/musicxml_file.hpp"
#include "support/zip_writer.hpp"

using namespace percussionist;
using test::container_of;
using test::zip_of;

namespace {

const std::string kScore =
    "<?xml version=\"1.0\"?><score-partwise><part-list><score-part id=\"P1\"/></part-list>"
    "<part id=\"P1\"><measure><attributes><divisions>2</divisions></attributes>"
    "<note><unpitched/><duration>2</duration></note><note><unpitched/><duration>2</duration></note>"
    "</measure></part></score-partwise>";

std::vector<char> archive(const std::string& score) {
    return zip_of({{"META-INF/container.xml", container_of("music/score.xml")},
                   {"other.txt", "nothing"},
                   {"music/score.xml", score}});
}

std::string refusal(const std::vector<char>& bytes) {
    try {
        files::parse_musicxml(bytes, "test.mxl");
    } catch (const files::MusicXmlError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("a compressed score says what the plain one says") {
    const auto plain = files::parse_musicxml(kScore, "test.mxl");
    const auto unpacked = files::parse_musicxml(archive(kScore), "test.mxl");
    REQUIRE(unpacked.notes.size() == 2);
    CHECK(unpacked.notes[1].time == plain.notes[1].time);
    CHECK(unpacked.duration == plain.duration);
}

TEST_CASE("what an archive may become is bounded, whatever it says") {
    const std::string bomb(100'000'000, ' ');
    const auto packed = archive(bomb);
    REQUIRE(packed.size() < 200'000);
    CHECK(refusal(packed).find("at most 16000000 bytes of music/score.xml") != std::string::npos);
    const auto fat_container = zip_of({{"META-INF/container.xml", std::string(100'000, ' ')}});
    CHECK(refusal(fat_container).find("at most 65536") != std::string::npos);
    const auto inner = archive(kScore);
    CHECK(refusal(archive({inner.begin(), inner.end()})).find("an archive") != std::string::npos);
}

TEST_CASE("what is missing in an archive is named") {
    CHECK(refusal(zip_of({{"score.xml", kScore}})).find("META-INF/container.xml") !=
          std::string::npos);
    CHECK(refusal(zip_of({{"META-INF/container.xml", container_of("score.xml")}}))
              .find("expected score.xml") != std::string::npos);
    CHECK(refusal(zip_of({{"META-INF/container.xml", "<container/>"}})).find("full-path") !=
          std::string::npos);
    CHECK(refusal({'P', 'K', 3, 4}).find("zip archive") != std::string::npos);
}

TEST_CASE("an archive that is damaged anywhere is read or refused") {
    const auto sound = archive(kScore);
    std::mt19937 random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        auto bytes = sound;
        for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
        if (trial % 4 == 0) bytes.resize(random() % bytes.size());
        try {
            files::parse_musicxml(bytes, "test.mxl");
        } catch (const files::MusicXmlError&) {
        }
    }
}
