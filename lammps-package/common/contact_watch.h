// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_CONTACT_WATCH_H
#define COHESION_CONTACT_WATCH_H

#include <mpi.h>

#include <cstring>
#include <vector>

#include "advice/change_detector.h"
#include "common/box_shear.h"
#include "common/several_neighbours.h"
#include "domain.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {

using cohesion::advice::LightestParticle;
using cohesion::advice::RunConditions;

/// Reduces what each rank has found of its particles to that of all.
inline void reduce_particles(const LAMMPS* lmp, const std::vector<LightestParticle>& mine,
                             double fastest, RunConditions& now) {
  static_assert(sizeof(LightestParticle) == 2 * sizeof(double), "two numbers of each type");
  now.lightest.resize(mine.size());
  MPI_Allreduce(mine.data(), now.lightest.data(), 2 * static_cast<int>(mine.size()), MPI_DOUBLE,
                MPI_MIN, lmp->world);
  MPI_Allreduce(&fastest, &now.run.fastest, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
}

/// Sees when contacts have to be judged: in each set-up of a run, and within one, whether it was
/// set up or not, where the step became longer, or where the list of neighbours is new or fix adapt
/// has acted, and lighter or faster particles are there.
///
/// `Engine`: what the engine knows of a run, with the static functions scan_particles(LAMMPS*,
/// RunConditions&) for the lightest particles of each type, those that fixes will bring among them,
/// and the speed of the fastest; may_crowd(LAMMPS*), whether a particle of this rank may have
/// several contacts; and gravity(LAMMPS*), the largest of all ranks, [length/time^2].
template <class Engine>
class ContactWatch {
 public:
  explicit ContactWatch(LAMMPS* lmp) : lmp_(lmp), now_() {}

  /// Whether they have to be judged now, by now(), which is of all ranks. To be called in each
  /// step, on all ranks, when the list of neighbours is that of the step.
  bool due(bool setup) {
    const double dt = lmp_->update->dt;
    if (setup)
      changes_.set_up(adapted_every());
    else if (!changes_.may_differ(lmp_->neighbor->ago == 0,
                                  static_cast<long>(lmp_->update->ntimestep), dt))
      return false;
    Engine::scan_particles(lmp_, now_);
    now_.run.dt = dt;
    now_.run.plane = lmp_->domain->dimension == 2;
    if (setup || now_.run.crowd != cohesion::advice::Crowd::several)
      now_.run.crowd = crowd_of_all(lmp_, Engine::may_crowd(lmp_));
    if (!setup && !changes_.worse(now_.lightest, now_.run)) return false;
    changes_.judged(now_.lightest, now_.run);
    now_.run.gravity = Engine::gravity(lmp_);
    now_.run.shear = rate_of_shear(lmp_->domain).amount;
    now_.within_run = !setup;
    return true;
  }
  const RunConditions& now() const { return now_; }
  /// What they are judged by besides has changed.
  void forget() { changes_.forget(); }

 private:
  /// In how many steps each fix that changes particles does so.
  std::vector<int> adapted_every() const {
    std::vector<int> steps;
    for (int k = 0; k < lmp_->modify->nfix; k++) {
      const Fix* const fix = lmp_->modify->fix[k];
      if (std::strncmp(fix->style, "adapt", 5) == 0 && fix->nevery > 0)
        steps.push_back(fix->nevery);
    }
    return steps;
  }

  LAMMPS* lmp_;
  RunConditions now_;
  cohesion::advice::ChangeDetector changes_;
};

}  // namespace LAMMPS_NS

#endif
