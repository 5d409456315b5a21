#include "imaging/ultrasound/ultrasound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"
#include "core/thread_pool.h"
#include "imaging/ultrasound/echo_lines.h"
#include "imaging/ultrasound/face_contact.h"
#include "imaging/ultrasound/layered_compression.h"
#include "imaging/ultrasound/needle_echo.h"
#include "imaging/ultrasound/picture_tables.h"
#include "imaging/ultrasound/reverberation.h"
#include "imaging/ultrasound/scan_kernel.h"
#include "imaging/ultrasound/scan_lines.h"
#include "imaging/ultrasound/scatterers.h"
#include "imaging/ultrasound/ultrasound_beam.h"

namespace bodkin::imaging {

namespace {

constexpr double least_press = 0.1;  // mm; less moves no tissue
constexpr int rows_a_turn = 8;

// The side of the slice of an off-centre ray, by line.
constexpr std::array<float, scan::lanes> one_side = [] {
  std::array<float, scan::lanes> sides{};
  sides.fill(1.0F);
  return sides;
}();
constexpr std::array<float, scan::lanes> sides_by_turns = [] {
  std::array<float, scan::lanes> sides{};
  for (std::size_t line = 0; line < sides.size(); ++line) sides[line] = line % 2 == 0 ? 1.0F : -1.0F;
  return sides;
}();

// u at a point of the scan plane (mm, probe's frame), linear between the points of the grid, its border beyond them.
Vec3 displacement_at(const ScanDisplacement& field, const Vec3& point) noexcept {
  const double column = std::clamp((point.x() - field.corner.x()) / field.spacing, 0.0, field.columns - 1.0);
  const double row = std::clamp((point.y() - field.corner.y()) / field.spacing, 0.0, field.rows - 1.0);
  const int left = std::min(static_cast<int>(column), std::max(0, field.columns - 2));
  const int above = std::min(static_cast<int>(row), std::max(0, field.rows - 2));
  const double fx = column - left, fy = row - above;
  Vec3 sum = Vec3::Zero();
  for (int corner = 0; corner < 4; ++corner) {
    const int c = std::min(left + (corner & 1), field.columns - 1),
              r = std::min(above + (corner >> 1), field.rows - 1);
    const double weight = ((corner & 1) != 0 ? fx : 1.0 - fx) * ((corner >> 1) != 0 ? fy : 1.0 - fy);
    const float* const u = field.moved.data() + 3 * (static_cast<std::ptrdiff_t>(r) * field.columns + c);
    sum += weight * Vec3(static_cast<double>(u[0]), static_cast<double>(u[1]), static_cast<double>(u[2]));
  }
  return sum;
}

// Steps after which a line leaves a lattice, including its outermost voxels.
double samples_within(const anatomy::Grid& grid, const Vec3& start, const Vec3& step) noexcept {
  double least = 1e6;  // more than any line has
  for (int axis = 0; axis < 3; ++axis) {
    const double far = step[axis] > 0.0 ? grid.size[static_cast<std::size_t>(axis)] - 0.5 : -0.5;
    if (step[axis] != 0.0) least = std::min(least, (far - start[axis]) / step[axis]);
  }
  return least;
}

bool sound(const ScanDisplacement& field) noexcept {
  constexpr float farthest = 1000.0F;  // mm; no tissue of a patient moves as far
  const bool shaped =
      field.columns >= 1 && field.rows >= 1 && field.spacing > 0.0 && field.corner.allFinite() &&
      field.moved.size() >= 3 * static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows);
  // False also for NaN.
  return shaped &&
         std::all_of(field.moved.begin(), field.moved.end(), [](float u) { return std::abs(u) <= farthest; });
}

// Refuses settings that the inner loops cannot process.
void check(const AcousticVolume* patient) {
  if (patient == nullptr)
    throw InputError("ultrasound has no patient, expected an acoustic volume; make one of a case");
  const std::array<int, 3>& size = patient->grid.size;
  if (size[0] < 2 || size[1] < 2 || size[2] < 2) {
    throw InputError(fmt::format(
        "the patient has {} x {} x {} voxels, expected at least two along each axis for ultrasound; import "
        "more of the CT",
        size[0], size[1], size[2]));
  }
  const std::size_t voxels = patient->grid.voxel_count();
  if (voxels > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw InputError(fmt::format(
        "the patient has {} voxels, expected less than 2^31 for ultrasound; import less of the CT", voxels));
  }
  if (patient->voxels.size() != voxels) {
    throw InputError(fmt::format("the acoustic volume has {} voxels, expected {}; make it of a case",
                                 patient->voxels.size(), voxels));
  }
}

}  // namespace

