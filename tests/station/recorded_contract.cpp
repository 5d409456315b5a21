// The hand of a session, tested by driver_contract.cpp.
#include "station/recorded_hand.h"
#include "tests/haptics/driver_contract.h"
#include "tests/session/session_samples.h"

namespace bodkin {

using namespace bodkin::haptics;
using namespace bodkin::session;
using namespace bodkin::simulation;
using namespace bodkin::station;

std::vector<ContractSubject> contract_subjects() {
  const auto arrange = [] {
    const auto file = std::make_shared<ScratchSession>();
    SessionHeader header = sample_header();
    header.path = {{10.0, 80.0, -30.0}, {10.0, 20.0, -30.0}};
    SessionWriter writer(file->path(), header, true);
    for (std::uint64_t tick = 0; tick < 200; ++tick) {
      TickRecord one;
      one.tick = tick;
      one.input.needle = needle_pose({10.0, 100.0 - 0.1 * static_cast<double>(tick), -30.0}, -Vec3::UnitY());
      writer.append(one);
    }
    writer.commit();
    return ContractScene{.identity = file->path().string(), .fault_at_end = DeviceFault::none, .leave = [file] {
                         }};  // keeps the file until then
  };
  return {{.name = "recorded",
           .driver = &recorded_driver(),
           .arrange = arrange,
           .absent_identity = "/no/such.bodkin",
           .absent_message = {"/no/such.bodkin"}}};
}

}  // namespace bodkin
