#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

// `bodkin case new` and `bodkin case synthesize` as a user runs them: exit codes, one sentence, nothing left behind.

namespace bodkin_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CaseNew : public BodkinCommand {
 protected:
  void SetUp() override {  // an empty folder for every test
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  // Exit code 2, one sentence containing `what`, and no folder, finished or partial.
  void expect_refusal(const std::string& arguments, const std::string& what) const {
    const Outcome outcome = bodkin(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr(what));
    EXPECT_EQ(outcome.output, "");
    for (const auto& entry : fs::directory_iterator(folder_)) {
      EXPECT_THAT(entry.path().filename().string(), testing::Not(testing::StartsWith("patient")));
    }
  }

  fs::path data() const {
    const char* named = std::getenv("BODKIN_DATA");
    const fs::path place = named != nullptr ? named : BODKIN_REPOSITORY "/../shared/data";
    return fs::exists(place / "MANIFEST.tsv") ? place : fs::path();
  }
};

TEST_F(CaseNew, what_is_no_image_is_refused_with_one_sentence_and_leaves_nothing) {
  write("empty.nii.gz", "");
  write("text.nrrd", "somebody's notes");
  write("cut.nrrd", "NRRD0004\ntype: short\ndimension: 3\n");
  fs::create_directory(folder_ / "nothing");
  expect_refusal("case new patient --ct empty.nii.gz", "empty.nii.gz: this file is empty");
  expect_refusal("case new patient --ct text.nrrd", "not an image that Bodkin reads");
  expect_refusal("case new patient --ct cut.nrrd", "no 'sizes'");
  expect_refusal("case new patient --ct nothing", "no DICOM image here");
  expect_refusal("case new patient --ct lost.mha", "there is no such file");
}

TEST_F(CaseNew, options_out_of_range_are_refused_before_anything_is_read) {
  write("ct.nrrd", "NRRD0004\n");
  const std::string start = "case new patient --ct ct.nrrd ";
  expect_refusal(start + "--needle-gauge 9", "--needle-gauge is '9'; expected a whole number from 10 to 34");
  expect_refusal(start + "--entry 1,2,3", "--target is missing");
  expect_refusal(start + "--entry 1,2 --target 1,2,3", "--entry");
  expect_refusal(start + "--entry 1,2,nan --target 1,2,3", "--entry");
  expect_refusal(start + "--entry 1,2,3 --target 1,2,3", "both 1,2,3");
  expect_refusal(start + "--series 0", "--series");
  expect_refusal(start + "--needle 9,90", "a gauge from 10 to 34 first");
  expect_refusal(start + "--needle 18,0", "a length of 1 to 1000 mm");
  expect_refusal(start + "--needle 18,90,blunt", "as the tip");
  expect_refusal(start + "--level L3", "--level is 'L3'; expected an interspace, T12_L1 to L5_S1");
  expect_refusal(start + "--level L3_L4 --entry 1,2,3 --target 4,5,6", "give only one of them");
  expect_refusal(start + "--lowest-vertebra five", "--lowest-vertebra is 'five'");
  expect_refusal(start + "--conus C3", "--conus is 'C3'");
  expect_refusal(start + "--age -1", "--age");
  expect_refusal(start + "--scheme tptbox", "--labels");
  expect_refusal("case new missing/patient --ct ct.nrrd", "does not exist");
  expect_refusal("case synthesize lumbar patient --age 7", "--age");
  expect_refusal("case synthesize lumbar patient --spacing 0", "--spacing");
  expect_refusal("case synthesize lumbar patient --seed -3", "--seed");
}

TEST_F(CaseNew, real_images_that_cannot_be_a_patient_are_refused_and_leave_nothing) {
  if (data().empty()) GTEST_SKIP() << "no real CT data: set BODKIN_DATA to its folder";
  const std::string start = "case new patient --ct '" + data().string();
  expect_refusal(start + "/oblique/head_phantom_ct_pitched.nii.gz'", "are not HU");
  expect_refusal(start + "/dicom_odd/missing_slice_4_slices'",
                 "a slice is missing between z = 28.11 and z = 38.11 mm");
  expect_refusal(start + "/dicom_odd'", "--series N to pick one");
  expect_refusal(
      start + "/lumbar_l3/lumbar_l3_ct.nii.gz' --labels '" + data().string() + "/abdomen/abdomen_labels.nii.gz'",
      "do not lie on the CT's voxels");
  expect_refusal(start + "/reference_ultrasound/spine_phantom_reconstructed.mha'", "are not HU");
}

TEST_F(CaseNew, a_real_ct_with_labels_becomes_a_case_that_case_check_finds_sound) {
  if (data().empty()) GTEST_SKIP() << "no real CT data: set BODKIN_DATA to its folder";
  const std::string crop = data().string() + "/derived_same_crop_three_formats/lumbar_crop_";
  const std::string arguments =
      "--json case new patient --ct '" + crop + "ct.nrrd' --labels '" + crop + "labels.mha'";
  const Outcome made = bodkin(arguments);
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const nlohmann::json result = nlohmann::json::parse(made.output);
  EXPECT_EQ(result.at("size"), (std::array<int, 3>{66, 60, 64}));
  EXPECT_EQ(result.at("axes"), "RAS");
  EXPECT_FALSE(result.at("tissues").empty());
  EXPECT_EQ(bodkin("case check patient").exit_code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "patient"), fs::directory_iterator()), 4);

  const Outcome again = bodkin(arguments);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.errors, HasSubstr("--overwrite"));
  EXPECT_EQ(bodkin(arguments + " --overwrite --quiet").exit_code, 0);
}

