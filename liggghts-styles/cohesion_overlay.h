// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_COHESION_OVERLAY_H
#define COHESION_COHESION_OVERLAY_H

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>

#include "atom.h"
#include "cohesion_model_base.h"
#include "cohesive_pairs.h"
#include "common/message.h"
#include "contact_models.h"
#include "contact_range.h"
#include "encounter.h"
#include "error.h"
#include "exact_contacts.h"
#include "fix_contact_advice.h"
#include "fix_energy_tally.h"
#include "fix_partner_ids.h"
#include "fix_restart_contacts.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "hidden_fix.h"
#include "mesh_contact.h"
#include "model_advice.h"
#include "normal_model_probe.h"
#include "pair_gran.h"
#include "word_settings.h"

namespace LIGGGHTS {
namespace Cohesion {
class HamakerAttraction;
}

namespace ContactModels {

/// A cohesion laid over whatever contact model it is combined with, at overlap and across a gap.
/// `Attraction` says what is its own; CohesionDefaults has what most have in common:
///
///   MODEL                          name in a script
///   Solver                         of scheme exact: ContactSolver, or one that derives from it
///   HAS_SAMPLED                    false: it has no scheme sampled
///   BINDS_WHAT_ENTERED             true: what entered is bound, wherever it stands
///   Attraction(lmp, owner, wall)   wall: null for pairs
///   registerSettings(settings)     its keywords
///   connect(registry, normal)      reads the parameters; normal: of the contact
///   adhesion(i, j, ri, rj)         of two types and radii; rj infinite: beside a wall
///   contact_law(normal, i, j, ri, rj)
///                                  of scheme exact, made of the engine's normal law
///   material(i, j)                 that a contact of two types stands for
///   material_words(normal)         by which a script gives it; empty: it cannot
///   doubt(i, j)                    what to say of numbers that no material has; empty: nothing
///   range()                        how far it must see (contact_range.h)
///   is_active()                    false: all types have strength 0, and nothing is remembered
///   is_out_of_reach(near, update_all)
///                                  true: no force, and its memory stays as it is; update_all: the
///                                  memory of every pair has to be brought up to date
///   is_idle(near), is_idle_in_contact(contact)
///                                  true: no force on one that is bound, which it has then marked
///                                  to be remembered; not called while all bound ones are listed
///   force(encounter)               attraction, [force]; called once per step and contact
///   binds(i, j, ri, rj, gap, history)  whether a pair is bound (cohesive_pairs.h)
///   energy(i, j, ri, rj, gap, remembered)
///                                  of the attraction, zero far away, [energy]; rj infinite: beside
///                                  a wall; remembered: what the model stores of the contact
template <class Attraction>
class CohesionOverlay : public CohesionModelBase, private Cohesion::CohesivePairs {
 public:
  CohesionOverlay(LAMMPS* lmp, IContactHistorySetup* owner, ContactModelBase* model)
      : CohesionModelBase(lmp, owner, model),
        CohesivePairs(lmp, owner, model->is_wall()),
        wall_(model->is_wall() ? static_cast<FixWallGran*>(owner) : nullptr),
        pair_(wall_ ? nullptr : static_cast<PairGran*>(owner)),
        attraction_(lmp, owner, wall_) {
    // Tangential and rolling model come next, and add what they remember then.
    others_history_ = wall_ ? wall_->dnum() : pair_->dnum_pair();
  }

  void registerSettings(Settings& settings) override {
    Cohesion::register_scheme(lmp, settings, name(), scheme_);
    attraction_.registerSettings(settings);
    make_probe();
    normal_->registerSettings(settings);
  }
  void postSettings(IContactHistorySetup* owner, ContactModelBase*) override {
    if (!Attraction::HAS_SAMPLED && scheme_ == Cohesion::SchemeChoice::sampled)
      LAMMPS_NS::stop(lmp, FLERR, name(),
                      " has no scheme sampled: use 'scheme exact', its default");
    if (scheme_ == Cohesion::SchemeChoice::none && !wall_)
      Cohesion::tell_of_restart_files(lmp, name());
    if (scheme_ != Cohesion::SchemeChoice::sampled)
      exact_contacts_ = std::make_unique<Cohesion::ExactContacts>(lmp, owner, wall_, name());
    has_scheme_of_pairs_ =
        wall_ && Attraction::HAS_SAMPLED && scheme_ == Cohesion::SchemeChoice::none;
  }

