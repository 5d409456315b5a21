#include "imaging/ultrasound/acoustic_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "core/error.h"
#include "imaging/ultrasound/bone_surface.h"

namespace bodkin::imaging {

namespace {

constexpr double air_impedance = 0.0004;        // MRayl
constexpr double greatest_impedance = 8.0;      // MRayl, that the map from HU gives
constexpr double mast_offset = 349.0;           // kg/m^3; speed = (density + offset) / slope, Mast 2000
constexpr double mast_slope = 0.893;            // kg s/m^4
constexpr double largest_variation = 0.08;      // fraction of a tissue's impedance by which its HU may change it
constexpr double softest = 1.0, hardest = 3.0;  // MRayl, the range in which HU predict impedance as in soft tissue

// The Gaussian against the noise of the CT: 0.7 voxels, which removes three quarters of it.
constexpr int gaussian_reach = 2;  // voxels
constexpr std::array<float, 2 * gaussian_reach + 1> gaussian = {0.0169F, 0.3604F, 1.0F, 0.3604F, 0.0169F};

constexpr double surely_air = -200.0;            // HU; air shows less somewhere
constexpr int picture_white = 200;               // the brightest of eight bits; a phantom of a few HU is darker
constexpr double surely_not_soft = 400.0;        // HU by which soft tissue may miss its typical value on average
constexpr std::size_t largest_sample = 1 << 20;  // voxels for the mean of soft tissue
constexpr int progress_reports = 32;

// impedance_of_hounsfield in steps of an eighth of a HU; the map must be fast, and the steps must not echo.
class HounsfieldTable {
 public:
  HounsfieldTable() : impedance_(static_cast<std::size_t>((last - first) * steps + 1)) {
    for (std::size_t i = 0; i < impedance_.size(); ++i)
      impedance_[i] = static_cast<float>(impedance_of_hounsfield(first + static_cast<double>(i) / steps));
  }
  float operator()(float hounsfield) const {
    const float position = (hounsfield - first) * steps + 0.5F;
    return impedance_[static_cast<std::size_t>(
        std::clamp(position, 0.0F, static_cast<float>(impedance_.size() - 1)))];
  }

 private:
  static constexpr int first = -1024, last = 4095, steps = 8;
  std::vector<float> impedance_;  // MRayl
};

bool is_bone(std::size_t id) {
  return id == anatomy::tissue::cortical_bone || id == anatomy::tissue::cancellous_bone;
}

// Tissues too thin for a CT: they are constructed by anatomy, and the HU there belong to their neighbours.
constexpr std::array<anatomy::TissueId, 9> constructed = {anatomy::tissue::skin,
                                                          anatomy::tissue::supraspinous_ligament,
                                                          anatomy::tissue::interspinous_ligament,
                                                          anatomy::tissue::ligamentum_flavum,
                                                          anatomy::tissue::epidural_fat,
                                                          anatomy::tissue::dura,
                                                          anatomy::tissue::cerebrospinal_fluid,
                                                          anatomy::tissue::nerve,
                                                          anatomy::tissue::spinal_cord};

bool varies_with_hounsfield(std::size_t id, double impedance) {
  return !is_bone(id) && impedance >= softest && impedance <= hardest &&
         std::find(constructed.begin(), constructed.end(), id) == constructed.end();
}

// The impedance of one tissue: own + (map(HU) - typical), limited to own +- most.
struct ImpedanceRule {
  float own = 0.0F;      // MRayl
  float typical = 0.0F;  // MRayl, of the map at the tissue's typical HU
  float most = 0.0F;     // MRayl
};

// Every tissue by id. A tissue without an impedance value has that of its HU.
std::array<ImpedanceRule, 256> impedance_rules(const anatomy::TissueLibrary& library) {
  std::array<ImpedanceRule, 256> rules;
  for (std::size_t id = 0; id < rules.size(); ++id) {
    const anatomy::TissueProperties* entry = library.find(static_cast<anatomy::TissueId>(id));
    const double own = entry == nullptr ? 0.0 : entry->acoustic.impedance;
    if (own == 0.0) {
      rules[id].most = 100.0F;
      continue;
    }
    rules[id].own = static_cast<float>(own);
    rules[id].typical = static_cast<float>(impedance_of_hounsfield(entry->hounsfield));
    if (varies_with_hounsfield(id, own)) rules[id].most = static_cast<float>(largest_variation * own);
  }
  rules[anatomy::tissue::air] = {.own = static_cast<float>(air_impedance)};
  return rules;
}

bool is_soft(const anatomy::TissueProperties& entry) {
  return !is_bone(entry.id) && entry.hounsfield > surely_air && entry.hounsfield < surely_not_soft;
}

// HU of the tissue lattice's voxels, slice by slice.
class HounsfieldSlices {
 public:
  explicit HounsfieldSlices(const anatomy::Case& patient)
      : ct_(patient.ct), tissues_(patient.tissues), same_(anatomy::same_lattice(ct_.grid, tissues_.grid)) {
    for (const anatomy::TissueProperties& entry : patient.library.tissues())
      typical_[entry.id] = static_cast<float>(entry.hounsfield);
  }