TEST_F(CaseNew, levels_are_planned_by_name_and_never_in_the_cord) {
  if (data().empty()) GTEST_SKIP() << "no real CT data: set BODKIN_DATA to its folder";
  const std::string crop = data().string() + "/derived_same_crop_three_formats/lumbar_crop_";
  const std::string bare = "case new patient --ct '" + crop + "ct.nrrd' ";
  const std::string labelled = bare + "--labels '" + crop + "labels.nrrd' ";
  expect_refusal(labelled + "--level L5_L6",
                 "--level is L5_L6, where no path can be planned: the interspaces found are");
  expect_refusal(labelled + "--level L3_L4 --conus L4", "of the spinal cord, which ends at the middle of L4");
  expect_refusal(labelled + "--entry 4.4,-46,339 --target 4.3,-107,361", "goes into the spinal cord");
  expect_refusal(labelled + "--entry 4.4,-46,339 --target 4.3,-107,900", "lies outside the CT");
  expect_refusal(bare + "--level T12_L1", "the interspaces found are");
  const auto height = [&](const std::string& arguments) {
    const Outcome made = bodkin("--json " + arguments + " --overwrite");
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    return nlohmann::json::parse(made.output).at("path").at("target_mm").at(2).get<double>();
  };
  EXPECT_NEAR(height(labelled + "--level L4_L5"), 269.0, 10.0);
  EXPECT_NEAR(height(bare + "--lowest-vertebra L4 --level L2_L3"), 321.0, 10.0) << "the user's word names the levels";
  EXPECT_LT(height(labelled + "--age 0"), 292.0) << "a newborn's cord ends at L3";
}

