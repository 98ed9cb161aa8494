// SPDX-License-Identifier: GPL-2.0-only
#include "bubbles/fix_bubbles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "common/fix_gas_coupling.h"
#include "common/message.h"
#include "domain.h"
#include "error.h"
#include "liquid/rows_of_bubbles.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using cohesion::Vector3;
using cohesion::bubbles::Bubble;
using cohesion::bubbles::Events;

namespace {

/// A bubble as ranks tell each other: ID, place in the arrays, radius, mass, x, v.
constexpr int numbers = 10;

}  // namespace

int FixBubbles::setmask() { return PRE_EXCHANGE; }

void FixBubbles::init() {
  if (domain->box_change)
    stop(lmp, FLERR, where, " needs a box that stays as it is; a fix changes it");
  coupling = nullptr;
  for (int k = 0; k < modify->nfix; k++)
    if (std::string(modify->fix[k]->style) == "gas/coupling")
      coupling = static_cast<FixGasCoupling*>(modify->fix[k]);
  const auto bounds = box();
  for (std::size_t k = 0; nozzles && k < nozzles->count(); k++)
    if (!bounds.holds(nozzles->place(k), cohesion::bubbles::radius_of(nozzles->most())))
      stop(lmp, FLERR, where, ": a bubble of nozzle ", k + 1, " at ", nozzles->place(k).x, " ",
           nozzles->place(k).y, " ", nozzles->place(k).z, " is not within the box");
  if (next_id < 0) next_id = highest_id() + 1;
}

/// A run begins with its events due at the next step that is a multiple of N of those before.
void FixBubbles::setup_pre_exchange() {
  if (next_reneighbor <= update->ntimestep)
    next_reneighbor = last_step + ((update->ntimestep - last_step) / nevery + 1) * nevery;
}

long FixBubbles::highest_id() const {
  long mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, static_cast<long>(atom->tag[i]));
  MPI_Allreduce(&mine, &all, 1, MPI_LONG, MPI_MAX, world);
  return all;
}

cohesion::bubbles::BubbleBox FixBubbles::box() const {
  cohesion::bubbles::BubbleBox bounds{};
  for (int k = 0; k < 3; k++) {
    bounds.low[k] = domain->boxlo[k];
    bounds.high[k] = domain->boxhi[k];
    bounds.periodic[k] = domain->periodicity[k] != 0;
  }
  return bounds;
}

FixBubbles::Gathered FixBubbles::gather() const {
  std::vector<double> mine;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    mine.insert(mine.end(), {static_cast<double>(atom->tag[i]), static_cast<double>(i),
                             atom->radius[i], atom->rmass[i]});
    mine.insert(mine.end(), atom->x[i], atom->x[i] + 3);
    mine.insert(mine.end(), atom->v[i], atom->v[i] + 3);
  }
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs, 0);
  const int size = static_cast<int>(mine.size());
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  std::partial_sum(sizes.begin(), sizes.end() - 1, starts.begin() + 1);
  std::vector<double> all(starts.back() + sizes.back());
  MPI_Allgatherv(mine.data(), size, MPI_DOUBLE, all.data(), sizes.data(), starts.data(), MPI_DOUBLE,
                 world);
  std::vector<std::pair<int, int> > rows;  // where in `all`, and rank
  for (int rank = 0; rank < comm->nprocs; rank++)
    for (int k = 0; k < sizes[rank]; k += numbers) rows.emplace_back(starts[rank] + k, rank);
  std::sort(rows.begin(), rows.end(),
            [&](const auto& a, const auto& b) { return all[a.first] < all[b.first]; });
  Gathered result;
  for (const auto& [at, rank] : rows) {
    const double* row = &all[at];
    const long number = std::lround(row[0]);
    const auto rest = resting.find(number);
    result.bubbles.push_back({number, cohesion::vector(row + 4), cohesion::vector(row + 7), row[2],
                              row[3], rest == resting.end() ? 0.0 : rest->second});
    result.owner.push_back(rank);
    result.index.push_back(static_cast<int>(std::lround(row[1])));
  }
  return result;
}

void FixBubbles::pre_exchange() {
  if (update->ntimestep != next_reneighbor) return;
  const double passed = static_cast<double>(update->ntimestep - last_step) * update->dt;
  last_step = update->ntimestep;
  next_reneighbor = update->ntimestep + nevery;
  elapsed += passed;
  if (nozzles) nozzles->flow_on(passed);

  Gathered all = gather();
  const Events events = cohesion::bubbles::round_of_events(
      all.bubbles, rules, box(), nozzles ? &*nozzles : nullptr, elapsed, next_id, totals);
  apply(all, events);
}