  void connectToProperties(PropertyRegistry& registry) override {
    if (!atom->sphere_flag)
      LAMMPS_NS::stop(lmp, FLERR, name(), ": needs spheres, use atom_style granular");
    if (force->cg_active()) error->cg(FLERR, name().c_str());
    if (!normal_) make_probe();  // from a restart file, which keeps no settings
    normal_->connect(registry);
    choose_scheme(registry.max_type());
    attraction_.connect(registry, *normal_);
    Cohesion::hidden_fix<Cohesion::FixContactAdvice>(lmp).ask(advice_);
    if (!wall_) {
      Cohesion::hidden_fix<Cohesion::FixPartnerIds>(lmp);
      Cohesion::hidden_fix<Cohesion::FixRestartContacts>(lmp);
    }
    connect_tally();
    Cohesion::ContactRange range = attraction_.range();
    if (exact_) {
      connect_exact(registry);
      range.margin = Cohesion::EXACT_MARGIN;
    }
    Cohesion::require_range(lmp, registry, wall_, name(), range);
  }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    if (exact_)
      advance(contact, on_i, on_j);
    else if (attraction_.is_active() && (list_all_ || !attraction_.is_idle_in_contact(contact)))
      attract(contact, contact.r, contact.en, on_i, on_j);
  }

  void surfacesClose(SurfacesCloseData& near, ForceData& on_i, ForceData& on_j) override {
    if (exact_) {
      if (!exact_->is_far(near)) advance_near(near, on_i, on_j);
      return;
    }
    if (!attraction_.is_active() || attraction_.is_out_of_reach(near, update_all_)) return;
    if (list_all_ || !attraction_.is_idle(near)) attract_near(near, on_i, on_j);
  }

  /// Once a step, of pairs alone. A step that is computed again repeats all forces.
  void beginPass(SurfacesIntersectData& pass, ForceData&, ForceData&) override {
    update_all_ = tally_ || !pass.computeflag || !pass.shearupdate;
    list_all_ = update_all_ || pair_->cpl() || pair_->storeContactForces() ||
                pair_->storeContactForcesStress();
    if (tally_ && pass.computeflag) tally_->begin_pairs();
  }
  void endPass(SurfacesIntersectData& pass, ForceData&, ForceData&) override {
    if (tally_ && pass.computeflag) tally_->end_pairs();
  }

  /// The last to be called of a contact.
  void endSurfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                            ForceData& on_j) override {
    if (tally_) write_contact(contact, on_i, on_j);
  }

 private:
  [[gnu::noinline]] void attract_near(SurfacesCloseData& near, ForceData& on_i, ForceData& on_j) {
    const double r = std::sqrt(near.rsq);
    const double inverse = 1.0 / r;
    const double normal[3] = {inverse * near.delta[0], inverse * near.delta[1],
                              inverse * near.delta[2]};
    if (!attract(near, r, normal, on_i, on_j)) return;
    near.has_force_update = true;
    if (tally_)
      tally_->add_sampled(near, on_i,
                          reads_energies() ? adhesion_energy(near, r - near.radsum) : 0.0);
  }

  /// A contact of scheme exact: in the place of what the engine's normal model made of it. Friction
  /// sees its spring and dashpot, as under scheme sampled.
  [[gnu::noinline]] void advance(SurfacesIntersectData& contact, ForceData& on_i, ForceData& on_j) {
    last_energies_ = nullptr;
    if (!carries(contact)) return;
    double* const spring = slides_ ? contact.contact_history + others_history_ : nullptr;
    double force;
    auto* const energies = last_energies();
    const bool with_stored = reads_energies();
    if (!exact_->advance_persistent(contact, spring, force, energies, with_stored)) {
      if (energies) *energies = {};
      cohesion::contact_solver::ContactStep step;
      if (!exact_->advance(contact, contact.r, contact.en, step, energies, with_stored)) step = {};
      exact_->set_friction(contact, step, spring);
      force = step.force;
    }
    for (int d = 0; d < 3; d++) {
      on_i.delta_F[d] = force * contact.en[d];
      on_j.delta_F[d] = -force * contact.en[d];  // of a wall the engine ignores it
    }
  }

