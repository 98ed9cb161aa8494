// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_EXACT_CONTACTS_H
#define COHESION_EXACT_CONTACTS_H

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "atom.h"
#include "contact/adhesion.h"
#include "contact_interface.h"
#include "contact_range.h"
#include "contact_solver/contact_solver.h"
#include "contact_solver/contact_state.h"
#include "contact_solver/normal_energies.h"
#include "contact_solver/pair_motion.h"
#include "fix_accelerations.h"
#include "integrated_particles.h"
#include "neighbor.h"
#include "normal_model_probe.h"
#include "update.h"

namespace LAMMPS_NS {
class FixWallGran;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

struct LateWarning;

/// The contacts of one pair style or wall under scheme exact: passes the motion of a contact to its
/// solver (contact_solver/contact_solver.h), and stores its state in the engine's contact history,
/// with which it goes through exchange and restart. Other forces act as in the step before.
class ExactContacts {
 public:
  using Adhesion =
      std::function<cohesion::contact::Adhesion(int itype, int jtype, double ri, double rj)>;
  using ContactSolver = cohesion::contact_solver::ContactSolver;
  using ContactEnergies = cohesion::contact_solver::ContactEnergies;
  using MakeSolver = std::unique_ptr<ContactSolver> (*)(const cohesion::contact::NormalLaw&,
                                                        const cohesion::contact::Adhesion&,
                                                        double contact_distance, double step);

  /// who: in messages; wall: null for pairs. Adds to the history of contacts.
  ExactContacts(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* owner, LAMMPS_NS::FixWallGran* wall,
                const std::string& who);
  ~ExactContacts();

  /// Why contacts of this normal model, or the particles of the run, cannot be integrated; empty:
  /// they can.
  std::string obstacle(const NormalModelProbe& normal, int types) const;

  /// `adhesion`: of two types and radii; rj infinite: next to a wall; law: made of the engine's
  /// normal law for the same; maker: of the solver; range: beyond which nothing acts; frictional:
  /// whether friction acts in contacts.
  void connect(const NormalModelProbe& normal, Adhesion adhesion, ContactLaw law, MakeSolver maker,
               const ContactRange& range, bool frictional, int types);

  /// A step of a contact that was persistent in the last step and stays so, with its friction:
  /// sets `force` on i, away from j or the wall. False, and nothing done, where that is not
  /// certain. `energies`: may hold values of another contact; all losses of the normal motion
  /// are set, its stored energies only if `with_stored`; null: not needed.
  bool advance_persistent(ContactModels::SurfacesIntersectData& contact, double* spring,
                          double& force, ContactEnergies* energies, bool with_stored);

  /// r: distance of the centres, or from the wall; normal: from j, or the wall, to i. False, and
  /// `step` of no meaning: the contact does nothing. `energies`: zero; null: not needed.
  /// `with_stored`: whether stored energies are evaluated, too.
  bool advance(const ContactModels::SurfacesCloseData& d, double r, const double* normal,
               cohesion::contact_solver::ContactStep& step, ContactEnergies* energies,
               bool with_stored);

  /// Whether a pair has no history and nothing can happen to it in this step, as is true of most
  /// pairs of the engine's list. Cheaper than advance(), which returns false then.
  bool is_far(const ContactModels::SurfacesCloseData& d) const;

  /// Whether a contact with this history is in the range of its attraction.
  bool in_range(const double* history) const;

  /// Lets the engine's friction act in `step` with the repulsion of the contact, and beside a
  /// linear spring with the discrete K_t and eta_t that are exact at any step (DiscreteConstants).
  /// Where K_t grows with the overlap, the force stays and the displacement shrinks. `spring`: its
  /// displacement, which the engine will let grow through all of the step before, also where there
  /// was no contact; null: it has none.
  void set_friction(ContactModels::SurfacesIntersectData& contact,
                    const cohesion::contact_solver::ContactStep& step, double* spring) const;

 private:
  using ContactState = cohesion::contact_solver::ContactState;
  using StaggeredMotion = cohesion::contact_solver::StaggeredMotion;

  // What is stored of a contact: its state, the repulsion of the last step, and STEP, the step in
  // which all this was written, and 1. Next to a wall also the velocity of the wall along the
  // normal, and by how much it has changed the rate of the distance.
  enum { REPULSION = ContactState::size, STEP, SIZE, WALL_VELOCITY = SIZE, WALL_CHANGE, WALL_SIZE };

  struct FrictionOfRadius {
    double stiffness, damping_squared;
  };
  /// The bodies of a contact, and its solver.
  struct CachedContact {
    double ri = 0.0, rj = 0.0, mass_i = 0.0, mass_j = 0.0;
    std::unique_ptr<ContactSolver> solver;
    cohesion::contact_solver::DiscreteConstants tangential{};  ///< beside a linear spring
    /// Of a tangential spring that stiffens with the overlap; none: it does not.
    std::optional<cohesion::contact::NormalLaw> stiffening;
    /// Of a radius of contact that is not Hertz's, of which the engine's friction is: K_t, and
    /// eta_t squared, over LawPoint::radius_stiffness.
    std::optional<FrictionOfRadius> friction;
  };

