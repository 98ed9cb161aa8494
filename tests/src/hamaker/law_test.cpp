// SPDX-License-Identifier: BSD-3-Clause
#include "hamaker/law.h"

#include <limits>

#include "hamaker/forms.h"
#include "refuses.h"

namespace cohesion::hamaker {
namespace {

const double A = 7.49e-19, H_cut = 4e-10, H_out = 1e-4, r = 0.5e-3, asperity = 2e-8;
const double eps = std::numeric_limits<double>::epsilon();

template <class Law>
struct Subject;
template <class Form>
struct Subject<HamakerLaw<Form>> {
  static HamakerLaw<Form> with(double constant) {
    return HamakerLaw<Form>({constant, H_cut, H_out});
  }
};
template <class Smooth>
struct Subject<HamakerLaw<Rough<Smooth>>> {
  static HamakerLaw<Rough<Smooth>> with(double constant) {
    return HamakerLaw<Rough<Smooth>>({constant, H_cut, H_out, asperity});
  }
};

template <class Chosen>
class EveryHamakerLaw : public testing::Test {
 protected:
  const Chosen law = Subject<Chosen>::with(A);
  const PairGeometry pairs[4] = {two_spheres(r, r), two_spheres(r, 0.2e-3), two_spheres(r, 3.0),
                                 sphere_and_plane(r)};

