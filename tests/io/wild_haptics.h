#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "anatomy/case.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;

// --- equality to the bit -----------------------------------------------------------------------------------------

// Every member of the settings: a member more or less does not compile.
inline auto members(const LayeredSettings& s) {
  const auto& [a, b, c] = s;
  return std::tie(a, b, c);
}
inline auto members(const SpringDamperWallSettings& s) {
  const auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
inline auto members(const TrackingWallTissue& s) {
  const auto& [a, b] = s;
  return std::tie(a, b);
}
inline auto members(const TrackingWallDepthLayer& s) {
  const auto& [a, b] = s;
  return std::tie(a, b);
}
inline auto members(const TrackingWallSettings& s) {
  const auto& [a, b, c, d, e, f, g, h] = s;
  return std::tie(a, b, c, d, e, f, g, h);
}
inline auto members(const DepthProfileSettings& s) {
  const auto& [a, b, c, d, e, f, g, h, i, j, k] = s;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k);
}
inline auto members(const HapticFieldSettings& s) {
  const auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
inline auto members(const ProxyProperties& s) {
  const auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
inline auto members(const TransferPoint& s) {
  const auto& [a, b] = s;
  return std::tie(a, b);
}
inline auto members(const VolumeProxySettings& s) {
  const auto& [a, b, c, d, e, f, g, h] = s;
  return std::tie(a, b, c, d, e, f, g, h);
}
inline auto members(const KarnoppFriction& s) {
  const auto& [a, b, c] = s;
  return std::tie(a, b, c);
}
inline auto members(const ThreeComponentSettings& s) {
  const auto& [a, b, c, d, e, f, g, h, i, j] = s;
  return std::tie(a, b, c, d, e, f, g, h, i, j);
}
inline auto members(const FractureSettings& s) {
  const auto& [a, b, c, d, e, f, g, h] = s;
  return std::tie(a, b, c, d, e, f, g, h);
}
inline auto members(const ShaftFrictionSettings& s) {
  const auto& [a] = s;
  return std::tie(a);
}
inline auto members(const DeformableBodySettings& s) {
  const auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
inline auto members(const CorridorSettings& s) {
  const auto& [a, b, c] = s;
  return std::tie(a, b, c);
}
inline auto members(const NeedleBendingSettings& s) {
  const auto& [a, b, c, d, e] = s;
  return std::tie(a, b, c, d, e);
}
inline auto members(const EmbeddedNeedleSettings& s) {
  const auto& [a, b, c, d, e, f, g, h] = s;
  return std::tie(a, b, c, d, e, f, g, h);
}
inline auto members(const ClosestNodeSettings& s) {
  const auto& [a, b, c, d, e, f, g] = s;
  return std::tie(a, b, c, d, e, f, g);
}
inline auto members(const LineSpringSettings& s) {
  const auto& [a, b, c] = s;
  return std::tie(a, b, c);
}
inline auto members(const PivotSettings& s) {
  const auto& [a, b, c, d, e] = s;
  return std::tie(a, b, c, d, e);
}
inline auto members(const RailSettings& s) {
  const auto& [a, b, c, d, e] = s;
  return std::tie(a, b, c, d, e);
}
inline auto members(const BeamSettings& s) {
  const auto& [a, b, c, d, e] = s;
  return std::tie(a, b, c, d, e);
}
inline auto members(const NoConstraint&) {
  return std::tuple<>();
}
inline auto members(const PronyTerm& s) {
  const auto& [a, b] = s;
  return std::tie(a, b);
}
inline auto members(const NeedleGraspSettings& s) {
  const auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
inline auto members(const SurfaceProxySettings& s) {
  const auto& [a, b, c, d, e, f] = s;
  return std::tie(a, b, c, d, e, f);
}
inline auto members(const RegisteredSettings& s) {
  const auto& [a, b, c] = s;
  return std::tie(a, b, c);
}
inline auto members(const BevelTipSettings& s) {
  const auto& [a, b, c] = s;
  return std::tie(a, b, c);
}
inline auto members(const CsfFlowSettings& s) {
  const auto& [a, b, c, d, e, f, g, h, i] = s;
  return std::tie(a, b, c, d, e, f, g, h, i);
}
inline auto members(const FingertipSettings& s) {
  const auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
inline auto members(const SyringeSettings& s) {
  const auto& [a, b, c, d, e, f, g, h, i] = s;
  return std::tie(a, b, c, d, e, f, g, h, i);
}
inline auto members(const ForceParts& s) {
  const auto& [a, b, c, d, e, f, g] = s;
  return std::tie(a, b, c, d, e, f, g);
}
inline auto members(const GravitySettings& s) {
  const auto& [a, b, c, d, e] = s;
  return std::tie(a, b, c, d, e);
}
inline auto members(const HapticSettings& s) {
  const auto& [a, b, c, d, e, f, g] = s;
  return std::tie(a, b, c, d, e, f, g);
}

template <typename T>
bool same_bits(const T& a, const T& b);
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const std::string& a, const std::string& b) {
  return a == b;
}
inline bool same_bits(const SettingsTree& a, const SettingsTree& b) {
  return a == b;
}
inline bool same_bits(const std::pair<std::string, std::string>& a, const std::pair<std::string, std::string>& b) {
  return a == b;
}
inline bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}
template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same_bits(x, y); });
}
template <typename T>
bool same_bits(const std::optional<T>& a, const std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || same_bits(*a, *b));
}
template <typename... T>
bool same_bits(const std::variant<T...>& a, const std::variant<T...>& b) {
  return a.index() == b.index() &&
         std::visit([&b](const auto& x) { return same_bits(x, std::get<std::decay_t<decltype(x)>>(b)); }, a);
}
template <typename T>
bool same_bits(const T& a, const T& b) {
  if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) {
    return a == b;
  } else {
    return std::apply(
        [&b](const auto&... x) {
          return std::apply([&](const auto&... y) { return (same_bits(x, y) && ... && true); }, members(b));
        },
        members(a));
  }
}

