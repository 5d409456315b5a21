#include "imaging/ultrasound/layered_compression.h"

#include <algorithm>
#include <cmath>

#include "core/settings_check.h"

namespace bodkin::imaging {

namespace {

// Young's modulus of the voxel around `point`, MPa; outside the volume that of soft tissue.
double modulus_at(const AcousticVolume& patient, const Vec3& point) noexcept {
  const Vec3 rounded = (patient.grid.to_index(point).array() + 0.5).floor();
  const auto& size = patient.grid.size;
  const bool inside = rounded.x() >= 0.0 && rounded.y() >= 0.0 && rounded.z() >= 0.0 && rounded.x() < size[0] &&
                      rounded.y() < size[1] && rounded.z() < size[2];
  if (!inside) return LayeredCompression::soft_modulus;
  const std::size_t voxel = patient.grid.offset(static_cast<int>(rounded.x()), static_cast<int>(rounded.y()),
                                                static_cast<int>(rounded.z()));
  const anatomy::TissueId id = patient.tissue(voxel);
  const bool bone =
      id == anatomy::tissue::cortical_bone || id == anatomy::tissue::cancellous_bone || id == anatomy::tissue::metal;
  return std::max(patient.young[id], bone ? LayeredCompression::rigid_modulus : 0.0);
}

}  // namespace

LayeredCompression::LayeredCompression(double reach, double spacing) : spacing_(spacing) {
  check_range("layered compression", "reach", reach, {10.0, 400.0}, "mm");
  check_range("layered compression", "spacing", spacing, {0.05, 5.0}, "mm");
  moduli_.resize(static_cast<std::size_t>(std::ceil(reach / spacing)));
  rest_depths_.resize(moduli_.size() + 1);
  settle_layers(moduli_.size(), 0.0);
}

void LayeredCompression::settle(const AcousticVolume& patient, const Pose& pose, double press) noexcept {
  settle(patient, pose.translation(), pose.linear().col(1), press);
}

void LayeredCompression::settle(const AcousticVolume& patient, const Vec3& face, const Vec3& direction,
                                double press) noexcept {
  const Vec3 skin = face - press * direction;
  if (!skin.allFinite()) return settle_layers(moduli_.size(), 0.0);
  std::size_t layers = 0;
  for (; layers < moduli_.size(); ++layers) {
    moduli_[layers] = modulus_at(patient, skin + (static_cast<double>(layers) + 0.5) * spacing_ * direction);
    if (moduli_[layers] >= rigid_modulus) break;
  }
  settle_layers(layers, press);
}

void LayeredCompression::settle(std::span<const double> moduli, double press) noexcept {
  const std::size_t given = std::min(moduli.size(), moduli_.size());
  std::copy_n(moduli.begin(), given, moduli_.begin());
  const auto rigid = std::find_if(moduli_.begin(), moduli_.begin() + static_cast<std::ptrdiff_t>(given),
                                  [](double modulus) { return modulus >= rigid_modulus; });
  settle_layers(static_cast<std::size_t>(rigid - moduli_.begin()), press);
}

void LayeredCompression::settle_layers(std::size_t layers, double press) noexcept {
  press_ = press > 0.0 && std::isfinite(press) ? press : 0.0;
  far_end_ = static_cast<double>(layers) * spacing_;
  for (std::size_t i = 0; i < layers; ++i)
    if (!(moduli_[i] > 0.0)) moduli_[i] = soft_modulus;  // also NaN

  // The same stress in every layer: strain = stress / modulus, together the press. Layers that it would shorten too
  // far take their maximum; the others share the rest, which may bring more of them to their maximum.
  double stress = 0.0, above = 0.0;  // MPa; the stress of the round before
  excess_ = std::max(0.0, press_ - most_strain * far_end_);
  if (excess_ > 0.0 || layers == 0) {
    stress = 1e300;  // every layer is at its maximum
  } else {
    do {
      above = stress;
      double left = press_, compliance = 0.0;  // mm; mm/MPa
      for (std::size_t i = 0; i < layers; ++i) {
        if (above > most_strain * moduli_[i])
          left -= most_strain * spacing_;
        else
          compliance += spacing_ / moduli_[i];
      }
      stress = compliance > 0.0 ? std::max(above, left / compliance) : above;
    } while (stress > above);
  }

  // Present depth below the face of the border above rest layer i; depths must be requested in order.
  double now = 0.0;
  std::size_t layer = 0, next = 0;
  for (; layer < layers; ++layer) {
    const double thickness = spacing_ * (1.0 - std::min(stress / moduli_[layer], most_strain));
    for (; next < rest_depths_.size(); ++next) {
      const double depth = static_cast<double>(next) * spacing_;
      if (depth >= now + thickness) break;
      const double share = (depth - now) / thickness;
      rest_depths_[next] = static_cast<float>((static_cast<double>(layer) + share) * spacing_);
    }
    now += thickness;
  }
  for (; next < rest_depths_.size(); ++next)
    rest_depths_[next] = static_cast<float>(static_cast<double>(next) * spacing_ + press_ - excess_);
}

double LayeredCompression::rest_depth(double depth) const noexcept {
  if (!(depth > 0.0)) return depth;
  const double position = depth / spacing_;
  const std::size_t last = rest_depths_.size() - 1;
  if (!(position < static_cast<double>(last))) return depth + press_ - excess_;
  const auto cell = static_cast<std::size_t>(position);
  const double share = position - static_cast<double>(cell);
  return (1.0 - share) * static_cast<double>(rest_depths_[cell]) +
         share * static_cast<double>(rest_depths_[cell + 1]);
}

}  // namespace bodkin::imaging
