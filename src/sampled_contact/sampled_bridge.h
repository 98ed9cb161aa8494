// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/adhesion.h"
#include "sampled_contact/sampled_repulsion.h"

namespace cohesion::sampled_contact {

using namespace contact_solver;

/// Whether a pair that stands at `gap` [length] has its bridge for the step, `bridged`: whether it
/// had one. range [length]: gap of rupture.
inline bool sampled_bridge(double range, double gap, bool bridged) {
  return gap < 0.0 || (bridged && gap < range);
}

/// A liquid bridge (docs/lammps-package/pair_gran_liquidbridge.md) as the scheme to compare with:
/// it forms and breaks where the pair is found at a grid point, and pulls for the whole step with
/// the force at its gap there. First order in the step; a touch that begins and ends between two
/// grid points is missed.
///
/// Sphere and sphere, or sphere and plane with the separation from the centre to the foot of the
/// normal.
class SampledBridge {
 public:
  /// Force and its fall and, as cutoff, the gap of rupture; no tail.
  using Attraction = contact::Adhesion;
  static constexpr bool pushes_at_edge = false;

  SampledBridge(const contact::NormalLaw& repulsion, const contact::Adhesion& bridge,
                double contact_distance, double /*step*/)
      : repulsion_(repulsion),
        contact_distance_(contact_distance),
        range_(bridge.cutoff),
        pull_(bridge.pull()) {}

  double range() const { return range_; }
  /// Gap at which a pair comes into range, [length].
  double entry_range() const { return 0.0; }

  bool within_reach(const RelativeState& grid, const StepWindow&) const {
    return norm(grid.separation) <= contact_distance_ + range_;
  }

  PairStep advance(const RelativeState& grid, const StepWindow& window, bool inside) const {
    PairStep step;
    const double distance = norm(grid.separation);
    const Vector3 normal = (1.0 / distance) * grid.separation;
    const double time = window.length();
    const double overlap = contact_distance_ - distance;
    const double rate = -dot(normal, grid.velocity);
    const double repulsion = repulsion_.force(overlap, rate, time, step.normal);
    step.inside = sampled_bridge(range_, -overlap, inside);
    // Its energy is counted from the touch: what it did not do since then, or had done when it
    // broke, from where the step began.
    if (step.inside != inside)
      step.normal.dissipated +=
          (step.inside ? -1.0 : 1.0) * pull_.work(window.before * rate - overlap);
    step.force = repulsion - attraction(overlap, step.inside);
    step.velocity_change = (time * step.force / repulsion_.reduced_mass()) * normal;
    return step;
  }

  /// `inside`: whether the pair has its bridge; [force].
  double attraction(double overlap, bool inside) const { return inside ? pull_.at(-overlap) : 0.0; }
  double spring_energy(double overlap) const { return repulsion_.energy(overlap); }
  /// Of a pair that has its bridge, zero at touch.
  double adhesion_energy(double overlap) const { return pull_.work(-overlap); }

 private:
  SampledRepulsion repulsion_;
  double contact_distance_;
  double range_;
  liquid_bridge::Pull pull_;
};

}  // namespace cohesion::sampled_contact