  void exclude_impulse(const CachedContact&, const ContactModels::SurfacesCloseData& d,
                       const double* normal, const ContactState&);
  /// The solver of a contact; null: nothing that a force could move.
  CachedContact* cached_contact(const ContactModels::SurfacesCloseData& d) {
    CachedContact& k = cache_[d.itype * (types_ + 1) + d.jtype];
    const double rj = d.is_wall ? std::numeric_limits<double>::infinity() : d.radj;
    const double mass_i = mass(d.i), mass_j = d.is_wall ? 0.0 : mass(d.j);
    const bool is_same = k.solver && k.ri == d.radi && k.rj == rj && k.mass_i == mass_i &&
                         k.mass_j == mass_j && k.solver->step() == lmp_->update->dt;
    return is_same ? &k : renew(k, d, rj, mass_i, mass_j);
  }
  CachedContact* renew(CachedContact& k, const ContactModels::SurfacesCloseData& d, double rj,
                       double mass_i, double mass_j) const;
  /// The mass of a particle; 0: no force moves it.
  double mass(int particle) const {
    return mobile_.moves(atom_->mask[particle]) ? atom_->rmass[particle] : 0.0;
  }
  /// r: distance of the centres, or from the wall; normal: from j, or the wall, to i.
  static StaggeredMotion motion(const ContactModels::SurfacesCloseData& d, double r,
                                const double* normal) {
    const cohesion::Vector3 n = cohesion::vector(normal);
    const cohesion::Vector3 w = cohesion::vector(d.v_i) - cohesion::vector(d.v_j);
    const double rate = dot(w, n);
    return {r, rate, d.is_wall ? 0.0 : norm(w - rate * n)};
  }
  /// The velocity of a wall along the normal, and by how much it has changed the rate of the
  /// distance since the step before, [length/time].
  struct WallVelocity {
    double velocity, change;
    void store(double* history) const {
      history[WALL_VELOCITY] = velocity;
      history[WALL_CHANGE] = change;
    }
  };
  /// The velocity of a wall is constant in a step. Its change, as by a servo, acts as an impulse,
  /// but the part that the last two changes have in common counts as an acceleration. Adds the
  /// impulse to the last rate in `state`. `last`: the stored history; null: none.
  static WallVelocity pass_wall(const ContactModels::SurfacesCloseData& d, const double* normal,
                                const double* last, ContactState& state) {
    const double velocity = dot(cohesion::vector(d.v_j), cohesion::vector(normal));
    if (!last) return {velocity, 0.0};
    const double change = last[WALL_VELOCITY] - velocity, before = last[WALL_CHANGE];
    const double common =
        change * before > 0.0 ? std::min(std::abs(change), std::abs(before)) : 0.0;
    state.last_rate += change - std::copysign(common, change);
    return {velocity, change};
  }
  double acceleration(const ContactModels::SurfacesCloseData& d,
                      const cohesion::Vector3& normal) const;
  /// Sets the stored energies of a step of advance_persistent(). `last_rate`: of the distance, with
  /// the impulse of the wall; `after`: the state that the solver left.
  void set_stored(const ContactSolver& solver, const ContactModels::SurfacesIntersectData& contact,
                  double last_rate, const ContactState& after, ContactEnergies& energies) const;
  bool repeat(const CachedContact& k, const ContactModels::SurfacesCloseData& d,
              cohesion::contact_solver::ContactStep& step, ContactState& state) const;
  bool was_in_range(const ContactModels::SurfacesCloseData&) const;
  const double* last_record(const ContactModels::SurfacesCloseData& d) const;
  void hold(const ContactModels::SurfacesCloseData& d) const;
  void write(const ContactModels::SurfacesCloseData& d, const ContactState& state,
             const cohesion::contact_solver::ContactStep& step) const;
  /// `time_apart`: how much of the step before it was no contact, [time].
  static void set_friction(ContactModels::SurfacesIntersectData& contact, const CachedContact& k,
                           const cohesion::contact_solver::PersistentStep& step, double time_apart,
                           double* spring);
  void make_solver(CachedContact& k, const ContactModels::SurfacesCloseData& d) const;
  /// Warns of a contact that overlaps and was beyond what is seen in the step before.
  void check_sight(const ContactSolver& solver, const ContactModels::SurfacesCloseData& d,
                   const StaggeredMotion& now) const;
  std::string names(const ContactModels::SurfacesCloseData& d) const;

