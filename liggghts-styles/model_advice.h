// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_MODEL_ADVICE_H
#define COHESION_MODEL_ADVICE_H

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "advice/contact_report.h"
#include "advice/unlike_walls.h"
#include "advice/warning_filter.h"
#include "common/contact_watch.h"
#include "contact/adhesion.h"
#include "normal_model_probe.h"

namespace LAMMPS_NS {
class LAMMPS;
class FixWallGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// What the time-step check asks of a run of LIGGGHTS. Particles of templates count as there.
struct LiggghtsRun {
  static void scan_particles(LAMMPS_NS::LAMMPS*, cohesion::advice::RunConditions& now);
  static bool may_crowd(LAMMPS_NS::LAMMPS*);
  static double gravity(LAMMPS_NS::LAMMPS*);
};
using LiggghtsWatch = LAMMPS_NS::ContactWatch<LiggghtsRun>;

/// As messages call it.
std::string name_of_wall(const LAMMPS_NS::FixWallGran& wall);

/// What a contact model has to say of a run before it can go wrong: the table of numbers that
/// decide whether the run can be right, warnings, and an error where it must blow up
/// (src/advice/contact_report.h); no table and no warning twice.
class ContactAdvice {
 public:
  /// Sets adhesion and material of a contact of these types, whose radii are known.
  using Adhesion =
      std::function<void(cohesion::advice::AdvisedContact& contact, int itype, int jtype)>;

  /// model: who speaks; wall: null for pairs; adhesion: of two, or of one beside the wall.
  ContactAdvice(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::FixWallGran* wall, const std::string& model,
                const NormalModelProbe& normal, Adhesion adhesion, ContactLaw contact_law);

  /// What there is to say, but for which walls; stands in their place.
  cohesion::advice::Report report(const cohesion::advice::RunConditions& now);
  static constexpr const char* WALLS = "\x01";
  /// What decides which particles stick, in the contacts of those that are there.
  cohesion::advice::StickingRules sticking_rules(const cohesion::advice::RunConditions& now) const;

  /// ID of the fix of the wall; empty for pairs.
  std::string wall() const;
  /// Under scheme exact; else sampled. What the other scheme printed stays stored under its name.
  void set_exact(bool exact) {
    if (exact != exact_) warning_filter_ = std::make_shared<cohesion::advice::WarningFilter>();
    exact_ = exact;
  }
  bool is_exact() const { return exact_; }
  /// The same for a model or wall that the script defines again.
  std::string name() const { return model_ + (exact_ ? " exact " : " sampled ") + wall(); }
  /// Repeats nothing that the one of this name has printed; null: there was none.
  void continue_from(std::shared_ptr<cohesion::advice::WarningFilter>& printed) {
    if (printed) warning_filter_ = printed;
    printed = warning_filter_;
  }

  /// Whether friction, sliding or rolling, may act on a particle of this type.
  bool has_friction(int type) const;

 private:
  std::vector<cohesion::advice::AdvisedContact> contacts(
      const cohesion::advice::RunConditions& now) const;
  void set_springs(cohesion::advice::AdvisedContact& contact, int itype, int jtype,
                   const cohesion::advice::RunNumbers& run) const;
  bool has(const char* kind, const char* model) const;
  double coefficient(const char* name, int itype, int jtype) const;

  LAMMPS_NS::LAMMPS* lmp_;
  LAMMPS_NS::FixWallGran* wall_;
  std::string model_;
  const NormalModelProbe& normal_;
  Adhesion adhesion_;
  ContactLaw contact_law_;
  bool exact_ = false;
  std::shared_ptr<cohesion::advice::WarningFilter> warning_filter_ =
      std::make_shared<cohesion::advice::WarningFilter>();
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
