#include "io/osc_inbox.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace percussionist::io {

namespace {

constexpr std::size_t kMostSenders = 16;
constexpr double kLongestLookahead = 10.0;  // [s]
constexpr double kMargin = 1.0;             // beyond that, for clocks and networks [s]
constexpr double kComplaintsApart = 1.0;    // [s]
constexpr double kReordering = 0.03;        // first packets may come that much out of order [s]
constexpr double kSilence = 0.5;            // of a sender that is otherwise heard often [s]
constexpr const char* kClock = "/clock";
constexpr const char* kContact = "/contact";

const OscMessage* find_in(const OscBundle& bundle, const char* address) {
    for (const auto& message : bundle.messages) {
        if (message.address == address) {
            return &message;
        }
    }
    return nullptr;
}

const OscMessage* find(const OscPacket& packet, const char* address) {
    for (const auto& bundle : packet.bundles) {
        const auto* const found = bundle.tag == packet.tag ? find_in(bundle, address) : nullptr;
        if (found) {
            return found;
        }
    }
    return nullptr;
}

std::optional<double> first_number(const OscMessage& message) {
    const auto& all = message.arguments;
    const auto* const number = all.empty() ? nullptr : std::get_if<double>(all.data());
    return number ? std::optional(*number) : std::nullopt;
}

/// The number that a contact is counted by; nothing where it is none that counts (NaN, 1e300).
std::optional<std::int64_t> sequence_of(const OscMessage& message) {
    constexpr double kMost = 1e15;
    const auto number = message.address == kContact ? first_number(message) : std::nullopt;
    if (!number || !(std::abs(*number) < kMost)) {
        return std::nullopt;
    }
    return static_cast<std::int64_t>(*number);
}

/// What /clock tells, if it is the protocol's.
std::optional<double> told_lookahead(const OscPacket& packet) {
    const OscMessage* const clock = find(packet, kClock);
    const auto told = clock ? first_number(*clock) : std::nullopt;
    return told && *told >= 0.0 && *told <= kLongestLookahead ? told : std::nullopt;
}

}  // namespace

std::string to_string(const Endpoint& endpoint) {
    std::string text;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        text += std::to_string(endpoint.address >> shift & 0xFFU) + (shift > 0U ? "." : ":");
    }
    return text + std::to_string(endpoint.port);
}

/// Whether it was announced for this very instant before; remembers that it is now.
bool OscInbox::Sender::announced(const OscMessage& message, TimeTag tag) {
    const bool once = message.address == "/started" || message.address == "/finished";
    if (!once) {
        return false;
    }
    const Announcement now{message.address, tag};
    if (std::find(announcements.begin(), announcements.end(), now) != announcements.end()) {
        return true;
    }
    std::rotate(announcements.begin(), std::prev(announcements.end()), announcements.end());
    announcements.front() = now;
    return false;
}

double OscInbox::Sender::due(TimeTag tag) const {
    return line.to_y(seconds_between(epoch, tag) - lookahead.value_or(0.0)) +
           lookahead.value_or(0.0);
}

void OscInbox::take(std::span<const std::uint8_t> bytes, const Endpoint& from, double arrival) {
    ++counts_.received;
    try {
        OscPacket packet = read_osc(bytes);
        Sender& who = sender(from, arrival);
        follow_clock(who, packet, arrival);
        for (OscBundle& bundle : packet.bundles) {
            if (std::erase_if(bundle.messages, [&](const auto& m) { return !affordable(m); }) > 0) {
                complain("message from " + to_string(from) +
                             " dropped: more new words than a patch can have use for",
                         arrival);
            }
            deliver(who, bundle, arrival);
        }
    } catch (const MalformedOsc& e) {
        complain("malformed packet from " + to_string(from) + ": " + e.what(), arrival);
    }
}