// Vectors of lines, three rows of floats.
struct Ultrasound::Lines {
  std::vector<float> x, y, z;

  void resize(std::size_t count) {
    for (std::vector<float>* part : {&x, &y, &z}) part->assign(count, 0.0F);
  }
  void set(std::size_t i, const Vec3& value) noexcept {
    x[i] = static_cast<float>(value.x());
    y[i] = static_cast<float>(value.y());
    z[i] = static_cast<float>(value.z());
  }
  scan::LineVectors view() const { return {x.data(), y.data(), z.data()}; }
};

struct Ultrasound::Machine {
  Machine(std::shared_ptr<const AcousticVolume> volume, anatomy::UltrasoundProbe used, UltrasoundDetail asked,
          ProcessorPath path)
      : patient(std::move(volume)),
        probe(std::move(used)),
        detail(asked),
        kernel(scan::kernel(path)),
        rays(slice_rays(asked.slices)),
        passes(slice_passes(rays, asked.speckle)),
        pool(asked.threads) {}

  void prepare(const UltrasoundSettings& wanted);
  void aim(const Pose& pose) noexcept;
  void move(const Pose& pose, const std::optional<ScanDisplacement>& displacement) noexcept;
  void draw(const Pose& pose, const std::optional<NeedleInUltrasound>& needle,
            std::span<const NeedleInUltrasound> others) noexcept;
  scan::March marching(std::size_t pass) const noexcept;

  std::shared_ptr<const AcousticVolume> patient;
  anatomy::UltrasoundProbe probe;
  UltrasoundSettings settings;
  UltrasoundDetail detail;
  const scan::Kernel& kernel;
  std::vector<SliceRay> rays;
  std::vector<SlicePass> passes;
  ThreadPool pool;

  LayeredCompression compression;
  ScanLines lines;
  UltrasoundBeam beam;
  PictureTables tables;
  ScanConversion conversion;
  UltrasoundFrame frame;

  Lines origin, step, direction, moved;
  Vec3 across = Vec3::Zero();  // voxels per mm
  float sharpness = 0.0F;      // as in scan::March
  bool is_moved = false;
  std::vector<float> gap, press, gel_samples, leaves, strong_at, strong_echo;
  std::vector<float> in_phase, quadrature, amplitude, work;
  std::vector<std::uint8_t> grey;
};

void Ultrasound::Machine::prepare(const UltrasoundSettings& wanted) {
  check(wanted, probe);
  settings = wanted;
  lines = scan_lines(probe, settings, detail);
  beam = ultrasound_beam(probe, settings);
  tables = picture_tables(*patient, probe, settings, detail, lines, beam, rays, passes);
  conversion = scan_conversion(lines, detail.width, detail.height, tables.stride);

  const auto stride = static_cast<std::size_t>(tables.stride), samples = static_cast<std::size_t>(detail.samples);
  for (Lines* vectors : {&origin, &step, &direction}) vectors->resize(stride);
  moved.resize(stride * (samples / scan::coarse + 2));
  for (std::vector<float>* row : {&gap, &press, &gel_samples, &leaves, &strong_at, &strong_echo})
    row->assign(stride, 0.0F);
  for (std::vector<float>* rows : {&in_phase, &quadrature, &amplitude}) rows->assign(stride * samples, 0.0F);
  work.assign(4 * (stride + 2 * scan::edge) * static_cast<std::size_t>(pool.threads()), 0.0F);
  grey.assign(stride * samples, 0);

  frame.width = detail.width;
  frame.height = detail.height;
  frame.pixel = conversion.pixel;
  frame.corner = conversion.corner;
  frame.pixels.assign(conversion.place.size(), 0);
}

void Ultrasound::Machine::aim(const Pose& pose) noexcept {
  const anatomy::Grid& grid = patient->grid;
  const Mat3 into_lattice = grid.direction.transpose() * pose.linear();
  const Vec3 per_mm = grid.spacing.cwiseInverse();
  const Mat3 face_into_voxels = per_mm.asDiagonal() * into_lattice;
  const Vec3 face = grid.to_index(pose.translation());
  for (int line = 0; line < tables.stride; ++line) {
    const int at = std::min(line, lines.lines - 1);  // unused lanes repeat the last line
    const auto i = static_cast<std::size_t>(line);
    const auto used = static_cast<std::size_t>(at);
    const Vec3 along = into_lattice * tables.line_direction[used];
    const Vec3 start = face + face_into_voxels * tables.line_origin[used];
    origin.set(i, start);
    direction.set(i, along);
    const Vec3 stride_in_voxels = lines.spacing * along.cwiseProduct(per_mm);
    step.set(i, stride_in_voxels);
    leaves[i] = static_cast<float>(samples_within(grid, start, stride_in_voxels));
    const bool reached = static_cast<double>(gap[used]) <= thickest_gel;
    gel_samples[i] =
        reached ? gap[used] / static_cast<float>(lines.spacing) : 2.0F * static_cast<float>(lines.samples);
  }
  across = (into_lattice * Vec3::UnitZ()).cwiseProduct(per_mm);
  const double voxel = 1.0 / (into_lattice * Vec3::UnitY()).cwiseProduct(per_mm).cwiseAbs().maxCoeff();
  sharpness = detail.speckle ? static_cast<float>(tables.ramp_loss(voxel / lines.spacing) - 1.0) : 0.0F;
}

