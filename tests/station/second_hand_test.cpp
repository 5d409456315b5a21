// Two hands at once: what the second hand feels of the needle, what is recorded of it, and the effect of its fault.
#include "station/second_hand.h"

#include <chrono>
#include <thread>

#include "station/hand_session.h"
#include "tests/session/session_samples.h"
#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "haptics/drivers/simulated.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::haptics;
using namespace bodkin::session;
using namespace bodkin::station;
namespace {

Case lumbar_case() {
  Case patient = slab_case(lumbar_slabs());
  patient.description.device.peak_force = 9.0;
  return patient;
}

std::unique_ptr<SecondHand> second_hand(SecondRole role, const std::string& settings, const Case& patient,
                                        const std::shared_ptr<SecondLink>& link) {
  DevicePort port(simulated_driver(), "", settings);
  const DeviceAbilities device = port.abilities();
  ServoSettings servo;
  servo.workspace = second_workspace(role, *patient.description.procedure.path);
  return std::make_unique<SecondHand>(role, std::move(port), device, servo, std::make_shared<const Case>(patient),
                                      link);
}

TEST(SecondWorkspace, the_probes_middle_is_sixty_millimetres_to_the_operators_left_of_the_needles) {
  const NeedlePath path{Vec3(10.0, 20.0, 30.0), Vec3(10.0, -40.0, 30.0)};
  const WorkspaceSettings needle = workspace_about(path), probe = second_workspace(SecondRole::probe, path);
  EXPECT_EQ(probe.rotation, needle.rotation);
  EXPECT_TRUE((probe.centre - needle.centre).isApprox(Vec3(60.0, 0.0, 0.0)));  // prone, head away: left is LPS +x
  EXPECT_EQ(second_workspace(SecondRole::plunger, path).rotation, Mat3::Identity());
}

// Four threads: two hands, the recorder, and this observing one.
TEST(SecondHand, two_hands_a_recorder_and_a_watcher_meet_without_waiting) {
  const ScratchSession scratch;
  const Case patient = lumbar_case();
  SessionHeader header = sample_header();
  header.second = SecondHeader{SecondRole::plunger, "{}"};
  const auto link = std::make_shared<SecondLink>();
  DevicePort port(simulated_driver(), "", "speed_mm_s=100 depth_mm=5 wait_s=0.5");
  const DeviceAbilities device = port.abilities();
  ServoSettings servo;
  servo.workspace = workspace_about(*patient.description.procedure.path);
  HandSession session(std::make_shared<const Case>(patient), header, scratch.path(), true, std::move(port), device,
                      servo, link);
  const auto second = second_hand(SecondRole::plunger, "speed_mm_s=5 tremor_mm=0.05", patient, link);
  session.start();
  second->start();
  second->arm();
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(2500);
  double latest = -1.0;
  while (std::chrono::steady_clock::now() < end) {
    const SecondSample& now = second->snapshot();
    EXPECT_GE(now.time, latest);
    latest = now.time;
    session.snapshot();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_TRUE(second->stop());
  EXPECT_TRUE(session.finish());
  const Session read = read_session(scratch.path());
  ASSERT_TRUE(read.header.second.has_value());
  ASSERT_GT(read.second.size(), 20u);
  ASSERT_GT(read.ticks.size(), 200u);
  EXPECT_LE(read.second.back().time, static_cast<double>(read.ticks.back().tick) * header.dt + 1e-9)
      << "a sample has the tick of its moment before it";
  for (std::size_t i = 1; i < read.second.size(); ++i) {
    EXPECT_GE(read.second[i].time - read.second[i - 1].time, 0.01 - 1e-6);
  }
  EXPECT_EQ(link->lost.load(), 0u);
}

TEST(SecondHand, feels_ligament_as_pressure_and_the_epidural_space_as_its_loss) {
  const Case patient = lumbar_case();
  const auto link = std::make_shared<SecondLink>();
  const auto hand = second_hand(SecondRole::plunger, "speed_mm_s=1.5 depth_mm=10 tremor_mm=0.02", patient, link);
  link->needle.write({0.0, tissue::ligamentum_flavum});
  hand->start();
  hand->arm();
  const auto comes_true = [](const auto& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return condition();
  };
  EXPECT_TRUE(comes_true([&] { return hand->snapshot().force > 2.0; }));
  EXPECT_GT(hand->servo().tick().snapshot().applied.force.z(), 1.0) << "upwards, at the hand";
  // At 1.5 mm/s the flow leaves 0.5 N: (R_needle + R_tissue) A^2 s'; with the space's own pressure 0.6 N.
  link->needle.write({0.1, tissue::epidural_fat});
  EXPECT_TRUE(comes_true([&] { return hand->snapshot().force < 1.0; }));
  hand->disarm();
  EXPECT_TRUE(comes_true([&] { return hand->snapshot().force == 0.0; })) << "not armed: a full syringe";
  EXPECT_TRUE(hand->stop());
}

}  // namespace
}  // namespace bodkin
