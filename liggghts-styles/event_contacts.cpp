// SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <algorithm>

#include "contact_models.h"
#include "domain.h"
#include "error.h"
#include "event_contacts.h"
#include "fix_contact_advice.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "guarded.h"
#include "hidden_fix.h"
#include "mesh_contact.h"
#include "neighbor.h"
#include "update.h"
#include "vector3.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;
using namespace cohesion::event_stepping;

namespace {

constexpr const char* seen_too_late =
    ", scheme event: a pair came nearer by more than 0.01 of its radii in one step, from beyond "
    "what is seen, and when it touched is not known exactly: use a smaller time step";

constexpr const char* turned_too_often =
    ", scheme event: a pair, or a particle and a wall, turned round a hundred times or more within "
    "one step, between contact and the edge of the adhesion or along that edge, and was not "
    "followed to the end of that step: use a smaller time step";

/// Without this flag the engine forgets the contact when it makes a new list.
void remember(const ContactModels::SurfacesCloseData& d, bool something) {
  if (!d.contact_flags) return;
  if (something)
    *d.contact_flags |= ContactModels::CONTACT_COHESION_MODEL;
  else
    *d.contact_flags &= ~ContactModels::CONTACT_COHESION_MODEL;
}

}  // namespace

EventContacts::EventContacts(LAMMPS* lmp, IContactHistorySetup* owner, FixWallGran* wall,
                             const std::string& who)
    : lmp_(lmp), atom_(lmp->atom), wall_(wall), who_(who), mobile_(lmp) {
  // "0": the same seen from the other particle.
  offset_ = owner->add_history_value("eventPhase", "0");
  for (const char* const name :
       {"eventAhead", "eventForce", "eventRepulsion", "eventTouch", "eventStep", "eventWork"})
    owner->add_history_value(name, "0");
}

EventContacts::~EventContacts() = default;

void EventContacts::connect(const NormalModelProbe& normal, Adhesion adhesion, MakeLaw maker,
                            const ContactRange& range, int types) {
  normal_ = &normal;
  adhesion_ = std::move(adhesion);
  make_law_ = maker;
  range_ = range;
  types_ = types;
  known_.clear();
  known_.resize((types + 1) * (types + 1));
  mobile_ = MobileParticles(lmp_);
  // A fix that is made while fixes are set up, as walls are, is called in the next run only.
  others_ = wall_ ? find_hidden_fix<FixOthers>(lmp_) : &hidden_fix<FixOthers>(lmp_);
  if (!others_)
    lmp_->error->all(FLERR, (who_ + ", scheme event, fix wall/gran " + wall_->id +
                             ": needs a pair_style gran of scheme event, too; without attraction "
                             "between particles, use it with a strength of 0 between them")
                                .c_str());
  auto& warnings = hidden_fix<FixContactAdvice>(lmp_);
  late_ = warnings.late_warning(who_ + seen_too_late);
  cut_short_ = warnings.late_warning(who_ + turned_too_often);
  const auto reject = [&](const std::string& why) {
    lmp_->error->all(FLERR, (who_ + ", scheme event: model " + normal.name() + " " + why +
                             ": use 'scheme sampled', or model hooke or hooke/stiffness as it is "
                             "by default")
                                .c_str());
  };
  if (normal.exponent() != 1.0) reject("has a spring whose motion has no closed form");
  for (int i = 1; i <= types; i++)
    for (int j = 1; j <= types; j++) {
      if (normal.dashpot_varies(i, j)) reject("has a dashpot that depends on the speed (viscous)");
      if (normal.limits_force(i, j))
        reject("cuts the force off where the dashpot pulls (limitForce)");
    }
}

EventContacts::KnownContact* EventContacts::know(KnownContact& k,
                                                 const ContactModels::SurfacesCloseData& d,
                                                 double rj, double mass_i, double mass_j) const {
  if (mass_i == 0.0 && mass_j == 0.0) return nullptr;
  k = {};
  k.ri = d.radi;
  k.rj = rj;
  k.mass_i = mass_i;
  k.mass_j = mass_j;
  make_law(k, d);
  return &k;
}

void EventContacts::make_law(KnownContact& k, const ContactModels::SurfacesCloseData& d) const {
  const auto inverse = [](double mass) { return mass > 0.0 ? 1.0 / mass : 0.0; };
  k.inverse_mass = inverse(k.mass_i) + inverse(k.mass_j);
  const double reduced_mass = 1.0 / k.inverse_mass, dt = lmp_->update->dt;
  guarded(lmp_, who_, [&] {
    const NormalModelProbe::Pair pair{d.itype,      d.jtype, d.radi,   d.is_wall ? d.radi : d.radj,
                                      reduced_mass, 0.0,     d.is_wall};
    const auto springs = normal_->springs(pair);
    const cohesion::contact::LinearSpringDashpot spring(springs.stiffness, springs.damping,
                                                        reduced_mass);
    const auto adhesion = adhesion_(d.itype, d.jtype, d.radi, k.rj);
    k.well = adhesion.force == 0.0;
    k.law = make_law_(spring, adhesion, d.radsum, dt);
    // The effective mass at the surface of solid spheres, which turn: 1/m + r^2/I of each.
    const double tangential_mass =
        reduced_mass / (1.0 + 1.0 / MobileParticles::inertia_factor(lmp_->domain->dimension));
    k.tangential = spring_on_grid(springs.tangential_stiffness, normal_->tangential_damping(pair),
                                  tangential_mass, dt);
  });
}

/// The acceleration of the distance by all forces of the step before, [length/time^2].
double EventContacts::others(const ContactModels::SurfacesCloseData& d,
                             const cohesion::Vector3& n) const {
  double by_all = 0.0;
  if (mobile_.moves(atom_->mask[d.i])) by_all += dot(others_->acceleration(d.i), n);
  if (!d.is_wall && mobile_.moves(atom_->mask[d.j])) by_all -= dot(others_->acceleration(d.j), n);
  return by_all;
}

