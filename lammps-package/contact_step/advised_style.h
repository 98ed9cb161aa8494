// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_ADVISED_STYLE_H
#define COHESION_ADVISED_STYLE_H

namespace cohesion::advice {
struct AdvisedContact;
struct LightestParticle;
struct RunConditions;
struct StickingRules;
class WarningFilter;
}  // namespace cohesion::advice

namespace LAMMPS_NS {

class AdviceOfStyles;

/// Interface of FixContactStep to the styles whose contacts the time-step check judges: before the
/// first step of a run, and within it when step or particles have changed.
class AdvisedStyle {
 public:
  virtual void give_advice(const cohesion::advice::RunConditions&, AdviceOfStyles&) = 0;

 protected:
  ~AdvisedStyle() = default;
};

}  // namespace LAMMPS_NS

#endif
