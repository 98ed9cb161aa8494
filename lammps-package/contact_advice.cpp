// SPDX-License-Identifier: GPL-2.0-only
#include "contact_advice.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "atom.h"
#include "box_shear.h"
#include "comm.h"
#include "contact/contact_parameters.h"
#include "error.h"
#include "fix_event_step.h"
#include "gravity.h"
#include "update.h"

using namespace LAMMPS_NS;
namespace advice = cohesion::advice;

static double largest_of_all(LAMMPS* lmp, double mine) {
  double all = 0.0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  return all;
}

/// The largest acceleration.
static double gravity(LAMMPS* lmp) {
  const std::vector<double> weight = weights(lmp);
  double g = 0.0;
  for (int i = 0; i < lmp->atom->nlocal; i++) {
    const double* const w = &weight[3 * i];
    g = std::max(g, std::hypot(w[0], w[1], w[2]) / lmp->atom->rmass[i]);
  }
  return largest_of_all(lmp, g);
}

std::vector<LightestParticle> LAMMPS_NS::lightest_particles(LAMMPS* lmp, const FixEventStep& step) {
  const Atom* atom = lmp->atom;
  const double none = std::numeric_limits<double>::infinity();
  std::vector<LightestParticle> mine(atom->ntypes + 1, {none, none});
  for (int i = 0; i < atom->nlocal; i++) {
    LightestParticle& lightest = mine[atom->type[i]];
    lightest.radius = std::min(lightest.radius, atom->radius[i]);
    if (step.body(i).inverse_mass > 0.0) lightest.mass = std::min(lightest.mass, atom->rmass[i]);
  }
  std::vector<LightestParticle> all(mine.size());
  MPI_Allreduce(mine.data(), all.data(), 2 * static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MIN,
                lmp->world);
  return all;
}

AdvisedContact LAMMPS_NS::advised_contact(const std::string& name, const LightestParticle& i,
                                          const LightestParticle& j,
                                          const cohesion::contact::ContactParameters& contact,
                                          const cohesion::contact::Adhesion& adhesion) {
  AdvisedContact c{name, i, j, {}, adhesion};
  if (!c.moves()) return c;
  const auto spring = cohesion::contact::normal_contact(contact, c.reduced_mass());
  const double tangential = cohesion::contact::tangential_contact(contact, spring).stiffness;
  c.springs.stiffness = spring.stiffness();
  c.springs.damping = spring.damping();
  if (contact.friction > 0.0) c.springs.tangential_stiffness = tangential;
  if (contact.rolling_friction > 0.0) c.springs.rolling_stiffness = tangential;
  return c;
}

void LAMMPS_NS::advise(LAMMPS* lmp, const std::string& style, const advice::SchemeLimits& limits,
                       const std::vector<AdvisedContact>& contacts) {
  const advice::RunNumbers run{fastest_particle(lmp), gravity(lmp), lmp->update->dt,
                               rate_of_shear(lmp->domain).amount};
  const advice::Report report = advice::report(style, limits, contacts, run);
  if (lmp->comm->me == 0) {
    utils::logmesg(lmp, report.table);
    for (const std::string& warning : report.warnings) lmp->error->warning(FLERR, warning);
  }
  if (!report.stop.empty()) lmp->error->all(FLERR, report.stop);
}
