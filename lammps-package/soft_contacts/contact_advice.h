// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_ADVICE_H
#define COHESION_CONTACT_ADVICE_H

#include <string>
#include <vector>

#include "advice/contact_report.h"
#include "advice/warning_filter.h"
#include "common/contact_watch.h"
#include "contact/contact_parameters.h"
#include "pointers.h"

namespace LAMMPS_NS {

using cohesion::advice::AdvisedContact;

/// What styles report of their contacts before the first step of a run, in the order of the styles.
/// Fixes of one style that report the same report it once, with their IDs.
class AdviceOfStyles {
 public:
  /// `report` without the name of the style in front. `fix_id`: empty for a pair style.
  void add(const std::string& style, const std::string& fix_id,
           const cohesion::advice::Report& report);
  /// Prints tables and warnings; stops LAMMPS behind those of the first style whose run must not
  /// begin.
  void print(LAMMPS*) const;

 private:
  struct StyleReport {
    std::string style, ids;
    bool several;
    cohesion::advice::Report report;

    std::string name() const;
  };

  std::vector<StyleReport> reports_;
};

/// What the time-step check asks of a run of LAMMPS.
struct LammpsRun {
  static void scan_particles(LAMMPS*, RunConditions& now);
  static bool may_crowd(LAMMPS*);
  static double gravity(LAMMPS*);
};
using LammpsWatch = ContactWatch<LammpsRun>;

/// `now` as far as the particles of a group go, of which some may be still to come. All ranks call
/// it.
RunConditions of_group(LAMMPS*, const RunConditions& now, int groupbit);

/// A contact between these two; without springs when neither moves.
AdvisedContact advised_contact(const std::string& name, const LightestParticle& i,
                               const LightestParticle& j,
                               const cohesion::contact::ContactParameters&,
                               const cohesion::contact::Adhesion&);

/// The table of numbers that decide whether the run can be right, a warning where one says that it
/// will not be, and why it must not begin where one says that it must blow up
/// (advice/contact_report.h); of what `advice_filter` holds only what is new. Without the name of
/// the style in front, which is `where` in errors.
cohesion::advice::Report advice_of_contacts(LAMMPS*, const std::string& where,
                                            const cohesion::advice::SchemeLimits&,
                                            const std::vector<AdvisedContact>&,
                                            const RunConditions&,
                                            cohesion::advice::WarningFilter& advice_filter);

/// The same of an attraction alone, laid over the contacts of another style. `remedy`: what else
/// than a smaller step helps.
cohesion::advice::Report advice_of_attraction(LAMMPS*, const std::string& where,
                                              std::string_view remedy,
                                              const std::vector<AdvisedContact>&,
                                              const RunConditions&,
                                              cohesion::advice::WarningFilter& advice_filter);

}  // namespace LAMMPS_NS

#endif