// --- anything that is allowed ------------------------------------------------------------------------------------

// Numbers with every bit in use, of any size that the range allows.
inline double wild_number(Random& random, double low, double high) {
  if (random.uniform() < 0.1) return low <= 0.0 && high >= 0.0 && low < 0.0 ? 0.0 : high;
  const double span = high - low;
  return std::min(high, low + span * std::pow(random.uniform(1e-4, 1.0), random.uniform(0.1, 3.0)));
}

inline ResistanceSettings wild_resistance(Random& random) {
  const auto number = [&](double low, double high) { return wild_number(random, low, high); };
  const auto coin = [&] { return random.uniform() < 0.5; };
  switch (random.next() % resistance_names.size()) {
    case 0:
      return LayeredSettings{coin() ? LayeredLaw::sum : LayeredLaw::cubic, coin(), number(0.1, 2.0)};
    case 1:
      return SpringDamperWallSettings{number(0.0, 100.0), number(0.0, 1.0), number(-1e3, 1e3), number(1e-3, 100.0)};
    case 2: {
      TrackingWallSettings s{coin(),
                             number(-1e3, 1e3),
                             number(1e-3, 1e9),
                             coin(),
                             number(1e-3, 100.0),
                             number(0.0, 100.0),
                             number(0.0, 90.0),
                             {}};
      for (double from = 0.0; from < 1e3 && coin(); from += number(1e-9, 100.0))
        s.layers.push_back({from, {number(0.01, 100.0), number(0.0, 50.0)}});
      return s;
    }
    case 3: {
      const double deep = number(0.1, 50.0);
      return DepthProfileSettings{number(0.01, 10.0),  deep,
                                  number(0.01, deep),  number(0.01, 10.0),
                                  number(1e-3, 100.0), number(0.0, 1.0),
                                  number(1.0, 400.0),  number(0.1, 1e3),
                                  number(0.0, 5.0),    number(0.0, 100.0),
                                  number(0.0, 90.0)};
    }
    case 4: {
      const double reference = number(1e-6, 1e3), lowest = number(-2e3, 2.5e3);
      VolumeProxySettings s{number(0.01, 10.0),
                            reference,
                            number(0.0, reference),
                            coin() ? ProxyVariant::viscous : ProxyVariant::drag,
                            coin(),
                            number(1e-3, 100.0),
                            {number(0.0, 10.0), lowest, number(lowest + 1.0, 4e3), number(0.0, 3.0)},
                            {}};
      for (double value = number(-100.0, 0.0); value < 100.0 && coin(); value += number(1e-9, 10.0))
        s.transfer.push_back({value, {number(0.0, 50.0), number(0.0, 50.0), number(0.0, 50.0), number(0.0, 10.0)}});
      return s;
    }
    case 5: {
      const double puncture = number(0.01, 50.0);
      return ThreeComponentSettings{number(1e-9, 10.0),
                                    number(0.0, 10.0),
                                    puncture,
                                    number(0.0, puncture),
                                    number(0.01, 100.0),
                                    {number(0.0, 10.0), number(0.0, 1.0), number(0.0, 10.0)},
                                    {number(0.0, 10.0), number(0.0, 1.0), number(0.0, 10.0)},
                                    number(0.01, 100.0),
                                    number(1e-3, 100.0),
                                    number(1e-3, 100.0)};
    }
    case 6:
      return FractureSettings{number(1e-3, 10.0), number(0.1, 10.0),   number(1e-4, 100.0), number(0.05, 5.0),
                              number(0.01, 20.0), number(0.01, 100.0), number(0.0, 100.0),  number(1e-3, 100.0)};
    case 7:
      return ShaftFrictionSettings{number(0.01, 1e3)};
    case 8: {
      const double slipping = number(0.0, 10.0);
      return SurfaceProxySettings{number(0.01, 10.0), number(slipping, 10.0), slipping,
                                  number(0.0, 1.0),   number(0.0, 1.0),       number(1e-3, 100.0)};
    }
    case 9:
      return RegisteredSettings{"somebodys_model", {{"force_N", value_text(number(0.0, 5.0))}, {"mode", "fast"}}, {}};
    default: {
      const DeformableBodySettings body{number(1e-3, 1e3), coin(), coin(), number(1.0, 1000.0)};
      if (coin())
        return EmbeddedNeedleSettings{
            number(0.2, 5.0),
            number(0.5, 5.0),
            number(0.0, 200.0),
            number(0.05, 20.0),
            number(0.001, 1.0),
            150,
            body,
            {coin(), number(1e3, 5e5), coin(), coin() ? NeedleHold::pinned : NeedleHold::clamped, number(0.0, 2.0)}};
      return ClosestNodeSettings{number(0.05, 50.0),
                                 number(0.01, 100.0),
                                 number(0.001, 1.0),
                                 number(0.1, 10.0),
                                 number(1.0, 1000.0),
                                 {number(1.0, 200.0), number(0.0, 200.0), number(10.0, 5000.0)},
                                 body};
    }
  }
}

