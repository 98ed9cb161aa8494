// SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <algorithm>
#include <sstream>
#include <string>

#include "common/guarded.h"
#include "common/message.h"
#include "contact_models.h"
#include "domain.h"
#include "encounter.h"
#include "exact_contacts.h"
#include "fix_contact_advice.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "hidden_fix.h"
#include "mesh_contact.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"
#include "vector3.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;

namespace {

constexpr const char* seen_too_late =
    ", scheme exact: a pair came nearer by more than 0.03 of its radii in one step, from beyond "
    "what is seen, and when it touched is not known exactly: use a smaller time step; first ";

constexpr const char* turned_too_often =
    ", scheme exact: a pair, or a particle and a wall, turned round a hundred times or more within "
    "one step, between contact and the edge of the adhesion or along that edge, and was not "
    "resolved to the end of that step: use a smaller time step; first ";

}  // namespace

ExactContacts::ExactContacts(LAMMPS* lmp, IContactHistorySetup* owner, FixWallGran* wall,
                             const std::string& who)
    : lmp_(lmp), atom_(lmp->atom), wall_(wall), who_(who), mobile_(lmp) {
  // "0": the same seen from the other particle.
  offset_ = owner->add_history_value("contact0", "0");
  for (int k = 1; k < (wall ? WALL_SIZE : SIZE); k++)
    owner->add_history_value(("contact" + std::to_string(k)).c_str(), "0");
}

ExactContacts::~ExactContacts() = default;

void ExactContacts::connect(const NormalModelProbe& normal, Adhesion adhesion, ContactLaw law,
                            MakeSolver maker, const ContactRange& range, bool frictional,
                            int types) {
  normal_ = &normal;
  adhesion_ = std::move(adhesion);
  contact_law_ = std::move(law);
  make_solver_ = maker;
  range_ = range;
  frictional_ = frictional;
  types_ = types;
  cache_.clear();
  cache_.resize((types + 1) * (types + 1));
  mobile_ = IntegratedParticles(lmp_);
  // A fix that is made while fixes are set up, as walls are, is called in the next run only.
  accelerations_ =
      wall_ ? find_hidden_fix<FixAccelerations>(lmp_) : &hidden_fix<FixAccelerations>(lmp_);
  if (!accelerations_)
    LAMMPS_NS::stop(lmp_, FLERR, who_, ", scheme exact, fix wall/gran ", wall_->id,
                    ": needs a pair_style gran of scheme exact, too; without attraction between "
                    "particles, use it with a strength of 0 between them");
  auto& warnings = hidden_fix<FixContactAdvice>(lmp_);
  late_ = warnings.late_warning(who_ + seen_too_late);
  cut_short_ = warnings.late_warning(who_ + turned_too_often);
}

std::string ExactContacts::obstacle(const NormalModelProbe& normal, int types) const {
  const std::string bodies = FixAccelerations::rigid_bodies(*lmp_->modify);
  if (!bodies.empty())
    return bodies + " moves bodies of several spheres, and it resolves spheres that move each by " +
           "itself";
  const auto of_model = [&](const std::string& why) {
    return "model " + normal.name() + " " + why;
  };
  if (normal.exponent() != 1.0 && normal.exponent() != 1.5)
    return of_model("has a spring that is neither linear nor Hertz's");
  for (int i = 1; i <= types; i++)
    for (int j = 1; j <= types; j++) {
      if (normal.dashpot_varies(i, j))
        return of_model("has a dashpot that depends on the speed (viscous)");
      if (normal.limits_force(i, j))
        return of_model("cuts the force off where the dashpot pulls (limitForce)");
    }
  return "";
}

ExactContacts::CachedContact* ExactContacts::renew(CachedContact& k,
                                                   const ContactModels::SurfacesCloseData& d,
                                                   double rj, double mass_i, double mass_j) const {
  if (mass_i == 0.0 && mass_j == 0.0) return nullptr;
  k = {};
  k.ri = d.radi;
  k.rj = rj;
  k.mass_i = mass_i;
  k.mass_j = mass_j;
  make_solver(k, d);
  return &k;
}

