#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"

namespace bodkin::training {

// A stage of a plan: attempts at one procedure on one patient.
struct PlanStage {
  std::string title;
  std::string patient;
  std::string procedure;
  int attempts = 1;
  int passes = 0;

  template <typename S = PlanStage>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"title", &S::title, "as people read it", Origin::choice},
        Parameter{"case", &S::patient, "folder of the case, from the plan's own folder", Origin::choice},
        Parameter{"procedure", &S::procedure, "its name or file; empty: the one that the case names", Origin::choice},
        Parameter{"attempts", &S::attempts, Range{1.0, 1000.0}, "", "after which the stage ends", Origin::choice},
        Parameter{"passes", &S::passes, Range{0.0, 1000.0}, "",
                  "in a row, after which it ends earlier; 0: only after all attempts", Origin::choice}};
  }
};

// What a teacher lets trainees do, in order.
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

// Reads a plan (docs/cohorts.md has the format, share/bodkin/plan.xsd its schema); folders of cases become paths from
// the plan's folder. Throws InputError naming file, line, what was found and what was expected.
Plan read_plan(const std::filesystem::path& file);
// The same from a document in memory; folders stay as they are.
Plan parse_plan(std::string_view document, const std::string& origin);

}  // namespace bodkin::training
