#pragma once

// A body solved by CalculiX (SPOOLES), an independent program. It prints seven digits.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/io/scratch_folder.h"
#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::fem;

inline bool calculix_is_there() {
  return std::system("command -v ccx > /dev/null 2>&1") == 0;
}

// Fibres along an axis of the mesh only.
inline std::string calculix_material(const ElasticMaterial& material) {
  const double nu = material.poisson, across = material.young / (2.0 * (1.0 + nu));
  if (!material.has_fibres()) return fmt::format("*ELASTIC\n{:.12g}, {:.12g}\n", material.young, nu);
  std::array<double, 3> young{}, shear{};  // shear: 12, 13, 23
  for (Eigen::Index i = 0; i < 3; ++i)
    young[static_cast<std::size_t>(i)] = material.fibre[i] != 0.0 ? material.young_along : material.young;
  const std::array<std::array<Eigen::Index, 2>, 3> pairs = {{{0, 1}, {0, 2}, {1, 2}}};
  std::array<double, 3> ratio{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [i, j] = pairs[k];
    const bool along = material.fibre[i] != 0.0 || material.fibre[j] != 0.0;
    shear[k] = along ? material.shear_along : across;
    // Of the strain along j, the pull being along i: nu / E_a is the compliance between the fibres and what is
    // across.
    ratio[k] = along ? nu / material.young_along * young[static_cast<std::size_t>(i)] : nu;
  }
  return fmt::format(
      "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n{:.12g}, {:.12g}, {:.12g}, {:.12g}, {:.12g}, {:.12g}, {:.12g}, "
      "{:.12g},\n{:.12g}\n",
      young[0], young[1], young[2], ratio[0], ratio[1], ratio[2], shear[0], shear[1], shear[2]);
}

// A mesh with its materials, and the nodes of it that are fixed; CalculiX reads no more than 20 characters of a
// number. With `edges`, all of them, its elements are of second order (C3D10), and the middles of the edges are nodes
// behind the mesh's.
inline std::string calculix_mesh(const BodyDescription& body, const QuadraticEdges& edges = {}) {
  std::string text = "*NODE, NSET=ALL\n";
  std::size_t number = 0;
  for (const Vec3& x : body.mesh.nodes)
    text += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", ++number, x.x(), x.y(), x.z());
  std::vector<std::string> fixed;
  for (const std::uint32_t node : body.fixed) fixed.push_back(fmt::format("{}, 1, 3\n", node + 1));
  std::map<std::array<std::uint32_t, 2>, std::size_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const std::array<std::uint32_t, 2> ends = {std::min(a, b), std::max(a, b)};
    const std::uint32_t unknown = edges.unknown(a, b);
    const auto [found, is_new] = middles.try_emplace(
        ends, unknown != QuadraticEdges::none ? body.mesh.nodes.size() + 1 + unknown - edges.first_unknown()
                                              : body.mesh.nodes.size() + 1 + edges.size() + middles.size());
    if (!is_new) return found->second;
    const Vec3 x = 0.5 * (body.mesh.nodes[a] + body.mesh.nodes[b]);
    text += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", found->second, x.x(), x.y(), x.z());
    if (unknown == QuadraticEdges::none) fixed.push_back(fmt::format("{}, 1, 3\n", found->second));
    return found->second;
  };
  std::map<TissueId, std::string> elements;
  for (std::size_t element = 0; element < body.mesh.elements.size(); ++element) {
    const auto& c = body.mesh.elements[element];
    std::string& lines = elements[body.mesh.tissues[element]];
    lines += fmt::format("{}, {}, {}, {}, {}", element + 1, c[0] + 1, c[1] + 1, c[2] + 1, c[3] + 1);
    if (edges.size() > 0)
      lines += fmt::format(", {}, {}, {}, {}, {}, {}", middle(c[0], c[1]), middle(c[1], c[2]), middle(c[0], c[2]),
                           middle(c[0], c[3]), middle(c[1], c[3]), middle(c[2], c[3]));
    lines += "\n";
  }
  for (const auto& [tissue, lines] : elements) {
    text += fmt::format("*ELEMENT, TYPE={}, ELSET=TISSUE{}\n{}", edges.size() > 0 ? "C3D10" : "C3D4", tissue, lines);
    text += fmt::format("*MATERIAL, NAME=MATERIAL{0}\n{1}*SOLID SECTION, ELSET=TISSUE{0}, MATERIAL=MATERIAL{0}\n",
                        tissue, calculix_material(*body.materials.find(tissue)));
  }
  text += "*BOUNDARY\n";
  for (const std::string& line : fixed) text += line;
  return text + "*STEP\n*STATIC\n";
}

