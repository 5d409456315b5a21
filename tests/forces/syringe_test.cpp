#include "forces/syringe.h"

#include <cmath>
#include <limits>
#include <utility>

#include "tests/forces/default_tissues.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

// Vaughan et al. (2012): 470 to 500 mmHg in the ligament go with 11.1 to 11.8 N on the plunger.
TEST(Syringe, a_plunger_held_at_the_published_pressures_takes_the_published_forces) {
  TissueProperties ligament;
  ligament.id = tissue::ligamentum_flavum;
  ligament.syringe.resistance = 1e6;
  constexpr double mmHg = 1.33322e-4;  // MPa
  for (const auto& [pressure, force] : {std::pair{470.0, 11.1}, std::pair{500.0, 11.8}}) {
    for (const SyringeFilling filling : {SyringeFilling::saline, SyringeFilling::air}) {
      Syringe syringe(TissueLibrary({ligament}), {.filling = filling}, 1e-3);
      while (syringe.state().pressure < pressure * mmHg) syringe.step(0.01, ligament.id);
      EXPECT_NEAR(syringe.step(0.0, ligament.id).force, force, 0.05) << pressure << " mmHg";
      EXPECT_GT(syringe.step(2.0, ligament.id).force, force + 0.2) << "a plunger that slides rubs";
    }
  }
}

TEST(Syringe, a_16_gauge_needle_empties_2_millilitres_of_air_exponentially) {
  const double resistance = tube_resistance(1e-9, 80.0, 1.194), compliance = 2000.0 / 0.1013;
  EXPECT_NEAR(resistance, 1.60374e-6, 5e-12);
  EXPECT_NEAR(Syringe(checks::default_tissues(), {}, 1e-3).needle_resistance(), resistance, 1e-18);
  EXPECT_NEAR(compliance, 19743.0, 0.5);
  const double time = resistance * compliance;
  EXPECT_NEAR(time, 0.03166, 5e-6);
  for (const int ticks : {1, 10, 1000}) {
    double pressure = 0.0627;
    for (int i = 0; i < ticks; ++i)
      pressure = Syringe::relax(pressure, 0.0, 0.0, compliance, resistance, 3.0 * time / ticks);
    EXPECT_NEAR(pressure * 11.1 / 0.0627, 0.5526, 5e-5);
  }
}

TEST(Syringe, ligament_holds_the_pressure_and_the_epidural_space_lets_it_go) {
  for (const SyringeFilling filling : {SyringeFilling::saline, SyringeFilling::air}) {
    Syringe syringe(checks::default_tissues(), {.filling = filling}, 1e-3);
    double force = 0.0;
    int ticks = 0;
    while (force < 11.0 && ticks < 20000) {
      force = syringe.step(2.0, tissue::ligamentum_flavum).force;
      ++ticks;
    }
    EXPECT_GE(force, 11.0);
    EXPECT_LT(syringe.state().flow, 0.01);
    for (int i = 0; i < 2000; ++i) syringe.step(0.0, tissue::epidural_fat);
    EXPECT_LT(syringe.state().force, 0.2);
    EXPECT_NEAR(syringe.state().pressure, 6e-4, 1e-4);  // that of the epidural space
  }
}

TEST(Syringe, air_is_springier_than_saline) {
  Syringe air(checks::default_tissues(), {.filling = SyringeFilling::air}, 1e-3),
      saline(checks::default_tissues(), {}, 1e-3);
  for (int i = 0; i < 50; ++i) {
    air.step(2.0, tissue::ligamentum_flavum);
    saline.step(2.0, tissue::ligamentum_flavum);
  }
  EXPECT_GT(saline.state().pressure, 20.0 * air.state().pressure);
}

TEST(Syringe, air_grows_stiffer_as_it_is_pressed) {
  const TissueLibrary& library = checks::default_tissues();
  const SyringeTissue& here = library.find(tissue::muscle)->syringe;
  const SyringeSettings settings{.filling = SyringeFilling::air};
  Syringe syringe(library, settings, 1e-3);
  double pressed = 0.0;
  for (int tick = 0; tick < 300; ++tick) pressed = syringe.step(20.0, tissue::muscle).pressure;
  ASSERT_GT(pressed, 0.01);
  const double compliance = settings.air_volume / (0.1013 + pressed);
  const double time = (syringe.needle_resistance() + here.resistance) * compliance;
  EXPECT_NEAR(syringe.step(0.0, tissue::muscle).pressure,
              here.pressure + (pressed - here.pressure) * std::exp(-1e-3 / time), 1e-9 * pressed);
}

TEST(Syringe, the_seal_drags_with_its_friction_at_any_speed_above_a_millimetre_per_second) {
  const SyringeSettings settings;
  for (const auto& [speed, share] :
       {std::pair(0.5, 0.5), std::pair(1.0, 1.0), std::pair(30.0, 1.0), std::pair(-8.0, -1.0)}) {
    Syringe syringe(checks::default_tissues(), settings, 1e-3);
    const SyringeState state = syringe.step(speed, tissue::muscle);
    EXPECT_NEAR(state.force - syringe.area() * state.pressure, share * settings.friction, 1e-9) << speed;
  }
}

TEST(Syringe, conserves_volume) {
  const SyringeSettings settings = {.saline_compliance = 500.0};
  Syringe syringe(checks::default_tissues(), settings, 1e-4);
  double out = 0.0, in = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double before = syringe.state().flow;
    in += syringe.area() * 0.5 * 1e-4;
    syringe.step(0.5, tissue::fat);
    out += 0.5 * (before + syringe.state().flow) * 1e-4;
  }
  EXPECT_NEAR(in, out + 500.0 * syringe.state().pressure, 1e-3 * in);
}

TEST(Syringe, is_finite_and_repeats_for_any_input) {
  Syringe one(checks::default_tissues(), {.filling = SyringeFilling::air}, 1e-3),
      two(checks::default_tissues(), {.filling = SyringeFilling::air}, 1e-3);
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const double speed : {1e308, -1e308, inf, -inf, std::nan(""), 1e4, -1e4, 3.0}) {
    for (const TissueId id : {tissue::air, tissue::ligamentum_flavum, tissue::epidural_fat}) {
      const SyringeState& state = one.step(speed, id);
      EXPECT_TRUE(std::isfinite(state.pressure) && std::isfinite(state.flow) && std::isfinite(state.force));
      EXPECT_EQ(state.force, two.step(speed, id).force);
    }
  }
}

TEST(Syringe, refuses_settings_outside_their_ranges) {
  EXPECT_THROW(Syringe(checks::default_tissues(), {.bore = 0.0}, 1e-3), InputError);
  EXPECT_THROW(Syringe(checks::default_tissues(), {.needle_bore = 0.09}, 1e-3), InputError);
  EXPECT_THROW(Syringe(checks::default_tissues(), {.needle_length = 9.0}, 1e-3), InputError);
  EXPECT_THROW(Syringe(checks::default_tissues(), {}, -1.0), InputError);
}

}  // namespace
}  // namespace bodkin
