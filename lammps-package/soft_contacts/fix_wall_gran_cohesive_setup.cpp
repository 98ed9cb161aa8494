// SPDX-License-Identifier: GPL-2.0-only
// The part of FixWallGranCohesive that knows contacts at set-up of a run.
#include "atom.h"
#include "cohesion_laws.h"
#include "fix_wall_gran_cohesive.h"

using namespace LAMMPS_NS;
using namespace cohesion::event_stepping;

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::reset_in_range() {
  const WallState now = state();
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double range = Cohesion::range(scheme, parameters, atom->radius[i], 0.0);
    for (int w = 0; w < static_cast<int>(walls.size()); w++) {
      double* const values = history.of(i, w);
      const WallPoint point = walls[w].nearest(vector(atom->x[i]), now, motion.rim_speed);
      const auto known = ContactMemory::from(values, per_wall);
      const double reach = atom->radius[i] + (known.in_range() ? range : range_at_start(range));
      const bool inside = point.distance > 0.0 && point.distance < reach;
      if (!inside || !known.in_range()) known.moved(inside).to(values, per_wall);
    }
  }
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::continue_run() {
  if (!step->energy_tally.is_active()) return;
  const WallState now = state();
  with_contacts([&](auto& shared, auto size) {
    shared.clear();
    for (int i = 0; i < atom->nlocal; i++)
      for (int w = 0; w < static_cast<int>(walls.size()); w++) {
        double* const values = history.of(i, w);
        if (values[0] <= 0.0 || step->body(i).inverse_mass == 0.0) continue;
        const int c = contact(shared, i);
        const Near near{i, w, c, walls[w].nearest(vector(atom->x[i]), now, motion.rim_speed),
                        values};
        step->energy_tally.store_normal(
            1.0, shared[c].stored(on_grid(near), ContactMemory::from(values, size)));
      }
  });
}

#define COHESION_INSTANTIATE(style, Law)                    \
  template void FixWallGranCohesive<Law>::reset_in_range(); \
  template void FixWallGranCohesive<Law>::continue_run();
COHESION_CONTACT_LAWS(COHESION_INSTANTIATE)
