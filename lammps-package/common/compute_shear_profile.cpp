// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/compute_shear_profile.h"

#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "common/box_shear.h"
#include "common/message.h"
#include "domain.h"
#include "force.h"
#include "memory.h"
#include "shear/granular_temperature.h"
#include "shear/kinetic_stress.h"
#include "update.h"

using namespace LAMMPS_NS;
using cohesion::shear::Layers;
using cohesion::shear::ProfileSums;

static constexpr int FITTED = 4;  // slope, intercept, temperature, slip; then six of stress

ComputeShearProfile::ComputeShearProfile(LAMMPS* lammps, int narg, char** arg)
    : engine_api::StyleCompute(lammps, narg, arg),
      layer_number(20),
      measured_step(-1),
      layers(1, 1.0) {
  const std::string where = std::string("compute ") + id + " shear/profile";
  if (narg != 3 && (narg != 5 || strcmp(arg[3], "layers") != 0))
    stop(lmp, FLERR, where, " takes no other words than 'layers N'");
  if (narg == 5) layer_number = engine_api::inumeric(FLERR, arg[4], lmp);
  if (layer_number < 3)
    stop(lmp, FLERR, where, ": layers ", layer_number, "; slip from a line takes at least 3");
  if (!domain->yperiodic)
    stop(lmp, FLERR, where, ": the gradient is along y, which must be periodic");
  scalar_flag = vector_flag = array_flag = 1;
  extscalar = extvector = extarray = 0;
  size_vector = FITTED + 6;
  size_array_rows = layer_number;
  size_array_cols = 3;
  vector = new double[size_vector];
  memory->create(array, size_array_rows, size_array_cols, "shear/profile:array");
}

ComputeShearProfile::~ComputeShearProfile() {
  delete[] vector;
  memory->destroy(array);
}

/// Sums about a line through the middle of the box with the rate that the box is sheared at, which
/// makes what is summed the same for all images of a particle.
void ComputeShearProfile::measure() {
  if (measured_step == update->ntimestep) return;
  measured_step = update->ntimestep;
  const double height = domain->yprd;
  const cohesion::shear::BoxShear flow = rate_of_shear(domain);
  ProfileSums mine, all;
  layers = Layers(layer_number, height);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double* const v = atom->v[i];
    const double m = atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
    const double y = atom->x[i][1] - flow.middle;
    const double in_box = y - height * std::floor(y / height + 0.5);
    const double u = flow.nonaffine(v[0], atom->x[i][1]);
    mine.add(m, in_box, {u, v[1], v[2]});
    layers.add(m, in_box, u);
  }
  MPI_Allreduce(mine.values.data(), all.values.data(), ProfileSums::count, MPI_DOUBLE, MPI_SUM,
                world);
  MPI_Allreduce(MPI_IN_PLACE, layers.sums().data(), static_cast<int>(layers.sums().size()),
                MPI_DOUBLE, MPI_SUM, world);
  profile = fit(all);
}

double ComputeShearProfile::compute_scalar() {
  invoked_scalar = update->ntimestep;
  measure();
  return scalar = granular_temperature(profile, domain->dimension);
}

void ComputeShearProfile::compute_vector() {
  invoked_vector = update->ntimestep;
  measure();
  vector[0] = rate_of_shear(domain).amount + profile.slope;
  vector[1] = profile.intercept;
  vector[2] = granular_temperature(profile, domain->dimension);
  vector[3] = layers.slip(profile);
  const double volume = domain->xprd * domain->yprd * (domain->dimension == 3 ? domain->zprd : 1.0);
  const auto stress = kinetic_stress(profile, volume);
  for (int k = 0; k < 6; k++) vector[FITTED + k] = force->mvv2e * force->nktv2p * stress[k];
}

void ComputeShearProfile::compute_array() {
  invoked_array = update->ntimestep;
  measure();
  const cohesion::shear::BoxShear flow = rate_of_shear(domain);
  for (int i = 0; i < layer_number; i++) {
    const bool empty = layers.mass(i) == 0.0;
    const double y =
        empty ? domain->yprd * ((i + 0.5) / layer_number - 0.5) : layers.mean_position(i);
    array[i][0] = flow.middle + y;
    array[i][1] = empty ? 0.0 : flow.amount * y + layers.mean_velocity(i);
    array[i][2] = profile.mass > 0.0 ? layers.mass(i) / profile.mass : 0.0;
  }
}