/// The one known by its address and port, or a new one in place of the one least worth keeping.
OscInbox::Sender& OscInbox::sender(const Endpoint& from, double arrival) {
    auto found = std::find_if(senders_.begin(), senders_.end(),
                              [&](const auto& known) { return known->from == from; });
    if (found == senders_.end()) {
        if (senders_.size() == kMostSenders) {
            const auto worth = [](const auto& known) {
                return std::pair(known->lookahead.has_value(), known->last_heard);
            };
            const auto least =
                std::min_element(senders_.begin(), senders_.end(),
                                 [&](const auto& a, const auto& b) { return worth(a) < worth(b); });
            counts_.lost += static_cast<double>((*least)->contacts.lost());
            counts_.repeated += static_cast<double>((*least)->contacts.repeated());
            senders_.erase(least);
        }
        auto fresh = std::make_unique<Sender>();
        fresh->from = from;
        fresh->first_heard = fresh->last_heard = arrival;
        senders_.push_back(std::move(fresh));
        found = std::prev(senders_.end());
    }
    if (arrival > (*found)->last_heard + kSilence) {
        (*found)->back = arrival;
    }
    (*found)->last_heard = arrival;
    return **found;
}

void OscInbox::follow_clock(Sender& sender, const OscPacket& packet, double arrival) const {
    if (packet.tag == kImmediately) {
        return;
    }
    const auto told = told_lookahead(packet);
    if (told && told != sender.lookahead) {
        sender.lookahead = told;
        sender.clock.restart();
    }
    if (!sender.clock.started()) {
        sender.epoch = packet.tag;
    }
    const double sent = seconds_between(sender.epoch, packet.tag) - sender.lookahead.value_or(0.0);
    if (told || !sender.lookahead) {
        sender.clock.observe(sent, arrival);
    } else if (find(packet, kContact)) {
        sender.clock.observe_if_early(sent, arrival);
    }
    sender.line.follow(sender.clock, sent);
}

void OscInbox::deliver(Sender& sender, OscBundle& bundle, double arrival) {
    auto delivery = std::make_unique<Delivery>();
    if (bundle.tag != kImmediately && sender.clock.started()) {
        const double due = sender.due(bundle.tag);
        if (due > arrival + kLongestLookahead + kMargin) {
            complain("bundle from " + to_string(sender.from) +
                         " dropped: its tag lies more than 10 s ahead",
                     arrival);
            return;
        }
        delivery->due = due;
        delivery->stale = due < sender.back - kReordering && find_in(bundle, kContact) != nullptr;
        std::erase_if(bundle.messages, [&](const OscMessage& message) {
            if (sender.announced(message, bundle.tag)) {
                return true;
            }
            const auto number = sequence_of(message);
            return number &&
                   (!sender.contacts.is_new(*number, static_cast<std::int64_t>(bundle.tag)) ||
                    due < sender.first_heard - kReordering);
        });
    }
    if (!bundle.messages.empty()) {
        delivery->messages = std::move(bundle.messages);
        delivery->serial = serial_++;
        deliver_(std::move(delivery));
    }
}

bool OscInbox::affordable(const OscMessage& message) {
    return words_.allows(message.address) &&
           std::all_of(message.arguments.begin(), message.arguments.end(), [&](const auto& value) {
               const auto* const word = std::get_if<std::string>(&value);
               return !word || words_.allows(*word);
           });
}

void OscInbox::complain(const std::string& text, double arrival) {
    ++counts_.malformed;
    if (arrival < complained_ + kComplaintsApart) {
        return;
    }
    complained_ = arrival;
    auto delivery = std::make_unique<Delivery>();
    delivery->serial = serial_++;
    delivery->complaint = text;
    deliver_(std::move(delivery));
}

OscInbox::Status OscInbox::status() const {
    Status status = counts_;
    status.senders = static_cast<double>(senders_.size());
    const Sender* main = nullptr;
    for (const auto& sender : senders_) {
        status.lost += static_cast<double>(sender->contacts.lost());
        status.repeated += static_cast<double>(sender->contacts.repeated());
        const auto worth = [](const Sender& s) {
            return std::tuple(s.clock.started(), s.lookahead.has_value(), s.last_heard);
        };
        main = !main || worth(*main) < worth(*sender) ? sender.get() : main;
    }
    if (main && main->clock.started()) {
        status.offset = main->clock.to_y(0.0) - static_cast<double>(main->epoch) / kTagsPerSecond;
        status.rate = -main->clock.rate();
        status.jitter = main->clock.lateness();
        status.lookahead = main->lookahead.value_or(0.0);
    }
    return status;
}

}  // namespace percussionist::io