/// What fix gas/coupling keeps of the bubbles that take part in mergers and breaks, on every rank;
/// empty of all others.
std::vector<std::vector<double> > FixBubbles::gas_rows(const Gathered& all,
                                                       const Events& events) const {
  std::vector<std::vector<double> > rows(all.bubbles.size());
  if (!coupling) return rows;
  std::vector<char> wanted(all.bubbles.size(), 0);
  for (const auto& pair : events.mergers) wanted[pair.into] = wanted[pair.gone] = 1;
  for (const auto& fresh : events.born)
    if (fresh.from) wanted[*fresh.from] = 1;
  for (const auto& fed : events.fed) wanted[fed.bubble] = 1;
  constexpr int most =
      cohesion::drag::GasOnParticle::size + cohesion::liquid::LiquidOnParticle::size;
  for (std::size_t k = 0; k < rows.size(); k++) {
    if (!wanted[k]) continue;
    std::vector<double> row(most + 1, 0.0);
    if (all.owner[k] == comm->me) row[most] = coupling->pack_exchange(all.index[k], row.data());
    MPI_Bcast(row.data(), most + 1, MPI_DOUBLE, all.owner[k], world);
    row.resize(static_cast<std::size_t>(row[most]));
    rows[k] = std::move(row);
  }
  return rows;
}

void FixBubbles::change(int i, const Bubble& bubble) {
  const double x[] = {bubble.position.x, bubble.position.y, bubble.position.z};
  const double v[] = {bubble.velocity.x, bubble.velocity.y, bubble.velocity.z};
  std::copy_n(x, 3, atom->x[i]);
  std::copy_n(v, 3, atom->v[i]);
  atom->radius[i] = bubble.radius;
  atom->rmass[i] = bubble.mass;
}

bool FixBubbles::is_mine(const Vector3& at) const {
  const double x[] = {at.x, at.y, at.z};
  for (int k = 0; k < 3; k++)
    if (x[k] < domain->sublo[k] || x[k] >= domain->subhi[k]) return false;
  return true;
}

void FixBubbles::create(const Events::New& fresh, int owner, const std::vector<double>& row) {
  const Bubble& bubble = fresh.bubble;
  double x[] = {bubble.position.x, bubble.position.y, bubble.position.z};
  // A half begins on its other half's rank, from where the exchange that follows takes it on.
  const bool here = fresh.from ? owner == comm->me : is_mine(bubble.position);
  if (!here) return;
  atom->avec->create_atom(type, x);
  const int i = atom->nlocal - 1;
  change(i, bubble);
  atom->tag[i] = static_cast<tagint>(bubble.number);
  atom->mask[i] = 1 | groupbit;
  std::fill_n(atom->omega[i], 3, 0.0);
  modify->create_attribute(i);
  if (coupling && !row.empty()) coupling->unpack_exchange(i, const_cast<double*>(row.data()));
}

void FixBubbles::remove(const std::vector<int>& places) {
  // From the last on: the one that takes a place is then none of those to go.
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    atom->avec->copy(atom->nlocal - 1, *place, 1);
    atom->nlocal--;
  }
}

