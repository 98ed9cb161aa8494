// SPDX-License-Identifier: GPL-2.0-only
#include "engine/particles_at_walls.h"

#include <mpi.h>

#include <algorithm>
#include <limits>

#include "atom.h"
#include "comm.h"
#include "common/message.h"
#include "engine/mobile_particles.h"
#include "error.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::contact_solver::Wall;
using cohesion::contact_solver::WallState;

namespace {

/// Particles that stand where they should not: how many, and the one with the lowest number.
struct Misplaced {
  double count = 0.0, tag = std::numeric_limits<double>::infinity();
  int i = -1, wall = -1;

  void add(int particle, int at_wall, double with_tag) {
    count += 1.0;
    if (with_tag < tag) *this = {count, with_tag, particle, at_wall};
  }
};

}  // namespace

std::string LAMMPS_NS::name_of_wall(const Wall& wall, const WallState& now, bool other_side) {
  if (wall.shape == Wall::z_cylinder) return message("zcylinder ", wall.position);
  const double moved[] = {now.displacement.x, now.displacement.y, now.displacement.z};
  const double position = wall.position + moved[wall.shape];
  const char* const plane = wall.shape == Wall::x_plane   ? "xplane "
                            : wall.shape == Wall::y_plane ? "yplane "
                                                          : "zplane ";
  const bool lower = (wall.side > 0.0) != other_side;
  return lower ? message(plane, position, " NULL") : message(plane, "NULL ", position);
}

std::string WallsAtStart::name(int w) const {
  return is_region(w) ? "region " + region(w).id() : name_of_wall(walls[w], state);
}

std::string WallsAtStart::words_of_other_side(int w) const {
  if (is_region(w)) return "define region " + region(w).id() + " with the other 'side'";
  return walls[w].is_flat() ? "write '" + name_of_wall(walls[w], state, true) + "'" : "";
}

double WallsAtStart::distance(int w, const cohesion::Vector3& centre) const {
  if (!is_region(w)) return walls[w].nearest(centre, state, 0.0).distance;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<RegionFaces::WallPoint> points(region(w).count());
  region(w).find(centre, state, infinite, points.data());
  double nearest = infinite;
  for (const auto& point : points) nearest = std::min(nearest, point.distance);
  return nearest;
}

bool LAMMPS_NS::warn_of_particles_at_walls(LAMMPS* lmp, const std::string& where,
                                           const WallsAtStart& start,
                                           const std::function<bool(int i, int wall)>& is_new) {
  const Atom* const atom = lmp->atom;
  MobileParticles mobile;
  mobile.look_up(lmp);
  Misplaced behind, through;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & start.groupbit)) continue;
    if (atom->rmass && mobile.inverse_mass(atom->mask[i], atom->rmass[i]) == 0.0) continue;
    bool is_behind = false, is_through = false;  // counts once for each
    for (int w = 0; w < start.count(); w++) {
      const double distance = start.distance(w, vector(atom->x[i]));
      if (distance >= (1.0 - 2.0 * start.deep) * atom->radius[i] || !is_new(i, w)) continue;
      const auto tag = static_cast<double>(atom->tag[i]);
      if (distance <= 0.0 && !is_behind)
        behind.add(i, w, tag), is_behind = true;
      else if (distance > 0.0 && !is_through)
        through.add(i, w, tag), is_through = true;
    }
  }
  double counts[] = {behind.count, through.count}, first[] = {behind.tag, through.tag};
  MPI_Allreduce(MPI_IN_PLACE, counts, 2, MPI_DOUBLE, MPI_SUM, lmp->world);
  if (counts[0] + counts[1] == 0.0) return false;
  MPI_Allreduce(MPI_IN_PLACE, first, 2, MPI_DOUBLE, MPI_MIN, lmp->world);

  // Of the first of each: where it is, its radius, its distance, its wall.
  constexpr int NUMBERS = 6;
  double shown[2 * NUMBERS] = {};
  const Misplaced* const mine[] = {&behind, &through};
  for (int kind = 0; kind < 2; kind++) {
    if (counts[kind] == 0.0 || mine[kind]->tag != first[kind]) continue;
    const int i = mine[kind]->i, w = mine[kind]->wall;
    double* const to = shown + NUMBERS * kind;
    std::copy_n(atom->x[i], 3, to);
    to[3] = atom->radius[i];
    to[4] = start.distance(w, vector(atom->x[i]));
    to[5] = w;
  }
  MPI_Allreduce(MPI_IN_PLACE, shown, 2 * NUMBERS, MPI_DOUBLE, MPI_SUM, lmp->world);
  if (lmp->comm->me != 0) return true;

  for (int kind = 0; kind < 2; kind++) {
    if (counts[kind] == 0.0) continue;
    const double* const of = shown + NUMBERS * kind;
    const int w = static_cast<int>(of[5]);
    const std::string particle = message("Particle ", static_cast<bigint>(first[kind]), " at (",
                                         of[0], " ", of[1], " ", of[2], ")");
    if (kind == 0) {
      const std::string words = start.words_of_other_side(w);
      const std::string turn = words.empty() ? "" : words + " if they are to be in front of it, ";
      lmp->error->warning(
          FLERR, message(where, ": particles with their centres behind a wall: ", counts[0], ". ",
                         particle, " is ", -of[4], " behind '", start.name(w),
                         "'. A wall acts on its front side only: such particles do not feel it "
                         "until they have once been clear of it in front. Move the wall or the "
                         "particles, ",
                         turn, "or leave these particles out of the group of the fix"));
    } else {
      const double overlap = of[3] - of[4];
      lmp->error->warning(
          FLERR,
          message(where, ": particles that a wall cuts through: ", counts[1], ". ", particle,
                  " reaches ", overlap, " into '", start.name(w), "', ", 50.0 * overlap / of[3],
                  " % of its diameter; ", start.effect, ". Move the wall or the particles"));
    }
  }
  return true;
}
