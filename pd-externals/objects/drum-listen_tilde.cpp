// [drum-listen~ SENSITIVITY]: hears which drums are struck; see core/listening/live_listener.hpp.
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/listening/live_listener.hpp"
#include "pdx/object.hpp"

namespace {

using namespace percussionist::pdx;
namespace listening = percussionist::listening;
using listening::LiveEvent;
using listening::OwnDrums;

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path + ": cannot be opened");
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

/// The listener hears floats, whatever Pd's samples are.
template <class Any>
std::span<const float> floats(const Any* samples, std::size_t size, std::vector<float>& room) {
    if constexpr (std::is_same_v<Any, float>) {
        return {samples, size};
    } else {
        std::transform(samples, samples + size, room.begin(),
                       [](Any sample) { return static_cast<float>(sample); });
        return {room.data(), size};
    }
}

class DrumListen : public Object {
  public:
    DrumListen(Box& box, const Arguments& creation)
        : Object(box), clock_(*this, [this] { tell_all(); }) {
        settings_.sensitivity = static_cast<float>(creation.number(0));
        listener_ = std::make_unique<listening::LiveListener>(settings_, listening::learnt_drums());
    }

    void learn(const Arguments& a) {
        OwnDrums drums = listener_->own_drums();
        const auto drum = drums.named(a.word(0));
        if (!drum)
            throw std::runtime_error(
                "expected a name of up to 31 characters, for one of at most 16 drums");
        listener_->set_own_drums(drums);
        listener_->learn(*drum, a.integer(1));
    }
    void forget(const Arguments&) { listener_->set_own_drums({}); }
    void save(const Arguments& a) {
        write_text(path_of(a.word(0)), listening::to_text(listener_->own_drums()));
    }
    void load(const Arguments& a) {
        listener_->set_own_drums(listening::own_drums_from_text(read_text(find_file(a.word(0)))));
    }

    void sensitivity(const Arguments& a) {
        settings_.sensitivity = static_cast<float>(a.number(0));
        listener_->set_sensitivity(settings_.sensitivity);
    }
    void reset(const Arguments&) {
        listener_->reset();
        count_ = 0;
    }

    void print(const Arguments&) {
        const OwnDrums& drums = listener_->own_drums();
        post("sensitivity " + std::to_string(settings_.sensitivity) +
             ", drums of your own: " + std::to_string(drums.size()));
        for (std::size_t i = 0; i < drums.size(); ++i) {
            post(std::string(drums[i].name.data()) + ", learnt from " +
                 std::to_string(drums[i].strokes) + " strokes");
        }
    }

    void prepare(double sample_rate, std::size_t block_size) override {
        as_floats_.resize(block_size);
        if (sample_rate == settings_.rate) return;
        auto settings = settings_;
        settings.rate = sample_rate;
        auto other = std::make_unique<listening::LiveListener>(settings, listening::learnt_drums());
        other->take_drums(*listener_);
        listener_ = std::move(other);
        settings_ = settings;
        heard_ = 0;
    }

    void process(const Block& block) noexcept override {
        listener_->process(floats(block.inputs[0], block.size, as_floats_),
                           [&](const LiveEvent& event, std::size_t samples) {
                               if (count_ == kMostWaiting) return;
                               const double now =
                                   static_cast<double>(heard_ + samples) / block.sample_rate;
                               waiting_[count_++] = {event, now - event.time};
                           });
        heard_ += block.size;
        if (count_ > 0) clock_.delay(0.0);
    }

  private:
    static constexpr std::size_t kMostWaiting = 256;
    struct Waiting {
        LiveEvent event;
        double age = 0.0;  ///< since the stroke sounded [s]
    };

    void tell_all() {
        for (std::size_t i = 0; i < count_; ++i) tell(waiting_[i]);
        count_ = 0;
    }

    void tell(const Waiting& waiting) const {
        const LiveEvent& event = waiting.event;
        if (event.kind == LiveEvent::Kind::attack) {
            send(0, "attack", std::array<Atom, 1>{waiting.age});
            return;
        }
        const bool own = event.kind == LiveEvent::Kind::own_drum;
        const char* name = own ? listener_->own_drums()[event.own].name.data()
                               : listening::name(event.drum).data();
        send(0, own ? "own" : "drum",
             std::array<Atom, 4>{name, event.velocity, event.confidence, waiting.age});
    }

    listening::LiveSettings settings_;
    std::unique_ptr<listening::LiveListener> listener_;
    Clock clock_;
    std::vector<float> as_floats_;
    std::array<Waiting, kMostWaiting> waiting_{};
    std::size_t count_ = 0;
    std::size_t heard_ = 0;  ///< samples
};

}  // namespace

PDX_SETUP(setup_drum0x2dlisten_tilde) {
    const listening::LiveSettings usual;
    const auto sensitivity = number("sensitivity").from(0.5).to(5);
    add_class(
        describe<DrumListen>("drum-listen~", "hears which drums are struck, and how hard")
            .creation({sensitivity.by_default(usual.sensitivity)})
            .message("learn", {word("name"), number("strokes").from(1).to(100).by_default(5)},
                     "the next strokes are a drum of your own", &DrumListen::learn)
            .message("forget", {}, "all drums of your own", &DrumListen::forget)
            .message("save", {word("file")}, "the drums of your own", &DrumListen::save)
            .message("load", {word("file")}, "the drums of your own, as save wrote them",
                     &DrumListen::load)
            .message("sensitivity", {sensitivity}, "how sudden a sound must be: less hears more",
                     &DrumListen::sensitivity)
            .message("reset", {}, "forgets what it heard, but not your drums", &DrumListen::reset)
            .message("print", {}, "prints settings and your drums", &DrumListen::print)
            .signal_inlet("what to listen to")
            .outlet("attack AGE; drum NAME VELOCITY CONFIDENCE AGE; own, the same, of your drums: "
                    "AGE in s since it sounded"));
}
