// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/held_spheres.h"

#include <mpi.h>
// LIGGGHTS' headers want mpi.h before them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "atom.h"
#include "comm.h"
#include "common/message.h"
#include "domain.h"
#include "fix_lineforce.h"
#include "fix_planeforce.h"
#include "fix_setforce.h"
#include "held_directions.h"
#include "modify.h"

using namespace LAMMPS_NS;
using cohesion::HeldDirections;
using cohesion::Vector3;

// The fixes tell neither directions nor components; so their members are read. Names of private
// members may stand in an explicit instantiation, which here defines a function. The fixes are
// known by their styles: no symbol of theirs need be in the engine.

namespace {

struct SetComponents {
  bool x, y, z, of_region;
};

SetComponents components(const FixSetForce&);
Vector3 direction(const FixLineForce&);
Vector3 direction(const FixPlaneForce&);

// What xstyle and its like are for a component that is NULL in the script. A variable gives a
// component its name, and its style only when a run begins.
constexpr int NOT_SET = 0;

template <auto x, auto y, auto z, auto variable_x, auto variable_y, auto variable_z, auto region>
struct SetForce {
  friend SetComponents components(const FixSetForce& fix) {
    return {fix.*variable_x || fix.*x != NOT_SET, fix.*variable_y || fix.*y != NOT_SET,
            fix.*variable_z || fix.*z != NOT_SET, fix.*region != nullptr};
  }
};
template struct SetForce<&FixSetForce::xstyle, &FixSetForce::ystyle, &FixSetForce::zstyle,
                         &FixSetForce::xstr, &FixSetForce::ystr, &FixSetForce::zstr,
                         &FixSetForce::idregion>;

template <auto x, auto y, auto z>
struct LineForce {
  friend Vector3 direction(const FixLineForce& fix) { return {fix.*x, fix.*y, fix.*z}; }
};
template struct LineForce<&FixLineForce::xdir, &FixLineForce::ydir, &FixLineForce::zdir>;

template <auto x, auto y, auto z>
struct PlaneForce {
  friend Vector3 direction(const FixPlaneForce& fix) { return {fix.*x, fix.*y, fix.*z}; }
};
template struct PlaneForce<&FixPlaneForce::xdir, &FixPlaneForce::ydir, &FixPlaneForce::zdir>;

/// What a fix holds of the particles of its group, in a region or everywhere.
struct Hold {
  const Fix* fix;
  HeldDirections directions;
  bool of_region;
};

Hold hold_of(const Fix* fix, int dimension) {
  const std::string style = fix->style;
  if (style == "setforce") {
    const SetComponents set = components(*static_cast<const FixSetForce*>(fix));
    HeldDirections directions(dimension);
    if (set.x) directions.add({1.0, 0.0, 0.0});
    if (set.y) directions.add({0.0, 1.0, 0.0});
    if (set.z) directions.add({0.0, 0.0, 1.0});
    return {fix, directions, set.of_region};
  }
  if (style == "lineforce")
    return {fix, cohesion::all_but(direction(*static_cast<const FixLineForce*>(fix)), dimension),
            false};
  HeldDirections directions(dimension);
  if (style == "planeforce") directions.add(direction(*static_cast<const FixPlaneForce*>(fix)));
  return {fix, directions, false};
}

/// Of all fixes that hold something.
std::vector<Hold> holds(const LAMMPS* lmp) {
  std::vector<Hold> all;
  for (int k = 0; k < lmp->modify->nfix; k++) {
    const Hold hold = hold_of(lmp->modify->fix[k], lmp->domain->dimension);
    if (!hold.directions.none()) all.push_back(hold);
  }
  return all;
}

/// Least and largest of a number of the particles, over all ranks.
struct MinMax {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double spread() const { return high > low ? high - low : 0.0; }
  MinMax of_all(MPI_Comm world) const {
    const double mine[] = {low, -high};
    double all[2];
    MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_MIN, world);
    MinMax range;
    range.low = all[0];
    range.high = -all[1];
    return range;
  }
};

/// Whether all particles lie in one layer across `direction`, and move in it.
bool is_layer(const LAMMPS* lmp, const Vector3& direction) {
  const Atom* const atom = lmp->atom;
  MinMax places, velocities, radii, speeds;
  for (int i = 0; i < atom->nlocal; i++) {
    const Vector3 v = cohesion::vector(atom->v[i]);
    places.add(dot(direction, cohesion::vector(atom->x[i])));
    velocities.add(dot(direction, v));
    speeds.add(norm(v));
    radii.add(atom->radius[i]);
  }
  const double allowed = cohesion::most_off_layer;
  return places.of_all(lmp->world).spread() <= allowed * radii.of_all(lmp->world).low &&
         velocities.of_all(lmp->world).spread() <=
             1e-12 * std::max(speeds.of_all(lmp->world).high, 0.0);
}