/// What the step before has left of the contact, or of one with the triangle of the mesh that it
/// has come from; nullptr: nothing.
const double* EventContacts::last_record(const ContactModels::SurfacesCloseData& d) const {
  const double* const history = d.contact_history + offset_;
  const double now = others_->clock();
  if (history[STEP] == now) return history;
  if (!d.mesh) return nullptr;
  const double* const before =
      history_before(*d.fix_mesh, d.j, d.i, atom_->x[d.i], d.radi, offset_ + STEP, now);
  return before ? before + offset_ : nullptr;
}

bool EventContacts::follow(const ContactModels::SurfacesCloseData& d, double r,
                           const double* normal, GridStep& step) {
  const bool first = d.computeflag && !d.shearupdate;
  KnownContact* const k = known_contact(d);
  followed_ = k;
  time_apart_ = 0.0;
  if (!k) return false;
  if (!d.computeflag || (first && others_->last_step() > 0.0)) {
    if (repeat(*k, d, step)) {
      remember(d, true);
      exclude_impulse(*k, d, normal, step);
      return true;
    }
    if (!d.computeflag) return false;
  }
  const double* const last = first ? nullptr : last_record(d);
  GridMemory memory;
  if (last) {
    memory.phase = static_cast<GridMemory::Phase>(static_cast<int>(last[PHASE]));
    memory.ahead = last[AHEAD];
    memory.force = last[FORCE];
    memory.work = last[WORK];
  }
  memory.is_new = !last;
  time_apart_ = k->law->step() * (1.0 - (last ? last[TOUCH] : 0.0));
  const cohesion::Vector3 n = cohesion::vector(normal);
  const cohesion::Vector3 w = cohesion::vector(d.v_i) - cohesion::vector(d.v_j);
  GridPoint at{r, dot(w, n), 0.0};
  if (!d.is_wall) at.sideways = norm(w - at.radial * n);
  double by_others = 0.0;
  if (!first) by_others = others(d, n);
  if (last && !is_impulse(*k, last[TOUCH])) by_others -= last[FORCE] * k->inverse_mass;
  if (!k->law->follow_lasting(at, by_others, memory, step)) {
    if (memory.phase == GridMemory::beyond) {
      if (!k->law->within_reach(at, by_others)) {
        remember(d, false);
        return false;
      }
      const double seen = (1.0 + MARGIN) * d.radsum + k->law->range();
      if (!first && r - k->law->step() * at.radial > seen) late_->due = true;
    }
    step = k->law->follow(at, by_others, first ? 0.5 * k->law->step() : k->law->step(), memory);
  }
  if (step.normal.unresolved) cut_short_->due = true;
  write(*k, d, memory, step);
  exclude_impulse(*k, d, normal, step);
  return true;
}

/// Whether the force of a step was that of an impulse, over when the step was: at a well's edge.
bool EventContacts::is_impulse(const KnownContact& k, double contact_time) {
  return k.well && contact_time == 0.0;
}

/// Excludes the force of an impulse from what other contacts of both particles take for lasting.
void EventContacts::exclude_impulse(const KnownContact& k,
                                    const ContactModels::SurfacesCloseData& d, const double* normal,
                                    const GridStep& step) {
  if (step.force == 0.0 || !is_impulse(k, step.normal.contact_time)) return;
  const cohesion::Vector3 on_i = step.force * cohesion::vector(normal);
  if (mobile_.moves(atom_->mask[d.i])) others_->exclude(d.i, on_i);
  if (!d.is_wall && mobile_.moves(atom_->mask[d.j])) others_->exclude(d.j, -on_i);
}

bool EventContacts::in_range(const double* history) const {
  GridMemory memory;
  if (history) memory.phase = static_cast<GridMemory::Phase>(static_cast<int>(history[offset_]));
  return memory.inside();
}

/// A step that is computed again, as each run does with the last one, repeats its force. A run of
/// another step begins anew, but for impulses: the half that is to come is another force then.
bool EventContacts::repeat(const KnownContact& k, const ContactModels::SurfacesCloseData& d,
                           GridStep& step) const {
  double* const history = d.contact_history + offset_;
  if (history[STEP] != others_->clock() + 1.0) return false;
  const double now = lmp_->update->dt, then = others_->last_step();
  if (d.computeflag && then != now) {
    if (history[FORCE] == 0.0 || !is_impulse(k, history[TOUCH])) return false;
    history[FORCE] *= then / now;
  }
  step = {};
  step.force = history[FORCE];
  step.repulsion = history[REPULSION];
  step.normal.contact_time = history[TOUCH] * k.law->step();
  return true;
}

void EventContacts::write(const KnownContact& k, const ContactModels::SurfacesCloseData& d,
                          const GridMemory& memory, const GridStep& step) const {
  double* const history = d.contact_history + offset_;
  history[PHASE] = memory.phase;
  history[AHEAD] = memory.ahead;
  history[FORCE] = memory.force;
  history[WORK] = memory.work;
  history[REPULSION] = step.repulsion;
  history[TOUCH] = step.normal.contact_time / k.law->step();
  history[STEP] = others_->clock() + 1.0;
  remember(d, memory.phase != GridMemory::beyond || step.force != 0.0);
}

void EventContacts::set_friction(ContactModels::SurfacesIntersectData& contact,
                                 const GridStep& step, double* spring) const {
  if (followed_)
    set_friction(contact, *followed_, step.repulsion, time_apart_, spring);
  else
    contact.Fn = std::max(step.repulsion, 0.0);
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
