// SPDX-License-Identifier: GPL-2.0-only
#include "pair_gran_cohesive.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "contact_advice.h"
#include "engine_api.h"
#include "error.h"
#include "fix_event_step.h"
#include "force.h"
#include "hamaker_cohesion.h"
#include "largest_radii.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "square_well_cohesion.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::event_stepping;
using cohesion::Vector3;

static constexpr int HISTORY = 4;

template <class Cohesion>
PairGranCohesive<Cohesion>::PairGranCohesive(LAMMPS* lammps)
    : Pair(lammps),
      atom_types(0),
      scheme(Scheme::event),
      largest_range(0.0),
      list_reach(0.0),
      friction(false),
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
  atom_types = atom->ntypes;
  memory->create(setflag, atom_types + 1, atom_types + 1, "pair:setflag");
  memory->create(cutsq, atom_types + 1, atom_types + 1, "pair:cutsq");
  for (int i = 1; i <= atom_types; i++) std::fill_n(setflag[i], atom_types + 1, 0);
  given.assign((atom_types + 1) * (atom_types + 1), {});
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void PairGranCohesive<Cohesion>::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (update->whichflag == 2)
    error->all(FLERR, where() + " follows motion in time; it cannot be minimized");
  std::visit(
      [this](auto& contacts) {
        if (step->resumes()) {
          if (evflag) tally_standing(contacts);
          return;
        }
        if (Cohesion::HAS_CONTACT && update->setupflag) give_advice();
        if (neighbor->ago == 0) check_radii();
        find_active(contacts);
        friction ? follow<true>(contacts) : follow<false>(contacts);
      },
      any_contacts);
}

template <class Cohesion>
inline RelativeState PairGranCohesive<Cohesion>::on_grid(int i, int j) const {
  return {vector(atom->x[j]) - vector(atom->x[i]), vector(atom->v[j]) - vector(atom->v[i])};
}

template <class Cohesion>
inline PairMotion PairGranCohesive<Cohesion>::with_spins(const RelativeState& grid, int i,
                                                         int j) const {
  return {grid, vector(atom->omega[i]), vector(atom->omega[j])};
}

template <class Cohesion>
template <bool FRICTION, class Contact>
void PairGranCohesive<Cohesion>::follow(Contacts<Contact>& contacts) {
  if constexpr (Contact::acts_within_step) follow_alone<FRICTION>(contacts);
  evflag ? follow_together<true, FRICTION>(contacts) : follow_together<false, FRICTION>(contacts);
}

/// Pairs of equal particles that come one after the other share a contact.
template <class Cohesion>
template <class Contact>
inline int PairGranCohesive<Cohesion>::contact(Contacts<Contact>& contacts, int i, int j) {
  const int types = of_types(atom->type[i], atom->type[j]);
  const Body a = step->body(i), b = step->body(j);
  int& last = contacts.last[types];
  if (last == Contacts<Contact>::NONE || !contacts.all[last].joins(a, b)) {
    last = static_cast<int>(contacts.all.size());
    contacts.all.emplace_back(
        used[types].contact,
        Cohesion::template of_pair<typename Contact::Attraction>(laws[types], a.radius, b.radius),
        a, b, step->window());
  }
  return last;
}

/// By how much the gap of a pair may have shrunk since `close` was made, [length].
template <class Cohesion>
double PairGranCohesive<Cohesion>::come_closer() const {
  const double* const now = atom->x[0];
  const double* const then = positions.data();
  const double* const radius = atom->radius;
  double furthest = 0.0, growth = 0.0;
  for (std::size_t k = 0; k < positions.size(); k += 3) {
    const double dx = now[k] - then[k], dy = now[k + 1] - then[k + 1],
                 dz = now[k + 2] - then[k + 2];
    furthest = std::max(furthest, dx * dx + dy * dy + dz * dz);
  }
  for (std::size_t i = 0; i < radii.size(); i++) growth = std::max(growth, radius[i] - radii[i]);
  return 2.0 * (std::sqrt(furthest) + growth);
}

