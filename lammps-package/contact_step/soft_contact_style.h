// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_SOFT_CONTACT_STYLE_H
#define COHESION_SOFT_CONTACT_STYLE_H

namespace cohesion::advice {
struct RunConditions;
struct StickingRules;
}  // namespace cohesion::advice

namespace LAMMPS_NS {

class AdviceOfStyles;

/// Interface of FixContactStep to the pair styles and walls with soft contacts of either scheme.
/// These compute their contacts in Pair::compute or Fix::post_force.
class SoftContactStyle {
 public:
  /// Whether friction exerts torques on particles of this type.
  virtual bool has_friction(int type) const = 0;
  /// Whether any contact may act in this run.
  virtual bool may_have_contacts() const { return true; }
  /// Whether the scheme is exact; otherwise it is sampled.
  virtual bool is_exact_scheme() const = 0;
  /// The parameters that decide which particles stick.
  virtual cohesion::advice::StickingRules sticking_rules() const = 0;
  /// Adds the time-step check of its contacts: before the first step of a run, and within it when
  /// step or particles have changed.
  virtual void give_advice(const cohesion::advice::RunConditions&, AdviceOfStyles&) = 0;
  /// Whether its contacts have a spring and act in this run.
  virtual bool has_contacts() const { return true; }
  /// Called when a run continues with the forces of the last one: finds the pairs that have entered
  /// or left the range between the runs, and adds the stored energies to the energy balance.
  virtual void continue_run() = 0;
  /// Called when particles have other IDs than those stored with the contacts.
  virtual void renumber(const class Renumbering&) {}

 protected:
  ~SoftContactStyle() = default;
};

}  // namespace LAMMPS_NS

#endif