inline ConstraintSettings wild_constraint(Random& random) {
  const auto number = [&](double low, double high) { return wild_number(random, low, high); };
  switch (random.next() % constraint_names.size()) {
    case 0:
      return LineSpringSettings{number(0.0, 100.0), number(0.0, 1.0), number(1e-9, 100.0)};
    case 1:
      return PivotSettings{number(0.0, 10.0), number(0.0, 10.0), number(1e-3, 100.0), number(1.0, 500.0),
                           number(0.01, 1.0)};
    case 2:
      return RailSettings{number(0.0, 10.0), number(1e-3, 100.0), number(0.0, 1e5), number(1.0, 500.0),
                          number(1e-3, 1e4)};
    case 3:
      return BeamSettings{number(1e3, 5e5), random.uniform() < 0.5, number(0.01, 10.0), number(1e-3, 100.0),
                          number(1.0, 400.0)};
    default:
      return NoConstraint{};
  }
}

inline HapticSettings wild_haptics(Random& random) {
  const auto number = [&](double low, double high) { return wild_number(random, low, high); };
  const auto vector = [&](double bound) {
    return Vec3(number(-bound, bound), number(-bound, bound), number(-bound, bound));
  };
  HapticSettings haptics;
  haptics.rate = number(200.0, 4000.0);
  haptics.resistance = wild_resistance(random);
  haptics.constraint = wild_constraint(random);
  for (int term = 0; term < 4 && random.uniform() < 0.5; ++term)
    haptics.parts.relaxation.push_back({number(0.0, 0.25), number(1e-3, 1e4)});
  if (random.uniform() < 0.3) haptics.parts.shaft_friction = ShaftFrictionSettings{number(0.01, 1e3)};
  if (random.uniform() < 0.3) {
    const double one_way = number(0.0, 10.0);
    haptics.parts.needle_grasp =
        NeedleGraspSettings{one_way, number(0.0, one_way), number(0.1, 10.0), number(0.1, 100.0)};
  }
  if (random.uniform() < 0.3)
    haptics.parts.bevel_tip = BevelTipSettings{number(0.0, 0.1), number(0.0, 10.0), number(1e-3, 100.0)};
  if (random.uniform() < 0.3) {
    CsfFlowSettings& flow = haptics.parts.csf_flow.emplace();
    flow.opening_pressure = number(0.0, 1000.0);
    flow.viscosity = number(1e-10, 1e-8);
    flow.manometer_bore = number(0.5, 10.0);
    flow.manometer = random.uniform() < 0.5;
    flow.stylet = random.uniform() < 0.5;
    flow.pressure_volume_index = number(0.0, 200.0);
    flow.times_faster = number(1.0, 100.0);
  }
  if (random.uniform() < 0.3) {
    FingertipSettings& finger = haptics.parts.fingertip.emplace();
    finger.modulus = number(0.001, 1.0);
    finger.radius = number(2.0, 15.0);
    finger.reach = number(10.0, 100.0);
    finger.limit = number(0.1, 20.0);
  }
  if (random.uniform() < 0.3) {
    SyringeSettings& syringe = haptics.parts.syringe.emplace();
    syringe.filling = random.uniform() < 0.5 ? SyringeFilling::air : SyringeFilling::saline;
    syringe.bore = number(2.0, 40.0);
    syringe.air_volume = number(10.0, 20000.0);
    syringe.saline_compliance = number(0.1, 1e5);
    syringe.viscosity = number(1e-11, 1e-6);
    syringe.friction = number(0.0, 20.0);
    syringe.thumb_force = number(0.0, 50.0);
  }
  haptics.compensation = {(vector(1.0) + Vec3(0.0, 0.0, 1.5)).normalized(), number(0.0, 20.0), vector(0.1),
                          vector(1e4), number(1e-3, 20.0)};
  return haptics;
}

}  // namespace bodkin
