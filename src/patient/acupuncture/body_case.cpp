#include "patient/acupuncture/body_case.h"

#include "patient/synthetic/painter.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/deferred_termination.h"
#include "io/partial_folder.h"
#include "io/tissue_library_file.h"

namespace bodkin::patient {
namespace {

constexpr double tolerance = 4.0;                          // mm about the point at its depth
constexpr int acupuncture_gauge = 32;                      // about 0.23 mm
constexpr double short_needle = 40.0, long_needle = 75.0;  // mm
constexpr double least_left = 10.0;                        // mm of the needle that stay outside

Progress part_of(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [=](std::string_view stage, double fraction) { progress(stage, from + (to - from) * fraction); };
}

}  // namespace

anatomy::CaseDescription write_body_case(const Atlas& atlas, const BodyCase& wanted, const Progress& teller) {
  const io::DeferredTermination deferred;  // ends this process, if a signal asked for it, once the folder is removed
  const Progress progress = io::until_interrupted(teller);
  const bool whole = wanted.point.empty();
  const AtlasPoint* point = whole ? nullptr : atlas.find(wanted.point);
  if (!whole && point == nullptr) {
    throw InputError(fmt::format(
        "--point is '{}'; expected the code or name of an acupuncture point, such as ST36 (bodkin points lists them)",
        wanted.point));
  }
  anatomy::CaseDescription description;
  const BodyParameters& body = atlas.shape().parameters();
  BodyBlock block;
  block.width = wanted.width;
  block.spacing = wanted.spacing > 0.0 ? wanted.spacing : whole ? 4.0 : 1.0;
  description.procedure.name = whole ? "needle_insertion" : "acupuncture";
  description.procedure.target_tolerance = tolerance;
  description.needle.gauge = acupuncture_gauge;
  description.needle.outer_diameter = anatomy::gauge_size(acupuncture_gauge)->outer_diameter;
  description.needle.inner_diameter = 0.0;
  description.needle.tip = anatomy::NeedleTip::filiform;
  description.needle.length = short_needle;
  description.haptics.mechanics = anatomy::Mechanics::physical;
  if (point != nullptr) {
    block.middle = point->place;
    const anatomy::NeedlePath path = atlas.path(*point);
    if (atlas.needling(*point).deepest + least_left > short_needle) description.needle.length = long_needle;
    description.procedure.path = path;
    description.landmarks.push_back({point->code, point->place});
    for (const AtlasPoint& other : atlas.points()) {
      const Vec3 off = (other.place - point->place).cwiseAbs();
      if (&other != point && off.maxCoeff() < 0.5 * block.width - 2.0)
        description.landmarks.push_back({other.code, other.place});
    }
  }
  const anatomy::TissueLibrary library = io::default_tissue_library();
  io::PartialFolder folder(wanted.folder, wanted.overwrite);
  const anatomy::TissueVolume tissues =
      body_volume(atlas.shape(), atlas.tissues(), block, part_of(progress, 0.0, 0.4));
  LumbarSizes adult{};  // only for its bone and muscle
  adult.cancellous_factor = adult.cortical_factor = 1.0;
  const anatomy::CtVolume ct = paint_ct(tissues, library, adult, wanted.seed, part_of(progress, 0.4, 0.8));

  description.name = wanted.name.empty() ? wanted.folder.filename().string() : wanted.name;
  description.description = fmt::format(
      "Synthetic {} body: {:g} m, {:g} kg, {}, voxels of {:g} mm", body.sex == Sex::female ? "female" : "male",
      body.height, body.weight, whole ? std::string("whole") : fmt::format("about {}", point->code), block.spacing);
  description.created_by = "bodkin";
  progress("writing the case", 0.8);
  io::write_case(description, ct, tissues, {}, nullptr, folder.path());
  progress("writing the case", 0.99);
  folder.finish();
  if (teller) teller("writing the case", 1.0);
  return description;
}

}  // namespace bodkin::patient