  [[gnu::noinline]] void advance_near(SurfacesCloseData& near, ForceData& on_i, ForceData& on_j) {
    const double r = std::sqrt(near.rsq);
    const double inverse = 1.0 / r;
    const double normal[3] = {inverse * near.delta[0], inverse * near.delta[1],
                              inverse * near.delta[2]};
    cohesion::contact_solver::ContactStep step;
    if (!carries(near) || !exact_->advance(near, r, normal, step, new_energies(), reads_energies()))
      return;
    if (step.force != 0.0) {
      for (int d = 0; d < 3; d++) {
        on_i.delta_F[d] = step.force * normal[d];
        on_j.delta_F[d] = -step.force * normal[d];
      }
      near.has_force_update = true;
    }
    if (tally_) tally_->add_exact(near, on_i, energies_);
  }

  /// Without a keyword the scheme is exact where the contact model allows it, which stays for later
  /// runs; a wall has that of the pairs of each run.
  void choose_scheme(int types) {
    using Choice = Cohesion::SchemeChoice;
    if (has_scheme_of_pairs_)
      scheme_ = Cohesion::pairs_are_exact(lmp) ? Choice::none : Choice::sampled;
    if (scheme_ != Choice::sampled) {
      scheme_ = Cohesion::scheme_of(lmp, name(), wall_, scheme_, obstacle_to_exact(types),
                                    Attraction::HAS_SAMPLED);
      if (!is_exact()) has_scheme_of_pairs_ = false;
    }
    exact_ = is_exact() ? exact_contacts_.get() : nullptr;
    last_energies_ = nullptr;  // of a wall whose scheme has changed
    advice_->set_exact(is_exact());
  }
  /// Why scheme exact is impossible; empty: it is possible.
  std::string obstacle_to_exact(int types) const {
    return exact_contacts_
               ? exact_contacts_->obstacle(*normal_, types)
               : "a restart file stores no keywords of contact models; repeat pair_style gran "
                 "and fix wall/gran behind read_restart";
  }

  void connect_exact(PropertyRegistry& registry) {
    slides_ = has("tangential", "history");
    if constexpr (std::is_same_v<Attraction, Cohesion::HamakerAttraction>)
      attraction_.require_turns_as_touching();
    exact_->connect(
        *normal_,
        [this](int i, int j, double ri, double rj) { return attraction_.adhesion(i, j, ri, rj); },
        [this](const auto& normal, int i, int j, double ri, double rj) {
          return attraction_.contact_law(normal, i, j, ri, rj);
        },
        [](const auto& spring, const auto& adhesion, double distance, double step) {
          using Solver = typename Attraction::Solver;
          return std::unique_ptr<Cohesion::ExactContacts::ContactSolver>(
              new Solver(spring, adhesion, distance, step));
        },
        attraction_.range(), !has("tangential", "off") || !has("rolling_friction", "off"),
        registry.max_type());
  }

  bool is_exact() const override { return scheme_ == Cohesion::SchemeChoice::exact; }

  bool binds(int itype, int jtype, double ri, double rj, double gap,
             const double* history) const override {
    if (Attraction::BINDS_WHAT_ENTERED && exact_ && attraction_.is_active())
      return exact_->in_range(history);
    return attraction_.binds(itype, jtype, ri, rj, gap, history);
  }

  void make_probe() {
    normal_ = std::make_unique<Cohesion::NormalModelProbe>(
        lmp, [this](const char* model) { return has("normal", model); });
    advice_ = std::make_shared<Cohesion::ContactAdvice>(
        lmp, wall_, name(), *normal_,
        [this](cohesion::advice::AdvisedContact& c, int i, int j) {
          c.adhesion = attraction_.adhesion(i, j, c.i.radius, c.j.radius);
          c.material = attraction_.material(i, j);
          c.material_words = attraction_.material_words(*normal_);
          c.doubt = attraction_.doubt(i, j);
        },
        [this](const auto& normal, int i, int j, double ri, double rj) {
          return attraction_.contact_law(normal, i, j, ri, rj);
        });
  }

  bool has(const char* kind, const char* model) const {
    return wall_ ? wall_->contact_match(kind, model) : pair_->contact_match(kind, model);
  }

