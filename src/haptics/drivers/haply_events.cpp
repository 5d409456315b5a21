#include "haptics/drivers/haply_events.h"

#include <chrono>
#include <utility>

#include <nlohmann/json.hpp>

#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/haply_messages.h"

namespace bodkin::haptics {

namespace {

using namespace std::chrono_literals;
using EventJson = nlohmann::json;
using EventClock = HaplyConnection::Clock;

constexpr auto listening_patience = 2000ms;   // for the channel to open; a closed port is refused at once
constexpr auto silence_patience = 24h * 365;  // between two events
constexpr std::size_t longest_words = 160;    // bytes of a message that are kept

std::string event_text(const EventJson& json, const char* key) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

HaplyIncident incident_of(const std::string& name, const std::string& safety) {
  if (name == "device-connected") return HaplyIncident::connected;
  if (name == "device-disconnected") return HaplyIncident::disconnected;
  if (name != "device-safety-triggered") return HaplyIncident::other;
  if (safety == "ebrake_triggered") return HaplyIncident::braked;
  if (safety == "ebrake_released") return HaplyIncident::released;
  return HaplyIncident::reported;
}

}  // namespace

HaplyEvent parse_haply_event(std::string_view text) {
  const EventJson json = EventJson::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  const EventJson data = json.contains("data") ? json.at("data") : EventJson();
  HaplyEvent event;
  event.incident = incident_of(event_text(json, "name"), event_text(data, "safety_type"));
  event.device = event_text(data, "device_id");
  event.message = event_text(json, "message").substr(0, longest_words);
  return event;
}

HaplyEventListener::HaplyEventListener(const HaplyAddress& address, std::string device) : device_(std::move(device)) {
  try {
    connection_ = std::make_unique<HaplyConnection>(address, listening_patience);
  } catch (const DriverFailure&) {
    return;  // services before 3.5 lack this channel
  }
  listens_.store(true);
  thread_ = std::thread([this] { listen(); });
}

HaplyEventListener::~HaplyEventListener() {
  if (connection_ != nullptr) connection_->interrupt();
  if (thread_.joinable()) thread_.join();
  if (connection_ != nullptr) connection_->abandon();
}

std::string HaplyEventListener::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

void HaplyEventListener::take(const HaplyEvent& event) {
  if (event.incident == HaplyIncident::other || event.device != device_) return;
  if (event.incident == HaplyIncident::braked) braked_.store(true);
  if (event.incident == HaplyIncident::released) braked_.store(false);
  if (event.incident == HaplyIncident::disconnected) disconnected_.store(true);
  if (event.incident == HaplyIncident::connected) disconnected_.store(false);
  const std::lock_guard lock(mutex_);
  last_ = event.message;
}

void HaplyEventListener::listen() noexcept {
  try {
    std::string text(longest_haply_message, '\0');
    std::size_t size = 0;
    // A read takes several messages from the socket, so an empty socket does not mean that none is buffered.
    while (connection_->receive(text, size, EventClock::now() + silence_patience))
      take(parse_haply_event(std::string_view(text).substr(0, size)));
  } catch (...) {
    // Read errors have no effect: the session's own channel reports a lost device, too.
  }
  listens_.store(false);
}

}  // namespace bodkin::haptics
