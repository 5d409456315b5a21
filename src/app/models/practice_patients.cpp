#include "app/models/practice_patients.h"

#include <algorithm>
#include <array>

#include "patient/acupuncture/body_case.h"
#include "patient/shoulder/shoulder_case.h"
#include "study/phantom.h"
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/experiment_file.h"
#include "io/image_worker.h"
#include "training/planning_rules.h"
#include "training/procedure_file.h"

namespace bodkin::app {

namespace fs = std::filesystem;

namespace {

constexpr double block_width = 160.0;                 // mm, about an acupuncture point
constexpr std::string_view practised_point = "ST36";  // on the leg, away from organs
constexpr std::string_view practised_layers = "alamilla_2018_fig_9";

// With the stylet, and 20 times as fast, because a column of fluid takes minutes to come to rest.
constexpr std::string_view fluid_of_practice =
    "csf_flow stylet=true manometer=false pressure_volume_index_mL=25 times_faster=20";

// A needle for the epidural space is open: fluid shows that the dura is, too.
constexpr std::string_view fluid_of_wet_tap = "csf_flow stylet=false manometer=false";

constexpr std::array<PracticePatient, 9> all_patients = {{
    {"lumbar_puncture", "synthetic-lumbar-puncture", "Lumbar torso. Fluid from the sac below the cord.", false},
    {"epidural", "synthetic-epidural-fluid", "Lumbar torso. Stop behind the flavum, before the dura.", false},
    {"spinal_anaesthesia", "synthetic-spinal-anaesthesia", "Lumbar torso. A thin needle, 25G, into the fluid.",
     false},
    {"ct_guided_biopsy", "synthetic-biopsy", "Lumbar torso. A lesion of 20 mm next to the psoas.", false},
    {"joint_injection", "synthetic-shoulder", "Shoulder. From behind, into the space of the joint.", false},
    {"ultrasound_guided_injection", "synthetic-shoulder-ultrasound", "Shoulder. The tip in the picture all the way.",
     true},
    {"ultrasound_guided_nerve_block", "synthetic-shoulder-nerve", "Shoulder. Next to the nerve, never into it.",
     true},
    {"acupuncture", practised_point, "Leg. Needle ST36; lift, thrust and twirl.", false},
    {"needle_insertion", "synthetic-layers", "Nine layers of a half ball, no anatomy.", false},
}};

// The same torso for all procedures of the spine, as worker input.
std::vector<std::string> make_torso(const PracticePatient& patient, const fs::path& folder,
                                    const Progress& progress) {
  const std::string name(patient.procedure);
  const training::Procedure procedure = training::find_shipped_procedure(name);
  nlohmann::json request = {{"folder", io::path_text(folder)},
                            {"overwrite", true},
                            {"name", "Synthetic torso"},
                            {"needle_gauge", 22},
                            {"seed", 1},
                            {"age", 45.0},
                            {"height", 1.72},
                            {"weight", 72.0},
                            {"flexion", 0.5},
                            {"spacing", 1.0}};
  if (!procedure.needle.empty()) request["needle"] = procedure.needle;
  if (name != built_in_patient().procedure) request["procedure"] = name;
  for (const training::Goal& goal : procedure.goals)
    if (!goal.tissue.empty()) request["target_tissue"] = goal.tissue;
  if (name != "ct_guided_biopsy") request["parts"] = {"fingertip"};
  if (name == "lumbar_puncture" || name == "spinal_anaesthesia") request["parts"].push_back(fluid_of_practice);
  if (name == "epidural") {
    request["parts"].push_back("syringe");
    request["parts"].push_back(fluid_of_wet_tap);
  }
  if (name == "ct_guided_biopsy") {
    request["force_in_organs"] = "none";  // as in the biopsy simulator of Kwon et al. 2001
    request["lesion"] = 20.0;
    request["target_structure"] = "lesion";
    const patient::PlanningRules rules = training::planning_rules(procedure);
    for (const patient::AvoidRule& rule : rules.avoid) {
      request["avoid"].push_back({{"tissue", rule.tissue},
                                  {"structure", rule.structure},
                                  {"title", rule.title},
                                  {"margin_mm", rule.margin}});
    }
    request["levels"] = rules.levels;
  }
  return io::run_image_worker("case-synthesize", request.dump(), folder.string(), progress).notes;
}

void make_layers(const fs::path& folder, const Progress& progress) {
  for (const fs::path& file : io::shipped_experiments()) {
    if (file.stem() != practised_layers) continue;
    study::write_phantom(io::read_experiment(file), {folder, true, "Nine layers"}, progress);
    return;
  }
  throw SystemError("the experiment " + std::string(practised_layers) +
                    " is not installed; install Bodkin's share/bodkin/experiments");
}

void make_shoulder(const PracticePatient& patient, const fs::path& folder, const Progress& progress) {
  patient::ShoulderCase wanted;
  wanted.folder = folder;
  wanted.overwrite = true;
  wanted.name = "Synthetic shoulder";
  wanted.procedure = std::string(patient.procedure);
  if (patient.procedure == "ultrasound_guided_nerve_block")
    wanted.target = patient::ShoulderTarget::suprascapular_nerve;
  patient::write_shoulder_case(wanted, progress);
}

}  // namespace

std::span<const PracticePatient> practice_patients() {
  return all_patients;
}

const PracticePatient& built_in_patient() {
  return all_patients.front();
}

const PracticePatient* find_practice_patient(std::string_view procedure) {
  const auto found = std::find_if(all_patients.begin(), all_patients.end(),
                                  [&](const PracticePatient& patient) { return patient.procedure == procedure; });
  return found == all_patients.end() ? nullptr : &*found;
}

std::vector<std::string> make_practice_patient(const PracticePatient& patient, const fs::path& folder,
                                               const Progress& progress) {
  fs::create_directories(folder.parent_path());
  if (patient.procedure == "acupuncture") {
    const patient::Atlas atlas(patient::BodyParameters{});
    needle_point_case(atlas, std::string(practised_point), folder.parent_path(), progress);
    return {};
  }
  if (patient.procedure == "joint_injection" || patient.procedure == "ultrasound_guided_injection" ||
      patient.procedure == "ultrasound_guided_nerve_block") {
    make_shoulder(patient, folder, progress);
    return {};
  }
  if (patient.procedure == "needle_insertion") {
    make_layers(folder, progress);
    return {};
  }
  return make_torso(patient, folder, progress);
}

fs::path needle_point_case(const patient::Atlas& atlas, const std::string& code, const fs::path& patients,
                           const Progress& progress) {
  patient::BodyCase wanted;
  wanted.folder = patients / code;
  wanted.point = code;
  wanted.name = code + " " + atlas.find(code)->pinyin;
  wanted.width = block_width;
  if (fs::exists(wanted.folder / "case.xml")) return wanted.folder;
  fs::create_directories(patients);
  patient::write_body_case(atlas, wanted, progress);
  return wanted.folder;
}

}  // namespace bodkin::app