// Every procedure that goes into the canal is planned no higher than L2/L3, and above it only at the user's request,
// without a cut vertebra or cord.
TEST_F(CaseNew, no_procedure_is_planned_above_l2_l3_without_the_users_word) {
  if (data().empty()) GTEST_SKIP() << "no real CT data: set BODKIN_DATA to its folder";
  const auto from = [&](const std::string& images) {
    return "case new patient --ct '" + data().string() + images + "ct.nii.gz' --labels '" + data().string() + images +
           "labels.nii.gz' --procedure ";
  };
  const std::string whole = from("/abdomen/abdomen_"), crop = from("/derived_same_crop_three_formats/lumbar_crop_");
  for (const std::string procedure : {"lumbar_puncture", "spinal_anaesthesia", "epidural"}) {
    const auto path_of = [&](const std::string& arguments) {
      const Outcome made = bodkin("--json " + arguments + " --overwrite");
      EXPECT_EQ(made.exit_code, 0) << arguments << made.errors;
      const auto result = nlohmann::json::parse(made.output);
      fs::remove_all(folder_ / "patient");
      return result.value("path", nlohmann::json());
    };
    const auto height = [&](const std::string& arguments) {
      return path_of(arguments).at("target_mm").at(2).get<double>();
    };
    EXPECT_LT(height(crop + procedure), 330.0) << procedure << ": L2/L3 is at 321, L1/L2 at 355";
    EXPECT_NEAR(height(whole + procedure + " --level L1_L2"), 355.0, 8.0) << procedure << ", by the user's word";
    expect_refusal(crop + procedure + " --level L1_L2", "the image border cuts one of its vertebrae");
    EXPECT_TRUE(path_of(crop + procedure + " --conus L4").is_null())
        << procedure << ": no interspace in sight lies a whole vertebra below the cord";
  }
  expect_refusal(whole + "spinal_anaesthesia --conus L2_L3 --level L1_L2",
                 "clear of bone and of the spinal cord, which ends at the interspace L2_L3");
}

// Bodkin's own tissues and a tumour with the id 40.
std::string library_with_tumour() {
  std::string library = content_of(BODKIN_REPOSITORY "/share/bodkin/tissues.xml");
  const std::string mine = R"(<tissue id="40" name="tumour" title="tumour" colour="#804080" hounsfield_HU="60"
      hounsfield_noise_HU="10"><layered><viscous drag_N_s_per_mm2="0.001"/></layered><source>test</source></tissue>)";
  return library.insert(library.rfind("</"), mine);
}

TEST_F(CaseNew, a_tissue_library_of_ones_own_gives_labels_tissues_of_their_own) {
  if (data().empty()) GTEST_SKIP() << "no real CT data: set BODKIN_DATA to its folder";
  write("mine.xml", library_with_tumour());
  write("mine.csv", "label,name,tissue,critical\n29,vertebrae_L3,tumour,false\n30,other,bone,false\n");
  const std::string crop = data().string() + "/derived_same_crop_three_formats/lumbar_crop_";
  const std::string arguments =
      "case new patient --ct '" + crop + "ct.nrrd' --labels '" + crop + "labels.mha' --scheme mine.csv";
  expect_refusal(arguments, "tumour");
  const Outcome made = bodkin("--json " + arguments + " --tissues mine.xml");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const auto amounts = nlohmann::json::parse(made.output).at("tissues");
  EXPECT_TRUE(std::any_of(amounts.begin(), amounts.end(), [](const nlohmann::json& amount) {
    return amount.at("tissue") == "tumour" && amount.at("volume_ml") > 20.0;
  })) << amounts;
  EXPECT_EQ(text_of("patient/tissues.xml"), text_of("mine.xml"));
  EXPECT_THAT(text_of("patient/case.xml"), HasSubstr("<tissue_library file=\"tissues.xml\""));
  EXPECT_EQ(bodkin("case check patient").exit_code, 0);
  EXPECT_THAT(bodkin("-q case show patient -o p.svg").output, HasSubstr("tumour"));
}