// Displacement of the tissue at every `coarse`-th sample, voxels.
void Ultrasound::Machine::move(const Pose& pose, const std::optional<ScanDisplacement>& displacement) noexcept {
  is_moved = false;
  const bool pressed = detail.yielding && frame.press >= least_press;
  const bool given = displacement && sound(*displacement);
  if (!given && !pressed) return;
  is_moved = true;
  if (!given) compression.settle(*patient, pose, frame.press);
  const anatomy::Grid& grid = patient->grid;
  const Mat3 into_voxels = grid.spacing.cwiseInverse().asDiagonal() * grid.direction.transpose();
  const int rows = lines.samples / scan::coarse + 2;
  for (int row = 0; row < rows; ++row) {
    const double depth = row * scan::coarse * lines.spacing;
    // Lines other than the middle one, pressed to other depths, compress like the middle one.
    const double share = given ? 0.0 : compression.moved(depth) / frame.press;
    for (int line = 0; line < tables.stride; ++line) {
      const int used = std::min(line, lines.lines - 1);
      const Vec3& along = tables.line_direction[static_cast<std::size_t>(used)];
      const Vec3 u =
          given ? displacement_at(*displacement, tables.line_origin[static_cast<std::size_t>(used)] + depth * along)
                : Vec3(share * static_cast<double>(press[static_cast<std::size_t>(used)]) * (pose.linear() * along));
      moved.set(
          static_cast<std::size_t>(row) * static_cast<std::size_t>(tables.stride) + static_cast<std::size_t>(line),
          into_voxels * u);
    }
  }
}

scan::March Ultrasound::Machine::marching(std::size_t pass) const noexcept {
  const anatomy::Grid& grid = patient->grid;
  scan::March march{};
  march.voxels = patient->voxels.data();
  for (int axis = 0; axis < 3; ++axis) {
    march.size[axis] = grid.size[static_cast<std::size_t>(axis)];
    march.per_mm[axis] = static_cast<float>(1.0 / grid.spacing[axis]);
    march.across[axis] = static_cast<float>(across[axis]);
    const auto i = static_cast<std::size_t>(axis);
    march.cells_per_voxel[axis] = tables.cells.per_voxel[i];
    march.first_cell[axis] = tables.cells.first[i];
    march.bundles_per_voxel[axis] = tables.bundles.per_voxel[i];
    march.first_bundle[axis] = tables.bundles.first[i];
  }
  march.media = tables.media.data();
  march.mirror = 0.6F;
  march.bone_mirror = 0.75F;
  march.bone_edge = 1.5F;
  march.surface = 1.0F;
  march.sharpness = sharpness;
  march.matched = tables.matched;
  march.scatterers = detail.speckle ? scatterers().cells.data() : nullptr;
  march.fibres = scatterers().bundles.data();
  march.speckle_gain = tables.speckle_gain.data();
  march.lines = lines.lines;
  march.samples = lines.samples;
  march.stride = tables.stride;
  march.origin = origin.view();
  march.step = step.view();
  march.direction = direction.view();
  march.gel_samples = gel_samples.data();
  march.leaves = leaves.data();
  march.offset = passes[pass].off == 0.0 ? nullptr : tables.offsets[pass].data();
  march.both_sides = passes[pass].alternates;
  march.sides = passes[pass].alternates ? sides_by_turns.data() : one_side.data();
  if (is_moved) {
    march.moved[0] = moved.x.data();
    march.moved[1] = moved.y.data();
    march.moved[2] = moved.z.data();
  }
  march.weight = static_cast<float>(passes[pass].weight);
  march.first = pass == 0;
  return march;
}