  // HU at voxel (i, j, k); beyond the CT the typical HU of the tissue there.
  float at(int i, int j, int k) const {
    const std::size_t position = tissues_.grid.offset(i, j, k);
    if (same_) return static_cast<float>(ct_.voxels[position]);
    const Vec3 index = ct_.grid.to_index(tissues_.grid.to_patient(Vec3(i, j, k)));
    const double value = anatomy::linear_at_index(ct_, index, std::numeric_limits<double>::quiet_NaN());
    return std::isnan(value) ? typical_[tissues_.voxels[position]] : static_cast<float>(value);
  }
  // The same of all voxels of slice k.
  void read(int k, std::vector<float>& slice) const {
    const anatomy::Grid& grid = tissues_.grid;
    float* row = slice.data();
    for (int j = 0; j < grid.size[1]; ++j, row += grid.size[0]) {
      const Vec3 first = ct_.grid.to_index(grid.to_patient(Vec3(0, j, k)));
      const Vec3 step = ct_.grid.to_index(grid.to_patient(Vec3(1, j, k))) - first;
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 index = first + i * step;
        row[i] = !same_ && well_inside(index) ? between(index) : at(i, j, k);
      }
    }
  }

 private:
  bool well_inside(const Vec3& index) const {
    return index.x() >= 0.0 && index.y() >= 0.0 && index.z() >= 0.0 && index.x() < ct_.grid.size[0] - 1 &&
           index.y() < ct_.grid.size[1] - 1 && index.z() < ct_.grid.size[2] - 1;
  }
  // linear_at_index where all eight neighbours exist.
  float between(const Vec3& index) const {
    const int i = static_cast<int>(index.x()), j = static_cast<int>(index.y()), k = static_cast<int>(index.z());
    const auto u = static_cast<float>(index.x() - i), v = static_cast<float>(index.y() - j),
               w = static_cast<float>(index.z() - k);
    const auto columns = static_cast<std::size_t>(ct_.grid.size[0]);
    const std::int16_t* const near = ct_.voxels.data() + ct_.grid.offset(i, j, k);
    const std::int16_t* const far = near + columns * static_cast<std::size_t>(ct_.grid.size[1]);
    const auto along = [u](const std::int16_t* pair) {
      return static_cast<float>(pair[0]) + u * static_cast<float>(pair[1] - pair[0]);
    };
    const float low = along(near), high = along(far);
    const float low_side = low + v * (along(near + columns) - low),
                high_side = high + v * (along(far + columns) - high);
    return low_side + w * (high_side - low_side);
  }

