// SPDX-License-Identifier: GPL-2.0-only
// The part of FixWallGranCohesive that knows the faces of regions.
#include <string>
#include <vector>

#include "atom.h"
#include "common/message.h"
#include "contact_solver/wall.h"
#include "engine/particles_at_walls.h"
#include "engine/region_faces.h"
#include "error.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/fix_wall_gran_cohesive.h"

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;
using cohesion::Vector3;

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::start_faces(const std::vector<std::string>& region_ids) {
  for (int w = 0; w < static_cast<int>(walls.size()); w++) wall_of_face.push_back(w);
  for (const std::string& region_id : region_ids) {
    const int w = static_cast<int>(walls.size() + regions.size());
    regions.emplace_back(lmp, where, region_id);
    wall_of_face.insert(wall_of_face.end(), regions.back().count(), w);
  }
  points.resize(wall_of_face.size());
}

/// Of the regions near particle i, whose `points` are known: contacts that go round the edge of an
/// open face, and curvatures that the tangent planes do not describe. `range`: of the adhesion.
template <class Cohesion>
void FixWallGranCohesive<Cohesion>::check_regions(int i, const WallState& now, double range) {
  const double radius = atom->radius[i], last_step = step->starts() ? 0.0 : update->dt;
  const Vector3 centre = vector(atom->x[i]), velocity = vector(atom->v[i]);
  const std::string particle = where + ": particle " + std::to_string(atom->tag[i]);
  int first = static_cast<int>(walls.size());
  for (const RegionFaces& region : regions) {
    const auto in_range = [&](int face) { return *history.of(i, first + face) > 0.0; };
    int to = -1;
    const int from = region.handed_over(&points[first], in_range, to);
    if (from >= 0 && region.has_passed(centre, velocity, points[first + to], now, last_step))
      error->one(FLERR,
                 particle + " went through region " + region.id() + "; use a larger stiffness");
    if (from >= 0) history.hand_over(i, first + from, first + to);
    first += region.count();
  }
  for (const RegionFaces& region : regions) {
    const double curvature = region.curvature_radius();
    if (region.is_hollow() && curvature < 2.0 * radius + range)
      error->one(FLERR, message(particle, " of radius ", radius, " is where region ", region.id(),
                                " has the radius of curvature ", curvature,
                                ", which must be above the diameter plus the range of adhesion: "
                                "use a wider region, or end a cone farther from its tip"));
    if (curvature >= 10.0 * radius || has_warned_of_curvature) continue;
    has_warned_of_curvature = true;
    error->warning(FLERR, message(particle, " of radius ", radius, " is near a face of region ",
                                  region.id(), " with the radius of curvature ", curvature,
                                  ". A face acts as a plane: adhesion and stiffness are those of "
                                  "a plane, true for 10 particle radii and more"));
  }
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::warn_of_particles() {
  const StepWindow next{0.0, 0.5 * update->dt};
  // Where the spring is meant for less, particles have been put there.
  warn_of_particles_at_walls(
      lmp, where,
      {walls, course.over(next), groupbit, cohesion::advice::overlap_for_warning,
       "the spring throws it out", &regions},
      [this](int i, int w) {
        for (int face = 0; face < faces(); face++)
          if (wall_of_face[face] == w && !history.is_new(i, face)) return false;
        return true;
      });
}

#define COHESION_INSTANTIATE(style, Law)                                                \
  template void FixWallGranCohesive<Law>::start_faces(const std::vector<std::string>&); \
  template void FixWallGranCohesive<Law>::check_regions(int, const WallState&, double); \
  template void FixWallGranCohesive<Law>::warn_of_particles();
COHESION_CONTACT_LAWS(COHESION_INSTANTIATE)
