// SPDX-License-Identifier: BSD-3-Clause
#include "advice/sampled_escape.h"

#include <gtest/gtest.h>

#include "contact_solver/thesis_contact.h"
#include "refuses.h"

namespace cohesion::advice {
namespace {

constexpr double A = 7.49e-19, cutoff = 4e-10, outer = 1e-7, depth = 5e-11;
constexpr double thesis_step = 2.25e-5;
const auto spring = contact::normal_contact(thesis::contact(), thesis::reduced_mass);
const sampled_contact::SampledHamaker::Attraction hamaker_law{
    hamaker::HamakerLaw<hamaker::SmallGap>({A, cutoff, outer}),
    two_spheres(thesis::radius, thesis::radius)};

SampledEscape hamaker_at(double step) {
  return sampled_escape(spring, hamaker_law, 2.0 * thesis::radius, step);
}
SampledEscape well_at(double step, double of_depth = depth) {
  return sampled_escape(spring, contact::Adhesion{0.0, 1e-5, of_depth}, 2.0 * thesis::radius, step);
}
double exact_hamaker() {
  const auto a = contact::adhesion_of(hamaker::HamakerLaw<hamaker::SmallGap>({A, cutoff, outer}),
                                      two_spheres(thesis::radius, thesis::radius));
  return contact::AdhesiveContact(spring, a).escape_velocity();
}

/// The thesis's scheme written out: force F(x, v) at the grid, kick, drift; v half a step before x.
/// `x` gap, `v` its rate, `out` where a parting pair is free.
template <class Force>
bool written_out_parts(const Force& force, double x, double v, double out, double step) {
  for (bool parting = false;;) {
    v += step * force(x, v) / thesis::reduced_mass;
    if (parting && v <= 0.0) return false;
    parting = v > 0.0;
    if (parting && x >= out) return true;
    x += step * v;
  }
}

double contact_force(double x, double v) { return x < 0.0 ? -800.0 * x - 0.79e-3 * v : 0.0; }

/// Three standard errors of the difference: of the mean at most sampling_error, of that below at
/// most half of most/n, twice the exact velocity over 1200.
const double three_errors = 3.0 * std::hypot(sampling_error, 2.0 / 1200.0);

/// Mean of the share that sticks over speeds up to `most`: n speeds, n positions.
template <class Parts>
double mean_escape(const Parts& parts, double most) {
  constexpr int n = 600;
  int stuck = 0;
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++)
      stuck += !parts(most * (i + 0.5) / n, std::fmod((k + 0.5) / n + 0.7548776662 * i, 1.0));
  return most * stuck / n / n;
}

}  // namespace

TEST(SampledEscape, OfHamakerAsWrittenOut) {
  const auto force = [](double x, double v) {
    if (x >= outer) return 0.0;
    const double gap = std::max(x, cutoff);
    return contact_force(x, v) - A * thesis::radius / 12.0 / gap / gap;
  };
  for (const double step : {thesis_step, thesis::contact_time / 10.0}) {
    const double exact = exact_hamaker();
    const double mean = mean_escape(
        [&](double speed, double position) {
          return written_out_parts(force, outer + speed * step * position, -speed, outer, step);
        },
        2.0 * exact);
    EXPECT_NEAR(hamaker_at(step).mean / exact, mean / exact, three_errors);
  }
}

TEST(SampledEscape, OfAWellAsWrittenOut) {
  const double mu = thesis::reduced_mass;
  for (const double step : {thesis_step, thesis::contact_time / 4.0}) {
    const double exact = escape_velocity_of_depth(spring, depth);
    const double mean = mean_escape(
        [&](double speed, double position) {
          // In the well, free until it touches; out of it with the energy to leave.
          double v = -std::sqrt(speed * speed + 2.0 * depth / mu), x = -v * step * position;
          while (v < 0.0 || x < 0.0) {
            const double before = v;
            v += step * contact_force(x, v) / mu;
            if (before > 0.0 && v <= 0.0) return false;
            x += step * v;
          }
          return 0.5 * mu * v * v > depth;
        },
        2.0 * exact);
    EXPECT_NEAR(well_at(step).mean / exact, mean / exact, three_errors);
  }
}

TEST(SampledEscape, ConvergesToTheExactOne) {
  // Of first order in the position of the contact, whose mean is none: 0.02 at 1e-6 s for one
  // position, a tenth of it at 1e-7 s.
  const double step = 1e-7, exact = exact_hamaker();
  const SampledEscape hamaker = hamaker_at(step);
  EXPECT_NEAR(hamaker.mean / exact, 1.0, 2e-3);
  EXPECT_GT(hamaker.slowest_parted / exact, 1.0 - 2e-3);
  EXPECT_LT(hamaker.fastest_stuck / exact, 1.0 + 2e-3);
  const SampledEscape well = well_at(step);
  EXPECT_NEAR(well.mean / escape_velocity_of_depth(spring, depth), 1.0, 2e-3);
}

TEST(SampledEscape, SpreadsAtTheStepOfTheThesis) {
  // Eight positions spread from 0.29 to 1.67 at this step; more positions spread more.
  const SampledEscape found = hamaker_at(thesis_step);
  EXPECT_LT(found.slowest_parted, 0.29 * exact_hamaker());
  EXPECT_GT(found.fastest_stuck, 1.67 * exact_hamaker());
  EXPECT_GT(found.mean, found.slowest_parted);
  EXPECT_LT(found.mean, found.fastest_stuck);
}

TEST(SampledEscape, OfAWellGoesWithTheRootOfItsDepth) {
  for (const double factor : {0.1, 7.0}) {
    const double ratio =
        well_at(thesis_step, factor * depth).mean / well_at(thesis_step).mean / std::sqrt(factor);
    EXPECT_NEAR(ratio, 1.0, sampling_error);
  }
}

TEST(SampledEscape, OfAWellIsKnownOnlyBeyondTheWayInAStep) {
  const double exact = escape_velocity_of_depth(spring, depth);
  const contact::AdhesiveContact contact(spring, contact::Adhesion{0.0, 1e-6, depth});
  const double way = contact.entry_speed(exact) * thesis_step;
  const auto of_width = [](double width) {
    return sampled_escape(spring, contact::Adhesion{0.0, width, depth}, 2.0 * thesis::radius,
                          thesis_step)
        .mean;
  };
  for (const double part : {0.999, 1.0})
    expect_refused([&] { of_width(part * way); }, "width of the well");
  EXPECT_EQ(of_width(1.001 * way), of_width(2.0 * way));
}

TEST(SampledEscape, RefusesWhatCannotBeSampled) {
  expect_refused([] { hamaker_at(0.0); }, "time step");
  expect_refused([] { hamaker_at(0.6 * thesis::contact_time); }, "time step");
  expect_refused([] { well_at(thesis_step, 0.0); }, "escape velocity");
  expect_refused(
      [] {
        sampled_escape(spring, contact::Adhesion{0.0, 1e-8, depth}, 2.0 * thesis::radius,
                       thesis_step);
      },
      "width of the well");
  // A pair that a step moves by less than a rounding of its place never ends.
  expect_refused([] { hamaker_at(1e-17); }, "time step");
  const contact::LinearSpringDashpot elastic(800.0, 0.0, thesis::reduced_mass);
  expect_refused([&] { sampled_escape(elastic, hamaker_law, 2.0 * thesis::radius, thesis_step); },
                 "restitution e");
}

}  // namespace cohesion::advice