void FixBubbles::tell_engine(long change) {
  atom->natoms += change;
  if (atom->map_style != Atom::MAP_NONE) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

/// Makes the rows those of the bubbles after mergers, breaks and what nozzles blew into them.
void FixBubbles::merge_and_halve(std::vector<std::vector<double> >& rows, const Gathered& all,
                                 const Events& events) const {
  using namespace cohesion::liquid;
  using cohesion::drag::GasOnParticle;
  const auto gas = [&](std::size_t k) -> GasOnParticle& {
    return *reinterpret_cast<GasOnParticle*>(rows[k].data());
  };
  const auto liquid = [&](std::size_t k) {
    return rows[k].size() > GasOnParticle::size
               ? reinterpret_cast<LiquidOnParticle*>(rows[k].data() + GasOnParticle::size)
               : nullptr;
  };
  // Several nozzles may have blown into one.
  std::vector<double> fed(all.bubbles.size());
  for (const auto& one : events.fed) fed[one.bubble] += one.volume;
  std::vector<char> halved(all.bubbles.size(), 0);
  for (const auto& fresh : events.born)
    if (fresh.from) halved[*fresh.from] = 1;
  for (const auto& [into, gone] : events.mergers) {
    // The one that is gone is in the list as it was; the other one has its volume, or half of both.
    const double volume = all.bubbles[gone].volume();
    const double joint = (all.bubbles[into].volume() - fed[into]) * (halved[into] ? 2.0 : 1.0);
    merge_rows(gas(into), gas(gone), joint - volume, volume);
    if (liquid(into)) merge_rows(*liquid(into), *liquid(gone));
  }
  for (std::size_t k = 0; k < halved.size(); k++) {
    if (!halved[k]) continue;
    halve_row(gas(k));
    if (liquid(k)) halve_row(*liquid(k));
  }
  for (std::size_t k = 0; k < fed.size(); k++)
    if (fed[k] > 0.0) spread_row(gas(k), all.bubbles[k].volume(), fed[k]);
}

void FixBubbles::note_rests(const Gathered& all, const Events& events) {
  for (std::size_t k = 0; k < all.bubbles.size(); k++) {
    resting.erase(all.bubbles[k].number);
    if (!events.gone[k] && all.bubbles[k].rests_until > elapsed)
      resting[all.bubbles[k].number] = all.bubbles[k].rests_until;
  }
  for (const auto& fresh : events.born)
    if (fresh.bubble.rests_until > elapsed) resting[fresh.bubble.number] = fresh.bubble.rests_until;
}

void FixBubbles::apply(const Gathered& all, const Events& events) {
  auto rows = gas_rows(all, events);
  if (coupling) merge_and_halve(rows, all, events);
  std::vector<int> places;
  for (std::size_t k = 0; k < all.bubbles.size(); k++) {
    if (all.owner[k] != comm->me) continue;
    if (events.gone[k]) {
      places.push_back(all.index[k]);
    } else if (events.changed[k]) {
      change(all.index[k], all.bubbles[k]);
      if (coupling) coupling->unpack_exchange(all.index[k], rows[k].data());
    }
  }
  const long before = atom->nlocal;
  for (const auto& fresh : events.born)
    create(fresh, fresh.from ? all.owner[*fresh.from] : -1,
           fresh.from ? rows[*fresh.from] : std::vector<double>());
  long born = atom->nlocal - before, made = 0;
  MPI_Allreduce(&born, &made, 1, MPI_LONG, MPI_SUM, world);
  if (made != static_cast<long>(events.born.size()))
    error->all(FLERR, where + ": a new bubble is on no rank, or on two");
  std::sort(places.begin(), places.end());
  remove(places);
  const long gone = std::count(events.gone.begin(), events.gone.end(), true);
  if (made || gone) tell_engine(made - gone);
  note_rests(all, events);
}

/// Injected, their volume; removed, theirs; mergers, breaks; what the nozzles owe; inside, their
/// volume.
double FixBubbles::compute_vector(int n) {
  if (n < 6) {
    const double sums[] = {totals.injected,       totals.injected_volume, totals.removed,
                           totals.removed_volume, totals.merged,          totals.broken};
    return sums[n];
  }
  if (n == 6)
    return nozzles ? std::accumulate(nozzles->pending().begin(), nozzles->pending().end(), 0.0)
                   : 0.0;
  double mine[2] = {0.0, 0.0}, all[2] = {0.0, 0.0};
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) {
      mine[0] += 1.0;
      mine[1] += cohesion::sphere_volume(atom->radius[i]);
    }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  return all[n - 7];
}

/* ---------------------------------------------------------------------- */

void FixBubbles::write_restart(FILE* file) {
  if (comm->me != 0) return;
  std::vector<double> state{totals.injected,
                            totals.injected_volume,
                            totals.removed,
                            totals.removed_volume,
                            totals.merged,
                            totals.broken,
                            elapsed,
                            static_cast<double>(next_id),
                            static_cast<double>(last_step),
                            static_cast<double>(next_reneighbor),
                            nozzles ? static_cast<double>(nozzles->count()) : 0.0};
  if (nozzles) state.insert(state.end(), nozzles->pending().begin(), nozzles->pending().end());
  state.push_back(static_cast<double>(resting.size()));
  for (const auto& [number, until] : resting)
    state.insert(state.end(), {static_cast<double>(number), until});
  const int size = static_cast<int>(state.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, file);
  fwrite(state.data(), sizeof(double), state.size(), file);
}

void FixBubbles::restart(char* buffer) {
  const auto* state = reinterpret_cast<double*>(buffer);
  const auto next = [&] { return *state++; };
  for (double* sum : {&totals.injected, &totals.injected_volume, &totals.removed,
                      &totals.removed_volume, &totals.merged, &totals.broken, &elapsed})
    *sum = next();
  next_id = std::lround(next());
  last_step = static_cast<bigint>(next());
  next_reneighbor = static_cast<bigint>(next());
  const auto count = static_cast<std::size_t>(next());
  if (count != (nozzles ? nozzles->count() : 0))
    stop(lmp, FLERR, where, ": the state that is read is of ", count, " nozzles, the script has ",
         nozzles ? nozzles->count() : 0, "; give it the same");
  for (std::size_t k = 0; k < count; k++) nozzles->pending()[k] = next();
  const auto rests = static_cast<std::size_t>(next());
  for (std::size_t k = 0; k < rests; k++) {
    const long number = std::lround(next());
    resting[number] = next();
  }
}
