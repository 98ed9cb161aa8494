// SPDX-License-Identifier: BSD-3-Clause
// Friction with Hertz's law: oblique impacts against the equations of motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "contact_solver/exact_contact.h"
#include "contact_solver/mindlin_reference.h"
#include "contact_solver/spheres.h"

namespace cohesion::contact_solver {
namespace {

/// Slow enough that the line of centres turns by 1e-5 only.
constexpr double speed = 1e-5;
constexpr int phases = 8;

/// An elastic impact of two of these balls, at this angle to the line of centres.
struct Oblique {
  double angle, friction;

  double along() const { return speed * std::cos(angle); }
  double across() const { return speed * std::sin(angle); }
  contact::ContactParameters parameters() const {
    contact::ContactParameters p;
    contact::set_hertz(p, 5e6, 0.25);
    p.restitution = 1.0;
    p.tangential_damping_ratio = 0.0;
    p.friction = friction;
    return p;
  }
  hertz_reference::Grains grains() const {
    return {parameters().modulus, 0.5 * thesis::radius, 1.0, thesis::reduced_mass};
  }
  double contact_time() const { return grains().law().contact_time(along()); }
  double turned() const { return across() * contact_time() / (2.0 * thesis::radius); }
  /// The velocity of the surfaces after the impact, over the speed.
  double expected() const {
    const double mass = 2.0 / 7.0 * thesis::reduced_mass;
    return hertz_reference::across_after(grains(), {parameters().tangential_ratio, friction, mass},
                                         along(), across()) /
           speed;
  }
  /// The same by steps of t_c/part.
  double found(double part, double phase, bool short_path) const {
    const double dt = contact_time() / part;
    auto pair = meeting<ContactSolver, ContactHistory::with_friction>(
        parameters(), {}, dt, 2.0 * thesis::radius, along(), across(), (2.0 + phase) * dt);
    pair.recorded = false;
    pair.short_path = short_path;
    pair.steps(static_cast<int>(1.6 * part) + 6);
    EXPECT_TRUE(pair.are_apart());
    const auto& s = pair.spheres;
    return (s[1].v.y - s[0].v.y - thesis::radius * (s[0].spin.z + s[1].spin.z)) / speed;
  }
  /// The largest of some positions of the impact within its step.
  double error(double part) const {
    const double right = expected();
    double worst = 0.0;
    for (int k = 0; k < phases; k++)
      worst = std::max(worst, std::abs(found(part, (k + 0.37) / phases, k % 2) - right));
    return worst;
  }
};

}  // namespace

TEST(MindlinContacts, ErrorsOfObliqueImpactsFallFasterThanTheStep) {
  // The mean stiffness of a step makes the force wrong by dt^2; where contact begins, the stiffness
  // grows as the root of the time, which makes that dt^(3/2). Steps of a quarter have an eighth of
  // the latter error, but a quarter of one of the first order; their geometric mean divides the
  // two. The centrifugal force is left out of the reference: by twice the angle that the pair
  // turns.
  for (const double friction : {0.1, 0.3, 1e6})
    for (const double angle : {0.3, 0.8, 1.2}) {
      const Oblique impact{angle, friction};
      const double parts[] = {20.0, 80.0, 320.0}, left_out = 4.0 * impact.turned();
      double before = 0.0;
      for (const double part : parts) {
        const double error = impact.error(part);
        // (w_t dt)^2/24 of the phase, at most w_t t_c = 7, of the swing that reverses u; the sum of
        // a root is wrong by a twelfth of K_t u dt^(3/2), whose force acts for a quarter of a
        // swing.
        EXPECT_LT(error,
                  7.0 * 7.0 * 7.0 / 24.0 / (part * part) + 1.4 / std::pow(part, 1.5) + left_out)
            << friction << " " << angle << " " << part;
        if (part > parts[0]) {
          EXPECT_LT(error, before / (4.0 * std::sqrt(2.0)) + left_out)
              << friction << " " << angle << " " << part;
        }
        before = error;
      }
    }
}

TEST(MindlinContacts, ImpactsThatSlideHaveCoulombsImpulse) {
  // At tan(angle) above 7 mu_f the surfaces never stick: J = 2 mu_f mu v_n at any step, to the
  // angle that the pair turns.
  for (const double part : {10.0, 20.0, 80.0})
    for (int k = 0; k < phases; k++) {
      const Oblique impact{1.2, 0.3};
      const double left = impact.across() - 7.0 * impact.friction * impact.along();
      EXPECT_NEAR(impact.found(part, (k + 0.37) / phases, k % 2), left / speed,
                  4.0 * impact.turned())
          << part << " " << k;
    }
}

}  // namespace cohesion::contact_solver
