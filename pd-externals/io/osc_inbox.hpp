// From packets to what is due when: takes packets apart, drops what was heard before, and brings
// the time tags of each sender to this machine's clock.
//
// The protocol is docs/osc-protocol.md. A sender's clock is read off its packets: none can arrive
// before it was sent. A bundle with /clock tells how far tags lie ahead of sending; from then on
// the sender's /clock and /contact bundles are what its clock is followed by (a /contact is sent
// some time after its instant, never before). A sender that never sends /clock is followed by the
// tags of all its bundles: then a message is due as long after its tag as the quickest packet took,
// and whoever sends ahead at an even distance is heard evenly.
//
// Tag 1 and plain messages are due at once. /contact is dropped where sequence number and tag were
// heard before, and where it was due before the sender was first heard of; a stroke that comes a
// tenth of a second late is worth nothing: after a cable was out, none are rained down at once.
// /started and /finished come several times too, and once for any one tag.
//
// What is due later than the longest lookahead after it came is dropped and complained of: it would
// take the room of what is due before.
//
// What brings new words beyond those there is room for (WordBudget) is dropped and complained of.
//
// No thread, no clock: times are arguments, seconds of one monotonic clock. One thread at a time.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/timing/clock_tracker.hpp"
#include "core/timing/sequence_filter.hpp"
#include "core/timing/steady_line.hpp"
#include "io/dns_sd.hpp"
#include "io/osc_packet.hpp"
#include "io/word_budget.hpp"

namespace percussionist::io {

struct Endpoint {
    std::uint32_t address = 0;  ///< IPv4, the first number highest
    std::uint16_t port = 0;
    bool operator==(const Endpoint&) const = default;
};

/// "127.0.0.1:7770"
std::string to_string(const Endpoint& endpoint);

/// Messages due at one time; or, instead, a complaint for the user, or a server that was found.
struct Delivery {
    std::optional<double> due;  ///< none: at once [s]
    /// Of a time when the sender could not be heard: only to be counted, if it is late.
    bool stale = false;
    std::uint64_t serial = 0;  ///< counts deliveries: the order of those due together
    std::vector<OscMessage> messages;
    std::string complaint;
    std::optional<FoundServer> found;
};

class OscInbox {
  public:
    using Deliver = std::function<void(std::unique_ptr<Delivery>)>;

    struct Status {
        double received = 0;   ///< packets
        double lost = 0;       ///< contacts that never came
        double repeated = 0;   ///< contacts dropped because they were heard before
        double malformed = 0;  ///< packets, bundles too far ahead, messages of new words
        double senders = 0;
        double offset = 0;     ///< this machine's monotonic clock less the sender's time tag [s]
        double rate = 0;       ///< how much faster the sender's clock runs
        double jitter = 0;     ///< mean lateness of its packets [s]
        double lookahead = 0;  ///< [s]
    };

    explicit OscInbox(Deliver deliver) : deliver_(std::move(deliver)) {}

    /// A packet that arrived at a time.
    void take(std::span<const std::uint8_t> bytes, const Endpoint& from, double arrival);
    /// Of the clock: of the sender that sent /clock last, else of any.
    Status status() const;

  private:
    struct Sender {
        Endpoint from;
        TimeTag epoch = 0;
        double first_heard = 0.0, last_heard = 0.0;
        double back = -1e9;  // heard again after a silence
        std::optional<double> lookahead;
        timing::ClockTracker clock;
        timing::SteadyLine line;
        timing::SequenceFilter contacts{kTagsPerSecond};
        using Announcement = std::pair<std::string, TimeTag>;
        std::array<Announcement, 8> announcements{};  // the latest first

        bool announced(const OscMessage& message, TimeTag tag);
        double due(TimeTag tag) const;
    };

    Sender& sender(const Endpoint& from, double arrival);
    void follow_clock(Sender& sender, const OscPacket& packet, double arrival) const;
    void deliver(Sender& sender, OscBundle& bundle, double arrival);
    bool affordable(const OscMessage& message);
    void complain(const std::string& text, double arrival);

    Deliver deliver_;
    std::vector<std::unique_ptr<Sender>> senders_;
    Status counts_;
    std::uint64_t serial_ = 0;
    double complained_ = -1e9;
    WordBudget words_;
};

}  // namespace percussionist::io
