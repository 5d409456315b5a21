// The forces on a needle do not depend on the fineness of the patient's mesh: along the planned path, and along a
// line for which the mesh was not refined.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/bodkin_command.h"
#include "tests/cli/mesher_rig.h"
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

// Depths of punctures, mm, and the force at depths, N.
struct InsertionResult {
  std::map<std::string, double> punctures;
  std::map<double, double> forces;
};

class PatientMeshes : public BodkinCommand {
 protected:
  static std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    return cells;
  }

  static InsertionResult felt(const std::string& path, const std::vector<double>& depths) {
    const Outcome profile = bodkin("--json profile patient --resistance embedded_needle " + path);
    EXPECT_EQ(profile.exit_code, 0) << profile.errors;
    InsertionResult felt;
    if (profile.exit_code != 0) return felt;
    const auto found = nlohmann::json::parse(profile.output);
    for (const auto& event : found["events"]) {
      if (event["text"].get<std::string>().find("gives way") != std::string::npos)
        felt.punctures[event["tissue"]] = event["depth_mm"];
    }
    std::istringstream table(text_of("profile.csv"));
    std::string line;
    std::getline(table, line);
    const std::vector<std::string> names = cells_of(line);
    const auto column = [&names](const char* name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const std::size_t depth = column("depth_mm"), force = column("resistance_N");
    auto wanted = depths.begin();
    while (wanted != depths.end() && std::getline(table, line)) {
      const std::vector<std::string> cells = cells_of(line);
      if (std::stod(cells.at(depth)) < *wanted) continue;
      felt.forces[*wanted++] = std::stod(cells.at(force));
    }
    EXPECT_EQ(felt.forces.size(), depths.size());
    return felt;
  }
};

void expect_within_7_percent(const std::vector<double>& values, const std::string& of) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  EXPECT_LT(*most, 1.07 * *least) << of << ": " << ::testing::PrintToString(values);
  std::printf("  %s: %s\n", of.c_str(), ::testing::PrintToString(values).c_str());
}

// With BODKIN_LARGE_BODIES also 10,000 and 40,000 nodes. The two coarse meshes lack the thin layers of the planned
// path, which are felt nevertheless.
TEST_F(PatientMeshes, of_5000_to_40000_nodes_feel_the_same) {
  BODKIN_NEEDS_MESHER();
  ASSERT_EQ(bodkin("-q case synthesize lumbar patient").exit_code, 0);
  std::vector<std::string> meshes = {"5000 --merge-layers", "20000"};
  if (std::getenv("BODKIN_LARGE_BODIES") != nullptr)
    meshes = {"5000 --merge-layers", "10000 --merge-layers", "20000", "40000"};
  struct TestPath {
    std::string path;
    std::vector<double> depths;  // mm; none where a layer is about to give way in one mesh and has in another
  };
  const std::vector<TestPath> paths = {
      {"", {1.0, 2.0, 3.0, 10.0, 25.0, 40.0, 46.0, 53.0}},
      {"--entry=11.5,79.5,-28.3 --target=5,30,-20", {1.0, 2.0, 3.0, 10.0, 25.0, 45.0}}};
  std::vector<std::vector<InsertionResult>> all(paths.size());
  for (const std::string& mesh : meshes) {
    const Outcome made = bodkin("-q case mesh patient --force --nodes " + mesh);
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    for (std::size_t path = 0; path < paths.size(); ++path)
      all[path].push_back(felt(paths[path].path, paths[path].depths));
  }
  for (std::size_t path = 0; path < paths.size(); ++path) {
    ASSERT_GE(all[path][0].punctures.size(), 2U);
    for (const auto& [tissue, ignored] : all[path][0].punctures) {
      std::vector<double> depths;
      for (const InsertionResult& here : all[path]) {
        ASSERT_TRUE(here.punctures.contains(tissue)) << tissue;
        depths.push_back(here.punctures.at(tissue));
      }
      expect_within_7_percent(depths, tissue + " gives way, mm");
    }
    for (const double depth : paths[path].depths) {
      std::vector<double> forces;
      for (const InsertionResult& here : all[path]) forces.push_back(here.forces.at(depth));
      expect_within_7_percent(forces, "force at " + std::to_string(static_cast<int>(depth)) + " mm, N");
    }
  }
}

}  // namespace
}  // namespace bodkin_test
