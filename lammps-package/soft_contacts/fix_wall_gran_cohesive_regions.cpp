// SPDX-License-Identifier: GPL-2.0-only
// The part of FixWallGranCohesive for regions.
#include <string>
#include <vector>

#include "advice/contact_advice.h"
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
  curvatures.resize(regions.size());
}

/// A wall as a script writes it.
template <class Cohesion>
std::string FixWallGranCohesive<Cohesion>::name_of(int w, const WallState& now) const {
  const int planes = static_cast<int>(walls.size());
  return w < planes ? name_of_wall(walls[w], now) : "region " + regions[w - planes].id();
}

/// Contacts of particle i, whose `points` are known, that continue around an open edge.
template <class Cohesion>
void FixWallGranCohesive<Cohesion>::continue_around_open_edges(int i, const WallState& now) {
  const double last_step = contact_step->starts() ? 0.0 : update->dt;
  int first = static_cast<int>(walls.size());
  for (const RegionFaces& region : regions) {
    const auto in_range = [&](int face) { return *history.of(i, first + face) > 0.0; };
    int to = -1;
    const int from = region.handed_over(&points[first], in_range, to);
    if (from >= 0) {
      if (region.has_passed(vector(atom->x[i]), vector(atom->v[i]), points[first + to], now,
                            last_step))
        error->one(FLERR, message(where, ": particle ", atom->tag[i], " went through 'region ",
                                  region.id(), "'; use a larger stiffness"));
      history.hand_over(i, first + from, first + to);
    }
    first += region.count();
  }
}

/// Checks particle i, whose `curvatures` are known, for curvatures that the tangent planes do not
/// describe. `range`: of the adhesion.
template <class Cohesion>
void FixWallGranCohesive<Cohesion>::check_curvature(int i, double range) {
  const double radius = atom->radius[i];
  for (std::size_t r = 0; r < regions.size(); r++) {
    const RegionFaces::Curvature& curvature = curvatures[r];
    if (curvature.is_concave && curvature.radius < 2.0 * radius + range)
      error->one(FLERR, message(where, ": particle ", atom->tag[i], " of radius ", radius,
                                " is where region ", regions[r].id(),
                                " has the radius of curvature ", curvature.radius,
                                ", which must be above the diameter plus the range of adhesion: "
                                "use a wider region, or end a cone farther from its tip"));
    if (curvature.radius >= 10.0 * radius || has_warned_of_curvature) continue;
    has_warned_of_curvature = true;
    error->warning(FLERR,
                   message(where, ": particle ", atom->tag[i], " of radius ", radius,
                           " is near a face of region ", regions[r].id(),
                           " with the radius of curvature ", curvature.radius,
                           ". A face acts as a plane: adhesion and stiffness are those of a plane, "
                           "true for 10 particle radii and more"));
  }
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::warn_of_particles() {
  const StepWindow next{0.0, 0.5 * update->dt};
  // Larger overlaps than the spring is chosen for come from the initial positions.
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

#define COHESION_INSTANTIATE(style, Law)                                                     \
  template std::string FixWallGranCohesive<Law>::name_of(int, const WallState&) const;       \
  template void FixWallGranCohesive<Law>::start_faces(const std::vector<std::string>&);      \
  template void FixWallGranCohesive<Law>::continue_around_open_edges(int, const WallState&); \
  template void FixWallGranCohesive<Law>::check_curvature(int, double);                      \
  template void FixWallGranCohesive<Law>::warn_of_particles();
COHESION_CONTACT_LAWS(COHESION_INSTANTIATE)