  LAMMPS_NS::LAMMPS* lmp_;
  LAMMPS_NS::Atom* atom_;
  LAMMPS_NS::FixWallGran* wall_;
  std::string who_;
  int offset_;
  const NormalModelProbe* normal_ = nullptr;
  Adhesion adhesion_;
  ContactLaw contact_law_;
  MakeSolver make_solver_ = nullptr;
  ContactRange range_;
  FixAccelerations* accelerations_ = nullptr;
  IntegratedParticles mobile_;
  std::vector<CachedContact> cache_;  // the last of each two types
  const CachedContact* last_contact_ = nullptr;
  double time_apart_ = 0.0;  // how much of the step before the last contact was none
  bool frictional_ = false;
  int types_ = 0;
  std::shared_ptr<LateWarning> late_, cut_short_;
};

inline bool ExactContacts::advance_persistent(ContactModels::SurfacesIntersectData& contact,
                                              double* spring, double& force,
                                              ContactEnergies* energies, bool with_stored) {
  double* const history = contact.contact_history + offset_;
  const double now = accelerations_->clock();
  if (ContactState::phase_of(history) != ContactState::persistent || history[STEP] != now)
    return false;
  if (!contact.computeflag || !contact.shearupdate) return false;
  const CachedContact* const k = cached_contact(contact);
  if (!k) return false;
  ContactState state = ContactState::stored_persistent(history);
  const double time_apart = k->solver->step() - state.contact_time;
  cohesion::contact_solver::PersistentStep step;
  const cohesion::Vector3 w = cohesion::vector(contact.v_i) - cohesion::vector(contact.v_j);
  const double rate = dot(w, cohesion::vector(contact.en));
  WallVelocity wall;
  if (contact.is_wall) wall = pass_wall(contact, contact.en, history, state);
  const double speed_squared = contact.is_wall ? rate * rate : dot(w, w);
  const auto distance = cohesion::contact_solver::DistanceMotion::of_pair(
      contact.r, contact.rinv, rate, speed_squared, k->solver->step());
  const double last_rate = state.last_rate;
  if (!k->solver->advance_persistent(distance, state, step)) return false;
  if (state.phase != ContactState::persistent) return false;
  if (energies) {
    set_persistent_losses(step, *energies);
    if (with_stored) set_stored(*k->solver, contact, last_rate, state, *energies);
  }
  force = state.force;
  set_friction(contact, *k, step, time_apart, spring);
  state.store_persistent(history);
  if (contact.is_wall) wall.store(history);
  history[REPULSION] = step.repulsion;
  history[STEP] = now + 1.0;
  if (contact.contact_flags) *contact.contact_flags |= ContactModels::CONTACT_COHESION_MODEL;
  return true;
}

inline bool ExactContacts::is_far(const ContactModels::SurfacesCloseData& d) const {
  // A triangle of a mesh has the memory of its neighbours; how far nothing attracts is not told.
  if (d.is_wall || !(range_.gap + range_.ratio > 0.0)) return false;
  if (*d.contact_flags & ContactModels::CONTACT_COHESION_MODEL) return false;
  // With a new list the engine has the memory, but not whose it is.
  if (lmp_->neighbor->ago == 0) return false;
  const double dt = lmp_->update->dt;
  const cohesion::Vector3 w = cohesion::vector(d.v_i) - cohesion::vector(d.v_j);
  const double outer = d.radsum + range_.gap + range_.ratio * d.radsum;
  const double by_others = outer + 2.0 * dt * dt * accelerations_->largest();
  // r > by_others + dt closing, times r
  const double flown = dt * std::max(-dot(w, cohesion::vector(d.delta)), 0.0);
  const double left = d.rsq - (1.0 + 1e-12) * flown;
  return left > 0.0 && left * left > (1.0 + 3e-12) * by_others * by_others * d.rsq;
}

inline void ExactContacts::set_friction(ContactModels::SurfacesIntersectData& contact,
                                        const CachedContact& k,
                                        const cohesion::contact_solver::PersistentStep& step,
                                        double time_apart, double* spring) {
  contact.Fn = std::max(step.repulsion, 0.0);
  if (!k.stiffening) {
    contact.kt = k.tangential.stiffness;
    contact.gammat = k.tangential.damping;
  }
  const auto radius_stiffness = [&](double overlap) {
    return cohesion::contact::point_of(*k.stiffening, overlap).radius_stiffness;
  };
  double here = step.at.radius_stiffness;
  if (k.stiffening && here == 0.0) here = radius_stiffness(contact.deltan);
  if (k.friction) {
    contact.kt = k.friction->stiffness * here;
    contact.gammat = std::sqrt(k.friction->damping_squared * here);
  }
  if (!spring || !contact.shearupdate) return;
  double weight = 1.0;
  if (k.stiffening) {
    const double before = step.radius_stiffness_before >= 0.0
                              ? step.radius_stiffness_before
                              : radius_stiffness(contact.deltan + k.solver->step() * contact.vn);
    const double left = cohesion::contact::stretch_left(before, here);
    for (int d = 0; d < 3; d++) spring[d] *= left;
    weight = cohesion::contact::displacement_weight(left);
  }
  // The spring takes `weight` of the displacement in contact. The engine will add that of the whole
  // step: what is too much, as a time.
  const double too_much = (1.0 - weight) * k.solver->step() + weight * time_apart;
  if (too_much == 0.0) return;
  const double slip[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
  for (int d = 0; d < 3; d++) spring[d] -= too_much * slip[d];
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
