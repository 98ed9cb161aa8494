// SPDX-License-Identifier: GPL-2.0-only
#include "pair_gran_cohesive.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "atom.h"
#include "engine_api.h"
#include "error.h"
#include "fix_event_step.h"
#include "flight_report.h"
#include "force.h"
#include "guarded.h"
#include "hamaker_cohesion.h"
#include "largest_radii.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "plausible_sizes.h"
#include "square_well_cohesion.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::event_stepping;
using cohesion::Vector3;

template <class Cohesion>
PairGranCohesive<Cohesion>::PairGranCohesive(LAMMPS* lammps)
    : Pair(lammps),
      coefficients(lammps),
      close(lammps),
      largest_range(0.0),
      friction(false),
      acts(false),
      looks(true),
      rested(false),
      per_pair(0),
      step(nullptr),
      history(modify, Cohesion::HISTORY_ID) {
  single_enable = 0;
  restartinfo = 1;
  no_virial_fdotr_compute = 1;
  finitecutflag = 1;
  beyond_contact = 1;
  FixEventStep::reserve(lmp);
}

template <class Cohesion>
PairGranCohesive<Cohesion>::~PairGranCohesive() {
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::allocate() {
  allocated = 1;
  const int types = atom->ntypes;
  memory->create(setflag, types + 1, types + 1, "pair:setflag");
  memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
  coefficients.make_room(types, setflag);
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void PairGranCohesive<Cohesion>::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  coefficients.require_taken();
  if (update->whichflag == 2)
    error->all(FLERR, coefficients.where() + " follows motion in time; it cannot be minimized");
  if (!acts) {
    rested = true;
    return;
  }
  guarded(lmp, coefficients.where(), [this] { follow_pairs(); });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::follow_pairs() {
  if (rested) begin_where_they_are(true);
  if (step->resumes()) {
    if (step->box_changed()) begin_where_they_are(false);
    if (evflag || step->book.kept) tally_standing();
    return;
  }
  std::visit(
      [this](auto& contacts) {
        if (neighbor->ago == 0) check_radii(lmp, coefficients.where(), largest_radius);
        find_active(contacts);
        if (per_pair == WITH_ROLLING)
          follow<true, true>(contacts);
        else
          friction ? follow<true, false>(contacts) : follow<false, false>(contacts);
      },
      any_contacts);
}

template <class Cohesion>
inline PairMotion PairGranCohesive<Cohesion>::with_spins(const RelativeState& grid, int i,
                                                         int j) const {
  return {grid, vector(atom->omega[i]), vector(atom->omega[j])};
}

template <class Cohesion>
template <bool FRICTION, bool ROLLING, class Contact>
void PairGranCohesive<Cohesion>::follow(Contacts<Contact>& contacts) {
  if constexpr (Contact::acts_within_step) follow_alone<FRICTION, ROLLING>(contacts);
  evflag || step->sums_flux() ? follow_together<true, FRICTION, ROLLING>(contacts)
                              : follow_together<false, FRICTION, ROLLING>(contacts);
}

/// The pairs that may touch in this step.
template <class Cohesion>
template <class Contact>
void PairGranCohesive<Cohesion>::find_active(Contacts<Contact>& contacts) {
  active.clear();
  contacts.clear();
  const bool first = step->window().before == 0.0;
  // Both fly half a step from the grid point, or, sampled, are found a whole one beyond the edge.
  const double flights = coefficients.scheme() == Scheme::sampled ? 4.0 : 2.0;
  const double reach = largest_range + flights * step->flight();
  if (reach > close.allowed())
    error->one(FLERR,
               "{}: particles fly up to {} in half a step and could miss a "
               "contact, the neighbour list allows for {}: use a smaller time step or a skin above "
               "{}. The fastest: {}",
               coefficients.where(), step->flight(), (close.allowed() - largest_range) / flights,
               10.0 * flights * step->flight(), report_fastest(lmp));
  close.update(*list, reach, history->firstflag);

  int* const* const flags = history->firstflag;
  double* const* const values_of = history->firstvalue;
  for (const ClosePair& pair : close) {
    const int i = pair.i, j = pair.j;
    if (!moves(i, j)) continue;
    int& kept = flags[i][pair.place];
    double* const values = values_of[i] + per_pair * pair.place;
    const int c = contact(contacts, i, j);
    if (!kept) {
      if (!contacts.all[c].within_reach(on_grid(i, j))) continue;
      std::fill_n(values, per_pair, 0.0);
      // A pair that a run starts with is where it is; it did not fall into the range.
      if (first) values[0] = closer(contacts.all[c].range(), i, j);
    }
    active.push_back({i, j, c, false, &kept, values});
    if (!Contact::acts_within_step) continue;
    step->announce(i);
    step->announce(j);
  }
}

/// Every contact by itself: what it would do to its two particles, where that matters to others.
/// Flattened, as the next one: the laws are many small functions, and calls cost a packing a
/// quarter.
template <class Cohesion>
template <bool FRICTION, bool ROLLING, class Contact>
[[gnu::flatten]] void PairGranCohesive<Cohesion>::follow_alone(Contacts<Contact>& contacts) {
  if (ROLLING) rolled.assign(active.size(), {});
  changes.resize(active.size());
  PairMotion* next = changes.data();
  for (Active& pair : active) {
    PairMotion& change = *next++;
    const int i = pair.i, j = pair.j;
    pair.only = !ROLLING && step->has_one_contact(i) && step->has_one_contact(j);
    if (pair.only) continue;
    const Contact& c = contacts.all[pair.contact];
    PairMotion motion = with_spins(on_grid(i, j), i, j);
    PairStep normal = c.advance(motion.relative, pair.history[0] != 0.0);
    if (!normal.acts) {
      change = {};
      continue;
    }
    change = c.template alone<FRICTION>(motion, normal, spring_memory<FRICTION>(pair.history));
    add_alone<FRICTION>(step->alone[i], -1.0, c.share_i(), change);
    add_alone<FRICTION>(step->alone[j], 1.0, c.share_j(), change);
    if (ROLLING)
      rolled[&pair - active.data()] =
          roll_alone(c, motion, change, normal, pair.history, step->alone[i], step->alone[j]);
  }
  step->share(FRICTION ? 9 : 6);
}

/// Every contact again, with half of what the other contacts of its particles do, and friction.
template <class Cohesion>
template <bool TALLY, bool FRICTION, bool ROLLING, class Contact>
[[gnu::flatten]] void PairGranCohesive<Cohesion>::follow_together(Contacts<Contact>& contacts) {
  const int nlocal = atom->nlocal;
  const ContactScatter scatter(atom, step);
  const PairMotion* next = changes.data();

  for (Active& pair : active) {
    const int i = pair.i, j = pair.j;
    const Contact& c = contacts.all[pair.contact];
    PairMotion others;
    if constexpr (Contact::acts_within_step) {
      const PairMotion& change = *next++;
      if (!pair.only) others = others_of<FRICTION>(step->alone[i], step->alone[j], change);
    }
    PairSpins by_rolling;
    if (ROLLING && Contact::acts_within_step) {
      by_rolling = c.rolled(rolled[&pair - active.data()]);
      others = without(others, by_rolling);
    }
    PairMotion motion = with_spins(on_grid(i, j), i, j);
    constexpr bool among_others = Contact::acts_within_step;
    FollowedContact now =
        follow_with_others<FRICTION>(c, motion, among_others ? &others : nullptr,
                                     ROLLING && among_others ? &by_rolling : nullptr, pair.history);
    *pair.kept = now.normal.inside;

    if (now.normal.acts) {
      scatter.on_i<FRICTION>(i, c, now);
      if (j < nlocal) scatter.on_j<FRICTION>(j, c, now);
    }
    scatter.book(c, j < nlocal ? 1.0 : 0.5, now);
    if (ROLLING) {
      RollingStep rolling = roll_with_others(c, motion, others, now, pair.history);
      scatter.roll_i(i, rolling);
      if (j < nlocal) scatter.roll_j(j, rolling);
      scatter.book(c, j < nlocal ? 1.0 : 0.5, rolling);
    }
    if (TALLY) {
      const Vector3 d = on_grid(i, j).separation;
      const Vector3 on_i = -scatter.kick() * now.impulse;
      if (step->sums_flux())
        step->flux.add(j < nlocal ? 1.0 : 0.5, c, d, now.normal, now.sliding, now.impulse);
      if (evflag)
        ev_tally_xyz(i, j, nlocal, 0, c.spring_energy(now.normal) + c.adhesion_energy(now.normal),
                     0.0, on_i.x, on_i.y, on_i.z, -d.x, -d.y, -d.z);
    }
  }
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void PairGranCohesive<Cohesion>::coeff(int narg, char** arg) {
  if (narg < 4)
    error->all(FLERR, std::string("pair_coeff of ") + Cohesion::STYLE + " takes 'i j " +
                          Cohesion::COEFFICIENTS);
  if (!allocated) allocate();
  coefficients.read(narg, arg);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::init_style() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, coefficients.where() + " acts between spheres; use 'atom_style sphere'");
  step = FixEventStep::of(lmp);
  require_plausible_radii(lmp, coefficients.where());
  largest_radius = largest_radii(lmp);
  smallest_radius = smallest_radii(lmp, largest_radius);
  coefficients.start();
  acts = coefficients.any_acts();
  if (coefficients.scheme() == Scheme::event)
    any_contacts.template emplace<static_cast<int>(Scheme::event)>();
  else
    any_contacts.template emplace<static_cast<int>(Scheme::sampled)>();
  std::visit([this](auto& contacts) { contacts.last.resize(coefficients.pairs_of_types()); },
             any_contacts);
  friction = false;
  largest_range = 0.0;
  close.start(for_flight());
  looks = acts || per_pair > 0 || bound_pairs_are_read();
  if (!looks) {
    list = nullptr;
    return;
  }
  engine_api::request_history_list(neighbor, this, instance_me);
  const int needed = values_per_pair();
  if (per_pair == 0) per_pair = needed;
  if (per_pair < needed)
    error->all(FLERR,
               coefficients.where() +
                   ": rolling_friction cannot begin here: the contacts of the run before, or "
                   "of the restart file, remember no rolling; give it from the first run on");
  history.init(this, per_pair);
}

template <class Cohesion>
bool PairGranCohesive<Cohesion>::bound_pairs_are_read() const {
  return std::any_of(modify->fix, modify->fix + modify->nfix,
                     [](Fix* fix) { return dynamic_cast<BoundPairsReader*>(fix) != nullptr; });
}

template <class Cohesion>
int PairGranCohesive<Cohesion>::values_per_pair() const {
  return coefficients.any_rolls() ? WITH_ROLLING : WITH_FRICTION;
}

/// A tenth of the skin for the flight of both within half a step: it is far less where the engine's
/// own check of the list holds at all.
template <class Cohesion>
double PairGranCohesive<Cohesion>::for_flight() const {
  return 0.1 * neighbor->skin;
}

template <class Cohesion>
double PairGranCohesive<Cohesion>::init_one(int i, int j) {
  const double range = coefficients.prepare(i, j, largest_radius[i], largest_radius[j]);
  coefficients.require_short(i, j, smallest_radius[i], smallest_radius[j]);
  require_plausible_range(lmp, coefficients.where(), largest_radius[i] + largest_radius[j] + range);
  const auto& contact = coefficients.contact(coefficients.of_types(i, j));
  friction = friction || contact.friction > 0.0;
  if (!looks) return largest_radius[i] + largest_radius[j];
  largest_range = std::max(largest_range, range);
  close.start(largest_range + for_flight());
  return largest_radius[i] + largest_radius[j] + range + for_flight();
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::give_advice(const Circumstances& now) {
  if (!Cohesion::HAS_CONTACT) return;
  const std::string where = coefficients.where();
  advise(lmp, where, limits_of(coefficients.scheme()),
         from_script(lmp, where, [&] { return advised_contacts(now.lightest); }), now, said);
}

/// Between particles of the types that are this style's.
template <class Cohesion>
std::vector<AdvisedContact> PairGranCohesive<Cohesion>::advised_contacts(
    const std::vector<LightestParticle>& lightest) const {
  std::vector<AdvisedContact> contacts;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      const LightestParticle &a = lightest[i], &b = lightest[j];
      if (!coefficients.has(i, j)) continue;
      if (!std::isfinite(a.radius) || !std::isfinite(b.radius)) continue;  // no particles yet
      const int types = coefficients.of_types(i, j);
      contacts.push_back(
          advised_contact(fmt::format("{} - {}", i, j), a, b, coefficients.contact(types),
                          coefficients.template attraction<cohesion::contact::Adhesion>(
                              types, a.radius, b.radius)));
      contacts.back().material = coefficients.material(types);
      contacts.back().material_words = Cohesion::MATERIAL_WORDS;
    }
  return contacts;
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void PairGranCohesive<Cohesion>::write_restart(FILE* fp) {
  write_restart_settings(fp);
  coefficients.write(fp);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::read_restart(FILE* fp) {
  read_restart_settings(fp);
  allocate();
  coefficients.read(fp);
}

template class LAMMPS_NS::PairGranCohesive<HamakerCohesion>;
template class LAMMPS_NS::PairGranCohesive<SquareWellCohesion>;
template class LAMMPS_NS::PairGranCohesive<SquareWellOverlay>;
