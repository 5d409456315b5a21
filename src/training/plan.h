#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"

namespace bodkin::training {

// The aids that the window may show in a stage.
struct PlanAids {
  bool overlay = true;      // the planned path, the target and the guidance to it
  bool slices = true;       // through the scan
  bool inside = true;       // the 3-D view may look through the skin
  bool ladder = true;       // tissues by depth
  bool ultrasound = false;  // next to the needle
  bool needle = true;       // the needle is drawn, in 3-D and in the slices
  bool sound = true;        // unless the person has switched it off
  bool hints = true;        // the step of the procedure, and instructions for it

  template <typename S = PlanAids>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"overlay", &S::overlay, "the planned path, the target and the way to it are shown", Origin::choice},
        Parameter{"slices", &S::slices, "slices through the scan are shown", Origin::choice},
        Parameter{"inside", &S::inside, "the 3-D picture may look through the skin", Origin::choice},
        Parameter{"ladder", &S::ladder, "the tissues by depth are shown", Origin::choice},
        Parameter{"ultrasound", &S::ultrasound, "ultrasound is shown", Origin::choice},
        Parameter{"needle", &S::needle, "the needle is drawn", Origin::choice},
        Parameter{"sound", &S::sound, "gives, bone and dangers are heard", Origin::choice},
        Parameter{"hints", &S::hints, "the step of the procedure and what to do in it are shown", Origin::choice}};
  }
};

// A stage of a plan: attempts at one procedure on one patient.
struct PlanStage {
  std::string title;
  std::string patient;
  std::string procedure;
  int attempts = 1;
  int passes = 0;
  double score_from = 0.0;
  bool mastery = false;
  bool must_pass = false;
  PlanAids aids;

  template <typename S = PlanStage>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"title", &S::title, "as people read it", Origin::choice},
        Parameter{"case", &S::patient, "folder of the case, from the plan's own folder", Origin::choice},
        Parameter{"procedure", &S::procedure, "its name or file; empty: the one that the case names", Origin::choice},
        Parameter{"attempts", &S::attempts, Range{1.0, 1000.0}, "", "after which the stage ends", Origin::choice},
        Parameter{"passes", &S::passes, Range{0.0, 1000.0}, "",
                  "in a row, after which it ends earlier; 0: only after all attempts", Origin::choice},
        Parameter{"score_from", &S::score_from, Range{0.0, 100.0}, "", "that an attempt needs to count as passed",
                  Origin::choice},
        Parameter{"mastery", &S::mastery, "CUSUM must show mastery before it ends earlier", Origin::choice},
        Parameter{"must_pass", &S::must_pass, "it does not end before that, however many attempts it takes",
                  Origin::choice},
        Inlined{&S::aids}};
  }
};

// The folder name for the patient that comes with the window.
inline constexpr std::string_view built_in_patient = "built-in";

// The stages that a teacher prescribes for trainees, in order.
struct Plan {
  std::string name = "plan";
  std::string title;
  std::vector<PlanStage> stages;

  template <typename S = Plan>
  static constexpr auto parameters() {
    return std::tuple{Parameter{"name", &S::name, "of letters, digits, '_', '-' and '.'", Origin::choice},
                      Parameter{"title", &S::title, "as people read it", Origin::choice},
                      ChildElements{"stage", &S::stages, "in order", 100}};
  }
};

// Reads a plan (docs/plans.md has the format, share/bodkin/plan.xsd its schema); folders of cases become paths
// relative to the plan's folder. Throws InputError naming file, line, what was found and what was expected.
Plan read_plan(const std::filesystem::path& file);
// As above, from a document in memory; folders are not changed.
Plan parse_plan(std::string_view document, const std::string& origin);

// Throws InputError for the first stage whose procedure or patient does not exist, or whose patient has no planned
// path. Does not load whole patients.
void check_names(const Plan& plan, const std::string& origin);

// A plan that comes with Bodkin (share/bodkin/plans), by its name, or the file of that path. Otherwise throws
// InputError, which lists those that come with Bodkin.
std::filesystem::path find_plan(const std::string& name);
// Names of the plans that come with Bodkin, in alphabetical order.
std::vector<std::string> shipped_plans();

}  // namespace bodkin::training
