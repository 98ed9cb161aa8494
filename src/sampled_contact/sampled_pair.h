// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/normal_law.h"
#include "contact_solver/motion_along_normal.h"
#include "contact_solver/step_window.h"
#include "vector3.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// What a sampled force does to a pair in one step.
struct PairStep {
  Vector3 velocity_change{};  ///< of the relative velocity, [length/time]
  double force = 0.0;         ///< along the normal, positive where it repels, [force]
  NormalRecord record{};
  bool inside = false;  ///< in the range of the adhesion at the end of the step
};

/// A pair at a time level, with the force of spring and dashpot there.
struct SampledMotion {
  Vector3 normal;    ///< from the particle to its partner
  double overlap;    ///< [length]
  double rate;       ///< of the overlap, [length/time]
  double repulsion;  ///< [force]
};

/// Repulsion and range of a pair whose forces are sampled once per step; each attraction derives
/// from it.
class SampledPair {
 public:
  /// Gap up to which the pair attracts, [length].
  double range() const { return range_; }

  bool within_reach(double distance) const { return distance <= contact_distance_ + range_; }

  /// Stored in the spring, [energy].
  double spring_energy(double overlap) const {
    return overlap > 0.0 ? contact::point_of(law_, overlap).energy : 0.0;
  }

 protected:
  /// contact_distance [length]: of the centres at touch; range [length]: gap up to which the pair
  /// attracts.
  SampledPair(const contact::NormalLaw& repulsion, double contact_distance, double range)
      : law_(repulsion),
        reduced_mass_(contact::reduced_mass(repulsion)),
        contact_distance_(contact_distance),
        range_(range) {}

  /// `time` [time]: for which the force of this time level acts; `record` receives its work.
  SampledMotion sample(const Vector3& separation, const Vector3& velocity, double time,
                       NormalRecord& record) const {
    const double distance = norm(separation);
    const Vector3 normal = (1.0 / distance) * separation;
    const double overlap = contact_distance_ - distance;
    const double rate = -dot(normal, velocity);
    return {normal, overlap, rate, repulsion(overlap, rate, time, record)};
  }

  double reduced_mass() const { return reduced_mass_; }

 private:
  /// Force of spring and dashpot at `overlap` [length] and its rate, for all of `time`, [force];
  /// positive repels. Sets what it does in `record`.
  double repulsion(double overlap, double rate, double time, NormalRecord& record) const {
    if (!(overlap > 0.0)) return 0.0;
    const contact::LawPoint here = contact::point_of(law_, overlap);
    const double repulsion = here.force + here.damping * rate;
    record.contact_time = time;
    record.repulsion_impulse = time * repulsion;
    record.repulsion_at_end = repulsion;
    record.dissipated = time * here.damping * rate * rate;
    return repulsion;
  }

  contact::NormalLaw law_;
  double reduced_mass_;
  double contact_distance_;
  double range_;
};

}  // namespace cohesion::sampled_contact