void Ultrasound::Machine::draw(const Pose& pose, const std::optional<NeedleInUltrasound>& needle,
                               std::span<const NeedleInUltrasound> others) noexcept {
  // Blocks of lines: one thread makes all passes of a block, in order, so that sums do not depend on the threads.
  const auto march_block = [this](int block) noexcept {
    for (std::size_t pass = 0; pass < passes.size(); ++pass) {
      scan::March march = marching(pass);
      march.in_phase = in_phase.data();
      march.quadrature = quadrature.data();
      march.amplitude = amplitude.data();
      march.strong_at = strong_at.data();
      march.strong_echo = strong_echo.data();
      kernel.march(march, block);
    }
  };
  pool.run(tables.stride / scan::lanes, march_block);

  const EchoLines rows{lines.lines, lines.samples, tables.stride, in_phase, quadrature, amplitude};
  if (detail.reverberation) add_reverberation(rows, strong_at, strong_echo, lines.spacing);
  const auto add = [&](NeedleInUltrasound seen) noexcept {
    seen.pose = pose.inverse(Eigen::Isometry) * seen.pose;
    add_needle(rows, lines, beam, seen);
  };
  for (const NeedleInUltrasound& other : others) add(other);
  if (needle) add(*needle);

  const auto compress_rows = [this](int turn, int thread) noexcept {
    scan::Row row = tables.row;
    row.in_phase = in_phase.data();
    row.quadrature = quadrature.data();
    const std::size_t length = 4 * (static_cast<std::size_t>(tables.stride) + 2 * scan::edge);
    row.work = work.data() + length * static_cast<std::size_t>(thread);
    for (int k = turn * rows_a_turn; k < std::min(lines.samples, (turn + 1) * rows_a_turn); ++k) {
      tables.describe(k, row);
      row.grey = grey.data() + static_cast<std::ptrdiff_t>(k) * tables.stride;
      kernel.compress(row);
    }
  };
  pool.run((lines.samples + rows_a_turn - 1) / rows_a_turn, compress_rows);

  const auto convert_rows = [this](int turn) noexcept {
    const scan::Conversion all{grey.data(), tables.stride, conversion.place.data(), conversion.weights.data(),
                               frame.pixels.data()};
    const int first_row = turn * rows_a_turn, last_row = std::min(frame.height, (turn + 1) * rows_a_turn);
    const std::size_t last = conversion.row_of_runs[static_cast<std::size_t>(last_row)];
    for (std::size_t run = conversion.row_of_runs[static_cast<std::size_t>(first_row)]; run < last; ++run)
      kernel.convert(all, conversion.runs[run].first, conversion.runs[run].last);
  };
  pool.run((frame.height + rows_a_turn - 1) / rows_a_turn, convert_rows);
}

Ultrasound::Ultrasound(std::shared_ptr<const AcousticVolume> patient, anatomy::UltrasoundProbe probe,
                       UltrasoundSettings settings, UltrasoundDetail detail, ProcessorPath path) {
  check(patient.get());
  anatomy::check(probe, "the probe");
  check(detail);
  machine_ = std::make_unique<Machine>(std::move(patient), std::move(probe), detail, path);
  machine_->prepare(settings);
}

Ultrasound::Ultrasound(Ultrasound&&) noexcept = default;
Ultrasound& Ultrasound::operator=(Ultrasound&&) noexcept = default;
Ultrasound::~Ultrasound() = default;

const anatomy::UltrasoundProbe& Ultrasound::probe() const {
  return machine_->probe;
}

const UltrasoundSettings& Ultrasound::settings() const {
  return machine_->settings;
}

const UltrasoundDetail& Ultrasound::detail() const {
  return machine_->detail;
}

void Ultrasound::set(const UltrasoundSettings& settings) {
  machine_->prepare(settings);
}

const UltrasoundFrame& Ultrasound::image(const Pose& pose, const std::optional<NeedleInUltrasound>& needle,
                                         const std::optional<ScanDisplacement>& displacement,
                                         std::span<const NeedleInUltrasound> others) noexcept {
  Machine& machine = *machine_;
  const FaceContact contact =
      face_contact(*machine.patient, machine.tables.line_origin, machine.tables.line_direction, pose,
                   machine.settings.gel, machine.gap, machine.press);
  machine.frame.why = contact.why;
  machine.frame.contact = contact.share;
  machine.frame.press = contact.press;
  if (contact.why != NoImage::none) {
    std::fill(machine.frame.pixels.begin(), machine.frame.pixels.end(), std::uint8_t{0});
    return machine.frame;
  }
  machine.aim(pose);
  machine.move(pose, displacement);
  machine.draw(pose, needle, others);
  return machine.frame;
}

}  // namespace bodkin::imaging
