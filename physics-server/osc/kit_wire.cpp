// What a drummer at a kit tells, as OSC packets.
#include "osc/bundle.hpp"

namespace percussionist::osc {

Packet encode(const ObjectsMessage& message, double lookahead) {
    Bundle bundle = make_bundle(message.wall + lookahead);
    for (const ObjectMotion& o : message.objects) {
        lo_bundle_add_message(bundle.get(), "/object",
                              make_message(o.object, o.flash, o.turn[0], o.turn[1], o.turn[2],
                                           o.lift, o.pedal, o.beater));
    }
    return serialise(bundle);
}

Packet encode(const KitMessage& kit, double lookahead) {
    Bundle bundle = make_bundle(kit.wall + lookahead);
    std::int32_t number = 0;
    for (const KitMessage::Object& o : kit.objects) {
        lo_bundle_add_message(bundle.get(), "/kit/object",
                              make_message(number++, o.name, o.kind, o.middle[0], o.middle[1],
                                           o.middle[2], o.orientation[0], o.orientation[1],
                                           o.orientation[2], o.orientation[3], o.radius, o.depth));
    }
    number = 0;
    for (const KitMessage::Pedal& p : kit.pedals) {
        lo_bundle_add_message(bundle.get(), "/kit/pedal",
                              make_message(number++, p.object, p.heel[0], p.heel[1], p.heel[2],
                                           p.length, p.direction, p.down, p.up, p.pivot[0],
                                           p.pivot[1], p.pivot[2], p.beater_length, p.beater_lean));
    }
    number = 0;
    for (const KitMessage::Event& e : kit.events) {
        lo_bundle_add_message(bundle.get(), "/kit/event",
                              make_message(number++, e.name, e.object, e.damping));
    }
    return serialise(bundle);
}

Packet encode(const TickMessage& tick, double lookahead) {
    return one_message(tick.wall + lookahead, "/tick", tick.time,
                       static_cast<float>(tick.position));
}

Packet encode(const NotedMessage& noted, double lookahead) {
    return one_message(noted.wall + lookahead, "/noted", noted.key, noted.limb, noted.object,
                       noted.ahead);
}

}  // namespace percussionist::osc
