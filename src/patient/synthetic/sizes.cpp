#include "patient/synthetic/sizes.h"

#include <algorithm>
#include <cmath>

#include "patient/synthetic/bounded_normal.h"
#include "patient/synthetic/shapes.h"

#include "core/random.h"
#include "core/settings_check.h"

namespace bodkin::patient {
namespace {

using shapes::degrees;

// Adults of middle size (1.72 m). Widths, depths and heights of the bodies and the canal: rounded from Panjabi et al.
// 1992 (Spine 17, 299-306), the canal's depth reduced to the 15-17 mm seen at the laminae in CT; bodies a little
// higher than theirs, whose donors were small. Pedicles: Zindrick et al. 1987 (Spine 12, 160-166). Wedge angles,
// spinous and transverse processes and facets: our choice within what atlases show; the reach of the spinous process
// is set so that supraspinous and interspinous ligament together measure about 30 mm (Lawrence et al.,
// layer_thickness.csv).
constexpr double d = degrees;
constexpr std::array<VertebraSize, level::vertebrae> kVertebrae = {{
    // width depth  Hp    wedge    canal      pedicle     lamina reach  mid   tip  drop  span  facet angle
    {36.0, 31.5, 23.0, -2.0 * d, 21.5, 16.0, 7.5, 15.0, 19.0, 24.0, 11.0, 9.0, 12.0, 52.0, 12.0, 70.0 * d},  // T11
    {39.0, 33.0, 24.0, -2.0 * d, 22.0, 16.5, 8.0, 15.5, 19.0, 25.0, 12.0, 13.0, 8.0, 50.0, 12.0, 60.0 * d},  // T12
    {41.0, 34.0, 25.5, -2.0 * d, 22.5, 16.5, 8.7, 15.4, 20.5, 28.0, 16.0, 19.5, 8.0, 71.0, 13.5, 20.0 * d},  // L1
    {42.5, 34.5, 26.0, 0.0 * d, 23.0, 16.0, 8.9, 15.0, 20.5, 29.5, 17.0, 21.5, 8.0, 78.0, 14.5, 25.0 * d},   // L2
    {44.0, 35.0, 26.0, 1.0 * d, 23.5, 15.5, 10.3, 14.9, 20.0, 29.5, 17.0, 21.0, 7.5, 86.0, 16.0, 30.0 * d},  // L3
    {46.5, 35.5, 25.5, 2.0 * d, 24.5, 16.0, 12.9, 14.8, 18.0, 28.5, 15.0, 18.0, 6.0, 82.0, 17.8, 37.0 * d},  // L4
    {49.0, 35.0, 23.5, 8.0 * d, 27.0, 16.5, 16.0, 14.0, 14.5, 23.0, 11.5, 12.5, 4.0, 90.0, 20.5, 47.0 * d},  // L5
}};

struct InterspaceTable {
  double disc_height;  // mm, young adult; 11 mm at the lower levels as in Zhou et al. 2000 (Eur. Spine J. 9, 242-248)
  double disc_wedge;   // degrees, prone and straight; with the bodies' wedges, 47 degrees of lordosis from L1 to S1
  double flexion;      // degrees lost at full flexion: Pearcy, Portek and Shepherd 1984 (Spine 9, 294-297), rounded
  double flavum;       // mm, Khasawneh et al. 2023 (layer_thickness.csv); above L2: our choice
};
constexpr std::array<InterspaceTable, level::vertebrae> kInterspaces = {{
    {6.0, 0.0, 3.0, 2.8},    // T11/T12
    {7.0, 2.0, 5.0, 3.0},    // T12/L1
    {8.5, 4.0, 8.0, 3.1},    // L1/L2
    {10.0, 6.0, 10.0, 3.2},  // L2/L3
    {11.0, 7.0, 12.0, 3.4},  // L3/L4
    {11.5, 9.0, 13.0, 3.7},  // L4/L5
    {10.5, 12.0, 9.0, 3.6},  // L5/S1
}};

double variation(Random& random) {
  return bounded_normal(random, 3.0);
}

VertebraSize vertebra_size(const VertebraSize& table, double scale, double facet_scale, Random& random) {
  VertebraSize size = table;
  const auto vary = [&](double& value, double percent) {
    value *= scale * (1.0 + 0.01 * percent * variation(random));
  };
  vary(size.endplate_width, 2.0);
  vary(size.endplate_depth, 2.0);
  vary(size.posterior_height, 1.5);
  vary(size.canal_width, 2.0);
  vary(size.canal_depth, 2.0);
  vary(size.pedicle_width, 4.0);
  vary(size.pedicle_height, 3.0);
  vary(size.lamina_height, 2.0);
  vary(size.process_reach, 1.5);
  vary(size.process_height, 3.0);
  vary(size.process_tip_height, 3.0);
  vary(size.process_drop, 10.0);
  vary(size.transverse_span, 3.0);
  vary(size.facet_half_distance, 2.0);
  size.facet_angle *= 1.0 + 0.05 * variation(random);
  size.wedge += 0.5 * degrees * variation(random);
  // Joints grow at the cost of the window between the laminae.
  size.lamina_height *= 1.0 + 0.25 * (facet_scale - 1.0);
  return size;
}

}  // namespace

double VertebraSize::height() const {
  return posterior_height + 0.5 * endplate_depth * wedge;  // small angle: tan(wedge) = wedge to 1 %
}

void check_parameters(const LumbarParameters& parameters) {
  constexpr auto origin = "synthetic patient";
  check_range(origin, "age", parameters.age, {18.0, 95.0}, "years");
  check_range(origin, "height", parameters.height, {1.40, 2.05}, "m");
  check_range(origin, "weight", parameters.weight, {40.0, 160.0}, "kg");
  check_range(origin, "flexion", parameters.flexion, {0.0, 1.0}, "");
  check_range(origin, "scoliosis", parameters.scoliosis, {-40.0, 40.0}, "degrees");
  check_range(origin, "calcification", parameters.calcification, {0.0, 1.0}, "");
  if (parameters.lesion != 0.0) check_range(origin, "lesion", parameters.lesion, {8.0, 30.0}, "mm");
  check_range(origin, "spacing", parameters.spacing, {0.5, 3.0}, "mm");
}

LumbarSizes lumbar_sizes(const LumbarParameters& parameters) {
  LumbarSizes sizes{};
  const double scale = parameters.height / 1.72;
  const double age = parameters.age;
  const double past_30 = std::max(age - 30.0, 0.0);
  const double bmi = std::clamp(parameters.weight / (parameters.height * parameters.height), 15.0, 60.0);

  SpineSizes& spine = sizes.spine;
  // Each group of sizes draws from its own sequence, so that one parameter never reshuffles the variation of others.
  Random vertebra_random(mix64(parameters.seed ^ 0x5645525445425241ULL));
  spine.facet_scale = 1.0 + 0.003 * past_30;              // up to a fifth larger at 95: our choice
  spine.osteophyte = 0.0012 * std::max(age - 50.0, 0.0);  // our choice
  for (std::size_t i = 0; i < spine.vertebra.size(); ++i)
    spine.vertebra[i] = vertebra_size(kVertebrae[i], scale, spine.facet_scale, vertebra_random);

  Random disc_random(mix64(parameters.seed ^ 0x444953435350ULL));
  for (std::size_t i = 0; i < spine.below.size(); ++i) {
    const InterspaceTable& table = kInterspaces[i];
    InterspaceSize& size = spine.below[i];
    const double loss = std::clamp(0.004 * past_30 * (1.0 + 0.3 * variation(disc_random)), 0.0, 0.4);
    size.disc_height = table.disc_height * scale * (1.0 - loss) * (1.0 + 0.03 * variation(disc_random));
    size.disc_wedge = degrees * (table.disc_wedge * (1.0 - 0.5 * loss) - table.flexion * parameters.flexion +
                                 0.6 * variation(disc_random));
    // The ligament thickens with age: our choice, about a millimetre in 60 years.
    size.flavum_thickness = (table.flavum + 0.015 * (age - 45.0)) * (1.0 + 0.05 * variation(disc_random));
    // Gaps in three of four interspaces of old spines (Lawrence et al.); rising from none at 50: our choice.
    size.ligament_gap = disc_random.uniform() < 0.75 * std::clamp((age - 50.0) / 30.0, 0.0, 1.0);
  }

  Random shape_random(mix64(parameters.seed ^ 0x5348415045ULL));
  const auto vary = [&](double percent) { return 1.0 + 0.01 * percent * variation(shape_random); };
  spine.sacrum_width = 50.0 * scale * vary(2.0);
  spine.sacrum_depth = 33.0 * scale * vary(2.0);
  spine.sacral_canal_width = 28.0 * scale * vary(2.0);
  spine.sacral_canal_depth = 14.0 * scale * vary(2.0);
  spine.sacral_facet_half_distance = 22.8 * scale * vary(2.0);
  spine.sacral_facet_angle = 53.0 * degrees;
  spine.scoliosis = 1.2 * scale * variation(shape_random);
  spine.rotation = 0.6 * degrees * variation(shape_random);
  spine.cobb = degrees * parameters.scoliosis;

  TorsoSizes& torso = sizes.torso;
  torso.scale = scale;
  torso.skin = 2.0 * vary(4.0);  // 1.9 mm at the waist (Laurent et al. 2007)
  // Chosen so that skin to epidural space at L3/L4 is about 46 mm at BMI 24 (Cha et al. 2011), below 40 mm in the
  // thin and about 80 mm in the very obese (Reg. Anesth. Pain Med. 44 Suppl. 1, 2019).
  const double excess = bmi - 24.3;
  torso.back_fat_midline = std::max(12.0 + (excess > 0.0 ? 1.25 : 0.9) * excess, 2.5) * vary(4.0);
  torso.back_fat = std::max(torso.back_fat_midline - 5.5, 2.0);
  torso.flank_fat = std::max(17.0 + 1.7 * excess, 4.0) * vary(5.0);
  torso.belly_fat = std::max(16.0 + 2.0 * excess, 4.0) * vary(5.0);
  torso.visceral = std::clamp(0.008 * excess, -0.06, 0.25);
  torso.muscle_fat = std::clamp((age - 35.0) / 60.0, 0.0, 1.0);

  sizes.calcification = parameters.calcification;
  // Trabecular attenuation falls by about 2.5 HU a year (Jang et al. 2019, Radiology 291, 360-367): with the
  // library's value standing for the age of 45, 1.25 % of 200 HU.
  sizes.cancellous_factor = std::clamp(1.0 - 0.0125 * (age - 45.0), 0.4, 1.3);
  sizes.cortical_factor = std::clamp(1.0 - 0.003 * (age - 45.0), 0.8, 1.05);
  return sizes;
}

}  // namespace bodkin::patient
