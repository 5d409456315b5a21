#include "training/scan_guide.h"

#include <cmath>

#include "tests/training/lumbar_patient.h"
#include "tests/training/written_session.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/probe_library_file.h"
#include "training/harm.h"
#include "training/probe_track.h"
#include "training/procedure_file.h"
#include "training/score.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

// A probe at the origin that faces -y, with its slice in x and y.
ProbeState looking_down(double reach) {
  return {.time = 0.0, .face = Vec3::Zero(), .into = -Vec3::UnitY(), .normal = Vec3::UnitZ(), .reach = reach};
}

TEST(ScanGuide, a_picture_ends_at_the_edges_of_the_probes_field) {
  const anatomy::UltrasoundProbe linear{.kind = anatomy::ProbeKind::linear, .elements = 100, .pitch = 0.4};
  const ProbeState probe = looking_down(60.0);
  EXPECT_TRUE(is_in_picture(probe, &linear, Vec3(19.9, -59.0, 0.0), 5.0));
  EXPECT_FALSE(is_in_picture(probe, &linear, Vec3(20.1, -59.0, 0.0), 5.0)) << "beside the face of 40 mm";
  EXPECT_FALSE(is_in_picture(probe, &linear, Vec3(0.0, -61.0, 0.0), 5.0)) << "deeper than is shown";
  EXPECT_FALSE(is_in_picture(probe, &linear, Vec3(0.0, 1.0, 0.0), 5.0)) << "behind the face";
  EXPECT_TRUE(is_in_picture(probe, &linear, Vec3(0.0, -30.0, 4.9), 5.0));
  EXPECT_FALSE(is_in_picture(probe, &linear, Vec3(0.0, -30.0, 5.1), 5.0)) << "beside the slice";
  // A face of 60 mm on a circle of 60 mm: half a radian to each side, from a point 60 mm behind the centre.
  const anatomy::UltrasoundProbe curved{
      .kind = anatomy::ProbeKind::curvilinear, .elements = 150, .pitch = 0.4, .radius = 60.0};
  const auto on_ray = [](double angle, double away) {
    return Vec3((60.0 + away) * std::sin(angle), 60.0 - (60.0 + away) * std::cos(angle), 0.0);
  };
  EXPECT_TRUE(is_in_picture(probe, &curved, on_ray(0.49, 59.0), 5.0));
  EXPECT_FALSE(is_in_picture(probe, &curved, on_ray(0.51, 59.0), 5.0));
  EXPECT_FALSE(is_in_picture(probe, &curved, on_ray(0.49, 61.0), 5.0));
  const anatomy::UltrasoundProbe phased{.kind = anatomy::ProbeKind::phased, .sector = 90.0};
  EXPECT_TRUE(is_in_picture(probe, &phased, Vec3(20.0, -21.0, 0.0), 5.0));
  EXPECT_FALSE(is_in_picture(probe, &phased, Vec3(21.0, -20.0, 0.0), 5.0));
  EXPECT_FALSE(is_in_picture(probe, &phased, Vec3(50.0, -51.0, 0.0), 5.0)) << "71 mm away";
  EXPECT_TRUE(is_in_picture(looking_down(unbounded), nullptr, Vec3(90.0, -300.0, 0.0), 5.0));
}

// Where the landmarks of the interspaces place a spinous process, the segmentation has that vertebra.
TEST(ScanGuide, the_spinous_processes_of_a_patient_are_where_his_segmentation_has_them) {
  for (const patient::LumbarParameters& parameters :
       {patient::LumbarParameters{.spacing = 1.5}, patient::LumbarParameters{.weight = 110.0, .spacing = 1.5},
        patient::LumbarParameters{.flexion = 0.0, .scoliosis = 20.0, .spacing = 1.5}}) {
    const patient::SyntheticPatient made = patient::synthesize_lumbar(parameters, io::default_tissue_library());
    anatomy::CaseDescription description;
    description.landmarks = made.landmarks;
    for (const std::string vertebra : {"L2", "L3", "L4", "L5"}) {
      const auto process = spinous_process(description, vertebra);
      ASSERT_TRUE(process.has_value()) << vertebra;
      std::uint16_t label = 0;
      for (const anatomy::Structure& each : made.structure_table)
        if (each.name == "vertebrae_" + vertebra) label = each.label;
      ASSERT_NE(label, 0) << vertebra;
      // Somewhere between skin and canal, and within the 5 mm that count as shown in an image.
      EXPECT_LT(distance_to_value(made.structures, process->middle, label, 30.0), 5.0) << vertebra;
    }
  }
  EXPECT_FALSE(spinous_process({}, "L4").has_value());
  EXPECT_FALSE(spinous_process(lumbar_patient().description, "T4").has_value());
}