void ExactContacts::make_solver(CachedContact& k, const ContactModels::SurfacesCloseData& d) const {
  const auto inverse = [](double mass) { return mass > 0.0 ? 1.0 / mass : 0.0; };
  const double reduced_mass = 1.0 / (inverse(k.mass_i) + inverse(k.mass_j));
  const double dt = lmp_->update->dt;
  guarded(lmp_, who_, [&] {
    const NormalModelProbe::ProbedContact pair{
        d.itype, d.jtype, d.radi, d.is_wall ? d.radi : d.radj, reduced_mass, 0.0, d.is_wall};
    const cohesion::contact::NormalLaw normal =
        contact_law_(normal_->law(pair), d.itype, d.jtype, d.radi, k.rj);
    k.solver = make_solver_(normal, adhesion_(d.itype, d.jtype, d.radi, k.rj), d.radsum, dt);
    if (frictional_) k.solver->leave_out_exchange();
    if (!cohesion::contact::is_linear(normal)) {
      k.stiffening = normal;
      using cohesion::contact::HertzSpringDashpot;
      if (!std::holds_alternative<HertzSpringDashpot>(normal)) {
        const auto springs = normal_->springs(pair);
        const double of_hertz = HertzSpringDashpot::radius_stiffness_of(springs.stiffness);
        k.friction = {springs.tangential_stiffness / of_hertz,
                      springs.tangential_damping * springs.tangential_damping / of_hertz};
      }
      return;
    }
    const auto springs = normal_->springs(pair);
    // The effective mass at the surface of solid spheres, which turn: 1/m + r^2/I of each.
    const double tangential_mass =
        reduced_mass / (1.0 + 1.0 / IntegratedParticles::inertia_factor(lmp_->domain->dimension));
    k.tangential = cohesion::contact_solver::discrete_constants(
        springs.tangential_stiffness, springs.tangential_damping, tangential_mass, dt);
  });
}

/// The acceleration of the distance by all forces of the step before, [length/time^2].
double ExactContacts::acceleration(const ContactModels::SurfacesCloseData& d,
                                   const cohesion::Vector3& n) const {
  double by_all = 0.0;
  if (mobile_.moves(atom_->mask[d.i])) by_all += dot(accelerations_->acceleration(d.i), n);
  if (!d.is_wall && mobile_.moves(atom_->mask[d.j]))
    by_all -= dot(accelerations_->acceleration(d.j), n);
  return by_all;
}

/// What the step before has left of the contact, or of one with the triangle of the mesh that it
/// has come from; nullptr: nothing.
const double* ExactContacts::last_record(const ContactModels::SurfacesCloseData& d) const {
  const double* const history = d.contact_history + offset_;
  const double now = accelerations_->clock();
  if (history[STEP] == now) return history;
  if (!d.mesh) return nullptr;
  const double* const before =
      history_before(*d.fix_mesh, d.j, d.i, atom_->x[d.i], d.radi, offset_ + STEP, now);
  return before ? before + offset_ : nullptr;
}

void ExactContacts::set_stored(const ContactSolver& solver,
                               const ContactModels::SurfacesIntersectData& contact,
                               double last_rate, const ContactState& after,
                               ContactEnergies& energies) const {
  ContactState before = ContactState::stored_persistent(contact.contact_history + offset_);
  before.last_rate = last_rate;
  const StaggeredMotion at = motion(contact, contact.r, contact.en);
  set_normal_stored(solver, {at, 0.0, false, before, after, after.force, 0.0}, contact.radsum,
                    energies);
}

bool ExactContacts::advance(const ContactModels::SurfacesCloseData& d, double r,
                            const double* normal, ContactStep& step, ContactEnergies* energies,
                            bool with_stored) {
  const bool first = d.computeflag && !d.shearupdate;
  CachedContact* const k = cached_contact(d);
  last_contact_ = k;
  time_apart_ = 0.0;
  if (!k) {
    hold(d);
    return false;
  }
  ContactState state;
  if (!d.computeflag || (first && accelerations_->last_step() > 0.0)) {
    if (repeat(*k, d, step, state)) {
      // What it stores under a load is that of the last step.
      if (energies && state.in_range()) {
        energies->stored.spring = k->solver->spring_energy(d.radsum - r);
        energies->stored.adhesion = k->solver->adhesion_energy(d.radsum - r);
      }
      remember(d, true);
      exclude_impulse(*k, d, normal, state);
      return true;
    }
    if (!d.computeflag) return false;
  }
  const double* const last = first ? nullptr : last_record(d);
  state = last ? ContactState::stored(last) : ContactState{ContactState::unknown};
  // What binds a pair, such as a bridge, is not to be seen from its distance.
  if (first && was_in_range(d) && r <= k->solver->outer_distance())
    state.phase = ContactState::held;
  time_apart_ = k->solver->step() - state.contact_time;
  const StaggeredMotion now = motion(d, r, normal);
  if (d.is_wall) pass_wall(d, normal, last, state).store(d.contact_history + offset_);
  const double by_all = first ? 0.0 : acceleration(d, cohesion::vector(normal));
  const double external = first ? 0.0 : k->solver->external(by_all, now, state);
  if (state.is_outside()) {
    if (!k->solver->within_reach(now, external)) {
      remember(d, false);
      return false;
    }
    if (!first) check_sight(*k->solver, d, now);
  }
  const double velocity_step = first ? 0.5 * k->solver->step() : k->solver->step();
  const ContactState before = state;
  step = k->solver->advance(now, external, velocity_step, state);
  if (energies) {
    const SolvedStep solved{now, external, first, before, state, step.force, step.dissipated};
    set_normal_losses(*k->solver, solved, *energies);
    if (with_stored) set_normal_stored(*k->solver, solved, d.radsum, *energies);
  }
  if (step.record.unresolved) cut_short_->found(names(d));
  write(d, state, step);
  exclude_impulse(*k, d, normal, state);
  return true;
}

