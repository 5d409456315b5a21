#include <cmath>
#include <filesystem>
#include <set>

#include "tests/cli/bodkin_command.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// `bodkin case synthesize` as a user runs it.

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CaseSynthesize : public PatientCommand {};

TEST_F(CaseSynthesize, the_same_seed_gives_the_same_files_and_another_seed_does_not) {
  const std::string options = "--quiet case synthesize lumbar ";
  ASSERT_EQ(bodkin(options + "one --spacing 3 --seed 5").exit_code, 0);
  ASSERT_EQ(bodkin(options + "two --spacing 3 --seed 5").exit_code, 0);
  ASSERT_EQ(bodkin(options + "three --spacing 3 --seed 6").exit_code, 0);
  for (const char* file : {"ct.nrrd", "tissues.nrrd", "structures.nrrd"}) {
    EXPECT_EQ(text_of(std::string("one/") + file), text_of(std::string("two/") + file)) << file;
    EXPECT_NE(text_of(std::string("one/") + file), text_of(std::string("three/") + file)) << file;
  }
}

TEST_F(CaseSynthesize, a_synthetic_case_is_sound_and_its_path_has_a_length_of_life) {
  const Outcome checked = bodkin("--json case check patient");
  EXPECT_EQ(checked.exit_code, 0) << checked.output << checked.errors;
  const Outcome shown = bodkin("--json case show patient -o patient.svg");
  ASSERT_EQ(shown.exit_code, 0) << shown.errors;
  EXPECT_TRUE(nlohmann::json::accept(shown.output));
  EXPECT_TRUE(fs::exists(folder_ / "patient.svg"));
}

TEST_F(CaseSynthesize, a_seed_draws_a_patient_and_what_is_given_stays) {
  const auto said = [&](const std::string& folder) {
    const std::string text = text_of(folder + "/case.xml");
    const std::size_t begin = text.find("Synthetic lumbar torso");
    return text.substr(begin, text.find('<', begin) - begin);
  };
  ASSERT_EQ(bodkin("-q case synthesize lumbar drawn --vary --seed 3 --spacing 3").exit_code, 0);
  ASSERT_EQ(bodkin("-q case synthesize lumbar other --vary --seed 4 --spacing 3").exit_code, 0);
  ASSERT_EQ(
      bodkin("-q case synthesize lumbar old --vary --seed 3 --spacing 2 --age 88 --calcification 0.5").exit_code, 0);
  EXPECT_NE(said("drawn"), said("other").replace(said("other").find("seed 4"), 6, "seed 3"));
  EXPECT_THAT(said("old"), HasSubstr("88 years"));
  EXPECT_THAT(said("old"), HasSubstr("ligaments calcified by 0.5"));
  // A calcified patient has a separate library, which makes the case complete.
  EXPECT_THAT(text_of("old/tissues.xml"), HasSubstr("calcified_ligament"));
  EXPECT_EQ(bodkin("case check old").exit_code, 0);
  const auto weight = [](const std::string& text) { return text.substr(text.find(" m, "), 9); };
  EXPECT_EQ(weight(said("old")), weight(said("drawn"))) << "other parameters are drawn as before";
}

// An epidural needs a thick needle: 16 to 20G.
TEST_F(CaseSynthesize, a_needle_is_drawn_among_those_that_are_usual_at_the_procedure) {
  std::set<std::string> drawn;
  for (int seed = 1; seed <= 6; ++seed) {
    const auto gauge_for = [&](const std::string& options) {
      const Outcome outcome = bodkin(
          fmt::format("-q case synthesize lumbar drawn --overwrite --vary --seed {} --spacing 3{}", seed, options));
      EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
      const std::string text = text_of("drawn/case.xml");
      const std::size_t begin = text.find("gauge=\"") + 7;
      return text.substr(begin, text.find('"', begin) - begin);
    };
    drawn.insert(gauge_for(""));
    EXPECT_EQ(gauge_for(" --procedure epidural"), "20");
  }
  EXPECT_GT(drawn.size(), 1U) << "of a lumbar puncture 20, 22 or 25G";
}

