// SPDX-License-Identifier: GPL-2.0-only
#include "soft_contacts/contact_advice.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "common/several_neighbours.h"
#include "contact/contact_parameters.h"
#include "domain.h"
#include "engine/announced_particles.h"
#include "engine/gravity.h"
#include "engine/mobile_particles.h"
#include "error.h"
#include "fix.h"
#include "input/law_from_script.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

using namespace LAMMPS_NS;
namespace advice = cohesion::advice;

namespace {

constexpr int ALL = 1, ANY_GROUP = ~0;  // bits of masks

/// What the fixes gravity of these groups put on a particle together, [length/time^2].
double gravity_of_fixes(const Modify* modify, int mask) {
  double sum[3] = {0.0, 0.0, 0.0};
  for (int k = 0; k < modify->nfix; k++) {
    Fix* const fix = modify->fix[k];
    int dimension = 0;
    if (!utils::strmatch(fix->style, "^gravity") || !(fix->groupbit & mask)) continue;
    if (const auto* of_fix = static_cast<double*>(fix->extract("gvec", dimension)))
      for (int d = 0; d < 3; d++) sum[d] += of_fix[d];
  }
  return std::hypot(sum[0], sum[1], sum[2]);
}

/// The largest acceleration that the fixes of the step put on a particle of the group, or will on
/// one that is announced; where there is none yet, that of all fixes together.
double gravity_of_group(LAMMPS* lmp, int groupbit) {
  const Atom* const atom = lmp->atom;
  double g = atom->natoms == 0 ? gravity_of_fixes(lmp->modify, ANY_GROUP) : 0.0;
  const std::vector<double> weight = weights(lmp);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double* const w = &weight[3 * i];
    const double mass = atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
    g = std::max(g, std::hypot(w[0], w[1], w[2]) / mass);
  }
  for (const AnnouncedParticle& p : announced_particles(lmp))
    if (p.mask & groupbit) g = std::max(g, gravity_of_fixes(lmp->modify, p.mask));
  double all = 0.0;
  MPI_Allreduce(&g, &all, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  return all;
}

/// The lightest particles of the group, those that fixes have announced among them, and the
/// fastest.
void scan_group(LAMMPS* lmp, int groupbit, RunConditions& now) {
  const Atom* const atom = lmp->atom;
  const double none = std::numeric_limits<double>::infinity();
  std::vector<LightestParticle> mine(atom->ntypes + 1, {none, none});
  MobileParticles mobile;
  mobile.look_up(lmp);
  const auto take = [&](int type, int mask, double radius, double mass) {
    if (!(mask & groupbit)) return;
    LightestParticle& lightest = mine[type];
    lightest.radius = std::min(lightest.radius, radius);
    if (mobile.inverse_mass(mask, mass) > 0.0) lightest.mass = std::min(lightest.mass, mass);
  };
  for (const AnnouncedParticle& p : announced_particles(lmp))
    if (p.type <= atom->ntypes) take(p.type, p.mask, p.radius, p.mass);
  const cohesion::shear::BoxShear flow = rate_of_shear(lmp->domain);
  double fastest = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const int type = atom->type[i];
    const double* const v = atom->v[i];
    fastest = std::max(fastest, std::hypot(flow.nonaffine(v[0], atom->x[i][1]), v[1], v[2]));
    take(type, atom->mask[i], atom->radius[i], atom->rmass ? atom->rmass[i] : atom->mass[type]);
  }
  reduce_particles(lmp, mine, fastest, now);
}

}  // namespace

RunConditions LAMMPS_NS::of_group(LAMMPS* lmp, const RunConditions& now, int groupbit) {
  RunConditions of_group = now;
  if (groupbit == ALL) return of_group;
  scan_group(lmp, groupbit, of_group);
  of_group.run.gravity = gravity_of_group(lmp, groupbit);
  return of_group;
}

void LammpsRun::scan_particles(LAMMPS* lmp, RunConditions& now) { scan_group(lmp, ALL, now); }

bool LammpsRun::may_crowd(LAMMPS* lmp) {
  bool several = !announced_particles(lmp).empty();
  for (int k = 0; k < lmp->neighbor->nlist && !several; k++) {
    const NeighList* const list = lmp->neighbor->lists[k];
    several = list->requestor_type == NeighList::PAIR && !list->occasional &&
              has_several_neighbours(lmp, list);
  }
  return several;
}

double LammpsRun::gravity(LAMMPS* lmp) { return gravity_of_group(lmp, ALL); }

AdvisedContact LAMMPS_NS::advised_contact(const std::string& name, const LightestParticle& i,
                                          const LightestParticle& j,
                                          const cohesion::contact::ContactParameters& contact,
                                          const cohesion::contact::Adhesion& adhesion) {
  AdvisedContact c{name, i, j, {}, adhesion};
  if (!c.moves()) return c;
  c.springs = advice::springs_of(contact, c.reduced_radius(), c.reduced_mass());
  return c;
}

std::string AdviceOfStyles::StyleReport::name() const {
  if (ids.empty()) return style;
  return (several ? "fixes " : "fix ") + ids + " " + style;
}

static bool same(const advice::Report& a, const advice::Report& b) {
  const auto texts = [](const advice::Warning& x, const advice::Warning& y) {
    return x.text == y.text;
  };
  return a.table == b.table && a.stop == b.stop &&
         std::equal(a.warnings.begin(), a.warnings.end(), b.warnings.begin(), b.warnings.end(),
                    texts);
}

void AdviceOfStyles::add(const std::string& style, const std::string& fix_id,
                         const advice::Report& report) {
  for (StyleReport& entry : reports_)
    if (!fix_id.empty() && entry.style == style && same(entry.report, report)) {
      entry.ids += ", " + fix_id;
      entry.several = true;
      return;
    }
  reports_.push_back({style, fix_id, false, report});
}

void AdviceOfStyles::print(LAMMPS* lmp) const {
  for (const StyleReport& entry : reports_) {
    const advice::Report& report = entry.report;
    if (lmp->comm->me == 0) {
      if (!report.table.empty()) utils::logmesg(lmp, entry.name() + report.table);
      for (const advice::Warning& warning : report.warnings)
        lmp->error->warning(FLERR, entry.name() + warning.text);
    }
    if (!report.stop.empty()) lmp->error->all(FLERR, entry.name() + report.stop);
  }
}

advice::Report LAMMPS_NS::advice_of_contacts(LAMMPS* lmp, const std::string& where,
                                             const advice::SchemeLimits& limits,
                                             const std::vector<AdvisedContact>& contacts,
                                             const RunConditions& now,
                                             advice::WarningFilter& advice_filter) {
  return from_script(lmp, where, [&] {
    return advice_filter.only_new(advice::report("", limits, contacts, now.run), contacts, now);
  });
}

advice::Report LAMMPS_NS::advice_of_attraction(LAMMPS* lmp, const std::string& where,
                                               std::string_view remedy,
                                               const std::vector<AdvisedContact>& contacts,
                                               const RunConditions& now,
                                               advice::WarningFilter& advice_filter) {
  advice::SchemeLimits limits = advice::sampled_scheme;
  limits.remedy = remedy;
  return from_script(lmp, where, [&] {
    return advice_filter.only_new(advice::attraction_report("", limits, contacts, now.run),
                                  contacts, now);
  });
}