/// A pair that does not overlap yet is resolved from this step on and needs no warning. Nor does
/// one that was within the margin a step ago. The step that the warning names is the one in which
/// the pair crosses MARGIN, so that its energy account closes, too (contact_range.h).
void ExactContacts::check_sight(const ContactSolver& solver,
                                const ContactModels::SurfacesCloseData& d,
                                const StaggeredMotion& now) const {
  const double way = -solver.step() * now.rate;
  if (late_->due || now.distance >= solver.entry_distance() ||
      now.distance + way <= solver.outer_distance() + EXACT_MARGIN * d.radsum)
    return;
  std::ostringstream where;
  where.precision(3);
  where << names(d) << ", by " << way / d.radsum << " of the radii at " << -now.rate
        << ": a time step of " << solver.step() * MARGIN * d.radsum / way << " would do";
  late_->found(where.str());
}

std::string ExactContacts::names(const ContactModels::SurfacesCloseData& d) const {
  const std::string one = std::to_string(atom_->tag[d.i]);
  return d.is_wall ? "particle " + one + " and fix wall/gran " + wall_->id
                   : "particles " + one + " and " + std::to_string(atom_->tag[d.j]);
}

/// Excludes the force of an impulse from the accelerations that other contacts of both particles
/// see.
void ExactContacts::exclude_impulse(const CachedContact& k,
                                    const ContactModels::SurfacesCloseData& d, const double* normal,
                                    const ContactState& state) {
  if (state.force == 0.0 || !k.solver->gave_impulse(state)) return;
  const cohesion::Vector3 on_i = state.force * cohesion::vector(normal);
  if (mobile_.moves(atom_->mask[d.i])) accelerations_->exclude(d.i, on_i);
  if (!d.is_wall && mobile_.moves(atom_->mask[d.j])) accelerations_->exclude(d.j, -on_i);
}

/// Whether the contact was in range when the last run ended.
bool ExactContacts::was_in_range(const ContactModels::SurfacesCloseData& d) const {
  const double* const history = d.contact_history + offset_;
  return history[STEP] == accelerations_->clock() + 1.0 && ContactState::stored(history).in_range();
}

bool ExactContacts::in_range(const double* history) const {
  ContactState state;
  if (history) state.phase = ContactState::phase_of(history + offset_);
  return state.in_range();
}

/// A step that is computed again, as each run does with the last one, repeats its force. A run of
/// another step begins anew, but for impulses: the half that is to come is another force then.
bool ExactContacts::repeat(const CachedContact& k, const ContactModels::SurfacesCloseData& d,
                           ContactStep& step, ContactState& state) const {
  double* const history = d.contact_history + offset_;
  if (history[STEP] != accelerations_->clock() + 1.0) return false;
  state = ContactState::stored(history);
  if (state.phase == ContactState::held) return false;
  const double now = lmp_->update->dt, then = accelerations_->last_step();
  if (d.computeflag && then != now) {
    if (state.force == 0.0 || !k.solver->gave_impulse(state)) return false;
    state.force *= then / now;
    state.store(history);
  }
  step = {};
  step.force = state.force;
  step.repulsion = history[REPULSION];
  step.record.contact_time = state.contact_time;
  return true;
}

/// Leaves a contact in range that nothing could move in this step.
void ExactContacts::hold(const ContactModels::SurfacesCloseData& d) const {
  if (!d.computeflag || !d.shearupdate)
    remember(d, was_in_range(d));  // a step that is computed again
  else if (const double* const last = last_record(d))
    write(d, ContactState::stored(last).hold(), {});
}

void ExactContacts::write(const ContactModels::SurfacesCloseData& d, const ContactState& state,
                          const ContactStep& step) const {
  double* const history = d.contact_history + offset_;
  state.store(history);
  history[REPULSION] = step.repulsion;
  history[STEP] = accelerations_->clock() + 1.0;
  remember(d, state.phase != ContactState::outside || step.force != 0.0);
}

void ExactContacts::set_friction(ContactModels::SurfacesIntersectData& contact,
                                 const ContactStep& step, double* spring) const {
  if (last_contact_)
    set_friction(contact, *last_contact_, {0.0, step.repulsion, 0.0}, time_apart_, spring);
  else
    contact.Fn = std::max(step.repulsion, 0.0);
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