// Runs CalculiX on this input, body.inp in `folder`; false: failed.
inline bool calculix_ran(const ScratchFolder& folder, const std::string& input) {
  folder.write("body.inp", input);
  const std::string command = "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 ccx body > ccx.log 2>&1";
  return std::system(command.c_str()) == 0;
}

// The table of the .dat file whose title begins with `title`: 3 values for each of the first `nodes`.
inline Eigen::VectorXd calculix_table(const std::filesystem::path& file, const std::string& title,
                                      std::size_t nodes) {
  Eigen::VectorXd values = Eigen::VectorXd::Constant(3 * static_cast<Eigen::Index>(nodes), std::nan(""));
  std::ifstream lines(file);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("for set") != std::string::npos) inside = line.find(title) != std::string::npos;
    std::istringstream fields(line);
    Eigen::Index node = 0;
    Vec3 value;
    if (!inside || !(fields >> node >> value.x() >> value.y() >> value.z())) continue;
    if (node <= static_cast<Eigen::Index>(nodes)) values.segment<3>(3 * (node - 1)) = value;
  }
  return values;
}

// Moves `count` nodes of the corridor by up to 2 mm at random, here through the condensed body and there whole, and
// expects all displacements and reactions to agree within 1e-6 of the largest.
inline void expect_what_calculix_says(const BodyDescription& body, std::size_t count) {
  const ScratchFolder folder;
  const BodyPlan plan = plan_body(body);
  const std::vector<std::uint32_t>& corridor = plan.corridor.mesh_nodes;  // the free ones
  const ElasticBody elastic(body, plan_body(body));
  const Eigen::MatrixXd compliance = elastic.condensed().compliance;
  Random random(2);
  std::vector<std::uint32_t> moved;
  std::vector<Eigen::Index> rows;
  const std::size_t stride = std::max<std::size_t>(1, corridor.size() / count);
  for (std::size_t i = 0; i < corridor.size(); i += stride) {
    moved.push_back(corridor[i]);
    for (Eigen::Index axis = 0; axis < 3; ++axis) rows.push_back(3 * static_cast<Eigen::Index>(i) + axis);
  }
  const auto size = static_cast<Eigen::Index>(rows.size());
  const Eigen::VectorXd way = Eigen::VectorXd::NullaryExpr(size, [&random] { return random.uniform(-2.0, 2.0); });
  Eigen::VectorXd on_corridor = Eigen::VectorXd::Zero(compliance.rows());
  const Eigen::VectorXd contact = Eigen::MatrixXd(compliance(rows, rows)).llt().solve(way);
  on_corridor(rows) = contact;
  const Eigen::VectorXd ours = elastic.displacement_by_corridor(on_corridor);
  const Eigen::VectorXd our_forces = elastic_forces(body.mesh, body.materials, ours);

  std::string input = calculix_mesh(body) + "*BOUNDARY\n";
  for (std::size_t i = 0; i < moved.size(); ++i)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      input += fmt::format("{0}, {1}, {1}, {2:.12g}\n", moved[i] + 1, axis + 1,
                           way(3 * static_cast<Eigen::Index>(i) + axis));
  ASSERT_TRUE(calculix_ran(folder, input + "*NODE PRINT, NSET=ALL\nU, RF\n*END STEP\n"));
  const std::size_t nodes = body.mesh.nodes.size();
  const Eigen::VectorXd theirs = calculix_table(folder.path() / "body.dat", "displacements", nodes);
  const Eigen::VectorXd their_forces = calculix_table(folder.path() / "body.dat", "forces", nodes);
  ASSERT_TRUE(theirs.allFinite());
  ASSERT_TRUE(their_forces.allFinite());
  const double displacement_off = (ours - theirs).cwiseAbs().maxCoeff() / theirs.cwiseAbs().maxCoeff();
  const double reaction_off = (our_forces - their_forces).cwiseAbs().maxCoeff() / their_forces.cwiseAbs().maxCoeff();
  std::cout << "  CalculiX, " << nodes << " nodes, " << moved.size() << " moved: displacements differ by "
            << displacement_off << ", reactions by " << reaction_off << " of the largest\n";
  EXPECT_LT(displacement_off, 1e-6);
  EXPECT_LT(reaction_off, 1e-6);
}

}  // namespace bodkin::checks