/// How many particles a fix holds that HeldGroups do not, and the lowest tag of one.
struct Partly {
  bigint number = 0, first = 0;
};
Partly partly_held(const LAMMPS* lmp, const Hold& hold, const HeldGroups& wholly) {
  const Atom* const atom = lmp->atom;
  bigint mine[2] = {0, -std::numeric_limits<bigint>::max()}, number = 0, tag = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & hold.fix->groupbit) || wholly.hold(atom->mask[i])) continue;
    mine[0]++;
    mine[1] = std::max(mine[1], -static_cast<bigint>(atom->tag[i]));
  }
  MPI_Allreduce(&mine[0], &number, 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  MPI_Allreduce(&mine[1], &tag, 1, MPI_LMP_BIGINT, MPI_MAX, lmp->world);
  return {number, -tag};
}

std::string in_words(const HeldDirections& directions) {
  std::string all;
  for (const Vector3& d : directions)
    all += message(all.empty() ? "" : " and ", "(", d.x, ", ", d.y, ", ", d.z, ")");
  return all;
}

}  // namespace

HeldGroups::HeldGroups(const LAMMPS* lmp) {
  std::vector<Hold> partial;
  for (const Hold& hold : holds(lmp)) {
    if (hold.of_region) continue;
    if (hold.directions.all())
      single_ |= hold.fix->groupbit;
    else
      partial.push_back(hold);
  }
  // Fixes that hold a particle together: two, or three.
  const auto hold_all = [&](std::initializer_list<const Hold*> some) {
    std::vector<const HeldDirections*> directions;
    int bits = 0;
    for (const Hold* hold : some) {
      directions.push_back(&hold->directions);
      bits |= hold->fix->groupbit;
    }
    const bool held = cohesion::leave_nothing(directions);
    if (held) together_.push_back(bits);
    return held;
  };
  for (std::size_t a = 0; a < partial.size(); a++)
    for (std::size_t b = a + 1; b < partial.size(); b++) {
      if (hold_all({&partial[a], &partial[b]})) continue;
      for (std::size_t c = b + 1; c < partial.size(); c++)
        hold_all({&partial[a], &partial[b], &partial[c]});
    }
}

bool LAMMPS_NS::require_whole_holds(LAMMPS* lmp, const std::string& where, bool exact) {
  const HeldGroups wholly(lmp);
  bool warned = false;
  for (const Hold& hold : holds(lmp)) {
    if (!hold.of_region && (hold.directions.all() ||
                            std::all_of(hold.directions.begin(), hold.directions.end(),
                                        [lmp](const Vector3& d) { return is_layer(lmp, d); })))
      continue;
    const Partly partly = partly_held(lmp, hold, wholly);
    if (partly.number == 0) continue;
    const std::string what =
        message(where, ": fix ", hold.fix->id, " ", hold.fix->style, " holds ", partly.number,
                " particles, the first of them ", partly.first,
                hold.of_region
                    ? ", while they are in its region"
                    : ", along " + in_words(hold.directions) +
                          " only, and particles do not all lie and move in one layer across that",
                "; a contact moves a sphere in all directions or in none: ");
    const char* const cure = "hold them by 'fix setforce 0 0 0' or 'fix freeze', or not at all";
    if (exact) stop(lmp, FLERR, what, cure);
    warned = true;
    if (lmp->comm->me == 0)
      lmp->error->warning(FLERR,
                          (what +
                           "their contacts have the dashpot of spheres that are free, and another "
                           "restitution; " +
                           cure)
                              .c_str());
  }
  return warned;
}

bool LAMMPS_NS::warn_of_held_turned(const LAMMPS* lmp, const HeldGroups& held, int turned,
                                    const std::vector<bool>& has_friction) {
  if (!held.any()) return false;
  const Atom* const atom = lmp->atom;
  bigint mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; i++)
    if (has_friction[atom->type[i]] && (atom->mask[i] & turned) && held.hold(atom->mask[i])) mine++;
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  if (all > 0 && lmp->comm->me == 0)
    lmp->error->warning(
        FLERR, message("friction acts on ", all,
                       " particles that fixes setforce, lineforce or planeforce hold in their "
                       "places: their spins are held, too, and contacts put no torque on them; "
                       "'fix freeze' in place of these fixes holds both without this warning")
                   .c_str());
  return all > 0;
}
