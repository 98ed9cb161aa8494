// SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
// LIGGGHTS' headers want mpi.h before them.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "advice/box_limits.h"
#include "advice/known_materials.h"
#include "atom.h"
#include "comm.h"
#include "common/message.h"
#include "common/plausible_sizes.h"
#include "domain.h"
#include "force.h"
#include "sphere.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

// Of atoms that create_atoms makes.
constexpr double CREATED_RADIUS = 0.5, CREATED_DENSITY = 1.0;
// So much smaller are others that one as created was not meant.
constexpr double MUCH_SMALLER = 0.1;

bool is_shrink_wrapped(const Domain* d) {
  constexpr int SHRINK = 2;  // and above
  return std::any_of(&d->boundary[0][0], &d->boundary[0][0] + 6,
                     [](int kind) { return kind >= SHRINK; });
}

cohesion::advice::BoxSize size_of(const Domain* d) {
  const bool flat = d->dimension == 2;
  return {{d->prd[0], d->prd[1], flat ? 0.0 : d->prd[2]},
          {d->periodicity[0] != 0, d->periodicity[1] != 0, d->periodicity[2] != 0 && !flat},
          is_shrink_wrapped(d)};
}

bool is_as_created(const Atom* atom, int i) {
  if (atom->radius[i] != CREATED_RADIUS || !atom->rmass) return false;
  const double mass = CREATED_DENSITY * cohesion::sphere_volume(CREATED_RADIUS);
  return std::abs(atom->rmass[i] - mass) <= 1e-12 * mass;
}

/// To three digits.
std::string rounded(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

/// Once in a session.
void warn(LAMMPS* lmp, const std::string& text) {
  static const LAMMPS* warned = nullptr;
  if (warned != lmp && lmp->comm->me == 0) lmp->error->warning(FLERR, text.c_str());
  warned = lmp;
}

/// In SI units a sphere of 1 m and 1 kg/m^3 is not meant; in others it may be.
void refuse_as_created(LAMMPS* lmp, const std::string& text) {
  if (std::string(lmp->update->unit_style) == "si") stop(lmp, FLERR, text);
  warn(lmp, text);
}

/// Whether the density of particle i was set before its diameter, or never. In two dimensions a
/// mass that was set may be that of a disc.
bool has_mass_of_another_size(const LAMMPS* lmp, int i, const cohesion::advice::SiUnits* units) {
  const double mass = lmp->atom->rmass[i], radius = lmp->atom->radius[i];
  return cohesion::advice::is_mass_as_created(mass, radius, units) ||
         (lmp->domain->dimension == 3 &&
          cohesion::advice::is_mass_of_diameter_1(mass, radius, units));
}

/// Stops where a density was set before the diameter, or never.
void require_own_masses(const LAMMPS* lmp, const std::string& where) {
  const Atom* const atom = lmp->atom;
  const cohesion::advice::SiUnits* const units = si_units(lmp);
  if (!atom->rmass || !units) return;
  // The tag of the last one, its mass and radius are of one particle: of the rank that has it.
  double mine[3] = {0.0, 0.0, 0.0}, number = 0.0, numbers = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!has_mass_of_another_size(lmp, i, units)) continue;
    number += 1.0;
    const double tag = atom->tag_enable ? static_cast<double>(atom->tag[i]) : 1.0;
    if (mine[0] > 0.0 && tag > mine[0]) continue;
    mine[0] = tag;
    mine[1] = atom->rmass[i];
    mine[2] = atom->radius[i];
  }
  MPI_Allreduce(&number, &numbers, 1, MPI_DOUBLE, MPI_SUM, lmp->world);
  if (numbers == 0.0) return;
  const int rank = number > 0.0 ? lmp->comm->me : lmp->comm->nprocs;
  int first = 0;
  MPI_Allreduce(&rank, &first, 1, MPI_INT, MPI_MIN, lmp->world);
  MPI_Bcast(mine, 3, MPI_DOUBLE, first, lmp->world);
  const double density = mine[1] / cohesion::sphere_volume(mine[2]);
  const double of_diameter_1 = mine[1] / cohesion::sphere_volume(CREATED_RADIUS);
  const double si = units->density();
  const bool created = cohesion::advice::is_mass_as_created(mine[1], mine[2], units);
  stop(lmp, FLERR, where, ": particle ", mine[0], " (one of ", numbers,
       ") has the mass of a sphere of diameter 1 and density ", of_diameter_1,
       ", and with its diameter of ", 2.0 * mine[2], " a density of ", rounded(si * density),
       " kg/m^3, which no material has", units_of_lengths(lmp),
       created ? ". It has the mass that create_atoms gave it, and 'set ... diameter' keeps the "
                 "mass: set the density after the diameter"
               : ". 'set ... diameter' keeps the mass that 'set ... density' gave before: set the "
                 "diameter first, then the density");
}

