#include "haptics/drivers/haply_service.h"

#include <optional>
#include <string_view>
#include <vector>

#include "haptics/bodkin_driver.h"
#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/haply_messages.h"

namespace bodkin::haptics {

namespace {

constexpr std::chrono::milliseconds patience{2000};
constexpr int oldest_major = 3;
constexpr const char* advice = "see whether Haply Hub shows the device, or restart haply-inverse-service";

HttpAnswer ask_version(const HaplyAddress& address) {
  const HttpAnswer answer = http_get(address, "/version", patience);
  return answer.status == 200 ? answer : http_get(address, "/3.0/version", patience);
}

HaplyService known_service(const HaplyAddress& address, const HttpAnswer& answer) {
  HaplyVersion version;
  try {
    version = parse_haply_version(answer.status == 200 ? std::string_view(answer.body) : std::string_view());
  } catch (const DriverFailure& failure) {
    throw DriverFailure(failure.result(), "what answers at " + address.text() + " is not Haply's Inverse service (" +
                                              failure.what() + "): say port=NUMBER for the port of the service");
  }
  if (version.major < oldest_major) {
    throw DriverFailure(BODKIN_WRONG_VERSION, "Haply's Inverse service at " + address.text() + " is version " +
                                                  version.text +
                                                  ", expected 3.0 or newer: install a newer Haply Hub");
  }
  HaplyService service;
  service.address = address;
  service.version = version;
  return service;
}

std::string addresses_text(const std::vector<HaplyAddress>& addresses) {
  std::string text;
  for (const HaplyAddress& one : addresses) text += (text.empty() ? "" : " or ") + one.text();
  return text;
}

}  // namespace

HaplyService find_haply_service(const DriverSettings& settings, const HaplyPorts& usual) {
  const std::string host = settings.text("host", "localhost");
  const auto port_in = [&settings](const char* key, double least) {
    return static_cast<int>(settings.number(key, 0.0, least, 65535.0));
  };
  const int chosen = port_in("port", 1.0), socket = port_in("websocket_port", 1.0);
  const bool names_events = !settings.text("events_port", "").empty();
  const int events = names_events ? port_in("events_port", 0.0) : chosen == 0 ? usual.events : 0;
  const std::vector<int> ports = chosen == 0 ? std::vector{usual.newer, usual.older} : std::vector{chosen};
  std::string tried;
  std::optional<DriverFailure> strange;  // another program answers there
  for (const int port : ports) {
    const HaplyAddress address{host, port};
    try {
      HaplyService service = known_service(address, ask_version(address));
      if (socket != 0) {
        service.sockets = {{host, socket}};
      } else {
        for (const int one : ports) service.sockets.push_back({host, one});
      }
      service.events = events;
      service.older_port = usual.older;
      return service;
    } catch (const DriverFailure& failure) {
      if (failure.result() == BODKIN_NOT_INSTALLED) {
        tried += (tried.empty() ? "" : " or ") + address.text() + " (" + failure.what() + ")";
      } else if (strange.has_value()) {
        continue;
      } else if (failure.result() == BODKIN_COMMUNICATION_LOST) {
        strange.emplace(BODKIN_COMMUNICATION_LOST, "what listens at " + address.text() +
                                                       " does not answer as Haply's Inverse service does (" +
                                                       failure.what() + "): " + advice);
      } else {
        strange.emplace(failure);
      }
    }
  }
  if (strange.has_value()) throw *strange;
  throw DriverFailure(BODKIN_NOT_INSTALLED,
                      "Haply's Inverse service does not answer at " + tried +
                          ": install Haply Hub, start the service (systemctl start haply-inverse-service), or say "
                          "host=NAME port=NUMBER where it is");
}

HaplySession open_haply_session(const HaplyService& service) {
  std::optional<DriverFailure> first;
  for (const HaplyAddress& address : service.sockets) {
    try {
      HaplySession session;
      session.address = address;
      session.older_format = address.port == service.older_port;
      session.connection = std::make_unique<HaplyConnection>(address, patience);
      std::string text(longest_haply_message, '\0');
      std::size_t size = 0;
      if (!session.connection->receive(text, size, HaplyConnection::Clock::now() + patience)) {
        throw DriverFailure(BODKIN_COMMUNICATION_LOST, "its first message does not come");
      }
      session.inventory = parse_haply_inventory(std::string_view(text).substr(0, size));
      return session;
    } catch (const DriverFailure& failure) {
      if (!first.has_value()) first.emplace(failure);
    }
  }
  throw DriverFailure(first->result(), "Haply's Inverse service begins no session at " +
                                           addresses_text(service.sockets) + " (" + first->what() + "): " + advice +
                                           ", or say websocket_port=NUMBER where its sessions are");
}

}  // namespace bodkin::haptics
