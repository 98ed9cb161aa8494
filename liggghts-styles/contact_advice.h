// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_CONTACT_ADVICE_H
#define COHESION_CONTACT_ADVICE_H

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "advice/contact_report.h"
#include "contact/adhesion.h"
#include "normal_model_probe.h"

namespace LAMMPS_NS {
class LAMMPS;
class FixWallGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// The smallest and lightest particle of each type, counted from 1, over all ranks; of those in
/// particle templates as well.
std::vector<cohesion::advice::LightestParticle> lightest_particles(LAMMPS_NS::LAMMPS* lmp);

/// What a contact model has to say before the first step of a run: the table of numbers that decide
/// whether the run can be right, warnings, and an error where it must blow up
/// (src/advice/contact_report.h).
class ContactAdvice {
 public:
  /// Sets adhesion and material of a contact of these types, whose radii are known.
  using Adhesion =
      std::function<void(cohesion::advice::AdvisedContact& contact, int itype, int jtype)>;

  /// model: who speaks; wall: null for pairs; adhesion: of two, or of one beside the wall.
  ContactAdvice(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::FixWallGran* wall, const std::string& model,
                const NormalModelProbe& normal, Adhesion adhesion);

  void give() const;

 private:
  std::vector<cohesion::advice::AdvisedContact> contacts(
      const cohesion::advice::RunNumbers& run) const;
  void set_springs(cohesion::advice::AdvisedContact& contact, int itype, int jtype,
                   const cohesion::advice::RunNumbers& run) const;
  bool holds(const char* kind, const char* model, const char* coefficient, int itype,
             int jtype) const;

  LAMMPS_NS::LAMMPS* lmp_;
  LAMMPS_NS::FixWallGran* wall_;
  std::string model_;
  const NormalModelProbe& normal_;
  Adhesion adhesion_;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