template <class Check>
void or_stop(LAMMPS* lmp, const std::string& where, const std::string& reason, Check check) {
  try {
    check();
  } catch (const cohesion::InvalidParameter& bad) {
    stop(lmp, FLERR, where, ": ", bad.what(), units_of_lengths(lmp), reason);
  }
}

}  // namespace

const cohesion::advice::SiUnits* LAMMPS_NS::si_units(const LAMMPS* lmp) {
  return cohesion::advice::find_si_units(lmp->update->unit_style);
}

void LAMMPS_NS::require_mechanical_units(const LAMMPS* lmp, const std::string& where) {
  if (lmp->force->ftm2v == 1.0) return;
  stop(lmp, FLERR, where, ": in 'units ", lmp->update->unit_style,
       "' force is not mass times acceleration, and energy not mass times the square of a speed: "
       "use 'units si', 'cgs', 'micro', 'nano' or 'lj'");
}

void LAMMPS_NS::require_time_step(const LAMMPS* lmp, const std::string& where) {
  const double dt = lmp->update->dt;
  if (dt > 0.0 && std::isfinite(dt)) return;
  stop(lmp, FLERR, where, ": timestep ", dt, ": give a time step above 0");
}

std::string LAMMPS_NS::units_of_lengths(const LAMMPS* lmp) {
  const std::string units = lmp->update->unit_style;
  const std::string length = units == "si" ? ", m" : units == "cgs" ? ", cm" : "";
  return "; lengths are those of 'units " + units + "'" + length;
}

void LAMMPS_NS::require_plausible_spheres(LAMMPS* lmp, const std::string& where) {
  require_mechanical_units(lmp, where);
  const Atom* const atom = lmp->atom;
  // Largest radius, minus the smallest, the largest tag of one that is as it was created.
  std::array<double, 3> mine{0.0, -std::numeric_limits<double>::infinity(), 0.0}, all{};
  for (int i = 0; i < atom->nlocal; i++) {
    mine[0] = std::max(mine[0], atom->radius[i]);
    mine[1] = std::max(mine[1], -atom->radius[i]);
    if (is_as_created(atom, i))
      mine[2] = std::max(mine[2], static_cast<double>(atom->tag_enable ? atom->tag[i] : 1));
  }
  MPI_Allreduce(mine.data(), all.data(), 3, MPI_DOUBLE, MPI_MAX, lmp->world);
  const double largest = all[0], smallest = -all[1], created = all[2];
  const std::string as_created =
      ". Spheres of create_atoms have the diameter 1 until 'set ... diameter', which changes those "
      "alone that are there before it";
  if (created > 0.0 && smallest < MUCH_SMALLER * CREATED_RADIUS)
    refuse_as_created(
        lmp, message(where, ": particle ", created, " has the diameter 1, others as little as ",
                     2.0 * smallest, units_of_lengths(lmp), as_created));
  or_stop(lmp, where, created > 0.0 ? as_created : "",
          [&] { cohesion::advice::require_radius_in_box(largest, size_of(lmp->domain)); });
  require_own_masses(lmp, where);
}

void LAMMPS_NS::require_plausible_range(LAMMPS* lmp, const std::string& where, double range) {
  or_stop(lmp, where, "",
          [&] { cohesion::advice::require_range_in_box(range, size_of(lmp->domain)); });
}
