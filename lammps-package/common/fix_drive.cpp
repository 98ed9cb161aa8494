// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/fix_drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "common/message.h"
#include "common/specified_keywords.h"
#include "domain.h"
#include "driving/philox.h"
#include "force.h"
#include "group.h"
#include "statistics/order_free_sum.h"
#include "update.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;
using cohesion::driving::Sums;
using cohesion::driving::VelocityChange;

FixDrive::FixDrive(LAMMPS* lammps, int narg, char** arg)
    : engine_api::StyleFix(lammps, narg, arg), where(std::string("fix ") + id + " drive") {
  if (narg < 4) stop(lmp, FLERR, where, " takes 'N', every so many steps, and 'temperature T'");
  nevery = engine_api::inumeric(FLERR, arg[3], lmp);
  if (nevery < 1) stop(lmp, FLERR, where, ": N is ", nevery, "; it must be 1 or more");
  read_keywords(narg, arg);
  if (kicks && !atom->tag_enable)
    stop(lmp, FLERR, where, ": random accelerations are of particles with IDs");
  scalar_flag = vector_flag = 1;
  size_vector = 3;
  extscalar = 1;
  extvector = 0;
  global_freq = 1;  // what the last action has left
  restart_global = 1;
  time_depend = 1;
}

void FixDrive::read_keywords(int narg, char** arg) {
  SpecifiedKeywords given(lmp, where);
  for (int i = 4; i < narg; i += 2) {
    const std::string word = arg[i];
    if (word != "temperature" && word != "by" && word != "seed")
      stop(lmp, FLERR, where, ": unknown keyword '", word, "'; valid ones: temperature, by, seed");
    if (i + 1 == narg) stop(lmp, FLERR, where, ": ", word, " takes a value");
    given.note(1, arg + i);
    const std::string value = arg[i + 1];
    if (word == "temperature") {
      temperature = engine_api::numeric(FLERR, arg[i + 1], lmp);
      if (!std::isfinite(temperature) || temperature <= 0.0)
        stop(lmp, FLERR, where, ": temperature ", value,
             "; it must be a finite number above 0, <v'.v'>/3 [velocity^2]");
    } else if (word == "by") {
      if (value != "rescale" && value != "random")
        stop(lmp, FLERR, where, ": by '", value, "'; valid ones: rescale, random");
      kicks = value == "random";
    } else {
      seed = engine_api::inumeric(FLERR, arg[i + 1], lmp);
      if (seed < 1) stop(lmp, FLERR, where, ": seed ", seed, "; it must be 1 or more");
    }
  }
  if (!given.has("temperature"))
    stop(lmp, FLERR, where, ": give 'temperature T', which it keeps, <v'.v'>/3 [velocity^2]");
  if (kicks && !seed)
    stop(lmp, FLERR, where, ": random accelerations need 'seed S', a whole number above 0");
  if (!kicks && seed)
    stop(lmp, FLERR, where, ": seed ", seed, " is for 'by random'; scaling draws no numbers");
}

int FixDrive::setmask() { return FixConst::END_OF_STEP | FixConst::POST_RUN; }

void FixDrive::init() {
  const auto count = static_cast<double>(group->count(igroup));
  if (count < 2)
    stop(lmp, FLERR, where, ": its group '", group->names[igroup], "' has ", count,
         " particles; motion about their mean velocity takes two or more");
}

/// Temperature and step from which it is integrated over time. A run that goes on from a restart
/// file knows them.
void FixDrive::setup(int) {
  const double found = cohesion::driving::temperature_of(sums(), domain->dimension);
  if (!kicks && found == 0.0)
    stop(lmp, FLERR, where,
         ": the particles have no motion about their mean velocity that could be scaled; give them "
         "velocities, or use 'by random'");
  if (!is_restarted) {
    state.now = found;
    state.step = static_cast<double>(update->ntimestep);
  }
  is_restarted = false;
}

double FixDrive::mass_of(int i) const {
  return atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
}

/// The velocity of a particle beyond the flow of a sheared box: the same for all its images.
Vector3 FixDrive::beyond_flow(int i) const {
  const double* const v = atom->v[i];
  return {rate_of_shear(domain).nonaffine(v[0], atom->x[i][1]), v[1], v[2]};
}

Vector3 FixDrive::random_numbers(int i) const {
  if (!kicks) return {};
  Vector3 w = cohesion::driving::normal_deviates(static_cast<std::uint32_t>(seed),
                                                 static_cast<std::uint64_t>(update->ntimestep),
                                                 static_cast<std::uint64_t>(atom->tag[i]));
  if (domain->dimension == 2) w.z = 0.0;
  return w;
}

/// Collective: the same to the last bit on any number of ranks.
Sums::Values FixDrive::sums() const {
  constexpr int count = Sums::count;
  std::array<double, count + 1> largest{};  // and how many particles
  const auto for_each = [&](const auto& take) {
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & groupbit) take(Sums::of(mass_of(i), beyond_flow(i), random_numbers(i)));
  };
  for_each([&](const Sums::Values& own) {
    for (int k = 0; k < count; k++) largest[k] = std::max(largest[k], std::abs(own[k]));
  });
  largest[count] = static_cast<double>(atom->natoms);
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), count, MPI_DOUBLE, MPI_MAX, world);
  const auto grid = [&](int k) {
    return cohesion::statistics::OrderFreeSum(largest[k],
                                              static_cast<std::int64_t>(largest[count]));
  };
  std::array<std::int64_t, count> units{};
  for_each([&](const Sums::Values& own) {
    for (int k = 0; k < count; k++) units[k] += grid(k).units(own[k]);
  });
  MPI_Allreduce(MPI_IN_PLACE, units.data(), count, MPI_INT64_T, MPI_SUM, world);
  Sums::Values all;
  for (int k = 0; k < count; k++) all[k] = grid(k).value(units[k]);
  return all;
}

/// Adds the temperature between the last time that it was known and now, as a straight line.
void FixDrive::count_time(double found) {
  const double steps = static_cast<double>(update->ntimestep) - state.step;
  state.over_time += 0.5 * (state.now + found) * steps * update->dt;
  state.now = found;
  state.step = static_cast<double>(update->ntimestep);
}

void FixDrive::end_of_step() {
  const Sums::Values all = sums();
  const VelocityChange action =
      kicks ? cohesion::driving::kicked(all, temperature, domain->dimension)
            : cohesion::driving::rescaled(all, temperature, domain->dimension);
  count_time(action.temperature);
  state.before = action.temperature;
  state.energy += action.energy;
  if (action.energy == 0.0)
    state.idle++;
  else
    apply(action);
}

void FixDrive::apply(const VelocityChange& action) {
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const Vector3 change = action.change(beyond_flow(i), random_numbers(i));
    atom->v[i][0] += change.x;
    atom->v[i][1] += change.y;
    atom->v[i][2] += change.z;
  }
  state.now = temperature;
}

void FixDrive::post_run() {
  if (static_cast<double>(update->ntimestep) > state.step)
    count_time(cohesion::driving::temperature_of(sums(), domain->dimension));
}

double FixDrive::compute_scalar() { return force->mvv2e * state.energy; }

double FixDrive::compute_vector(int n) {
  const double values[] = {state.before, state.over_time, state.idle};
  return values[n];
}

void FixDrive::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  const int size = static_cast<int>(sizeof(DriveState));
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&state, sizeof(DriveState), 1, fp);
}

void FixDrive::restart(char* buf) {
  memcpy(&state, buf, sizeof(DriveState));
  is_restarted = true;
}