TEST_F(CaseNew, a_tissue_library_that_lacks_a_tissue_or_is_none_is_refused) {
  write("ct.nrrd", "NRRD0004\n");
  std::string library = content_of(BODKIN_REPOSITORY "/share/bodkin/tissues.xml");
  const auto start = library.find("<tissue id=\"2\""), end = library.find("</tissue>", start) + 9;
  write("lacking.xml", library.erase(start, end - start));
  write("text.xml", "not a library");
  expect_refusal("case new patient --ct ct.nrrd --tissues lacking.xml", "no tissue with id 2 (fat)");
  expect_refusal("case new patient --ct ct.nrrd --tissues text.xml", "text.xml");
  expect_refusal("case new patient --ct ct.nrrd --tissues lost.xml", "lost.xml");
}

TEST_F(CaseNew, overwrite_never_removes_a_folder_that_is_no_case) {
  fs::create_directory(folder_ / "photos");
  write("photos/holiday.jpg", "dear");
  const Outcome outcome = bodkin("case synthesize lumbar photos --overwrite --spacing 3");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("has no case.xml"));
  EXPECT_EQ(text_of("photos/holiday.jpg"), "dear");
}

TEST_F(CaseNew, what_a_killed_run_left_is_cleared_by_the_next) {
  fs::create_directory(folder_ / "patient.partial-2147483646");  // no process has this number
  const Outcome outcome = bodkin("--json case synthesize lumbar patient --spacing 3 --seed 5 --name Ada");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_FALSE(fs::exists(folder_ / "patient.partial-2147483646"));
  EXPECT_TRUE(fs::exists(folder_ / "patient/case.xml"));
  const nlohmann::json result = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(result.at("name"), "Ada");
  EXPECT_TRUE(result.contains("path"));
  EXPECT_EQ(bodkin("case check patient").exit_code, 0);
}

TEST_F(CaseNew, a_run_that_is_told_to_end_leaves_nothing) {
  struct InterruptedRun {
    int signal;
    std::vector<const char*> command;
  };
  const std::vector<InterruptedRun> runs = {
      {SIGTERM, {"lumbar", "patient", "--spacing", "1"}},
      {SIGHUP, {"lumbar", "patient", "--spacing", "1"}},
      {SIGTERM, {"body", "patient", "--spacing", "3"}},
      {SIGINT, {"body", "patient", "--point", "GB30", "--spacing", "0.8", "--width", "400"}},
  };
  for (const InterruptedRun& run : runs) {
    std::vector<const char*> words = {"bodkin", "-q", "case", "synthesize"};
    words.insert(words.end(), run.command.begin(), run.command.end());
    words.push_back(nullptr);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      std::signal(run.signal, SIG_DFL);  // the tests may run where it is ignored
      if (chdir(folder_.c_str()) != 0) _exit(99);
      execv(BODKIN_BUILD "/bin/bodkin", const_cast<char**>(words.data()));
      _exit(98);
    }
    // A partial case is visible as soon as the work begins, and takes seconds.
    const auto nothing_yet = [&] { return fs::directory_iterator(folder_) == fs::directory_iterator(); };
    for (int n = 0; n < 6000 && nothing_yet(); ++n) usleep(10'000);
    EXPECT_FALSE(nothing_yet()) << "no case was begun";
    kill(child, run.signal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << run.command[0];
    EXPECT_EQ(WTERMSIG(status), run.signal) << run.command[0];
    EXPECT_TRUE(nothing_yet()) << *listing().begin();
  }
}

TEST_F(CaseNew, without_the_image_worker_the_sentence_says_so_and_the_exit_code_is_one) {
  write("ct.nrrd", "NRRD0004\n");
  setenv("BODKIN_IMAGES_WORKER", "/nonexistent/bodkin-images", 1);
  const Outcome outcome = bodkin("case new patient --ct ct.nrrd");
  unsetenv("BODKIN_IMAGES_WORKER");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("/nonexistent/bodkin-images cannot be started"));
}

TEST_F(CaseNew, help_has_examples) {
  for (const std::string command : {"case new --help", "case synthesize lumbar --help"}) {
    const Outcome outcome = bodkin(command);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.output, HasSubstr("Examples:"));
  }
}

}  // namespace
}  // namespace bodkin_test
