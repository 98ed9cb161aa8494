// SPDX-License-Identifier: GPL-2.0-only
#include "contact_advice.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "atom.h"
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

static double fastest_particle(LAMMPS* lmp) {
  double squared = 0.0;
  for (int i = 0; i < lmp->atom->nlocal; i++) {
    const double* const v = lmp->atom->v[i];
    squared = std::max(squared, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  return std::sqrt(largest_of_all(lmp, squared));
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

void LAMMPS_NS::advise(LAMMPS* lmp, const std::string& style, const advice::SchemeLimits& limits,
                       const std::vector<AdvisedContact>& contacts) {
  const double g = gravity(lmp), fastest = fastest_particle(lmp);
  const bool prints = lmp->comm->me == 0;
  if (prints)
    utils::logmesg(lmp, style + ", scheme " + std::string(limits.scheme) +
                            ": what to expect (lightest particles; / d: over the diameter)\n"
                            "  contact       speed  steps/t_c  H_cut/(v dt)  F_ad/K/d  impact/d"
                            "      Bond     v_esc   tail/spring\n");
  std::string stop;
  for (const AdvisedContact& c : contacts) {
    const double inverse_mass = 1.0 / c.i.mass + 1.0 / c.j.mass;
    if (inverse_mass == 0.0) continue;  // neither moves
    const double mass = 1.0 / inverse_mass;
    const double diameter = 2.0 * std::min(c.i.radius, c.j.radius);
    const double speed = std::max(fastest, std::sqrt(2.0 * g * diameter));
    const auto spring = cohesion::contact::normal_contact(c.contact, mass);
    const double tangential = cohesion::contact::tangential_contact(c.contact, spring).stiffness;
    const advice::ContactNumbers n({c.i.radius, c.j.radius, c.i.mass, c.j.mass, spring.stiffness(),
                                    spring.damping(), c.adhesion, speed, lmp->update->dt, g,
                                    c.contact.friction > 0.0 ? tangential : 0.0,
                                    c.contact.rolling_friction > 0.0 ? tangential : 0.0});
    if (prints)
      utils::logmesg(
          lmp, fmt::format("  {:<10}{:>9.3g}{:>11.4g}{:>14.3g}{:>10.2g}{:>10.2g}{:>10.3g}{:>10.3g}"
                           "{:>14}\n",
                           c.name, speed, n.steps_per_contact(), n.steps_in_cutoff(),
                           n.static_overlap_over_diameter(), n.impact_overlap_over_diameter(),
                           n.bond_number(), n.escape_velocity(),
                           c.adhesion.force > 0.0
                               ? fmt::format("{:.3g}", n.well_energy() / n.spring_adhesion_energy())
                               : "none"));
    for (const advice::Verdict& verdict : advice::advise(n, limits)) {
      const std::string message = style + ", " + c.name + ": " + verdict.sentence;
      if (verdict.severity == advice::Severity::warning && prints)
        lmp->error->warning(FLERR, message);
      if (verdict.severity == advice::Severity::error && stop.empty()) stop = message;
    }
  }
  if (!stop.empty()) lmp->error->all(FLERR, stop);
}
