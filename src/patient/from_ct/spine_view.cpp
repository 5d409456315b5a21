#include "patient/from_ct/spine_view.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>

#include "patient/from_ct/hounsfield_classes.h"
#include <fmt/format.h>

#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

std::uint8_t role_of(const anatomy::Structure& structure) {
  if (structure.tissue == "spinal_canal") return spine_role::canal;
  if (structure.tissue.find("bone") == std::string::npos) return spine_role::none;
  std::string name = structure.name;
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  static const std::regex level("^(?:vertebrae?[_ ])?([tls])([0-9]{1,2})$");
  std::smatch match;
  if (std::regex_match(name, match, level)) {
    const int number = std::stoi(match[2]);
    if (match[1] == "t" && number >= 1 && number <= 13) return static_cast<std::uint8_t>(number);
    if (match[1] == "l" && number >= 1 && number <= 6) return static_cast<std::uint8_t>(spine_role::l1 + number - 1);
    if (match[1] == "s") return spine_role::sacrum;
  }
  if (name == "sacrum") return spine_role::sacrum;
  static const std::regex part("vertebra|spinosus|spinous|articular_|costal_process|lamina");
  static const std::regex other("_c[0-9]|endplate|disc");
  return std::regex_search(name, part) && !std::regex_search(name, other) ? spine_role::vertebra : spine_role::none;
}

}  // namespace

std::vector<std::uint8_t> spine_roles(const std::vector<anatomy::Structure>& table) {
  std::vector<std::uint8_t> roles(65536, spine_role::none);
  for (const anatomy::Structure& structure : table) roles[structure.label] = role_of(structure);
  return roles;
}

std::string level_name(std::uint8_t role) {
  if (role >= 1 && role < spine_role::l1) return fmt::format("T{}", role);
  if (role >= spine_role::l1 && role < spine_role::sacrum) return fmt::format("L{}", role - spine_role::l1 + 1);
  return role == spine_role::sacrum ? "S1" : "";
}

int SpineView::i_of(double x) const {
  return static_cast<int>(std::lround((x - grid().origin.x()) / grid().spacing.x()));
}
int SpineView::j_of(double y) const {
  return static_cast<int>(std::lround((y - grid().origin.y()) / grid().spacing.y()));
}
int SpineView::k_of(double z) const {
  return static_cast<int>(std::lround((z - grid().origin.z()) / grid().spacing.z()));
}

std::optional<PatientBox> box_of_roles(const anatomy::LabelVolume& structures, const std::vector<std::uint8_t>& roles,
                                       std::uint8_t first, std::uint8_t last) {
  if (structures.empty()) return std::nullopt;
  const anatomy::Grid& grid = structures.grid;
  const int step = grid.voxel_count() > 8'000'000 ? 2 : 1;  // vertebrae are larger than two voxels
  PatientBox box{Vec3::Constant(1e9), Vec3::Constant(-1e9)};
  for (int k = 0; k < grid.size[2]; k += step) {
    for (int j = 0; j < grid.size[1]; j += step) {
      for (int i = 0; i < grid.size[0]; i += step) {
        const std::uint8_t role = roles[structures.at(i, j, k)];
        if (role < first || role > last) continue;
        const Vec3 point = grid.to_patient(Vec3(i, j, k));
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
      }
    }
  }
  if (box.low.x() > box.high.x()) return std::nullopt;
  return box;
}

PatientBox box_of_image(const anatomy::Grid& grid) {
  PatientBox box{Vec3::Constant(1e9), Vec3::Constant(-1e9)};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 index((corner & 1) != 0 ? grid.size[0] - 1 : 0, (corner & 2) != 0 ? grid.size[1] - 1 : 0,
                     (corner & 4) != 0 ? grid.size[2] - 1 : 0);
    const Vec3 point = grid.to_patient(index);
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

SpineView view_spine(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                     const std::vector<std::uint8_t>& roles, const anatomy::TissueVolume& tissues,
                     const PatientBox& box, double spacing) {
  const PatientBox image = box_of_image(ct.grid);
  const Vec3 low = box.low.cwiseMax(image.low), high = box.high.cwiseMin(image.high).cwiseMax(low);
  anatomy::Grid grid;
  grid.origin = low;
  grid.spacing = Vec3::Constant(spacing);
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>((high[axis] - low[axis]) / spacing) + 1;
  }
  SpineView view;
  view.hounsfield = anatomy::Volume<std::int16_t>(grid);
  view.bone = MaskVolume(grid);
  view.role = anatomy::Volume<std::uint8_t>(grid);
  parallel_for(grid.size[2], [&](int k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 point = grid.to_patient(Vec3(i, j, k));
        view.hounsfield.at(i, j, k) = static_cast<std::int16_t>(std::lround(anatomy::linear(ct, point, -1000.0)));
        view.bone.at(i, j, k) = is_bone(anatomy::nearest(tissues, point, anatomy::tissue::air)) ? 1 : 0;
        if (!structures.empty()) view.role.at(i, j, k) = roles[anatomy::nearest(structures, point, std::uint16_t{0})];
      }
    }
  });
  return view;
}

}  // namespace bodkin::patient
