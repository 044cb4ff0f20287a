#include "app/drum_sound.hpp"

#include <algorithm>
#include <cmath>

#include "core/modal/modal_drum.hpp"

namespace percussionist::app {

namespace {

modal::Stroke stroke_of(const sim::ContactEvent& contact, const modal::Mallet& tip) {
    modal::Stroke stroke;
    stroke.velocity = std::clamp(-contact.velocity.z(), 1e-3, 100.0);
    stroke.r = std::hypot(contact.place.x(), contact.place.y());
    stroke.theta = std::atan2(contact.place.y(), contact.place.x());
    stroke.slide_x = contact.velocity.x();
    stroke.slide_y = contact.velocity.y();
    stroke.mallet = tip;
    stroke.mallet.mass = contact.effective_mass;
    return stroke;
}

}  // namespace

files::Audio drum_sound(const PerformanceLog& log, double duration, int rate,
                        const sim::DrumheadOptions& head) {
    files::Audio audio;
    audio.rate = rate;
    audio.samples.assign(static_cast<std::size_t>(std::lround(duration * rate)), 0.0);
    modal::DrumSettings settings;
    settings.body = head.membrane;
    settings.loss = head.decay;
    // On the line between the hands: both sound alike.
    settings.pickups[0].r = 0.6 * head.membrane.radius;
    settings.pickups[0].theta = 0.0;
    modal::ModalDrum drum(settings, rate);

    // Contacts are told when they end, so that two hands' may stand in the wrong order.
    std::vector<LoggedContact> contacts = log.contacts();
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const LoggedContact& a, const LoggedContact& b) {
                         return a.event.instant < b.event.instant;
                     });
    std::size_t next = 0;
    constexpr std::size_t kBlock = 64;
    for (std::size_t start = 0; start < audio.samples.size(); start += kBlock) {
        const std::size_t size = std::min(kBlock, audio.samples.size() - start);
        while (next < contacts.size()) {
            const auto at =
                static_cast<std::size_t>(std::lround(contacts[next].event.instant * rate));
            if (at >= start + size) break;
            if (!contacts[next].event.recontact) {
                drum.strike(at - start, stroke_of(contacts[next].event, head.tip));
            }
            ++next;
        }
        drum.process(std::span(audio.samples).subspan(start, size));
    }
    return audio;
}

double peak(const files::Audio& audio) {
    double most = 0.0;
    for (const double sample : audio.samples) most = std::max(most, std::abs(sample));
    return most;
}

}  // namespace percussionist::app
