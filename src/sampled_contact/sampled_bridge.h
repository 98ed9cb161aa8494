// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/adhesion.h"
#include "sampled_contact/sampled_pair.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// Whether a pair that stands at `gap` [length] has its bridge for the step, `bridged`: whether it
/// had one. range [length]: gap of rupture.
inline bool sampled_bridge(double range, double gap, bool bridged) {
  return gap < 0.0 || (bridged && gap < range);
}

/// A liquid bridge (docs/lammps-package/pair_gran_liquidbridge.md) as the scheme to compare with:
/// it forms and breaks at time levels, and pulls for the whole step with the force at the gap of
/// the time level. First order in the step; a touch that begins and ends between two time levels
/// is missed.
///
/// Sphere and sphere, or sphere and plane with the separation from the centre to the foot of the
/// normal.
class SampledBridge : public SampledPair {
 public:
  /// Force and its fall and, as cutoff, the gap of rupture; no tail.
  using Attraction = contact::Adhesion;
  static constexpr bool pushes_at_edge = false;

  SampledBridge(const contact::NormalLaw& repulsion, const contact::Adhesion& bridge,
                double contact_distance)
      : SampledPair(repulsion, contact_distance, bridge.cutoff), pull_(bridge.pull()) {}

  /// Gap at which a pair comes into range, [length].
  double entry_range() const { return 0.0; }

  PairStep advance(const Vector3& separation, const Vector3& velocity, const StepWindow& window,
                   bool inside) const {
    PairStep step;
    const double time = window.length();
    const SampledMotion now = sample(separation, velocity, time, step.record);
    step.inside = sampled_bridge(range(), -now.overlap, inside);
    // The energy of a bridge is zero at touch. The work between the touch and the gap at the
    // beginning of the step enters the balance when the bridge forms or breaks.
    if (step.inside != inside)
      step.record.dissipated +=
          (step.inside ? -1.0 : 1.0) * pull_.work(window.before * now.rate - now.overlap);
    step.force = now.repulsion - attraction(now.overlap, step.inside);
    step.velocity_change = (time * step.force / reduced_mass()) * now.normal;
    return step;
  }

  /// `inside`: whether the pair has its bridge; [force].
  double attraction(double overlap, bool inside) const { return inside ? pull_.at(-overlap) : 0.0; }
  /// Of a pair that has its bridge, zero at touch.
  double adhesion_energy(double overlap) const { return pull_.work(-overlap); }

 private:
  liquid_bridge::Pull pull_;
};

}  // namespace cohesion::sampled_contact