  /// Integral of the force from `gap` to the outer cut-off by Simpson's rule in ln(H), below the
  /// surface cut-off in H.
  double work(double gap, const PairGeometry& pair) const {
    const auto simpson = [](auto f, double a, double b) {
      const int n = 8000;
      double sum = f(a) + f(b);
      for (int i = 1; i < n; i++) sum += (i % 2 ? 4.0 : 2.0) * f(a + (b - a) * i / n);
      return sum * (b - a) / n / 3.0;
    };
    const auto force = [&](double h) { return law.force(h, pair); };
    double sum = 0.0;
    if (gap < H_cut) sum = simpson(force, gap, H_cut);
    const auto in_log = [&](double s) { return force(std::exp(s)) * std::exp(s); };
    return sum + simpson(in_log, std::log(std::max(gap, H_cut)), std::log(H_out) - 1e-15);
  }
};

using AllLaws = testing::Types<HamakerLaw<SmallGap>, HamakerLaw<Exact>, HamakerLaw<Rough<SmallGap>>,
                               HamakerLaw<Rough<Exact>>>;
TYPED_TEST_SUITE(EveryHamakerLaw, AllLaws);

}  // namespace

TYPED_TEST(EveryHamakerLaw, ForceIsTheSurfaceAdhesionBelowTheSurfaceCutoff) {
  for (const auto& pair : this->pairs) {
    const double adhesion = this->law.adhesion_force(pair);
    EXPECT_GT(adhesion, 0.0);
    for (const double gap : {-1e-6, 0.0, 0.5 * H_cut, H_cut})
      EXPECT_EQ(this->law.force(gap, pair), adhesion);
    // One eps of H moves the force by two; rounding of it.
    EXPECT_NEAR(this->law.force(H_cut * (1.0 + eps), pair) / adhesion, 1.0, 20.0 * eps);
  }
}

TYPED_TEST(EveryHamakerLaw, EnergyIsContinuousAtTheSurfaceCutoff) {
  for (const auto& pair : this->pairs) {
    const double below = this->law.energy(H_cut * (1.0 - eps), pair);
    EXPECT_NEAR(below / this->law.energy(H_cut, pair), 1.0, 40.0 * eps);
  }
}

TYPED_TEST(EveryHamakerLaw, ForceAndEnergyEndAtTheOuterCutoff) {
  for (const auto& pair : this->pairs) {
    const double inside = H_out * (1.0 - 1e-12);
    EXPECT_GT(this->law.force(inside, pair), 0.0);
    EXPECT_EQ(this->law.force(H_out, pair), 0.0);
    EXPECT_EQ(this->law.energy(H_out, pair), 0.0);
    EXPECT_EQ(this->law.energy(1.0, pair), 0.0);
    // Continuous: F(H_out) (H_out - inside), and the rounding of the difference of two energies of
    // at most A R*/(6 H_out).
    EXPECT_NEAR(this->law.energy(inside, pair), 0.0, A * pair.reduced_radius / (6 * H_out) * 2e-12);
  }
}

TYPED_TEST(EveryHamakerLaw, EnergyIsMinusTheWorkOfTheForce) {
  for (const auto& pair : this->pairs)
    for (const double gap : {-1e-8, -1e-10, 0.0, 2e-10, 4e-10, 1e-9, 5e-8, 2e-5})
      // Simpson in 8000 intervals of 0.0016 in ln(H): error 5^4 (0.0016)^4/180 for H^-5, below
      // 1e-12; the rounding of 8000 terms is 1e-13.
      EXPECT_NEAR(this->law.energy(gap, pair) / -this->work(gap, pair), 1.0, 2e-12) << gap;
}

TYPED_TEST(EveryHamakerLaw, ForceIsTheSlopeOfTheEnergy) {
  for (const auto& pair : this->pairs)
    for (const double gap : {-3e-9, 1e-10, 5e-10, 2e-9, 2e-8, 6e-8, 1e-6, 3e-5}) {
      const double h = std::abs(gap) / 1024.0;
      const auto e = [&](int k) { return this->law.energy(gap + k * h, pair); };
      const double slope =
          (45.0 * (e(1) - e(-1)) - 9.0 * (e(2) - e(-2)) + (e(3) - e(-3))) / (60.0 * h);
      // As in exact_test.cpp; E/(F H) is at most H_cut/H = 4 below H_cut, and 1 above.
      EXPECT_NEAR(slope / this->law.force(gap, pair), 1.0, 4.0 * 20.0 * eps * 2.0 * 1024.0) << gap;
    }
}

TYPED_TEST(EveryHamakerLaw, TailIsTheEnergyBetweenTheCutoffs) {
  for (const auto& pair : this->pairs) {
    EXPECT_GT(this->law.tail_energy(pair), 0.0);
    EXPECT_DOUBLE_EQ(this->law.tail_energy(pair), -this->law.energy(H_cut, pair));
  }
}

TYPED_TEST(EveryHamakerLaw, BarrierIsThatOfAPairPulledThroughTheTail) {
  // Moved slowly through the tail, gap by gap, it does work against the attraction and gets that of
  // the load: the most that it is short of on the way is what it has to bring. Trapezoids over gaps
  // d = 6.2e-4 apart in ln(H) err by n (n + 1) d^2/12 < 1.8e-6 of the work, n < 7 the slope of ln
  // F, and the top is up to d/2 beside one of these gaps: n d^2/8 < 4e-7. The work is below F_ad
  // H_cut.
  const int n = 20000;
  const double ratio = std::pow(H_out / H_cut, 1.0 / n);
  for (const auto& pair : this->pairs)
    for (const double start : {1.0, 1.7, 400.0})
      for (const double part :
           {1e-11, 1e-7, 1e-4, 0.01, 0.1, 0.25, 0.5, 0.9, 0.99, 1.0, 1.1, 3.0}) {
        const double load = part * this->law.adhesion_force(pair);
        double work = 0.0, top = 0.0, gap = start * H_cut;
        while (gap < H_out) {
          const double next = std::min(gap * ratio, H_out);
          const double inside = next < H_out ? next : H_out * (1.0 - 1e-15);
          work += 0.5 * (next - gap) *
                  (this->law.force(gap, pair) + this->law.force(inside, pair) - 2.0 * load);
          top = std::max(top, work);
          gap = next;
        }
        EXPECT_NEAR(this->law.barrier(load, start * H_cut, pair), top,
                    2.5e-6 * this->law.tail_energy(pair))
            << part << " " << start;
      }
}

TYPED_TEST(EveryHamakerLaw, BarrierIsTheWholeTailWithoutLoadAndNoneAtTheAdhesionForce) {
  for (const auto& pair : this->pairs) {
    const double adhesion = this->law.adhesion_force(pair);
    EXPECT_DOUBLE_EQ(this->law.barrier(0.0, H_cut, pair), this->law.tail_energy(pair));
    EXPECT_DOUBLE_EQ(this->law.barrier(0.0, -1e-9, pair), this->law.tail_energy(pair));
    EXPECT_EQ(this->law.barrier(adhesion, H_cut, pair), 0.0);
    EXPECT_EQ(this->law.barrier(0.0, H_out, pair), 0.0);
    // Once the load is that of the attraction where the pair is, there is none from there on.
    EXPECT_EQ(this->law.barrier(this->law.force(3.0 * H_cut, pair), 3.0 * H_cut, pair), 0.0);
  }
}

TEST(HamakerBarrier, OfTheFormOfSmallGapsIsInClosedForm) {
  const double out = 1e-7;
  const HamakerLaw<SmallGap> law({A, H_cut, out});
  const PairGeometry pair = two_spheres(r, r);
  const double adhesion = law.adhesion_force(pair), k = H_cut / out;
  // Both branches and where they meet. The difference of two energies rounds to a few eps.
  for (const double f : {0.0, 0.3 * k * k, k * k, 1.001 * k * k, 0.01, 0.5, 0.999, 1.0, 2.0}) {
    const double branch = f < k * k ? 1.0 - k - f * (1.0 / k - 1.0)
                          : f < 1.0 ? (1.0 - std::sqrt(f)) * (1.0 - std::sqrt(f))
                                    : 0.0;
    EXPECT_NEAR(law.barrier(f * adhesion, H_cut, pair) / (adhesion * H_cut), branch, 20.0 * eps)
        << f;
  }
}

TYPED_TEST(EveryHamakerLaw, PlaneIsTheLimitOfALargeSphere) {
  for (const double gap : {0.0, 1e-9, 1e-7, 1e-5})
    for (const double ratio : {1e3, 1e6, 1e9}) {
      const PairGeometry large = two_spheres(r, ratio * r);
      // R* = r/(1 + r/r_j) moves the force by r/r_j of it at small gaps, and twice that at most at
      // larger ones; rounding.
      EXPECT_NEAR(this->law.force(gap, large) / this->law.force(gap, sphere_and_plane(r)), 1.0,
                  2.0 / ratio + 20.0 * eps);
      EXPECT_NEAR(this->law.energy(gap, large) / this->law.energy(gap, sphere_and_plane(r)), 1.0,
                  2.0 / ratio + 40.0 * eps);
    }
}

TYPED_TEST(EveryHamakerLaw, ScalesWithTheHamakerConstantAndVanishesWithoutIt) {
  const auto twice = Subject<TypeParam>::with(2.0 * A), off = Subject<TypeParam>::with(0.0);
  for (const auto& pair : this->pairs) {
    EXPECT_DOUBLE_EQ(twice.force(1e-9, pair), 2.0 * this->law.force(1e-9, pair));
    EXPECT_DOUBLE_EQ(twice.energy(1e-9, pair), 2.0 * this->law.energy(1e-9, pair));
    EXPECT_EQ(off.force(-1e-9, pair), 0.0);
    EXPECT_EQ(off.energy(-1e-9, pair), 0.0);
  }
}

TYPED_TEST(EveryHamakerLaw, RefusesWhatCannotBe) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const auto refused = [](const HamakerParameters& p, const char* part) {
    expect_refused([&] { TypeParam refused_law(p); }, part);
  };
  for (const double bad : {-1e-30, nan, inf}) {
    refused({bad, H_cut, H_out}, "Hamaker constant A");
    refused({A, H_cut, H_out, bad}, "asperity radius");
  }
  for (const double bad : {0.0, -1e-10, nan, inf}) {
    refused({A, bad, H_out}, "surface cut-off H_cut");
    refused({A, H_cut, bad}, "outer cut-off");
  }
  refused({A, 2e-9, 1e-9}, "smaller than the outer cut-off");
  refused({A, 1e-9, 1e-9}, "smaller than the outer cut-off");
}

}  // namespace cohesion::hamaker
