// SPDX-License-Identifier: GPL-2.0-only
// The part of FixWallGranCohesive for the set-up of a run, and for restart files.
#include <algorithm>
#include <cmath>
#include <limits>

#include "atom.h"
#include "comm.h"
#include "contact_solver/contact_output.h"
#include "contact_step/altered_particles.h"
#include "error.h"
#include "input/restart_format.h"
#include "input/wall_course_in_restart.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/fix_wall_gran_cohesive.h"

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;

static constexpr double infinite = std::numeric_limits<double>::infinity();

/// Decides by their distance whether particles are in range that have no history, or whose gap to
/// the wall a script has changed.
template <class Cohesion>
template <class Contact>
void FixWallGranCohesive<Cohesion>::find_in_range(std::vector<Contact>& shared,
                                                  const WallState& now) {
  shared.clear();
  std::vector<WallPoint> points_before(faces());
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const AlteredParticles& altered = contact_step->altered_particles();
    const Vector3 centre = vector(atom->x[i]), before = centre - altered.displacement(i);
    find_points(centre, now, infinite, points);
    find_points(before, now, infinite, points_before);
    for (int face = 0; face < faces(); face++) {
      double* const values = history.of(i, face);
      const double distance = points[face].distance;
      const bool is_altered =
          altered.is_resized(i) || (distance != points_before[face].distance &&
                                    altered.is_displaced(distance - points_before[face].distance));
      if (contact_step->body(i).inverse_mass == 0.0) {
        if (is_altered) values[0] = WallHistory::NOT_KNOWN;
        continue;
      }
      if (is_altered && values[0] == WallHistory::BEHIND) values[0] = WallHistory::NOT_KNOWN;
      const bool is_new = values[0] == WallHistory::NOT_KNOWN;
      if (!is_new && !is_altered) continue;
      const Contact& c = contact(shared, i);
      const double clear = atom->radius[i] + c.range();
      if (is_new && WallHistory::keep_behind(values[0], distance, clear)) continue;
      const auto known = is_new ? ContactHistory() : ContactHistory::stored(values, per_wall);
      const bool was_inside = known.normal.in_range();
      const bool inside =
          distance > 0.0 && (was_inside ? distance < clear : c.is_in_range(distance));
      known.moved(inside).store(values, per_wall);
    }
  }
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::continue_run() {
  const WallState now = state();
  with_contacts([&](auto& shared, auto size) {
    find_in_range(shared, now);
    if (!contact_step->energy_tally.is_active()) return;
    for_each_with_history<size>(now, [&](int i, const Vector3& separation,
                                         const ContactHistory& known) {
      contact_step->energy_tally.store_normal(1.0, contact(shared, i).stored(separation, known));
    });
  });
}

/// As PairGranCohesive::repeat_forces().
template <class Cohesion>
void FixWallGranCohesive<Cohesion>::repeat_forces() {
  const WallState now = state();
  with_contacts([&](auto& shared, auto size) {
    for_each_with_history<size>(now, [&](int i, const Vector3& separation,
                                         const ContactHistory& known) {
      contact_step->repeat_forces(
          i, -1, forces_of(contact(shared, i), separation, known, contact_step->forces_length()));
    });
  });
}

/// Calls what(i, separation, history) for each particle with a history of a wall.
template <class Cohesion>
template <int SIZE, class What>
void FixWallGranCohesive<Cohesion>::for_each_with_history(const WallState& now, const What& what) {
  for (int i = 0; i < atom->nlocal; i++) {
    if (contact_step->body(i).inverse_mass == 0.0) continue;
    find_points(vector(atom->x[i]), now, infinite, points);
    for (int face = 0; face < faces(); face++) {
      double* const values = history.of(i, face);
      if (values[0] <= 0.0 || !std::isfinite(points[face].distance)) continue;
      what(i, points[face].separation, ContactHistory::stored(values, SIZE));
    }
  }
}

/* ---------------------------------------------------------------------- */

// Numbers of a restart file: its layout; how many walls, numbers of history for each face, regions
// and faces; the fingerprints of the regions; the course of the walls; and the force on them, which
// a run that continues another does not compute again.
static constexpr int LAYOUT = 5, FINGERPRINTS = 5;

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::write_restart(FILE* fp) {
  std::vector<double> head{RESTART_MARK + LAYOUT, static_cast<double>(walls.size()),
                           static_cast<double>(per_wall), static_cast<double>(regions.size()),
                           static_cast<double>(faces())};
  for (const RegionFaces& region : regions) head.push_back(region.fingerprint());
  append_course(head, course, walls);
  forces.write_restart(fp, world, std::move(head));
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::restart(char* buf) {
  const auto* values = reinterpret_cast<double*>(buf);
  require_layout(lmp, values[0], where, LAYOUT);
  if (values[1] != static_cast<double>(walls.size()) || values[2] != per_wall ||
      values[3] != static_cast<double>(regions.size()))
    error->all(FLERR,
               where +
                   ": other walls than in the restart file, or friction or rolling "
                   "friction in one of them only: {} walls and {} regions with {} numbers of "
                   "history each there, {} and {} with {} here; give the fix another ID",
               static_cast<int>(values[1]), static_cast<int>(values[3]),
               static_cast<int>(values[2]), walls.size(), regions.size(), per_wall);
  bool are_same = values[4] == faces();
  values += FINGERPRINTS;
  for (const RegionFaces& region : regions)
    are_same = *values++ == region.fingerprint() && are_same;
  if (!are_same)
    error->all(FLERR, where +
                          ": other regions than in the restart file; define them as in the "
                          "script of the first run, or give the fix another ID");
  course = continued_course(lmp, where, course, walls, values);
  if (comm->me == 0) forces.put_back(values + size_of_course(walls));
}

#define COHESION_INSTANTIATE(style, Law)                        \
  template void FixWallGranCohesive<Law>::continue_run();       \
  template void FixWallGranCohesive<Law>::repeat_forces();      \
  template void FixWallGranCohesive<Law>::write_restart(FILE*); \
  template void FixWallGranCohesive<Law>::restart(char*);
COHESION_CONTACT_LAWS(COHESION_INSTANTIATE)
