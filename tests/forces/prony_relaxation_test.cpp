#include "forces/prony_relaxation.h"

#include <vector>

#include "tests/forces/model_checks.h"

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

const std::vector<PronyTerm> one_term = {{0.5, 0.2}};

struct Spring {  // 0.5 N/mm that relaxes
  PronyRelaxation relaxation{one_term, 1e-3};
  double operator()(const AxialMotion& motion) { return relaxation.step(0.5 * motion.depth); }
};

TEST(PronyRelaxation, a_ramp_gives_the_closed_form_exactly) {
  PronyRelaxation model(one_term, 1e-3);
  double force = 0.0;
  for (int i = 1; i <= 200; ++i) force = model.step(i / 200.0);
  EXPECT_NEAR(force, 0.816060, 5e-7);
}

TEST(PronyRelaxation, a_step_decays_to_what_remains) {
  PronyRelaxation model(one_term, 1e-3);
  EXPECT_NEAR(model.step(1.0), 0.998752, 5e-7);
  double force = 0.0;
  for (int i = 1; i <= 200; ++i) force = model.step(1.0);
  EXPECT_NEAR(force, 0.683481, 5e-7);
  for (int i = 1; i <= 200; ++i) force = model.step(1.0);
  EXPECT_NEAR(force, 0.567499, 5e-7);
  for (int i = 1; i <= 20000; ++i) force = model.step(1.0);
  EXPECT_NEAR(force, model.remaining(), 1e-12);
  // The limit of a sudden step: 1, 0.683940, 0.567668.
  PronyRelaxation fine(one_term, 1e-6);
  EXPECT_NEAR(fine.step(1.0), 1.0, 2e-6);
  for (int i = 1; i <= 200000; ++i) force = fine.step(1.0);
  EXPECT_NEAR(force, 0.683940, 2e-6);
  for (int i = 1; i <= 200000; ++i) force = fine.step(1.0);
  EXPECT_NEAR(force, 0.567668, 2e-6);
}

TEST(PronyRelaxation, the_sum_of_several_terms_is_the_sum_of_each) {
  const std::vector<PronyTerm> terms = {{0.2, 0.05}, {0.3, 0.5}};
  PronyRelaxation both(terms, 1e-3), first(std::vector<PronyTerm>{terms[0]}, 1e-3),
      second(std::vector<PronyTerm>{terms[1]}, 1e-3);
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const double input = random.normal();
    const double sum = first.step(input) + second.step(input) - input;
    EXPECT_NEAR(both.step(input), sum, 1e-12);
  }
}

TEST(PronyRelaxation, does_not_depend_on_dt_for_a_ramp) {
  PronyRelaxation coarse(one_term, 2e-3), fine(one_term, 1e-3);
  double one = 0.0, two = 0.0;
  for (int i = 1; i <= 100; ++i) one = coarse.step(0.01 * i);
  for (int i = 1; i <= 200; ++i) two = fine.step(0.005 * i);
  EXPECT_NEAR(one, two, 1e-12);
}

TEST(PronyRelaxation, has_the_properties_of_every_model) {
  const auto make = [] { return Spring(); };
  checks::finite_on_any_input(make);
  checks::same_bits_on_repetition(make, 40.0);
  checks::no_growth_under_reversal_at_every_tick(make, 12.0);
}

TEST(PronyRelaxation, a_relaxing_spring_returns_less_than_it_took_from_any_path) {
  Random random(3);
  for (int path = 0; path < 200; ++path) {
    Spring spring;
    double work = 0.0, force = 0.0, depth = 0.0;
    for (const double next : checks::random_closed_path(random, 20.0, 50.0)) {
      const double now = spring({next + 2.0, 0.0, 0, false});  // a closed path from zero load
      work += 0.5 * (force + now) * (next + 2.0 - depth);
      depth = next + 2.0;
      force = now;
    }
    ASSERT_GE(work, -1e-9) << path;
  }
}

TEST(PronyRelaxation, refuses_shares_above_one_and_too_many_terms) {
  EXPECT_THROW(PronyRelaxation(std::vector<PronyTerm>{{0.6, 0.1}, {0.6, 1.0}}, 1e-3), InputError);
  EXPECT_THROW(PronyRelaxation(std::vector<PronyTerm>(5), 1e-3), InputError);
  EXPECT_THROW(PronyRelaxation(one_term, 0.0), InputError);
}

}  // namespace
}  // namespace bodkin
