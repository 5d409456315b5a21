#include "station/recorded_hand.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "station/hand_session.h"

#include "core/error.h"
#include "haptics/drivers/driver_adapter.h"
#include "haptics/drivers/driver_settings.h"
#include "haptics/drivers/vendor_frame.h"

namespace bodkin::station {

namespace {

constexpr std::uint64_t longest_gap = 1000;  // ticks; a hand that was unseen for longer cannot be played back

class RecordedDevice : public haptics::OpenDevice {
 public:
  explicit RecordedDevice(std::vector<Pose> poses) : poses_(std::move(poses)) {}

  void start(bodkin_tick, void*) override { next_ = 0; }
  void stop() override {}
  std::string explain() override { return {}; }

  int exchange(const bodkin_command&, bodkin_state& state) noexcept override {
    state = haptics::blank_state();
    const bool over = next_ == poses_.size();
    const Pose& hand = poses_[over ? next_ - 1 : next_++];
    Eigen::Map<Vec3>(state.position) = hand.translation();
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state.rotation) = hand.linear();
    if (over) state.buttons = BODKIN_BUTTON_END;
    return BODKIN_OK;
  }

 private:
  std::vector<Pose> poses_;
  std::size_t next_ = 0;
};

struct Recorded {
  static constexpr const char* name = "recorded";
  static constexpr const char* summary = "the hand of a session file; no force";

  static void list(const char* text, const haptics::DeviceSink& found) {
    const haptics::DriverSettings none(text, {});
    found("FILE.bodkin", "any session that you name");
  }

  static std::unique_ptr<haptics::OpenDevice> open(const std::string& identity, const char* text,
                                                   bodkin_abilities& abilities) {
    const haptics::DriverSettings none(text, {});
    if (identity.empty()) {
      throw haptics::DriverFailure(BODKIN_BAD_SETTINGS, "no session is named; expected recorded:FILE.bodkin");
    }
    try {
      RecordedHand hand = read_recorded_hand(identity);
      haptics::copy_text("recorded hand", abilities.name, BODKIN_TEXT);
      abilities.rate = hand.rate;
      abilities.measures_rotation = 1;
      return std::make_unique<RecordedDevice>(std::move(hand.poses));
    } catch (const InputError& error) {
      throw haptics::DriverFailure(BODKIN_BAD_SETTINGS, error.what());
    }
  }
};

}  // namespace

RecordedHand read_recorded_hand(const std::filesystem::path& file) {
  const session::Session session = session::read_session(file);
  if (session.ticks.empty()) {
    throw InputError(file.string() + ": the session has no tick, expected one in which a needle moved");
  }
  const haptics::WorkspaceSettings workspace = workspace_about(session.header.path);
  const Mat3 to_operator = workspace.rotation.transpose();
  RecordedHand hand;
  hand.rate = std::round(1e6 / session.header.dt) * 1e-6;
  hand.limits = session.header.device;
  const std::uint64_t first = session.ticks.front().tick;
  for (const simulation::TickRecord& record : session.ticks) {
    Pose pose = Pose::Identity();
    pose.translation() = to_operator * (record.input.needle.translation() - workspace.centre);
    pose.linear() = to_operator * record.input.needle.linear();
    const std::uint64_t due = record.tick - first;
    if (due > hand.poses.size() + longest_gap) {
      throw InputError(file.string() + ": the session lacks " + std::to_string(due - hand.poses.size()) +
                       " ticks in a row, expected at most " + std::to_string(longest_gap) + "; choose another one");
    }
    while (hand.poses.size() < due) hand.poses.push_back(hand.poses.back());
    hand.poses.push_back(pose);
  }
  return hand;
}

const bodkin_driver& recorded_driver() noexcept {
  static constexpr bodkin_driver driver = haptics::driver_of<Recorded>();
  return driver;
}

}  // namespace bodkin::station
