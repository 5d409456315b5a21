#include "haptics/drivers/haply_service.h"

#include <string_view>
#include <vector>

#include "haptics/bodkin_driver.h"
#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/haply_messages.h"

namespace bodkin::haptics {

namespace {

constexpr std::chrono::milliseconds patience{2000};
constexpr int usual_port = 10001;
constexpr int older_port = 10000;  // of the 3.0 interface, which older services serve alone
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
  return {address, version};
}

}  // namespace

HaplyService find_haply_service(const DriverSettings& settings) {
  const std::string host = settings.text("host", "localhost");
  const int chosen = static_cast<int>(settings.number("port", 0.0, 1.0, 65535.0));
  const std::vector<int> ports = chosen == 0 ? std::vector{usual_port, older_port} : std::vector{chosen};
  std::string tried;
  for (const int port : ports) {
    const HaplyAddress address{host, port};
    try {
      return known_service(address, ask_version(address));
    } catch (const DriverFailure& failure) {
      if (failure.result() == BODKIN_COMMUNICATION_LOST) {
        throw DriverFailure(BODKIN_COMMUNICATION_LOST, "what listens at " + address.text() +
                                                           " does not answer as Haply's Inverse service does (" +
                                                           failure.what() + "): " + advice);
      }
      if (failure.result() != BODKIN_NOT_INSTALLED) throw;
      tried += (tried.empty() ? "" : " or ") + address.text() + " (" + failure.what() + ")";
    }
  }
  throw DriverFailure(BODKIN_NOT_INSTALLED,
                      "Haply's Inverse service does not answer at " + tried +
                          ": install Haply Hub, start the service (systemctl start haply-inverse-service), or say "
                          "host=NAME port=NUMBER where it is");
}

HaplySession open_haply_session(const HaplyService& service) {
  HaplySession session;
  try {
    session.connection = std::make_unique<HaplyConnection>(service.address, patience);
    std::string text(longest_haply_message, '\0');
    std::size_t size = 0;
    if (!session.connection->receive(text, size, HaplyConnection::Clock::now() + patience)) {
      throw DriverFailure(BODKIN_COMMUNICATION_LOST, "its first message does not come");
    }
    session.inventory = parse_haply_inventory(std::string_view(text).substr(0, size));
  } catch (const DriverFailure& failure) {
    throw DriverFailure(failure.result(), "Haply's Inverse service at " + service.address.text() +
                                              " begins no session (" + failure.what() + "): " + advice);
  }
  return session;
}

}  // namespace bodkin::haptics
