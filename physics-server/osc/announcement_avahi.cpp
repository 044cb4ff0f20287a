#include <avahi-client/client.h>
#include <avahi-client/publish.h>
#include <avahi-common/alternative.h>
#include <avahi-common/error.h>
#include <avahi-common/malloc.h>
#include <avahi-common/thread-watch.h>
#include <avahi-common/timeval.h>

#include <cstdint>
#include <string>

#include "osc/announcement.hpp"

namespace percussionist::osc {

/// All callbacks come from Avahi's thread; it is stopped before anything is freed.
class Announcement::Avahi {
  public:
    explicit Avahi(int port)
        : port_(static_cast<std::uint16_t>(port)), poll_(avahi_threaded_poll_new()) {
        if (poll_ == nullptr) return;
        connect();
        avahi_threaded_poll_start(poll_);
    }
    ~Avahi() {
        if (poll_ == nullptr) return;
        avahi_threaded_poll_stop(poll_);
        disconnect();
        avahi_threaded_poll_free(poll_);
    }
    Avahi(const Avahi&) = delete;
    Avahi& operator=(const Avahi&) = delete;

  private:
    static constexpr const char* kService = "_percussionist._udp";
    static constexpr unsigned kTryAgain = 2000;  // [ms]

    /// Waits for a daemon where there is none yet, and tries again where there is no D-Bus.
    void connect() {
        const AvahiPoll* const poll = avahi_threaded_poll_get(poll_);
        client_ = avahi_client_new(poll, AVAHI_CLIENT_NO_FAIL, client_changed, this, nullptr);
        if (client_ != nullptr) return;
        timeval later{};
        avahi_elapse_time(&later, kTryAgain, 0);
        poll->timeout_new(poll, &later, try_again, this);
    }
    static void try_again(AvahiTimeout* timeout, void* self) {
        auto& own = *static_cast<Avahi*>(self);
        avahi_threaded_poll_get(own.poll_)->timeout_free(timeout);
        own.connect();
    }
    void disconnect() {
        if (client_ != nullptr) avahi_client_free(client_);  // and the group with it
        client_ = nullptr;
        group_ = nullptr;
    }

    static void client_changed(AvahiClient* client, AvahiClientState state, void* self) {
        auto& own = *static_cast<Avahi*>(self);
        own.client_ = client;  // it may call before it is returned
        if (state == AVAHI_CLIENT_S_RUNNING) {
            own.announce();
        } else if (state == AVAHI_CLIENT_FAILURE &&
                   avahi_client_errno(client) == AVAHI_ERR_DISCONNECTED) {
            own.disconnect();
            own.connect();
        } else if (own.group_ != nullptr) {
            avahi_entry_group_reset(own.group_);  // the host's name changes
        }
    }

    static void group_changed(AvahiEntryGroup* group, AvahiEntryGroupState state, void* self) {
        auto& own = *static_cast<Avahi*>(self);
        own.group_ = group;
        if (state != AVAHI_ENTRY_GROUP_COLLISION) return;
        own.use_another_name();
        avahi_entry_group_reset(group);
        own.announce();
    }

    void use_another_name() {
        char* const other = avahi_alternative_service_name(name_.c_str());
        name_ = other;
        avahi_free(other);
    }

    void announce() {
        if (name_.empty()) {
            name_ = std::string("percussionist on ") + avahi_client_get_host_name(client_);
        }
        if (group_ == nullptr) group_ = avahi_entry_group_new(client_, group_changed, this);
        if (group_ == nullptr || avahi_entry_group_is_empty(group_) == 0) return;
        while (avahi_entry_group_add_service(group_, AVAHI_IF_UNSPEC, AVAHI_PROTO_INET, {},
                                             name_.c_str(), kService, nullptr, nullptr, port_,
                                             nullptr) == AVAHI_ERR_COLLISION) {
            use_another_name();
        }
        avahi_entry_group_commit(group_);
    }

    std::uint16_t port_;
    AvahiThreadedPoll* poll_;
    AvahiClient* client_ = nullptr;
    AvahiEntryGroup* group_ = nullptr;
    std::string name_;
};

Announcement::Announcement(int port) : avahi_(std::make_unique<Avahi>(port)) {}
Announcement::~Announcement() = default;

}  // namespace percussionist::osc
