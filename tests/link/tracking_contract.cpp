// A tracked tool, under driver_contract.cpp.
#include <thread>

#include "link/contents.h"
#include "link/server.h"
#include "link/tracking_driver.h"
#include "tests/haptics/driver_contract.h"
#include <fmt/format.h>

namespace bodkin {

using namespace bodkin::haptics;

namespace {

// Sends a pose two hundred times a second until it is destroyed.
class TrackerOnAir {
 public:
  TrackerOnAir()
      : server_(settings()), thread_([this](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            server_.publish(
                {"TRANSFORM", "NeedleTipToReference", link::time_now(), link::transform_content(Pose::Identity())},
                true);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
          }
        }) {}
  std::uint16_t port() const { return server_.port(); }

 private:
  static link::ServerSettings settings() {
    link::ServerSettings settings;
    settings.port = 0;
    return settings;
  }

  link::Server server_;
  std::jthread thread_;
};

}  // namespace

std::vector<ContractSubject> contract_subjects() {
  const auto arrange = [] {
    auto tracker = std::make_shared<std::unique_ptr<TrackerOnAir>>(std::make_unique<TrackerOnAir>());
    return ContractScene{.identity = fmt::format("127.0.0.1:{}/NeedleTipToReference", (*tracker)->port()),
                         .end = [tracker] { tracker->reset(); }};
  };
  return {{.name = "openigtlink",
           .driver = &link::tracking_driver(),
           .arrange = arrange,
           .absent_identity = "127.0.0.1:1/NeedleTipToReference",
           .absent_settings = "first_pose_s=0.3",
           .absent_message = {"no server answers at 127.0.0.1:1", "has it been started?"}}};
}

}  // namespace bodkin