  const anatomy::CtVolume& ct_;
  const anatomy::TissueVolume& tissues_;
  std::array<float, 256> typical_{};
  bool same_;
};

// Mean deviation of soft tissue from its typical HU, over at most a million voxels; 0 without soft tissue.
double soft_tissue_error(const anatomy::Case& patient, const HounsfieldSlices& hounsfield) {
  const anatomy::Grid& grid = patient.tissues.grid;
  std::array<const anatomy::TissueProperties*, 256> soft{};
  for (const anatomy::TissueProperties& entry : patient.library.tissues())
    if (is_soft(entry)) soft[entry.id] = &entry;
  const std::size_t stride = grid.voxel_count() / largest_sample + 1;
  double sum = 0.0, count = 0.0;
  const auto columns = static_cast<std::size_t>(grid.size[0]), rows = static_cast<std::size_t>(grid.size[1]);
  for (std::size_t position = 0; position < grid.voxel_count(); position += stride) {
    const anatomy::TissueProperties* entry = soft[patient.tissues.voxels[position]];
    if (entry == nullptr) continue;
    const auto i = static_cast<int>(position % columns), j = static_cast<int>(position / columns % rows),
               k = static_cast<int>(position / columns / rows);
    sum += static_cast<double>(hounsfield.at(i, j, k)) - entry->hounsfield;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

void check_hounsfield(const anatomy::Case& patient, const HounsfieldSlices& hounsfield) {
  const auto& voxels = patient.ct.voxels;
  const auto& tissues = patient.tissues.voxels;
  if (voxels.empty() || voxels.size() != patient.ct.grid.voxel_count())
    throw InputError("the case has no CT, which ultrasound is computed from; import the patient again");
  if (tissues.empty() || tissues.size() != patient.tissues.grid.voxel_count())
    throw InputError("the case has no tissues, which ultrasound is computed from; import the patient again");
  const auto airy = [](std::uint8_t id) { return id == anatomy::tissue::air; };
  if (std::all_of(tissues.begin(), tissues.end(), airy))
    throw InputError("the case holds nothing but air, expected a patient; import one whose skin is in the CT");
  const auto [least, most] = std::minmax_element(voxels.begin(), voxels.end());
  const char* const remedy = "import the patient from a CT with its rescale slope and intercept";
  if (*least >= 0 && *most >= picture_white && *most <= 255) {
    throw InputError(
        fmt::format("the CT is not in Hounsfield units: its values go from {} to {}, as a picture's do; {}", *least,
                    *most, remedy));
  }
  if (*least > surely_air && std::any_of(tissues.begin(), tissues.end(), airy)) {
    throw InputError(
        fmt::format("the CT is not in Hounsfield units: no value is below {}, though there is air, expected about "
                    "-1000; {}",
                    *least, remedy));
  }
  const double error = soft_tissue_error(patient, hounsfield);
  if (!(std::abs(error) <= surely_not_soft)) {
    throw InputError(
        fmt::format("the CT is not in Hounsfield units: soft tissue misses its usual values by {:+.0f} on average, "
                    "expected less than {:.0f}; {}",
                    error, surely_not_soft, remedy));
  }
}

// Smooths slice after slice along the rows and columns, then across slices, each time only over neighbours of the
// same tissue: borders do not move.
class TissueSmoother {
 public:
  TissueSmoother(const HounsfieldSlices& hounsfield, const anatomy::TissueVolume& tissues)
      : hounsfield_(hounsfield),
        tissues_(tissues),
        row_(static_cast<std::size_t>(tissues.grid.size[0])),
        column_(static_cast<std::size_t>(tissues.grid.size[1])),
        slice_(row_ * column_),
        weight_(slice_),
        smooth_(slice_) {
    for (auto& slice : ring_) slice.resize(slice_);
    for (int k = 0; k < std::min(gaussian_reach, tissues.grid.size[2]); ++k) smooth_in_plane(k);
  }

  // HU of slice k; slices must be asked for in order.
  const std::vector<float>& slice(int k) {
    if (k + gaussian_reach < tissues_.grid.size[2]) smooth_in_plane(k + gaussian_reach);
    start();
    for (int d = -gaussian_reach; d <= gaussian_reach; ++d) {
      if (k + d < 0 || k + d >= tissues_.grid.size[2]) continue;
      add(d, ids(k), ids(k + d), slot(k + d).data(), 0, slice_);
    }
    finish();
    return smooth_;
  }

 private:
  const std::uint8_t* ids(int k) const { return tissues_.voxels.data() + static_cast<std::size_t>(k) * slice_; }
  std::vector<float>& slot(int k) { return ring_[static_cast<std::size_t>(k) % ring_.size()]; }
  void start() {
    std::fill(smooth_.begin(), smooth_.end(), 0.0F);
    std::fill(weight_.begin(), weight_.end(), 0.0F);
  }
  // Adds neighbour number d of `count` voxels from `begin` on, if it has the voxel's tissue.
  void add(int d, const std::uint8_t* here, const std::uint8_t* there, const float* value, std::size_t begin,
           std::size_t count) {
    const int neighbour = d + gaussian_reach;
    const float share = gaussian[static_cast<std::size_t>(neighbour)];
    float* const sum = smooth_.data() + begin;
    float* const weight = weight_.data() + begin;
    for (std::size_t i = 0; i < count; ++i) {
      const float w = here[i] == there[i] ? share : 0.0F;
      sum[i] += w * value[i];
      weight[i] += w;
    }
  }
  void finish() {
    for (std::size_t i = 0; i < slice_; ++i) smooth_[i] /= weight_[i];  // at least the voxel itself
  }
  void smooth_in_plane(int k) {
    std::vector<float>& values = slot(k);
    const std::uint8_t* const id = ids(k);
    hounsfield_.read(k, values);
    start();
    for (int d = -gaussian_reach; d <= gaussian_reach; ++d) {
      const auto away = static_cast<std::size_t>(std::abs(d));
      if (away >= row_) continue;
      for (std::size_t begin = 0; begin < slice_; begin += row_) {
        const std::size_t here = begin + (d < 0 ? away : 0), there = begin + (d > 0 ? away : 0);
        add(d, id + here, id + there, values.data() + there, here, row_ - away);
      }
    }
    finish();
    std::copy(smooth_.begin(), smooth_.end(), values.begin());
    start();
    for (int d = -gaussian_reach; d <= gaussian_reach; ++d) {
      const std::size_t away = static_cast<std::size_t>(std::abs(d)) * row_;
      if (away >= slice_) continue;
      const std::size_t here = d < 0 ? away : 0, there = d > 0 ? away : 0;
      add(d, id + here, id + there, values.data() + there, here, slice_ - away);
    }
    finish();
    std::copy(smooth_.begin(), smooth_.end(), values.begin());
  }

  const HounsfieldSlices& hounsfield_;
  const anatomy::TissueVolume& tissues_;
  std::size_t row_, column_, slice_;                             // voxels
  std::vector<float> weight_, smooth_;                           // of one slice
  std::array<std::vector<float>, 2 * gaussian_reach + 1> ring_;  // HU, smooth in their planes
};

}  // namespace

double impedance_of_hounsfield(double hounsfield) {
  const double x = hounsfield + 1000.0;
  double density = 0.6625370912451 * x + 348.8555178455294;  // kg/m^3
  if (x < 930.0)
    density = 1.025793065681423 * x - 5.680404011488714;
  else if (x <= 1098.0)
    density = 0.9082709691264 * x + 103.6151457847139;
  else if (x < 1260.0)
    density = 0.5108369316599 * x + 539.9977189228704;
  if (!(density > 1.2)) return air_impedance;  // air's own density, below which the fit is meaningless; also for NaN
  return std::clamp(1e-6 * density * (density + mast_offset) / mast_slope, air_impedance, greatest_impedance);
}

std::shared_ptr<const AcousticVolume> acoustic_volume(const anatomy::Case& patient, const Progress& progress) {
  const HounsfieldSlices hounsfield(patient);
  check_hounsfield(patient, hounsfield);
  auto volume = std::make_shared<AcousticVolume>();
  volume->grid = patient.tissues.grid;
  volume->media = patient.library.by_id(&anatomy::TissueProperties::acoustic);
  for (const anatomy::TissueProperties& entry : patient.library.tissues())
    volume->young[entry.id] = entry.deformable.young;
  const auto& tissues = patient.tissues.voxels;
  volume->voxels.reserve(tissues.size());

  const HounsfieldTable map;
  const std::array<ImpedanceRule, 256> rules = impedance_rules(patient.library);
  constexpr auto steps = static_cast<float>(1.0 / AcousticVolume::unit);
  constexpr auto highest = static_cast<float>(std::numeric_limits<std::int16_t>::max());
  TissueSmoother smoother(hounsfield, patient.tissues);
  const int slices = volume->grid.size[2];
  std::size_t position = 0;
  for (int k = 0; k < slices; ++k) {
    if (progress && k % (slices / progress_reports + 1) == 0)
      progress("preparing the ultrasound", static_cast<double>(k) / slices);
    for (const float value : smoother.slice(k)) {
      const anatomy::TissueId id = tissues[position++];
      const ImpedanceRule& rule = rules[id];
      const float change = std::clamp(map(value) - rule.typical, -rule.most, rule.most);
      const auto impedance = static_cast<std::int16_t>(std::min((rule.own + change) * steps + 0.5F, highest));
      volume->voxels.push_back(AcousticVolume::voxel(impedance, id));
    }
  }
  smooth_bone_surface(*volume);
  if (progress) progress("preparing the ultrasound", 1.0);
  return volume;
}

}  // namespace bodkin::imaging
