#include "patient/from_ct/spine_search.h"

#include <algorithm>
#include <utility>

#include "patient/from_ct/marrow.h"
#include "patient/from_ct/midline_search.h"
#include <fmt/format.h>

namespace bodkin::patient {
namespace {

constexpr double least_labelled_laminae = 15.0;  // mm of laminae that labels of vertebrae must show to be a spine
constexpr double below_lung = 60.0;  // mm, two vertebrae: how far below lung an interspace counts as lumbar
constexpr double least_side = 6.0;   // mm of image on either side of the midline, about half a canal

// The middle of the labelled vertebrae, slice by slice; labels of the sides balance.
std::vector<double> midline_of_labels(const SpineView& view) {
  const auto& size = view.grid().size;
  std::vector<double> x;
  double last = 0.5 * (view.x_of(0) + view.x_of(size[0] - 1));
  for (int k = 0; k < size[2]; ++k) {
    double sum = 0.0;
    int count = 0;
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (view.role.at(i, j, k) != spine_role::none) sum += view.x_of(i), ++count;
      }
    }
    if (count > 100) last = sum / count;
    x.push_back(last);
  }
  return moving_average(x, 25);
}

FoundSpine found_in(const SpineSearch& search, SpineView view, SpinalCanal canal, const char* source) {
  constexpr double coarse = 2.0;  // mm
  LevelTexts words{{}, search.options.lowest_vertebra, search.options.conus, search.ct.grid.spacing.maxCoeff()};
  LumbarSpine spine = find_interspaces(view, canal, words);
  if (spine.levels.confidence < LevelConfidence::high && !spine.levels.names.empty()) {
    const SpineView wide =
        view_spine(search.ct, {}, {}, search.tissues, wide_box(canal, box_of_image(search.ct.grid)), coarse);
    words.landmarks = find_level_landmarks(wide, canal);
    spine = find_interspaces(view, std::move(canal), words);
  }
  mark_cut(spine, search.ct.grid, search.structures, search.roles);
  return {std::move(view), std::move(spine), source};
}

// LPS z of the lowest lung in the image; far above the image if there is none.
double lung_base(const BodySurface& body) {
  double base = 1e9;
  const anatomy::Grid& grid = body.lung.grid;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        if (body.lung.at(i, j, k) == 1) base = std::min(base, grid.to_patient(Vec3(i, j, k)).z());
      }
    }
  }
  return base;
}

// Why a spine known only by bone is not a lumbar spine for planning a needle, as the end of a sentence; empty if it
// may be one.
std::string why_not_lumbar(const LumbarSpine& spine, const anatomy::CtVolume& ct, const BodySurface& body) {
  const PatientBox image = box_of_image(ct.grid);
  const auto& sections = spine.canal.sections;
  const auto cut = std::count_if(sections.begin(), sections.end(), [&](const CanalSection& section) {
    return std::min(section.x - image.low.x(), image.high.x() - section.x) < least_side;
  });
  if (cut > static_cast<std::ptrdiff_t>(sections.size() / 2)) return "the image border cuts it lengthwise";
  if (spine.interspaces.back().middle() > lung_base(body) - below_lung) {
    return fmt::format("it lies at the level of the lungs or less than {:.0f} mm below, where vertebrae are thoracic",
                       below_lung);
  }
  return "";
}

}  // namespace

std::optional<FoundSpine> find_spine(const SpineSearch& search, std::string& why_not) {
  constexpr double spacing = 1.0;
  const auto& [ct, structures, roles, tissues, body, options] = search;
  const auto bones = box_of_roles(structures, roles, 1, spine_role::vertebra);
  const auto canal_box = box_of_roles(structures, roles, spine_role::canal, spine_role::canal);
  std::optional<SpinalCanal> canal;
  if (canal_box) {
    PatientBox box = *canal_box;
    const double middle = 0.5 * (box.low.x() + box.high.x()),
                 half = std::max(35.0, 0.5 * (box.high.x() - box.low.x()) + 20.0);
    box.low.x() = middle - half, box.high.x() = middle + half;
    box.low.y() -= 10.0;
    box.high.y() = std::max(box.high.y() + 70.0, bones ? bones->high.y() + 10.0 : box.high.y());
    SpineView view = view_spine(ct, structures, roles, tissues, box, spacing);
    canal = canal_from_label(view);
    if (canal) return found_in(search, std::move(view), std::move(*canal), "the labels of the spinal canal");
  }
  if (bones) {
    PatientBox box = *bones;
    box.low -= Vec3(2.0, 2.0, 2.0), box.high += Vec3(2.0, 15.0, 2.0);
    SpineView view = view_spine(ct, structures, roles, tissues, box, spacing);
    canal = canal_from_bone(view, midline_of_labels(view), least_labelled_laminae);
    if (canal) return found_in(search, std::move(view), std::move(*canal), "the labels of the vertebrae");
  }
  if (const auto midline = find_midline(ct, tissues, body)) {
    SpineView view = view_spine(ct, structures, roles, tissues, midline->box, spacing);
    std::vector<double> x;
    for (int k = 0; k < view.grid().size[2]; ++k) x.push_back(midline->x_at(view.z_of(k)));
    canal = canal_from_bone(view, x, 2 * least_labelled_laminae);
    // The spinous processes show the midline more precisely than the search.
    for (int pass = 0; pass < 2 && canal; ++pass) {
      const LumbarSpine spine = find_interspaces(view, *canal);
      for (std::size_t k = 0; k < x.size(); ++k) {
        const double n = std::clamp(view.z_of(static_cast<int>(k)) - canal->lowest, 0.0, spine.tip_x.size() - 1.0);
        x[k] = spine.tip_x[static_cast<std::size_t>(n)];
      }
      canal = canal_from_bone(view, x, 2 * least_labelled_laminae);
    }
    if (!canal) return std::nullopt;
    const LumbarSpine bare = find_interspaces(view, *canal);
    if (bare.interspaces.empty()) return std::nullopt;  // without them bone alone is no proof of a spine
    if (options.lowest_vertebra.empty()) why_not = why_not_lumbar(bare, ct, body);
    if (!why_not.empty()) return std::nullopt;
    fill_marrow(view, tissues, *canal);
    FoundSpine found = found_in(search, std::move(view), std::move(*canal), "bone and midline of the CT");
    if (!found.spine.interspaces.empty()) return found;
  }
  return std::nullopt;
}

}  // namespace bodkin::patient
