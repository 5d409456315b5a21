#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "haptics/drivers/haply_connection.h"

namespace bodkin::haptics {

// The meaning of an event of Haply's service for a hand that holds the device.
enum class HaplyIncident {
  other,         // does not change the force
  reported,      // worth reporting when something fails: a stall, a step of the device's own safety
  braked,        // the device's emergency brake is engaged
  released,      // it is released
  disconnected,  // the device was lost
  connected      // it was found
};

struct HaplyEvent {
  HaplyIncident incident = HaplyIncident::other;
  std::string device;   // device concerned, "" = not stated
  std::string message;  // the service's words, may be empty
};

// Parses one message of the event channel. An unreadable one is HaplyIncident::other.
HaplyEvent parse_haply_event(std::string_view text);

// Receives the events of one device on its own thread. If the service has no such channel it receives none.
class HaplyEventListener {
 public:
  // Waits for the channel for at most two seconds, and not at all if nothing listens.
  HaplyEventListener(const HaplyAddress& address, std::string device);
  ~HaplyEventListener();
  HaplyEventListener(const HaplyEventListener&) = delete;
  HaplyEventListener& operator=(const HaplyEventListener&) = delete;

  // From any thread; these two lock nothing.
  bool is_braked() const noexcept { return braked_.load(); }
  bool is_disconnected() const noexcept { return disconnected_.load(); }
  // Whether the channel exists and has not ended.
  bool listens() const noexcept { return listens_.load(); }
  // The service's words about the last relevant event, may be empty.
  std::string last() const;

 private:
  void listen() noexcept;
  void take(const HaplyEvent& event);

  std::string device_;
  std::unique_ptr<HaplyConnection> connection_;
  std::atomic<bool> braked_{false}, disconnected_{false}, listens_{false};
  mutable std::mutex mutex_;
  std::string last_;
  std::thread thread_;
};

}  // namespace bodkin::haptics