  void connect_tally() {
    if (!wall_) Cohesion::FixEnergyTally::to_the_end(lmp);
    tally_ = Cohesion::FixEnergyTally::tally_of(lmp);
    update_all_ = list_all_ = tally_ != nullptr;
    const bool slides = has("tangential", "history");
    if (slides) other_models_.displacement = others_history_;
    if (has("rolling_friction", "epsd2"))
      other_models_.rolling = others_history_ + (slides ? 3 : 0);
    other_models_.exponent = normal_->exponent();
    other_models_.rolls = !has("rolling_friction", "off");
  }

  /// Of scheme exact; null: no tally is kept.
  cohesion::contact_solver::ContactEnergies* last_energies() {
    return last_energies_ = tally_ ? &energies_ : nullptr;
  }
  cohesion::contact_solver::ContactEnergies* new_energies() {
    if (tally_) energies_ = {};
    return last_energies();
  }

  /// Whether an output reads the energies of this step.
  bool reads_energies() const { return tally_ && tally_->is_read(); }

  [[gnu::noinline]] void write_contact(const SurfacesIntersectData& contact, const ForceData& on_i,
                                       const ForceData& on_j) {
    if (!contact.computeflag) return;  // a force evaluation without a step
    if (tally_->is_read()) return write_read_contact(contact, on_i, on_j);
    tally_->add(contact, on_i, on_j, other_models_, last_energies_);
  }
  [[gnu::noinline]] void write_read_contact(const SurfacesIntersectData& contact,
                                            const ForceData& on_i, const ForceData& on_j) {
    if (last_energies_)
      tally_->store(contact, other_models_, last_energies_->stored);
    else
      tally_->store_sampled(contact, other_models_,
                            carries(contact) ? adhesion_energy(contact, -contact.deltan) : 0.0);
    tally_->add(contact, on_i, on_j, other_models_, last_energies_);
  }

  /// Whether a triangle of a mesh has the attraction of the wall here.
  bool carries(const SurfacesCloseData& data) const {
    return !data.mesh ||
           Cohesion::carries_contact(*data.fix_mesh, data.j, data.i, atom->x[data.i], data.radi);
  }

  /// Of scheme sampled.
  double adhesion_energy(const SurfacesCloseData& d, double gap) const {
    const bool bound =
        binds(d.itype, d.jtype, d.radi, d.is_wall ? 0.0 : d.radj, gap, d.contact_history);
    const double rj = d.is_wall ? std::numeric_limits<double>::infinity() : d.radj;
    return attraction_.energy(d.itype, d.jtype, d.radi, rj, gap, bound);
  }

  static std::string name() { return std::string("cohesion model ") + Attraction::MODEL; }

  /// r: distance of i's centre from j's, or from the wall, of which radsum is then the radius of i.
  [[gnu::noinline]] bool attract(const SurfacesCloseData& data, double r, const double* normal,
                                 ForceData& on_i, ForceData& on_j) {
    if (!carries(data)) return false;
    const double attraction = attraction_.force({data, normal, r - data.radsum});
    for (int d = 0; d < 3; d++) {
      on_i.delta_F[d] -= attraction * normal[d];
      on_j.delta_F[d] += attraction * normal[d];  // of a wall the engine ignores it
    }
    return true;
  }

  FixWallGran* wall_;  // null for pairs
  PairGran* pair_;     // null for walls
  Attraction attraction_;
  Cohesion::SchemeChoice scheme_ = Cohesion::SchemeChoice::none;
  bool slides_ = false;  // over a spring
  bool has_scheme_of_pairs_ = false;
  std::unique_ptr<Cohesion::ExactContacts> exact_contacts_;  // null: never of scheme exact
  Cohesion::ExactContacts* exact_ = nullptr;                 // null: scheme sampled
  std::unique_ptr<Cohesion::NormalModelProbe> normal_;
  std::shared_ptr<Cohesion::ContactAdvice> advice_;
  std::shared_ptr<Cohesion::ModelEnergyTally> tally_;  // null: none is kept
  bool update_all_ = false;  // the memory of every contact is brought up to date in this step
  bool list_all_ = false;    // every bound pair is listed, with a force of 0, too
  Cohesion::OtherModels other_models_;
  cohesion::contact_solver::ContactEnergies energies_{};
  cohesion::contact_solver::ContactEnergies* last_energies_ = nullptr;  // null: a sampled contact
  int others_history_;  // place of what the tangential and the rolling model remember
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
