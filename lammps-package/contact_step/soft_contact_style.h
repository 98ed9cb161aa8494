// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_SOFT_CONTACT_STYLE_H
#define COHESION_SOFT_CONTACT_STYLE_H

#include "advice/unlike_walls.h"

namespace LAMMPS_NS {

/// The pair styles and walls with soft contacts, of either scheme, as FixContactStep knows them.
/// They compute their contacts in Pair::compute or Fix::post_force.
class SoftContactStyle {
 public:
  /// Whether friction turns particles of this type.
  virtual bool has_friction(int type) const = 0;
  /// Whether any contact may act in this run.
  virtual bool may_have_contacts() const { return true; }
  /// Whether contacts are those of scheme exact; else they are sampled.
  virtual bool is_exact_scheme() const = 0;
  /// What decides in its contacts which particles stick.
  virtual cohesion::advice::StickingRules sticking_rules() const = 0;
  /// Whether it has contacts with a spring, which act in this run.
  virtual bool has_contacts() const { return true; }
  /// Where a run takes over the forces of the last one: finds what has come into range or out of it
  /// between the two, and adds what the contacts store to the energy tally.
  virtual void continue_run() = 0;
  /// Particles have other IDs than those by which contacts are stored.
  virtual void renumber(const class Renumbering&) {}

 protected:
  ~SoftContactStyle() = default;
};

}  // namespace LAMMPS_NS

#endif
