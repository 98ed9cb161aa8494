// SPDX-License-Identifier: GPL-2.0-or-later
#include "sampled_energy_tally.h"

#include <mpi.h>

#include <limits>

#include "atom.h"
#include "comm.h"
#include "gravity_of_fixes.h"
#include "modify.h"
#include "sphere.h"
#include "update.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;
using namespace cohesion::contact;

ContactSample contact_of(const ContactModels::SurfacesIntersectData& d,
                         const ContactModels::ForceData& on_i, const ContactModels::ForceData& on_j,
                         double exponent, const HistoryPlaces& places) {
  ContactSample c;
  const Vector3 force = vector(on_i.delta_F);
  c.normal = vector(d.en);
  c.overlap = d.deltan;
  c.stiffness = d.kn;
  c.exponent = exponent;
  c.repulsion = d.Fn;
  c.attraction = d.Fn - dot(force, c.normal);
  c.tangential = force - dot(force, c.normal) * c.normal;
  c.lever_i = d.cri;
  c.lever_j = d.is_wall ? 0.0 : d.crj;
  if (places.displacement >= 0) {
    c.displacement = vector(d.contact_history + places.displacement);
    c.tangential_stiffness = d.kt;
  }
  c.tangential_damping = d.gammat;
  const Vector3 turn = cross(c.normal, c.tangential);
  c.rolling_i = vector(on_i.delta_torque) + c.lever_i * turn;
  if (!d.is_wall) c.rolling_j = vector(on_j.delta_torque) + c.lever_j * turn;
  if (places.rolling >= 0)
    c.rolling_energy =
        rolling_spring_energy(vector(d.contact_history + places.rolling), d.kt,
                              d.is_wall ? d.radi : cohesion::reduced_radius(d.radi, d.radj));
  return c;
}

Moving SampledEnergyTally::moving(int particle) const {
  return {vector(lmp_->atom->v[particle]), vector(lmp_->atom->omega[particle])};
}

void SampledEnergyTally::write(const ContactModels::SurfacesCloseData& d, const Entry& entry) {
  if (!d.computeflag) return;  // of a look that moves nothing
  Record r{entry, {moving(d.i), {}}, d.i, -1, d.itype, d.jtype, d.radi, 0.0, 1.0};
  if (d.is_wall) {
    r.before.j.velocity = vector(d.v_j);
    r.rj = std::numeric_limits<double>::infinity();
  } else {
    r.before.j = moving(d.j);
    r.j = d.j;
    r.rj = d.radj;
    if (d.j >= lmp_->atom->nlocal) r.owned_fraction = 0.5;
  }
  records_.push_back(r);
}

void SampledEnergyTally::end_step(bool set_up) {
  const double half = 0.5 * lmp_->update->dt;
  // Ghosts have the velocities of half a step before.
  lmp_->comm->forward_comm();
  force_.assign(lmp_->atom->nlocal, {});
  torque_.assign(lmp_->atom->nlocal, {});
  spring = tangential_spring = adhesion = rolling_spring = 0.0;
  Losses now;
  double external = 0.0;
  const MobileParticles mobile(lmp_);
  for (const Record& r : records_) work_out(r, mobile, set_up, now, external);
  records_.clear();
  external += work_of_fixes(mobile);

  // A run that goes on has the half step after its grid point in the tally already, from the forces
  // of the last step; its set-up makes new ones.
  if (set_up && last_step_ == lmp_->update->ntimestep) {
    lost_.add(-last_half_, last_);
    external_work_ -= last_half_ * last_external_;
  }
  const double time = set_up ? half : 2.0 * half;
  lost_.add(time, now);
  external_work_ += time * external;
  if (!begun_) {
    at_begin_ = tangential_spring - time * (now.tangential - now.tangential_damping);
    rolling_at_begin_ = rolling_spring - time * now.rolling;
  }
  begun_ = true;
  last_ = now;
  last_external_ = external;
  last_half_ = half;
  last_step_ = lmp_->update->ntimestep;
}

void SampledEnergyTally::work_out(const Record& r, const MobileParticles& mobile, bool set_up,
                                  Losses& now, double& external) {
  const Atom* const atom = lmp_->atom;
  const ContactSample& c = r.entry.contact;
  const Motion grid{moving(r.i), r.j < 0 ? r.before.j : moving(r.j)};
  const Motion before = set_up ? grid : r.before;
  const double half = 0.5 * lmp_->update->dt;
  const Stored s = stored(c, half_a_step_on(before, grid), half);
  spring += r.owned_fraction * s.spring;
  tangential_spring += r.owned_fraction * s.tangential_spring;
  rolling_spring += r.owned_fraction * c.rolling_energy;
  if (r.entry.law)
    adhesion += r.owned_fraction *
                r.entry.law->energy(r.itype, r.jtype, r.ri, r.rj, -s.overlap, r.entry.inside);
  now.add(r.owned_fraction, losses(c, before, grid));

  // What a wall, or a particle that is led, gives to the others.
  const auto put_in = [&](const Vector3& force, const Vector3& torque, const Moving& by) {
    external -= r.owned_fraction * (dot(force, by.velocity) + dot(torque, by.spin));
  };
  const auto act = [&](int particle, const Vector3& force, const Vector3& torque,
                       const Moving& by) {
    if (particle < 0 || !mobile.moves(atom->mask[particle])) {
      put_in(force, torque, by);
    } else if (particle < atom->nlocal) {
      force_[particle] += force;
      torque_[particle] += torque;
    }
  };
  act(r.i, c.force_on_i(), c.torque_on_i(), grid.i);
  act(r.j, -c.force_on_i(), c.torque_on_j(), grid.j);
}

/// Power on the particles of this rank of all that is neither contact nor gravity, [energy/time].
double SampledEnergyTally::work_of_fixes(const MobileParticles& mobile) const {
  const Atom* const atom = lmp_->atom;
  const GravityOfFixes gravity(lmp_->modify);
  double power = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!mobile.moves(atom->mask[i])) continue;
    const Vector3 weight = atom->rmass[i] * gravity.on(atom->mask[i]);
    power += dot(vector(atom->f[i]) - force_[i] - weight, vector(atom->v[i])) +
             dot(vector(atom->torque[i]) - torque_[i], vector(atom->omega[i]));
  }
  return power;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