/// Most pairs of the engine's list are a skin apart. Those whose gap is below `list_reach` are
/// enough until particles have moved or grown so far that others could come as near as `reach`.
template <class Cohesion>
void PairGranCohesive<Cohesion>::find_close(double reach) {
  if (neighbor->ago != 0 && !positions.empty() && reach + come_closer() <= list_reach) return;
  close.clear();
  const int all = atom->nlocal + atom->nghost;
  if (all == 0) return;
  positions.assign(atom->x[0], atom->x[0] + 3 * all);
  radii.assign(atom->radius, atom->radius + all);
  const double* const x = atom->x[0];
  const double* const radius = atom->radius;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int* const neighbors = list->firstneigh[i];
    const int count = list->numneigh[i];
    const double xi = x[3 * i], yi = x[3 * i + 1], zi = x[3 * i + 2];
    // With room for what other contacts do to a pair within a step.
    const double near_i = 1.0001 * radius[i] + list_reach;
    const std::size_t before = close.size();
    close.resize(before + count);
    Close* last = close.data() + before;
    for (int jj = 0; jj < count; jj++) {
      const int j = neighbors[jj] & NEIGHMASK;
      const double dx = x[3 * j] - xi;
      const double dy = x[3 * j + 1] - yi;
      const double dz = x[3 * j + 2] - zi;
      const double near = near_i + radius[j];
      *last = {i, j, jj};  // no branch: which pairs are near cannot be predicted
      last += dx * dx + dy * dy + dz * dz <= near * near;
    }
    close.resize(last - close.data());
    if (neighbor->ago == 0) forget_others(i, close.data() + before, last);
  }
}

/// Only a particle that was put elsewhere can have left a partner that is not near any more.
template <class Cohesion>
void PairGranCohesive<Cohesion>::forget_others(int i, const Close* near, const Close* end) {
  for (int jj = 0; jj < list->numneigh[i]; jj++) {
    if (near != end && near->place == jj)
      near++;
    else
      history->firstflag[i][jj] = 0;
  }
}

/// The pairs that may touch in this step.
template <class Cohesion>
template <class Contact>
void PairGranCohesive<Cohesion>::find_active(Contacts<Contact>& contacts) {
  active.clear();
  contacts.clear();
  const bool first = step->window().before == 0.0;
  // Both fly half a step from the grid point, or, sampled, are found a whole one beyond the edge.
  const double flights = scheme == Scheme::sampled ? 4.0 : 2.0;
  const double reach = largest_range + flights * step->flight();
  if (reach > list_reach)
    error->one(FLERR,
               "{}: particles fly up to {} in half a step and could miss a "
               "contact, the neighbour list allows for {}: use a smaller time step or a skin above "
               "{}",
               where(), step->flight(), (list_reach - largest_range) / flights,
               10.0 * flights * step->flight());
  find_close(reach);

  for (const Close& pair : close) {
    const int i = pair.i, j = pair.j;
    const double near = atom->radius[i] + atom->radius[j] + reach;
    const Vector3 d = vector(atom->x[j]) - vector(atom->x[i]);
    if (dot(d, d) > 1.0002 * near * near) continue;
    if (!step->body(i).inverse_mass && !step->body(j).inverse_mass) continue;
    int& kept = history->firstflag[i][pair.place];
    const int c = contact(contacts, i, j);
    const RelativeState grid = on_grid(i, j);
    if (!kept && !contacts.all[c].within_reach(grid)) continue;
    double* const values = &history->firstvalue[i][HISTORY * pair.place];
    if (!kept) std::fill_n(values, HISTORY, 0.0);
    // A pair that a run starts with is where it is; it did not fall into the range.
    if (first && !kept)
      values[0] =
          norm(grid.separation) < atom->radius[i] + atom->radius[j] + contacts.all[c].range();
    active.push_back({i, j, c, false, &kept, values, {}});
    step->announce(i);
    step->announce(j);
  }
}

/// Every contact by itself: what it would do to its two particles, where that matters to others.
/// Flattened, as the next one: the laws are many small functions, and calls cost a packing a
/// quarter.
template <class Cohesion>
template <bool FRICTION, class Contact>
[[gnu::flatten]] void PairGranCohesive<Cohesion>::follow_alone(Contacts<Contact>& contacts) {
  for (Active& pair : active) {
    const int i = pair.i, j = pair.j;
    pair.alone = step->has_one_contact(i) && step->has_one_contact(j);
    if (pair.alone) continue;
    const Contact& c = contacts.all[pair.contact];
    pair.change =
        c.template alone<FRICTION>(with_spins(on_grid(i, j), i, j), pair.history[0] != 0.0,
                                   spring_memory<FRICTION>(pair.history));
    add_alone<FRICTION>(step->alone[i], -1.0, c.share_i(), pair.change);
    add_alone<FRICTION>(step->alone[j], 1.0, c.share_j(), pair.change);
  }
  step->share();
}

