#include "training/simulated_probe.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "training/thresholds.h"

namespace bodkin::training {

namespace {

constexpr double sample_time = 0.01;   // s
constexpr double sliding_speed = 5.0;  // mm/s after a tip that was lost
constexpr double wander_time = 2.0;    // s, after which the hand's drift has lost memory of its position
constexpr double beside_entry = 25.0;  // mm from the entry to the middle of the probe's face

}  // namespace

void hold_probe(session::Session& session, const simulation::OperatorScript& script, std::uint64_t seed) {
  session.header.second = session::SecondHeader{session::SecondRole::probe, R"({"driver":"simulated"})"};
  session.second.clear();
  if (session.ticks.empty()) return;
  Random random(mix64(seed) ^ 0x70726F6265ULL);
  const anatomy::NeedlePath& path = session.header.path;
  const Vec3 along = path.direction();
  // The slice holds the path; its other direction is the patient's long axis, unless the path runs along it.
  const Vec3 upright = std::abs(along.z()) < 0.9 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::UnitY());
  const Vec3 across = (upright - upright.dot(along) * along).normalized();
  const double turned = script.aim_angle * random.normal();
  const double tilted = script.aim_angle * random.normal();
  const Mat3 error = (Eigen::AngleAxisd(turned, along) * Eigen::AngleAxisd(tilted, across)).toRotationMatrix();
  Mat3 axes;
  axes.col(0) = error * across;
  axes.col(2) = error * along;
  axes.col(1) = axes.col(2).cross(axes.col(0));
  const Vec3 normal = axes.col(1);
  const Vec3 face = path.entry + beside_entry * across;
  const double aimed_beside = script.aim_position * random.normal();
  const double keeps = std::exp(-sample_time / wander_time);
  double slid = aimed_beside, drift = 0.0, lost_for = 0.0;
  const auto stride =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(sample_time / session.header.dt)));
  for (std::size_t i = 0; i < session.ticks.size(); i += stride) {
    drift = keeps * drift + std::sqrt(1.0 - keeps * keeps) * script.wander * random.normal();
    const Vec3 place = face + (slid + drift) * normal;
    const double away = (session.ticks[i].input.needle.translation() - place).dot(normal);
    lost_for = std::abs(away) > Thresholds().tip_in_slice ? lost_for + sample_time : 0.0;
    if (lost_for > script.reaction)
      slid += std::copysign(std::min(sliding_speed * sample_time, std::abs(away)), away);
    session::SecondSample sample;
    sample.time = static_cast<double>(session.ticks[i].tick) * session.header.dt;
    sample.position = place;
    sample.rotation = Eigen::Quaterniond(axes);
    session.second.push_back(sample);
  }
}

}  // namespace bodkin::training
