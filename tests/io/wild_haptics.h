#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "anatomy/case.h"
#include "core/error.h"
#include "core/random.h"
#include "core/settings_check.h"

namespace bodkin {

using namespace bodkin::anatomy;

// --- equality to the bit -----------------------------------------------------------------------------------------

// Converts to a member of any type, and counts how many a struct takes.
struct AnyMember {
  template <typename T>
  operator T() const;
};
template <typename S, std::size_t... I>
constexpr bool takes_members(std::index_sequence<I...> /*of*/) {
  return requires {
    S{(static_cast<void>(I), AnyMember())...};
  };
}
template <typename S, std::size_t count = 0>
constexpr std::size_t member_count() {
  if constexpr (takes_members<S>(std::make_index_sequence<count + 1>()))
    return member_count<S, count + 1>();
  else
    return count;
}

// Every member of the settings, whether or not their table of parameters knows it.
template <typename S>
auto members(const S& s) {
  constexpr std::size_t count = member_count<S>();
  static_assert(count <= 12, "add the next count here");
  if constexpr (count == 0) {
    return std::tuple<>();
  } else if constexpr (count == 1) {
    const auto& [a] = s;
    return std::tie(a);
  } else if constexpr (count == 2) {
    const auto& [a, b] = s;
    return std::tie(a, b);
  } else if constexpr (count == 3) {
    const auto& [a, b, c] = s;
    return std::tie(a, b, c);
  } else if constexpr (count == 4) {
    const auto& [a, b, c, d] = s;
    return std::tie(a, b, c, d);
  } else if constexpr (count == 5) {
    const auto& [a, b, c, d, e] = s;
    return std::tie(a, b, c, d, e);
  } else if constexpr (count == 6) {
    const auto& [a, b, c, d, e, f] = s;
    return std::tie(a, b, c, d, e, f);
  } else if constexpr (count == 7) {
    const auto& [a, b, c, d, e, f, g] = s;
    return std::tie(a, b, c, d, e, f, g);
  } else if constexpr (count == 8) {
    const auto& [a, b, c, d, e, f, g, h] = s;
    return std::tie(a, b, c, d, e, f, g, h);
  } else if constexpr (count == 9) {
    const auto& [a, b, c, d, e, f, g, h, i] = s;
    return std::tie(a, b, c, d, e, f, g, h, i);
  } else if constexpr (count == 10) {
    const auto& [a, b, c, d, e, f, g, h, i, j] = s;
    return std::tie(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (count == 11) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k] = s;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k);
  } else if constexpr (count == 12) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = s;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
  }
}
inline auto members(const RegisteredSettings& s) {
  const auto& [a, b, c] = s;
  return std::tie(a, b, c);
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

// Values that the tables of parameters allow; texts and lists stay as they are.
template <typename Settings>
Settings wild(Random& random) {
  Settings settings;
  const auto fill = [&random](auto& self, auto& owner) -> void {
    for_each_entry(
        [&](const auto& entry, auto& value) {
          using Entry = std::remove_cvref_t<decltype(entry)>;
          using Value = std::remove_cvref_t<decltype(value)>;
          if constexpr (std::same_as<Value, bool>) {
            value = random.uniform() < 0.5;
          } else if constexpr (NamedEnumeration<Value>) {
            value = static_cast<Value>(random.next() % enumeration_names(value).size());
          } else if constexpr (std::floating_point<Value>) {
            value = wild_number(random, entry.range.includes_low ? entry.range.low : entry.range.low + 1e-9,
                                std::min(entry.range.high, 1e9));
          } else if constexpr (parameter_detail::is_optional<Value>) {
            if (random.uniform() < 0.3) value = wild<typename Value::value_type>(random);
          } else if constexpr (!parameter_detail::is_list<Entry> && Parameterized<Value>) {
            self(self, value);
          }
        },
        owner);
  };
  while (true) {
    fill(fill, settings);
    try {
      check(settings, "wild");
      return settings;
    } catch (const InputError&) {  // two of them do not go together
    }
  }
}

// One of the models.
template <typename Models>
Models wild_model(Random& random) {
  Models chosen;
  const std::size_t wanted = random.next() % std::variant_size_v<Models>;
  [&]<std::size_t... index>(std::index_sequence<index...>) {
    ((wanted == index ? chosen = wild<std::variant_alternative_t<index, Models>>(random) : chosen), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Models>>());
  return chosen;
}

inline ResistanceSettings wild_resistance(Random& random) {
  const auto number = [&](double low, double high) { return wild_number(random, low, high); };
  const auto one_more = [&] { return random.uniform() < 0.5; };
  auto chosen = wild_model<ResistanceSettings>(random);
  if (auto* wall = std::get_if<TrackingWallSettings>(&chosen)) {
    for (double from = 0.0; from < 1e3 && one_more(); from += number(1e-9, 100.0))
      wall->layers.push_back({from, wild<TrackingWallTissue>(random)});
  } else if (auto* proxy = std::get_if<VolumeProxySettings>(&chosen)) {
    for (double value = number(-100.0, 0.0); value < 100.0 && one_more(); value += number(1e-9, 10.0))
      proxy->transfer.push_back({value, wild<ProxyProperties>(random)});
  } else if (auto* registered = std::get_if<RegisteredSettings>(&chosen)) {
    *registered = {"somebodys_model", {{"force_N", value_text(number(0.0, 5.0))}, {"mode", "fast"}}, {}};
  }
  return chosen;
}

inline HapticSettings wild_haptics(Random& random) {
  const auto number = [&](double low, double high) { return wild_number(random, low, high); };
  const auto vector = [&](double bound) {
    return Vec3(number(-bound, bound), number(-bound, bound), number(-bound, bound));
  };
  HapticSettings haptics;
  haptics.rate = number(200.0, 4000.0);
  haptics.resistance = wild_resistance(random);
  haptics.constraint = wild_model<ConstraintSettings>(random);
  haptics.parts = wild<ForceParts>(random);
  for (int term = 0; term < 4 && random.uniform() < 0.5; ++term)
    haptics.parts.relaxation.push_back({number(0.0, 0.25), number(1e-3, 1e4)});
  haptics.compensation = {(vector(1.0) + Vec3(0.0, 0.0, 1.5)).normalized(), number(0.0, 20.0), vector(0.1),
                          vector(1e4), number(1e-3, 20.0)};
  return haptics;
}

}  // namespace bodkin