/// Every contact again, with half of what the other contacts of its particles do, and friction.
template <class Cohesion>
template <bool TALLY, bool FRICTION, class Contact>
[[gnu::flatten]] void PairGranCohesive<Cohesion>::follow_together(Contacts<Contact>& contacts) {
  const int nlocal = atom->nlocal;
  const ContactScatter scatter(atom, step);

  for (Active& pair : active) {
    const int i = pair.i, j = pair.j;
    const Contact& c = contacts.all[pair.contact];
    PairMotion others;
    if (Contact::acts_within_step && !pair.alone)
      others = others_of<FRICTION>(step->alone[i], step->alone[j], pair.change);
    const FollowedContact now =
        follow_with_others<FRICTION>(c, with_spins(on_grid(i, j), i, j), others, pair.history);
    *pair.kept = now.normal.inside;

    scatter.on_i<FRICTION>(i, c.share_i(), now);
    if (j < nlocal) scatter.on_j<FRICTION>(j, c.share_j(), now);
    scatter.book(c, j < nlocal ? 1.0 : 0.5, now);
    if (TALLY) {
      const RelativeState d = on_grid(i, j);
      const Vector3 on_i = -scatter.kick() * now.impulse;
      ev_tally_xyz(i, j, nlocal, 0, c.spring_energy(now.normal) + c.adhesion_energy(now.normal),
                   0.0, on_i.x, on_i.y, on_i.z, -d.separation.x, -d.separation.y, -d.separation.z);
    }
  }
}

/// Energies of the pairs where they stand, for a run that takes over the forces of the last one.
template <class Cohesion>
template <class Contact>
void PairGranCohesive<Cohesion>::tally_standing(Contacts<Contact>& contacts) {
  contacts.clear();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      if (!history->firstflag[i][jj]) continue;
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const Contact& c = contacts.all[contact(contacts, i, j)];
      const Vector3 d = on_grid(i, j).separation;
      PairStep standing;
      standing.overlap_at_end = atom->radius[i] + atom->radius[j] - norm(d);
      standing.inside = history->firstvalue[i][HISTORY * jj] != 0.0;
      ev_tally_xyz(i, j, atom->nlocal, 0, c.spring_energy(standing) + c.adhesion_energy(standing),
                   0.0, 0.0, 0.0, 0.0, -d.x, -d.y, -d.z);
    }
  }
}

/// Bound are the pairs within the range of contact and adhesion.
template <class Cohesion>
void PairGranCohesive<Cohesion>::append_bound(std::vector<std::array<int, 2>>& pairs) const {
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++)
      if (history->firstflag[i][jj] && history->firstvalue[i][HISTORY * jj] != 0.0)
        pairs.push_back({i, list->firstneigh[i][jj] & NEIGHMASK});
  }
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void PairGranCohesive<Cohesion>::settings(int narg, char** arg) {
  if (!Cohesion::HAS_CONTACT && narg > 0)
    error->all(FLERR, where() + " takes no keywords, not '" + arg[0] + "'");
  for (int i = 0; i < narg; i += 2) {
    const std::string word = arg[i];
    if (word != "scheme" && !is_setting<Cohesion>(word))
      error->all(FLERR, where() + ": unknown keyword '" + word +
                            "'; valid ones: " + setting_names<Cohesion>());
    if (i + 1 == narg) error->all(FLERR, where() + ": " + word + " takes a name");
    if (word == "scheme")
      scheme = scheme_from_script(lmp, where(), arg[i + 1]);
    else
      attraction.set(lmp, where(), word, arg[i + 1]);
  }
}

template <class Cohesion>
typename Cohesion::Parameters PairGranCohesive<Cohesion>::read(const std::string& here, int first,
                                                               int narg, char** arg) {
  if constexpr (Cohesion::HAS_CONTACT)
    return cohesive_contact_from_script<Cohesion>(lmp, here, first, narg, arg);
  else
    return Cohesion::from_script(lmp, here, first, narg, arg);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::coeff(int narg, char** arg) {
  if (narg < 4)
    error->all(FLERR, std::string("pair_coeff of ") + Cohesion::STYLE + " takes 'i j " +
                          Cohesion::COEFFICIENTS);
  if (!allocated) allocate();
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  const std::string here =
      std::string("pair_coeff ") + arg[0] + " " + arg[1] + " of " + Cohesion::STYLE;
  const Parameters p = read(here, 2, narg, arg);
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = std::max(jlo, i); j <= jhi; j++) {
      given[of_types(i, j)] = p;
      given[of_types(j, i)] = Cohesion::reversed(p);
      setflag[i][j] = 1;
      count++;
    }
  if (count == 0) error->all(FLERR, here + " names no pair with i <= j");
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::init_style() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, where() + " acts between spheres; use 'atom_style sphere'");
  step = FixEventStep::of(lmp);
  largest_radius = largest_radii(lmp);
  laws.assign(given.size(), attraction.no_law());
  used = given;
  if (scheme == Scheme::event)
    any_contacts.template emplace<static_cast<int>(Scheme::event)>().last.resize(given.size());
  else
    any_contacts.template emplace<static_cast<int>(Scheme::sampled)>().last.resize(given.size());
  friction = false;
  positions.clear();
  // A tenth of the skin for the flight of both within half a step: it is far less where the
  // engine's own check of the list holds at all.
  largest_range = 0.0;
  list_reach = 0.1 * neighbor->skin;
  engine_api::request_history_list(neighbor, this, instance_me);
  history.init(this, HISTORY);
}

