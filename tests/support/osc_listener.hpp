// A subscriber for tests: asks a server over loopback and collects what it is told.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "osc/udp_socket.hpp"
#include "osc/wire.hpp"

namespace percussionist::test {

class OscListener {
  public:
    explicit OscListener(int server_port)
        : socket_("127.0.0.1", 0),
          server_(osc::UdpSocket::resolve("127.0.0.1", std::to_string(server_port))),
          thread_([this] { hear(); }) {}
    ~OscListener() {
        stopping_ = true;
        thread_.join();
    }
    OscListener(const OscListener&) = delete;
    OscListener& operator=(const OscListener&) = delete;

    [[nodiscard]] int port() const { return socket_.port(); }
    void send(const osc::Packet& packet) { socket_.send(packet, server_); }
    void send(const std::string& address, const std::vector<std::string>& texts = {}) {
        send(osc::encode_text(address, texts));
    }

    /// Asks for a feed and waits for the answer; false if there is none within a minute.
    bool subscribes(const std::string& feed) {
        const int before = count("/status");
        send(osc::encode_message("/subscribe",
                                 std::vector<osc::Argument>{static_cast<double>(port()), feed}));
        return hears("/status", before + 1);
    }

    /// How often an address has been heard.
    int count(const std::string& address) const {
        const std::lock_guard lock(mutex_);
        const auto found = counts_.find(address);
        return found == counts_.end() ? 0 : found->second;
    }
    /// The sequence numbers of the contacts heard.
    std::set<int> contacts() const {
        const std::lock_guard lock(mutex_);
        return contacts_;
    }
    /// All texts heard with an address.
    std::vector<std::string> texts(const std::string& address) const {
        const std::lock_guard lock(mutex_);
        const auto found = texts_.find(address);
        return found == texts_.end() ? std::vector<std::string>{} : found->second;
    }
    /// Waits until an address has been heard; gives up after a minute.
    bool hears(const std::string& address, int times = 1) const {
        for (int i = 0; i < 60000 && count(address) < times; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return count(address) >= times;
    }
    /// Waits until so many different contacts have been heard; gives up after a minute.
    bool hears_contacts(std::size_t different) const {
        for (int i = 0; i < 60000 && contacts().size() < different; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return contacts().size() >= different;
    }

  private:
    void hear() {
        std::vector<char> buffer(65536);
        while (!stopping_) {
            const auto received = socket_.receive(buffer, 20);
            if (!received) continue;
            osc::decode({buffer.data(), received->size},
                        [this](const std::string& path, std::span<const osc::Argument> arguments) {
                            note(path, arguments);
                        });
        }
    }
    void note(const std::string& path, std::span<const osc::Argument> arguments) {
        const std::lock_guard lock(mutex_);
        ++counts_[path];
        if (path == "/contact") {
            contacts_.insert(static_cast<int>(std::get<double>(arguments[0])));
        }
        for (const osc::Argument& a : arguments) {
            if (const auto* text = std::get_if<std::string>(&a)) texts_[path].push_back(*text);
        }
    }

    osc::UdpSocket socket_;
    sockaddr_in server_;
    mutable std::mutex mutex_;
    std::map<std::string, int> counts_;
    std::set<int> contacts_;
    std::map<std::string, std::vector<std::string>> texts_;
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

}  // namespace percussionist::test