TEST_F(CaseSynthesize, the_needle_is_the_procedure_s_unless_one_is_given) {
  const auto needle = [&](const std::string& options) {
    const std::string folder = fmt::format("needle{}", std::hash<std::string>()(options));
    EXPECT_EQ(bodkin("--quiet case synthesize lumbar " + folder + " --spacing 3 " + options).exit_code, 0);
    const auto about = nlohmann::json::parse(bodkin("--json case show " + folder + " -o it.svg").output).at("needle");
    return fmt::format("{} {} {}", about.at("gauge").get<int>(), about.at("length_mm").get<double>(),
                       about.at("tip").get<std::string>());
  };
  EXPECT_EQ(needle(""), "22 90 quincke");
  EXPECT_EQ(needle("--procedure epidural"), "18 90 tuohy");
  EXPECT_EQ(needle("--procedure epidural --needle 16,110,tuohy"), "16 110 tuohy");
  EXPECT_EQ(needle("--procedure epidural --needle-gauge 20"), "20 90 quincke");
  EXPECT_THAT(needle("--procedure epidural --vary --seed 4"), testing::EndsWith(" 90 tuohy"));
}

TEST_F(CaseSynthesize, the_needle_is_felt_unless_the_tables_are_asked_for) {
  const auto mechanics = [&](const std::string& options) {
    const Outcome made = bodkin("-q --json case synthesize lumbar felt --overwrite --spacing 3 " + options);
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    const std::string said = nlohmann::json::parse(made.output).at("mechanics");
    const bool is_written = text_of("felt/case.xml").find("mechanics=\"physical\"") != std::string::npos;
    EXPECT_EQ(is_written, said == "physical") << options;
    return said;
  };
  for (const char* options : {"", "--procedure epidural", "--vary --seed 3", "--needle 16,90,tuohy",
                              "--needle-gauge 25", "--mechanics physical"})
    EXPECT_EQ(mechanics(options), "physical") << options;
  for (const char* options : {"--mechanics tables", "--needle 16,90,tuohy --mechanics tables"})
    EXPECT_EQ(mechanics(options), "tables") << options;
  EXPECT_THAT(bodkin("-q case synthesize lumbar felt --overwrite --spacing 3 --needle 16,90,tuohy").output,
              HasSubstr("forces    physical: the needle's"));
}

TEST_F(CaseSynthesize, its_device_is_strong_enough_for_the_needle) {
  const auto peak = [&](const std::string& options) {
    EXPECT_EQ(bodkin("-q case synthesize lumbar strong --overwrite --spacing 3 " + options).exit_code, 0);
    const std::string text = text_of("strong/case.xml");
    const std::string name = "peak_force_N=\"";
    return std::stod(text.substr(text.find(name) + name.size()));
  };
  EXPECT_EQ(peak(""), 6.0);
  EXPECT_EQ(peak("--procedure epidural"), 12.0) << "18G";
  EXPECT_EQ(peak("--needle 16,90,tuohy"), 20.0);
  EXPECT_EQ(peak("--needle 16,90,tuohy --mechanics tables"), 6.0);
}

TEST_F(CaseSynthesize, parameters_out_of_range_are_refused_and_leave_nothing) {
  for (const char* wrong : {"--age 12", "--age nan", "--weight 400", "--height 0", "--flexion -0.1", "--spacing 0.1",
                            "--scoliosis 60", "--calcification 2", "--seed -3", "--seed x"}) {
    const Outcome outcome = bodkin(std::string("case synthesize lumbar refused ") + wrong);
    EXPECT_EQ(outcome.exit_code, 2) << wrong;
    EXPECT_THAT(outcome.errors, HasSubstr(std::string(wrong).substr(0, std::string(wrong).find(' ')))) << wrong;
    EXPECT_FALSE(fs::exists(folder_ / "refused")) << wrong;
  }
}

TEST_F(CaseSynthesize, a_case_that_exists_is_kept_unless_overwriting_is_asked_for) {
  const std::string before = text_of("patient/case.xml");
  const Outcome refused = bodkin("case synthesize lumbar patient --spacing 3");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("--overwrite"));
  EXPECT_EQ(text_of("patient/case.xml"), before);
  EXPECT_EQ(bodkin("-q case synthesize lumbar patient --spacing 3 --overwrite").exit_code, 0);
  EXPECT_NE(text_of("patient/case.xml"), before);
}

}  // namespace
}  // namespace bodkin_test
