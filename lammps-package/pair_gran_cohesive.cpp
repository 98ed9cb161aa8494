// SPDX-License-Identifier: GPL-2.0-only
#include "pair_gran_cohesive.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

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
  if (step->resumes()) {
    if (evflag) tally_standing();
    return;
  }
  step->work_out();
  with_contacts([this](auto& contacts, auto size) { follow_together<size>(contacts); });
}

/// Calls what(contacts, size of their history).
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::with_contacts(const What& what) {
  guarded(lmp, coefficients.where(), [&] {
    std::visit(
        [&](auto& contacts) {
          if (per_pair == HistorySize::with_rolling)
            what(contacts, std::integral_constant<int, HistorySize::with_rolling>());
          else if (friction)
            what(contacts, std::integral_constant<int, HistorySize::with_friction>());
          else
            what(contacts, std::integral_constant<int, HistorySize::normal_only>());
        },
        any_contacts);
  });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::gather() {
  if (!acts) return;
  if (rested) begin_where_they_are(true);
  if (neighbor->ago == 0) check_radii(lmp, coefficients.where(), largest_radius);
  with_contacts([this](auto& contacts, auto size) { gather<size>(contacts); });
}

/// The same, in scheme event only.
template <class Cohesion>
template <class What>
void PairGranCohesive<Cohesion>::with_event_contacts(const What& what) {
  if (acts)
    with_contacts([&](auto& contacts, auto size) {
      if constexpr (std::is_same_v<std::decay_t<decltype(contacts)>, Contacts<EventContact>>)
        what(contacts, size);
    });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::unsettle() {
  with_event_contacts([this](auto& contacts, auto size) { unsettle<size>(contacts); });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::join() {
  with_event_contacts([this](auto& contacts, auto size) { join<size>(contacts); });
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::follow_alone() {
  with_event_contacts([this](auto& contacts, auto size) {
    contacts_now.follow_alone(ContactsOfStep<EventContact, size>(atom, step), step, contacts.all);
  });
}

/// Energy of spring and adhesion.
static double energy(const StoredEnergies& stored) { return stored.spring + stored.adhesion; }

/// Finds the pairs that may touch in this step.
template <class Cohesion>
void PairGranCohesive<Cohesion>::find_close() {
  // Both fly a whole step from the grid point; sampled, they are found as far beyond the edge.
  constexpr double flights = 4.0;
  const double reach = largest_range + flights * step->flight();
  if (reach > close.allowed())
    error->one(FLERR,
               "{}: particles fly up to {} in half a step and could miss a "
               "contact, the neighbour list allows for {}: use a smaller time step or a skin above "
               "{}. The fastest: {}",
               coefficients.where(), step->flight(), (close.allowed() - largest_range) / flights,
               20.0 * step->flight(), report_fastest(lmp));
  close.update(*list, reach, history->firstflag);
}

/// Calls what(i, j, kept, history) for them.
template <class Cohesion>
template <class What>
[[gnu::always_inline]] inline void PairGranCohesive<Cohesion>::for_each_close(const What& what) {
  double* const* const values_of = history->firstvalue;
  const int each = per_pair;
  close.for_each_near(history->firstflag,
                      [&](const ClosePair& pair, int& kept) __attribute__((always_inline)) {
                        what(pair.i, pair.j, kept, values_of[pair.i] + each * pair.place);
                      });
}

/// Adds what a contact does to the sums of momentum flux, if somebody reads them.
template <class Cohesion>
auto PairGranCohesive<Cohesion>::flux_sum() {
  return [sums = step->sums_flux(), this](int j, const PairMotion& grid, const Vector3& impulse,
                                          const auto& by_contact, double factor) {
    if (sums)
      step->flux.add(factor * (j < atom->nlocal ? 1.0 : 0.5), grid.relative.separation, impulse,
                     by_contact());
  };
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::gather(Contacts<EventContact>& contacts) {
  contacts_now.clear();
  contacts.clear();
  const ContactsOfStep<EventContact, SIZE> scatter(atom, step);
  find_close();
  const LastingContacts<EventContact, SIZE> lasting(atom, step);
  const bool asked = step->book.is_kept() || step->sums_flux();
  const double* const x = atom->x[0];
  const double* const v = atom->v[0];
  const double* const spin = atom->omega[0];
  const int* const type = atom->type;
  const Bodies bodies = step->bodies();
  for_each_close([&](int i, int j, int& kept, double* values) __attribute__((always_inline)) {
    const int c = contact(contacts, type, bodies, i, j);
    if (c == contacts.NONE) return;
    if (kept && !asked &&
        lasting.act(contacts.all[c], i, j,
                    {{vector(x + 3 * j) - vector(x + 3 * i), vector(v + 3 * j) - vector(v + 3 * i)},
                     vector(spin + 3 * i),
                     vector(spin + 3 * j)},
                    values))
      contacts_now.lasting.push_back({i, j, c, values});
    else
      take<SIZE>(scatter, contacts.all[c], c, i, j, kept, values);
  });
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::take(const ContactsOfStep<EventContact, SIZE>& scatter,
                                      const EventContact& law, int contact, int i, int j, int& kept,
                                      double* values) {
  if (!kept || values[0] == ContactMemory::beyond) {
    kept = 0;
    if (!law.within_reach(on_grid(i, j), step->flight())) return;
    std::fill_n(values, per_pair, 0.0);
    // A pair that a run starts with is where it is; it did not fall into the range.
    if (step->starts() && closer(law.range(), i, j))
      ContactMemory::seen_inside().to(values, per_pair);
  }
  kept = 1;
  contacts_now.take<SIZE>(scatter, step, law, contact, i, j, on_grid_with_spins(i, j), values,
                          flux_sum());
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::unsettle(Contacts<EventContact>& contacts) {
  const ContactsOfStep<EventContact, SIZE> scatter(atom, step);
  contacts_now.unsettle<SIZE>(
      scatter, step, contacts.all,
      [this](const LastingContact& p) { return on_grid_with_spins(p.i, p.j); }, flux_sum());
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::join(Contacts<EventContact>& contacts) {
  contacts_now.join<SIZE>(ContactsOfStep<EventContact, SIZE>(atom, step), step, contacts.all,
                          [this](const LastingContact& p) { return on_grid_with_spins(p.i, p.j); });
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::follow_together(Contacts<EventContact>& contacts) {
  const ContactsOfStep<EventContact, SIZE> scatter(atom, step);
  if (evflag)
    contacts_now.for_each_lasting<SIZE>(
        contacts.all, [this](const LastingContact& p) { return on_grid_with_spins(p.i, p.j); },
        [&](const LastingContact& p, const ContactMemory& known, const PairMotion& grid,
            const auto& action) {
          tally(p.i, p.j, grid.relative.separation,
                energy(contacts.all[p.contact].stored(grid, known)), action().impulse);
        });
  if (evflag)
    for (const LastingContact& p : contacts_now.idle) {
      const PairMotion grid = on_grid_with_spins(p.i, p.j);
      const ContactMemory known = ContactMemory::from(p.history, SIZE);
      tally(p.i, p.j, grid.relative.separation, energy(contacts.all[p.contact].stored(grid, known)),
            {});
    }
  // What a contact remembers is new after its second pass.
  std::vector<double> before;
  if (evflag)
    for (const FollowedContact& p : contacts_now.followed)
      before.push_back(energy(contacts.all[p.contact].stored(
          on_grid_with_spins(p.i, p.j), ContactMemory::as_stored(p.history, SIZE))));
  std::size_t next = 0;
  const auto sum = flux_sum();
  contacts_now.follow_together(scatter, step, contacts.all,
                               [&](int j, const PairMotion& grid, const Vector3& impulse,
                                   const auto& by_contact, double factor) {
                                 sum(j, grid, impulse, by_contact, factor);
                                 if (!evflag) return;
                                 tally(contacts_now.followed[next].i, j, grid.relative.separation,
                                       before[next], impulse);
                                 next++;
                               });
}

/// Sampled contacts do not wait for each other.
template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::gather(Contacts<SampledContact>&) {
  find_close();
}

template <class Cohesion>
template <int SIZE>
void PairGranCohesive<Cohesion>::follow_together(Contacts<SampledContact>& contacts) {
  contacts.clear();
  const ContactsOfStep<SampledContact, SIZE> scatter(atom, step);
  const SampledForces<SampledContact, SIZE> forces(atom, step);
  const bool asked = step->book.is_kept() || step->sums_flux() || evflag;
  const double* const x = atom->x[0];
  const double* const v = atom->v[0];
  const double* const spin = atom->omega[0];
  const int* const type = atom->type;
  const Bodies bodies = step->bodies();
  for_each_close([&](int i, int j, int& kept, double* values) __attribute__((always_inline)) {
    const int c = contact(contacts, type, bodies, i, j);
    if (c == contacts.NONE) return;
    const SampledContact& law = contacts.all[c];
    const RelativeState apart{vector(x + 3 * j) - vector(x + 3 * i),
                              vector(v + 3 * j) - vector(v + 3 * i)};
    if (!kept) {
      if (!law.within_reach(apart)) return;
      std::fill_n(values, per_pair, 0.0);
      if (step->starts()) values[0] = closer(law.range(), i, j);
    }
    if (asked || values[0] < 0.0)
      kept = sample<SIZE>(scatter, law, i, j, values);
    else
      kept = forces.act(law, i, j, {apart, vector(spin + 3 * i), vector(spin + 3 * j)}, values);
  });
}

/// A sampled contact of which somebody asks what it does. Gives whether it remembers anything.
template <class Cohesion>
template <int SIZE>
[[gnu::noinline]] bool PairGranCohesive<Cohesion>::sample(
    const ContactsOfStep<SampledContact, SIZE>& scatter, const SampledContact& c, int i, int j,
    double* values) {
  const PairMotion grid = on_grid_with_spins(i, j);
  ContactMemory known = ContactMemory::from(values, SIZE);
  const SampledStep now = LAMMPS_NS::sample(scatter, step, c, i, j, grid, known);
  known.to(values, SIZE);
  flux_sum()(j, grid, now.action.impulse, [&] { return c.by_contact(grid, now); }, 1.0);
  if (evflag)
    tally(i, j, grid.relative.separation, energy(c.stored(grid, known)), now.action.impulse);
  return known.in_range();
}

/// Energy and virial, of an impulse on j.
template <class Cohesion>
void PairGranCohesive<Cohesion>::tally(int i, int j, const Vector3& separation, double energy,
                                       const Vector3& impulse) {
  const Vector3 on_i = -step->force_per_impulse() * impulse;
  ev_tally_xyz(i, j, atom->nlocal, 0, energy, 0.0, on_i.x, on_i.y, on_i.z, -separation.x,
               -separation.y, -separation.z);
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
  return coefficients.any_rolls() ? HistorySize::with_rolling : HistorySize::with_friction;
}

/// A fifth of the skin for the flight of both within a step: it is far less where the engine's own
/// check of the list holds at all.
template <class Cohesion>
double PairGranCohesive<Cohesion>::for_flight() const {
  return 0.2 * neighbor->skin;
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
