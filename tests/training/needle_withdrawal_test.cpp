#include "training/needle_withdrawal.h"

#include <gtest/gtest.h>

#include "io/tissue_library_file.h"
#include "training/procedure_file.h"

namespace bodkin {

using namespace bodkin::training;

namespace {

// An attempt of a procedure whose target lies 40 mm below the origin, given step by step.
class WatchedNeedle {
 public:
  explicit WatchedNeedle(const training::Procedure& procedure) {
    anatomy::Case patient;
    patient.library = io::default_tissue_library();
    patient.description.procedure.target_tolerance = 3.0;
    watch_ = {procedure, patient, Vec3(0, -40, 0)};
  }
  explicit WatchedNeedle(const char* procedure) : WatchedNeedle(find_procedure(procedure)) {}

  // `duration`: s.
  void inside(double depth, double duration, anatomy::TissueId tissue = anatomy::tissue::muscle) {
    go({.is_inside = true, .tissue = tissue, .tip = Vec3(0, -depth, 0)}, duration);
  }
  void pressing(double duration) { go({.tissue = anatomy::tissue::skin}, duration); }
  void outside(double duration) { go({.is_outside = true, .tip = Vec3(0, 20, 0)}, duration); }
  void happens(forces::EventKind kind, anatomy::TissueId tissue = anatomy::tissue::muscle) {
    const session::SessionEvent event{0, {kind, tissue, 20.0, 0.0}};
    watch_.follow({.time = time_, .is_inside = true, .tissue = anatomy::tissue::muscle, .events = {&event, 1}});
  }
  std::optional<double> remaining() const { return watch_.remaining(); }

 private:
  void go(NeedleWithdrawal::Moment moment, double duration) {
    for (const double end = time_ + duration; time_ < end - 1e-9; time_ += step) {
      moment.time = time_;
      watch_.follow(moment);
    }
    moment.time = time_;
    watch_.follow(moment);
  }

  static constexpr double step = 0.0625;  // s
  NeedleWithdrawal watch_;
  double time_ = 3.0;
};

TEST(NeedleWithdrawal, ends_an_acupuncture_five_seconds_after_the_needle_has_left_the_body) {
  WatchedNeedle needle("acupuncture");
  needle.outside(20.0);
  EXPECT_FALSE(needle.remaining()) << "it has not been in";
  needle.pressing(1.0);
  needle.outside(20.0);
  EXPECT_FALSE(needle.remaining()) << "it only touched the skin";
  needle.inside(10.0, 2.0);
  EXPECT_FALSE(needle.remaining());
  needle.outside(2.0);
  ASSERT_TRUE(needle.remaining());
  EXPECT_DOUBLE_EQ(*needle.remaining(), 3.0);
  needle.outside(3.0);
  EXPECT_EQ(needle.remaining(), 0.0);
}

TEST(NeedleWithdrawal, begins_anew_when_the_needle_comes_to_the_skin_again) {
  WatchedNeedle needle("acupuncture");
  needle.inside(10.0, 1.0);
  needle.outside(4.5);
  needle.pressing(0.5);
  EXPECT_FALSE(needle.remaining());
  needle.outside(1.0);
  EXPECT_DOUBLE_EQ(needle.remaining().value_or(-1.0), 4.0);
}

TEST(NeedleWithdrawal, lets_a_needle_that_has_missed_go_in_again) {
  for (const char* procedure : {"lumbar_puncture", "epidural", "needle_insertion", "ultrasound_guided_injection"}) {
    WatchedNeedle needle(procedure);
    needle.inside(30.0, 3.0);
    needle.outside(60.0);
    EXPECT_FALSE(needle.remaining()) << procedure;
  }
}

TEST(NeedleWithdrawal, ends_an_attempt_whose_tip_was_within_the_tolerance_of_its_target) {
  for (const double depth : {36.5, 37.5, 42.5, 43.5}) {
    WatchedNeedle needle("needle_insertion");
    needle.inside(depth, 1.0);
    needle.inside(5.0, 1.0);
    needle.outside(5.0);
    EXPECT_EQ(needle.remaining().has_value(), std::abs(depth - 40.0) < 3.0) << depth;
  }
}

TEST(NeedleWithdrawal, ends_a_lumbar_puncture_that_was_in_the_sac_or_had_fluid) {
  WatchedNeedle in_sac("lumbar_puncture");
  in_sac.inside(45.0, 1.0, anatomy::tissue::cerebrospinal_fluid);
  in_sac.outside(5.0);
  EXPECT_EQ(in_sac.remaining(), 0.0);
  // Through the sac between two steps.
  WatchedNeedle quick("lumbar_puncture");
  quick.happens(forces::EventKind::tissue_entered, anatomy::tissue::cerebrospinal_fluid);
  quick.outside(5.0);
  EXPECT_EQ(quick.remaining(), 0.0);
  WatchedNeedle fluid("lumbar_puncture");
  fluid.happens(forces::EventKind::fluid_returned);
  fluid.outside(5.0);
  EXPECT_EQ(fluid.remaining(), 0.0);
  WatchedNeedle elsewhere("lumbar_puncture");
  elsewhere.happens(forces::EventKind::tissue_entered, anatomy::tissue::disc);
  elsewhere.outside(5.0);
  EXPECT_FALSE(elsewhere.remaining());
}

TEST(NeedleWithdrawal, is_what_the_procedure_s_file_says) {
  const std::string file =
      R"(<procedure version="1" name="own" title="Own"%><description>d</description><goal by="near_target"/></procedure>)";
  const auto with = [&file](const std::string& attribute) {
    std::string text = file;
    return parse_procedure(text.replace(text.find('%'), 1, attribute), "own.xml").withdrawal_ends;
  };
  EXPECT_EQ(with(""), WithdrawalEnds::after_goal);
  EXPECT_EQ(with(R"( taken_out_ends="always")"), WithdrawalEnds::always);
  ASSERT_EQ(with(R"( taken_out_ends="never")"), WithdrawalEnds::never);
  training::Procedure never = find_procedure("acupuncture");
  never.withdrawal_ends = WithdrawalEnds::never;
  WatchedNeedle needle(never);
  needle.inside(40.0, 1.0);
  needle.outside(60.0);
  EXPECT_FALSE(needle.remaining());
  WatchedNeedle none{training::Procedure{}};
  none.inside(40.0, 1.0);
  none.outside(60.0);
  EXPECT_FALSE(none.remaining()) << "no goal was met";
}

}  // namespace
}  // namespace bodkin