// An insertion along the planned path of the synthetic patient, after a scan that shows each of these parts for 1 s.
class Guided {
 public:
  explicit Guided(const std::vector<std::string>& scanned, const Vec3& beside = Vec3::Zero(), double turned = 0.0) {
    const anatomy::CaseDescription& about = lumbar_patient().description;
    const anatomy::NeedlePath path = *about.procedure.path;
    session::Session& session = written_.session();
    session.header.path = path;
    session.header.ultrasound = io::find_probe("L18-4");
    session.ticks.clear();
    const Vec3 along = path.direction();
    const Vec3 axis = Eigen::AngleAxisd(turned, Vec3::UnitX()) * along;
    const Vec3 begin = path.entry + beside;
    for (const std::string& part : scanned) {
      session::ScanSample sample;
      sample.time = 0.001 * static_cast<double>(session.ticks.size());
      sample.settings.depth = 30.0;
      Vec3 into = along, middle = path.target;
      if (const auto process = spinous_process(about, part)) {
        into = process->into;
        middle = process->middle;
      } else if (part == "askew") {
        into = Eigen::AngleAxisd(20.0 * degree, Vec3::UnitX()) * spinous_process(about, "L5")->into;
        middle = spinous_process(about, "L5")->middle;
      }
      sample.probe.translation() = middle - 20.0 * into;
      sample.probe.linear().col(1) = into;
      sample.probe.linear().col(2) = Vec3::UnitX();  // a slice along the spine
      sample.probe.linear().col(0) = into.cross(Vec3::UnitX());
      session.scans.push_back(sample);
      written_.go(begin - 20.0 * axis, 1000, WrittenSession::air, axis);
    }
    written_.go(begin, 500, WrittenSession::air, axis);
    written_.go(begin + path.length() * axis, 4000, {}, axis).go(begin + path.length() * axis, 1000, {}, axis);
  }
  WrittenSession& written() { return written_; }
  std::vector<std::string> missed() const {
    const Attempt attempt(session(), lumbar_patient().description);
    std::vector<std::string> names;
    for (const GuideStep& each : guide_steps(attempt))
      if (!each.kept) names.push_back(each.name);
    return names;
  }
  std::optional<double> value(std::string_view metric) const {
    const Attempt attempt(session(), lumbar_patient().description);
    return find_metric(metric)->compute(Measured(attempt));
  }

 private:
  const session::Session& session() const { return const_cast<Guided*>(this)->written_.session(); }
  WrittenSession written_;
};

const std::vector<std::string> whole_scan = {"L5", "L4", "L3", "target"};

TEST(ScanGuide, each_of_the_seven_steps_is_missed_by_what_breaks_it) {
  using ::testing::ElementsAre;
  using ::testing::IsEmpty;
  EXPECT_THAT(Guided(whole_scan).missed(), IsEmpty());
  EXPECT_EQ(Guided(whole_scan).value("guide_steps_percent"), 100.0);
  EXPECT_EQ(Guided(whole_scan).value("spinous_processes_shown"), 3.0);
  EXPECT_THAT(Guided({"askew", "L4", "L3", "target"}).missed(), ElementsAre("spinous_process_L5"));
  EXPECT_THAT(Guided({"L5", "askew", "target"}).missed(), ::testing::Contains("spinous_process_L3"));
  EXPECT_THAT(Guided({"L5"}).missed(), ::testing::IsSupersetOf({"spinous_process_L3", "target"}));
  const double tolerance = lumbar_patient().description.procedure.target_tolerance;
  // Next to the line and parallel to it.
  const Guided beside(whole_scan, Vec3(tolerance + 0.5, 0, 0));
  EXPECT_THAT(beside.missed(), ElementsAre("line"));
  EXPECT_NEAR(*beside.value("aim_miss_mm"), tolerance + 0.5, 1e-6);
  EXPECT_NEAR(*beside.value("aim_off_line_mm"), tolerance + 0.5, 1e-6);
  EXPECT_THAT(Guided(whole_scan, Vec3(10.5, 0, 0)).missed(), ElementsAre("line", "offset"));
  EXPECT_THAT(Guided(whole_scan, Vec3::Zero(), 16.0 * degree).missed(), ElementsAre("line", "angle"));
  EXPECT_NEAR(*Guided(whole_scan, Vec3::Zero(), 16.0 * degree).value("guide_steps_percent"), 500.0 / 7.0, 1e-9);
}

TEST(ScanGuide, a_way_that_meets_bone_before_it_is_changed_was_aimed_badly) {
  Guided guided(whole_scan);
  session::Session& session = guided.written().session();
  const std::uint64_t contact = 4500;
  session.events.push_back({contact + 2000, {forces::EventKind::bone_contact, tissue::cortical_bone, 30.0, 1.0}});
  EXPECT_THAT(guided.missed(), ::testing::ElementsAre("line"));
  EXPECT_EQ(guided.value("bone_on_first_way"), 1.0);
}

TEST(ScanGuide, what_is_shown_after_the_skin_was_pierced_was_no_guide) {
  Guided guided(whole_scan);
  session::Session& session = guided.written().session();
  for (session::ScanSample& each : session.scans) each.time += 5.0;
  EXPECT_THAT(guided.missed(), ::testing::SizeIs(4));
  session.scans.clear();
  EXPECT_FALSE(guided.value("guide_steps_percent").has_value()) << "without a probe";
}

TEST(ScanGuide, a_case_without_a_lumbar_spine_has_the_last_four_steps) {
  Guided guided({"target"});
  anatomy::CaseDescription elsewhere = lumbar_patient().description;
  elsewhere.landmarks = {{"humeral_head", elsewhere.procedure.path->target}};
  const Attempt attempt(guided.written().session(), elsewhere);
  const auto steps = guide_steps(attempt);
  ASSERT_EQ(steps.size(), 4U);
  for (const GuideStep& each : steps) EXPECT_TRUE(each.kept) << each.name;
  EXPECT_EQ(first_shown(attempt, "humeral_head"), 0.0);
  EXPECT_FALSE(first_shown(attempt, "coracoid_tip").has_value());
}

TEST(ScanGuide, the_step_that_shows_the_target_is_reached_when_the_picture_first_has_it) {
  Guided guided({"L5", "L4", "target"});
  const Score result =
      score(guided.written().session(), lumbar_patient().description, find_procedure("ultrasound_guided_injection"));
  ASSERT_EQ(result.steps.front().title, "Show the target");
  EXPECT_NEAR(result.steps.front().time.value(), 2.0, 0.011);
  EXPECT_FALSE(result.steps.front().depth.has_value());
}

}  // namespace
}  // namespace bodkin
