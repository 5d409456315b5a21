#include "io/experiment_file.h"

#include <algorithm>
#include <fstream>
#include <numbers>
#include <sstream>

#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::HasSubstr;

constexpr const char* plain = R"(<experiment version="1" name="mine" title="my needle">
  <caption><reproduces>one
     line</reproduces></caption>
  <changed_tissues>
    <changed name="gel" like="muscle" colour="#102030"><tracking_wall stiffness_N_per_mm="0.4" force_N="2"/></changed>
    <changed name="skin"><tracking_wall stiffness_N_per_mm="0.25" force_N="3"/></changed>
  </changed_tissues>
  <body><stack voxel_mm="0.5"><tissue_layer tissue="skin" thickness_mm="1.5"/><tissue_layer tissue="gel" thickness_mm="20"/></stack></body>
  <haptics><resistance><tracking_wall catch_up_s="0.25"/></resistance><constraint><none/></constraint></haptics>
  <motion from_mm="-5" direction_z="2">
    <move depth_mm="5" speed_mm_per_s="10"/>
    <hold time_s="0.5"/>
    <move tilt_deg="90e-1" aside_mm="3" time_s="2"/>
  </motion>
  <plot><panel><curve quantity="wall_mm"/></panel></plot>
  <published><value what="w" source="s" quantity="resistance_N" take="last" is="2" tolerance="0.1" to_s="3"/></published>
</experiment>)";

Experiment read(const std::string& text) {
  return parse_experiment(text, "mine.xml");
}

TEST(ExperimentFile, says_what_it_says) {
  const Experiment experiment = read(plain);
  EXPECT_EQ(experiment.name, "mine");
  EXPECT_EQ(experiment.caption.reproduces, "one line");
  ASSERT_EQ(experiment.body.layers.size(), 2U);
  EXPECT_EQ(experiment.body.layers[1].thickness, 20.0);
  EXPECT_EQ(std::get<TrackingWallSettings>(experiment.haptics.resistance).catch_up, 0.25);
  EXPECT_TRUE(std::holds_alternative<NoConstraint>(experiment.haptics.constraint));
  EXPECT_EQ(experiment.motion.direction, Vec3::UnitZ());
  const auto& places = experiment.motion.places;
  ASSERT_EQ(places.size(), 4U);
  EXPECT_DOUBLE_EQ(places[1].time, 1.0);
  EXPECT_DOUBLE_EQ(places[2].time, 1.5);
  EXPECT_DOUBLE_EQ(places[3].time, 3.5);
  EXPECT_DOUBLE_EQ(places[3].depth, 5.0);
  EXPECT_DOUBLE_EQ(places[3].tilt, 9.0 * std::numbers::pi / 180.0);
  EXPECT_EQ(experiment.values.at(0).aggregation, Aggregation::last);
  EXPECT_EQ(experiment.values.at(0).window.time_to, 3.0);
}

TEST(ExperimentFile, changes_the_library_and_adds_to_it) {
  const Experiment experiment = read(plain);
  const TissueProperties* gel = experiment.library.find("gel");
  const TissueProperties* muscle = experiment.library.find("muscle");
  ASSERT_NE(gel, nullptr);
  EXPECT_GE(gel->id, 32);
  EXPECT_EQ(gel->colour, 0x102030U);
  EXPECT_EQ(gel->tracking_wall.force, 2.0);
  EXPECT_EQ(gel->layered.break_force, muscle->layered.break_force);
  EXPECT_NE(muscle->tracking_wall.force, 2.0);
  EXPECT_EQ(experiment.library.find("skin")->tracking_wall.force, 3.0);
  // The library's description of muscle and skin does not apply to tissue with other forces.
  EXPECT_EQ(gel->physical.puncture_force, 0.0);
  EXPECT_EQ(experiment.library.find("skin")->physical.friction, 0.0);
  EXPECT_GT(muscle->physical.puncture_force, 0.0);
  std::string described = plain;
  described.insert(described.find("<tracking_wall stiffness_N_per_mm=\"0.25\""),
                   "<physical puncture_force_N=\"2\" dimpling_mm=\"3\" friction_MPa=\"0.01\"/>");
  EXPECT_EQ(read(described).library.find("skin")->physical.puncture_force, 2.0);
}

TEST(ExperimentFile, refuses_in_one_sentence_what_cannot_be_played) {
  const struct {
    const char *from, *to, *says;
  } cases[] = {
      {"tissue=\"gel\" thick", "tissue=\"jelly\" thick", "neither the tissue library nor <changed_tissues> has"},
      {"like=\"muscle\"", "like=\"mussel\"", "no tissue 'mussel'"},
      {"name=\"skin\"", "name=\"skin\" like=\"fat\"", "exists already"},
      {"thickness_mm=\"1.5\"", "thickness_mm=\"1.7\"", "expected a multiple of the voxel_mm of 0.5"},
      {"thickness_mm=\"1.5\"", "thickness_mm=\"-2\"", "expected a number from"},
      {"direction_z=\"2\"", "direction_z=\"0\"", "direction of no length"},
      {"speed_mm_per_s=\"10\"", "", "expected one of them"},
      {"speed_mm_per_s=\"10\"", "speed_mm_per_s=\"10\" time_s=\"1\"", "expected one of them"},
      {"depth_mm=\"5\" speed", "speed", "expected time_s instead"},
      {"time_s=\"2\"", "time_s=\"0\"", "takes no time"},
      {"time_s=\"0.5\"", "time_s=\"599\"", "expected at most 600 s"},
      {"\"wall_mm\"", "\"proxy_x_mm\"", "needs the resistance volume_proxy, found tracking_wall"},
      {"\"wall_mm\"", "\"happiness\"", "time_s"},
      {"to_s=\"3\"", "from_s=\"3\" to_s=\"3\"", "expected an end after the beginning"},
      {"<tracking_wall catch_up_s=\"0.25\"/>", "<tracking_hall/>", "tracking_wall"},
      {"<plot>", "<plots>", "plot"},
      {"version=\"1\"", "version=\"2\"", "expected '1'"},
      {"name=\"mine\"", "name=\"../mine\"", "a name of lower-case letters"},
  };
  for (const auto& bad : cases) {
    const std::string said = refusal([&] { read(replaced(plain, bad.from, bad.to)); });
    EXPECT_THAT(said, HasSubstr(bad.says));
    EXPECT_THAT(said, ::testing::StartsWith("mine.xml"));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << said;
  }
  EXPECT_THAT(refusal([] { read("<case/>"); }), HasSubstr("<case>"));
  EXPECT_THAT(refusal([] { read(""); }), HasSubstr("empty"));
  EXPECT_THAT(refusal([] { read("<!DOCTYPE a [<!ENTITY b 'c'>]><experiment/>"); }), HasSubstr("document type"));
  EXPECT_THAT(refusal([] { read_experiment("/no/such/file.xml"); }), HasSubstr("no such file"));
}

TEST(ExperimentFile, the_shipped_experiments_are_named_after_their_files_and_have_whole_captions) {
  const auto files = shipped_experiments();
  EXPECT_GE(files.size(), 12U);
  for (const auto& file : files) {
    const Experiment experiment = read_experiment(file);
    EXPECT_EQ(experiment.name, file.stem());
    EXPECT_FALSE(experiment.paper.empty()) << file;
    for (const std::string* part : {&experiment.caption.reproduces, &experiment.caption.parameters,
                                    &experiment.caption.agrees, &experiment.caption.differs})
      EXPECT_GT(part->size(), 40U) << file;
    EXPECT_FALSE(experiment.values.empty()) << file;
  }
}

}  // namespace
}  // namespace bodkin
