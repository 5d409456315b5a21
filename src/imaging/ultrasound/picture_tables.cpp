#include "imaging/ultrasound/picture_tables.h"

#include <algorithm>
#include <cmath>

#include "imaging/ultrasound/scatterers.h"

namespace bodkin::imaging {

namespace {

constexpr double machine_compensates = 0.7;   // dB/cm/MHz, of soft tissue
constexpr double most_compensation = 60.0;    // dB: beyond it, there would be only noise
constexpr double matched_impedance = 1.6;     // MRayl
constexpr double rayleigh_mean = 0.88622693;  // of a complex normal number of variance 1

double from_decibels(double decibels) {
  return std::pow(10.0, decibels / 20.0);
}

// The upper half of a float, rounded.
std::uint32_t upper_half(double value) {
  const auto bits = __builtin_bit_cast(std::uint32_t, static_cast<float>(value));
  return (bits + 0x8000U) & 0xFFFF0000U;
}

std::uint32_t byte_share(double share) {
  return static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

void set_media(PictureTables& tables, const AcousticVolume& patient, double frequency, double spacing) {
  tables.media.assign(scan::media, 0);
  for (std::size_t id = 0; id < patient.media.size(); ++id) {
    const anatomy::AcousticTissue& medium = patient.media[id];
    const double both_ways = 2.0 * medium.attenuation * std::pow(frequency, medium.power) * spacing / 10.0;
    const auto fall = __builtin_bit_cast(std::uint32_t, static_cast<float>(from_decibels(-both_ways)));
    const double density = std::max(medium.density, 1e-3);
    const double level = from_decibels(medium.echo) / rayleigh_mean / std::sqrt(density);
    const std::uint32_t texture =
        upper_half(level) | byte_share(medium.density) << 8 | byte_share(1.0 - from_decibels(-medium.variation));
    tables.media[id] = static_cast<std::uint64_t>(texture) << 32 | fall;
  }
}

// Cells of `size` mm along the lattice's axes, counted from the patient's origin, so that a part cut out of a CT has
// the speckle of the whole.
PictureTables::Cells cells_of(const anatomy::Grid& grid, const Vec3& size) {
  constexpr double middle = 32768.0;  // a multiple of every period, only to make the numbers positive
  PictureTables::Cells cells;
  const Vec3 start = grid.direction.transpose() * grid.origin;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    cells.per_voxel[i] = static_cast<float>(grid.spacing[axis] / size[axis]);
    cells.first[i] = static_cast<float>(middle + std::remainder(start[axis] / size[axis], 4096.0));
  }
  return cells;
}

// The same for bundles of fibres that run from head to foot, as in the back: along the nearest axis of the lattice.
PictureTables::Cells bundles_of(const anatomy::Grid& grid) {
  constexpr double thick = 1.3, long_ = 16.0;  // mm
  Vec3 size = Vec3::Constant(thick);
  int along = 0;
  grid.direction.row(2).cwiseAbs().maxCoeff(&along);
  size[along] = long_;
  return cells_of(grid, size);
}

void set_widths(PictureTables& tables, const UltrasoundDetail& detail, const ScanLines& lines,
                const UltrasoundBeam& beam, const std::vector<SliceRay>& rays, const std::vector<SlicePass>& passes,
                double cell) {
  const auto samples = static_cast<std::size_t>(lines.samples);
  const double pulse = beam.pulse * deviation_of_width / lines.spacing;  // samples
  const int axial_half = detail.speckle ? std::clamp(static_cast<int>(std::ceil(3.0 * pulse)), 1, 64) : 0;
  const std::vector<double> one_side = half_gaussian(detail.speckle ? pulse : 0.0, axial_half);
  std::vector<double> axial;
  for (int tap = -axial_half; tap <= axial_half; ++tap)
    axial.push_back(one_side[static_cast<std::size_t>(std::abs(tap))] / one_side[0]);  // a sharp echo keeps its level
  tables.axial.assign(axial.begin(), axial.end());
  const double axial_left = variance_left(axial, lines.spacing / cell);

  tables.lateral.assign(samples * (scan::edge + 1), 0.0F);
  tables.lateral_half.assign(samples, 0);
  tables.speckle_gain.assign(samples, 0.0F);
  tables.offsets.assign(passes.size(), std::vector<float>(samples, 0.0F));
  for (int k = 0; k < lines.samples; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double depth = k * lines.spacing, apart = lines.apart(depth);
    const double width = detail.speckle ? beam.lateral(depth) * deviation_of_width / std::max(apart, 1e-3) : 0.0;
    const int half = detail.speckle ? std::clamp(static_cast<int>(std::ceil(2.5 * width)), 1, scan::edge) : 0;
    const std::vector<double> side = half_gaussian(width, half);
    for (std::size_t tap = 0; tap < side.size(); ++tap)
      tables.lateral[i * (scan::edge + 1) + tap] = static_cast<float>(side[tap]);
    tables.lateral_half[i] = half;
    std::vector<double> lateral;
    for (int tap = -half; tap <= half; ++tap) lateral.push_back(side[static_cast<std::size_t>(std::abs(tap))]);

    const double thick = beam.elevation(depth) * deviation_of_width;
    for (std::size_t pass = 0; pass < passes.size(); ++pass)
      tables.offsets[pass][i] = static_cast<float>(passes[pass].off * thick);
    double slice_left = 0.0;
    for (const SliceRay& a : rays) {
      for (const SliceRay& b : rays)
        slice_left += a.weight * b.weight * std::max(0.0, 1.0 - std::abs(a.off - b.off) * thick / cell);
    }
    const double left = axial_left * variance_left(lateral, apart / cell) * slice_left;
    tables.speckle_gain[i] = static_cast<float>(1.0 / std::sqrt(left));
  }
}

void set_gain(PictureTables& tables, const UltrasoundSettings& settings, const ScanLines& lines, double frequency) {
  tables.gain.clear();
  for (int k = 0; k < lines.samples; ++k) {
    const double depth = k * lines.spacing;
    const double machine = std::min(most_compensation, 2.0 * machine_compensates * frequency * depth / 10.0);
    const double at = (static_cast<double>(settings.sliders.size()) - 1.0) * k / (lines.samples - 1);
    const auto slider = std::min(static_cast<std::size_t>(at), settings.sliders.size() - 2);
    const double part = at - static_cast<double>(slider);
    const double chosen = (1.0 - part) * settings.sliders[slider] + part * settings.sliders[slider + 1];
    tables.gain.push_back(static_cast<float>(from_decibels(settings.gain + machine + chosen)));
  }
}

// The ringing of the face, and beyond it a haze from multiple reflections of the nearest layers; at the same place in
// every image, because it belongs to the probe.
void set_clutter(PictureTables& tables, const ScanLines& lines) {
  constexpr double bang = 0.5, bang_length = 0.5;  // amplitude, mm
  constexpr double haze = 0.012, haze_length = 3.0;
  const auto& cells = scatterers().cells;
  const auto stride = static_cast<std::size_t>(tables.stride);
  for (std::vector<float>& rows : tables.clutter) rows.assign(stride * static_cast<std::size_t>(lines.samples), 0.0F);
  for (int k = 0; k < lines.samples; ++k) {
    const double depth = k * lines.spacing;
    const double level = haze * std::exp(-depth / haze_length);
    const double ring = bang * std::exp(-depth / bang_length);
    if (level + ring < 1e-6) break;
    for (std::size_t l = 0; l < stride; ++l) {
      const std::size_t at = static_cast<std::size_t>(k) * stride + l;
      const std::uint32_t cell = cells[(at * 7919) % cells.size()];
      tables.clutter[0][at] = static_cast<float>(ring + level / 64.0 * static_cast<std::int8_t>(cell & 0xFFU));
      tables.clutter[1][at] = static_cast<float>(level / 64.0 * static_cast<std::int8_t>(cell >> 8 & 0xFFU));
    }
  }
}

}  // namespace

double PictureTables::ramp_loss(double length) const noexcept {
  const std::size_t middle = axial.size() / 2;
  double heard = static_cast<double>(axial[middle]) * std::min(1.0, length);
  for (std::size_t tap = 1; tap <= middle; ++tap) {
    const double covered = std::clamp(0.5 * length - (static_cast<double>(tap) - 0.5), 0.0, 1.0);
    heard += 2.0 * covered * static_cast<double>(axial[middle + tap]);
  }
  return length / heard;
}

void PictureTables::describe(int sample, scan::Row& described) const noexcept {
  const auto k = static_cast<std::size_t>(sample);
  described.row = sample;
  described.axial = axial.data();
  described.axial_half = static_cast<int>(axial.size() / 2);
  described.lateral = lateral.data() + k * (scan::edge + 1);
  described.lateral_half = lateral_half[k];
  described.clutter_in_phase = clutter[0].empty() ? nullptr : clutter[0].data();
  described.clutter_quadrature = clutter[1].empty() ? nullptr : clutter[1].data();
  described.gain = gain[k];
}

PictureTables picture_tables(const AcousticVolume& patient, const anatomy::UltrasoundProbe& probe,
                             const UltrasoundSettings& settings, const UltrasoundDetail& detail,
                             const ScanLines& lines, const UltrasoundBeam& beam, const std::vector<SliceRay>& rays,
                             const std::vector<SlicePass>& passes) {
  PictureTables tables;
  tables.stride = (lines.lines + scan::lanes - 1) / scan::lanes * scan::lanes;
  for (int line = 0; line < lines.lines; ++line) {
    tables.line_origin.push_back(lines.origin(line));
    tables.line_direction.push_back(lines.direction(line));
  }
  tables.matched = static_cast<float>(matched_impedance / AcousticVolume::unit);
  const double frequency = settings.frequency > 0.0 ? settings.frequency : probe.frequency;
  set_media(tables, patient, frequency, lines.spacing);

  const double cell = std::clamp(0.5 * beam.pulse, 0.08, 0.5);  // mm: finer than any width of the picture
  tables.cells = cells_of(patient.grid, Vec3::Constant(cell));
  tables.bundles = bundles_of(patient.grid);
  set_widths(tables, detail, lines, beam, rays, passes, cell);
  set_gain(tables, settings, lines, frequency);
  if (detail.clutter) set_clutter(tables, lines);

  tables.row.samples = lines.samples;
  tables.row.stride = tables.stride;
  tables.row.lines = lines.lines;
  constexpr double decibels_per_octave = 6.0205999;
  tables.row.white = 255.0F;
  tables.row.levels_per_octave = static_cast<float>(255.0 * decibels_per_octave / settings.dynamic_range);
  return tables;
}

}  // namespace bodkin::imaging