template <class Cohesion>
double PairGranCohesive<Cohesion>::init_one(int i, int j) {
  Parameters& p = given[of_types(i, j)];
  if (!setflag[i][j]) {
    if (!setflag[i][i] || !setflag[j][j])
      error->all(FLERR, where() + ": no pair_coeff for types " + std::to_string(i) + " and " +
                            std::to_string(j) + " nor for both of them to mix");
    p = Cohesion::mixed(given[of_types(i, i)], given[of_types(j, j)]);
    given[of_types(j, i)] = Cohesion::reversed(p);
  }
  const std::string here = where() + ", types " + std::to_string(i) + " and " + std::to_string(j);
  const Parameters now = attraction.scaled(lmp, here, p);
  const double range = Cohesion::range(scheme, now, largest_radius[i], largest_radius[j]);
  used[of_types(j, i)] = Cohesion::reversed(now);
  used[of_types(i, j)] = now;
  laws[of_types(j, i)] = attraction.law(lmp, here, used[of_types(j, i)]);
  laws[of_types(i, j)] = attraction.law(lmp, here, now);
  friction = friction || now.contact.friction > 0.0;
  largest_range = std::max(largest_range, range);
  list_reach = largest_range + 0.1 * neighbor->skin;
  return largest_radius[i] + largest_radius[j] + range + 0.1 * neighbor->skin;
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::give_advice() {
  const std::vector<LightestParticle> lightest = lightest_particles(lmp, *step);
  std::vector<AdvisedContact> contacts;
  for (int i = 1; i <= atom_types; i++)
    for (int j = i; j <= atom_types; j++) {
      const LightestParticle &a = lightest[i], &b = lightest[j];
      if (!std::isfinite(a.radius) || !std::isfinite(b.radius)) continue;  // no particles yet
      contacts.push_back({fmt::format("{} - {}", i, j), a, b, used[of_types(i, j)].contact,
                          Cohesion::template of_pair<cohesion::contact::Adhesion>(
                              laws[of_types(i, j)], a.radius, b.radius)});
    }
  advise(lmp, where(), limits_of(scheme), contacts);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::check_radii() {
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->radius[i] > largest_radius[atom->type[i]])
      error->one(FLERR,
                 "{}: particle {} of type {} has radius {}, its type had at "
                 "most {} when the run was set up; end the run before particles grow, and start a "
                 "new one",
                 where(), atom->tag[i], atom->type[i], atom->radius[i],
                 largest_radius[atom->type[i]]);
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void PairGranCohesive<Cohesion>::write_restart(FILE* fp) {
  write_restart_settings(fp);
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      fwrite(&setflag[i][j], sizeof(int), 1, fp);
      fwrite(&given[of_types(i, j)], sizeof(Parameters), 1, fp);
    }
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::read_restart(FILE* fp) {
  read_restart_settings(fp);
  allocate();
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      Parameters& p = given[of_types(i, j)];
      if (comm->me == 0) {
        utils::sfread(FLERR, &setflag[i][j], sizeof(int), 1, fp, nullptr, error);
        utils::sfread(FLERR, &p, sizeof(Parameters), 1, fp, nullptr, error);
      }
      MPI_Bcast(&setflag[i][j], 1, MPI_INT, 0, world);
      MPI_Bcast(&p, sizeof(Parameters), MPI_BYTE, 0, world);
      given[of_types(j, i)] = Cohesion::reversed(p);
    }
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::write_restart_settings(FILE* fp) {
  const int numbers[2] = {attraction.settings(), static_cast<int>(scheme)};
  fwrite(numbers, sizeof(int), 2, fp);
}

template <class Cohesion>
void PairGranCohesive<Cohesion>::read_restart_settings(FILE* fp) {
  int numbers[2] = {0, 0};
  if (comm->me == 0) utils::sfread(FLERR, numbers, sizeof(int), 2, fp, nullptr, error);
  MPI_Bcast(numbers, 2, MPI_INT, 0, world);
  attraction.restore_settings(numbers[0]);
  scheme = static_cast<Scheme>(numbers[1]);
}

template class LAMMPS_NS::PairGranCohesive<HamakerCohesion>;
template class LAMMPS_NS::PairGranCohesive<SquareWellCohesion>;
template class LAMMPS_NS::PairGranCohesive<SquareWellOverlay>;
