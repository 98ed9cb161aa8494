// SPDX-License-Identifier: GPL-2.0-only
// The part of FixHardEvents that brings flights, bodies and walls from the engine to the
// simulation.
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine_api.h"
#include "fix_hard_events.h"
#include "pair_hard_square_well.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::vector;
using cohesion::Vector3;

// Strain of the box for which a particle's neighbours are found: the more, the more of them.
static constexpr double STRAIN_OF_A_HOME = 0.4;
// By how much numbers of a flight may differ from the engine's that has gone the same way, in units
// in the last place of a box length: some roundings on each side.
static constexpr double ROUNDINGS = 64.0 * std::numeric_limits<double>::epsilon();
// A particle that is farther than this from where it was, in radii, has been put there.
static constexpr double MOVED = 0.1;

/// The bits of image flags of an axis.
static imageint flag(imageint image, int axis) {
  return (image >> (axis == 0 ? 0 : axis == 1 ? IMGBITS : IMG2BITS)) & IMGMASK;
}

static PeriodicBox::Edges edges(const double* h) { return {h[0], h[1], h[2], h[3], h[4], h[5]}; }

static PeriodicBox::Edges rates(const Domain* domain) {
  return domain->deform_vremap ? edges(domain->h_rate) : PeriodicBox::Edges{};
}

/// Puts particles back to where pre_exchange() took them from.
void FixHardEvents::put_back_outside() {
  for (int i = 0; i < atom->nlocal; i++)
    for (int axis = 0; axis < 3; axis++) {
      atom->x[i][axis] += columns_[i][OUTSIDE + axis];
      columns_[i][OUTSIDE + axis] = 0.0;
    }
}

/// By how many boxes a particle has gone out of the box since the clock was started. Flags begin
/// anew when they run out of bits.
Vector3 FixHardEvents::boxes_gone(int i) const {
  const auto before = static_cast<imageint>(ubuf(columns_[i][IMAGE]).i);
  const imageint now = atom->image[i];
  if (now == before) return {};
  const auto gone = [&](int axis) {
    const imageint difference = flag(now, axis) - flag(before, axis);
    return static_cast<double>(((difference + IMGMAX) & IMGMASK) - IMGMAX);
  };
  return {gone(0), gone(1), gone(2)};
}

void FixHardEvents::note_image(int i) { columns_[i][IMAGE] = ubuf(atom->image[i]).d; }

/// Whether the box at the end of this step is not what the simulation takes it for.
bool FixHardEvents::box_is_another(double dt) const {
  const PeriodicBox& box = simulation_.box();
  const double end = simulation_.end() + dt;
  const PeriodicBox::Edges expected = box.at(end), now = edges(domain->h), rate = rates(domain);
  const auto differ = [&](double PeriodicBox::Edges::* k) {
    return std::abs(expected.*k - now.*k) > ROUNDINGS * (now.xx + now.yy + now.zz) ||
           box.rates.*k != rate.*k;
  };
  return (box.periodic[0] && differ(&PeriodicBox::Edges::xx)) ||
         (box.periodic[1] &&
          (differ(&PeriodicBox::Edges::yy) || differ(&PeriodicBox::Edges::xy))) ||
         (box.periodic[2] && (differ(&PeriodicBox::Edges::zz) || differ(&PeriodicBox::Edges::xz) ||
                              differ(&PeriodicBox::Edges::yz)));
}

/// Starts the simulation's clock at the beginning of this step, with the box of then.
void FixHardEvents::start_clock(double dt) {
  PeriodicBox box;
  box.origin = vector(domain->boxlo);
  box.rates = rates(domain);
  box.edges = edges(domain->h);
  box.edges = box.at(-dt);
  for (int k = 0; k < 3; k++) box.periodic[k] = domain->periodicity[k] && k < domain->dimension;
  simulation_.start_clock(box);
  place_rounding_ = ROUNDINGS * (box.edges.xx + box.edges.yy + box.edges.zz + norm(box.origin));
  age_ = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    columns_[i][SINCE] = std::nan("");
    note_image(i);
  }
}

/// Whether the bodies of the simulation are the own particles, in the same order and of the same
/// matter.
bool FixHardEvents::has_the_same_bodies() const {
  if (static_cast<int>(simulation_.bodies.size()) != atom->nlocal) return false;
  for (int i = 0; i < atom->nlocal; i++)
    if (!same_matter(matter_of(i), simulation_.bodies[i])) return false;
  return true;
}

/// Where a particle is at the end of the step, in the simulation's box, and its velocity.
FixHardEvents::Observed FixHardEvents::observed(int i, double end) const {
  const Vector3 x = vector(atom->x[i]), v = vector(atom->v[i]), boxes = boxes_gone(i);
  if (same(boxes, {})) return {x, v, 0.0};
  const Vector3 flow = simulation_.box().rates * boxes;
  return {x + simulation_.box().at(end) * boxes, v + flow, ROUNDINGS * (norm(v) + norm(flow))};
}

/// Whether a particle goes on with the flight that the simulation has.
bool FixHardEvents::goes_on(int i, const Observed& now, double end) const {
  const Flight& flight = simulation_.flights[i];
  if (columns_[i][KICK] > 0.0) return false;
  const bool same_velocity = now.velocity_rounding > 0.0
                                 ? norm(now.velocity - flight.velocity) <= now.velocity_rounding
                                 : same(now.velocity, flight.velocity);
  const Vector3 off = now.place - flight.at(end);
  return same_velocity && dot(off, off) <= place_rounding_ * place_rounding_;
}

/// Loads all bodies and their flights, before a step of length `dt` begins.
void FixHardEvents::load_all(double dt) {
  load_walls(simulation_.end() + dt);
  const RemoteParticles remote = remote_particles();
  load_bodies(remote, dt);
  share_flights(remote);
}

/// Loads all own bodies, and the remote ones but for their flights.
void FixHardEvents::load_bodies(const RemoteParticles& remote, double dt) {
  simulation_.bodies.assign(atom->nlocal + remote.size(), Body{});
  simulation_.flights.resize(simulation_.bodies.size());
  for (int i = 0; i < atom->nlocal; i++) load_body(i, dt);
  for (const auto& [ghost, request] : remote) simulation_.bodies[request.local] = matter_of(ghost);
}

/// Loads a body and its flight: from what the engine has brought along with the particle, where it
/// goes on with that.
void FixHardEvents::load_body(int i, double dt) {
  const double start = simulation_.end(), end = start + dt;
  Body& body = simulation_.bodies[i];
  body = matter_of(i);
  body.kick = columns_[i][KICK];
  body.course.spin = vector(atom->omega[i]);
  Flight& flight = simulation_.flights[i];
  const bool known = !std::isnan(columns_[i][SINCE]);
  if (known) {
    flight.place = vector(columns_[i] + PLACE);
    flight.velocity = vector(columns_[i] + VELOCITY);
    flight.since = columns_[i][SINCE];
    body.course.causal_depth = static_cast<int>(columns_[i][DEPTH]);
  } else {
    note_image(i);
  }
  const Observed now = observed(i, end);
  if (known && goes_on(i, now, end)) return;
  const Vector3 place = now.place - dt * now.velocity;
  const bool from_there = known && norm(place - flight.at(start)) <= place_rounding_;
  flight.place = from_there ? flight.at(start) : place;
  flight.velocity = now.velocity;
  flight.since = start;
  body.course.causal_depth = -1;
}

/// Takes the bodies that the engine has now, before a step of length `dt` begins: those that were
/// there before stay as they are. Returns whether that could be done; if not, all are loaded.
bool FixHardEvents::keep_bodies(double dt) {
  const RemoteParticles remote = remote_particles();
  std::unordered_map<std::int64_t, int> before;
  for (int n = 0; n < static_cast<int>(simulation_.bodies.size()); n++)
    before[simulation_.bodies[n].tag] = n;
  std::vector<int> old, added;
  bool same = true;
  const auto look_for = [&](int i) {
    const Body now = matter_of(i);
    const auto found = before.find(now.tag);
    const bool known =
        found != before.end() && simulation_.bodies[found->second].remote == now.remote;
    if (known)
      same = same && same_matter(simulation_.bodies[found->second], now);
    else
      added.push_back(static_cast<int>(old.size()));
    old.push_back(known ? found->second : -1);
  };
  for (int i = 0; i < atom->nlocal; i++) look_for(i);
  for (const auto& [ghost, request] : remote) look_for(ghost);
  if (same) {
    simulation_.arrange(old);
    for (const int n : added)
      if (n < atom->nlocal)
        load_body(n, dt);
      else
        simulation_.bodies[n] = matter_of(remote[n - atom->nlocal].first);
  } else {
    load_bodies(remote, dt);
  }
  share_flights(remote);
  return same && simulation_.take_in(added, inside_);
}

/// Loads the flights that others have changed, in the step that has begun, and what their events
/// depend on.
void FixHardEvents::load_changes(double dt) {
  const double start = simulation_.start(), end = simulation_.end();
  load_walls(end);
  for (int i = 0; i < atom->nlocal; i++) {
    Body& body = simulation_.bodies[i];
    const Vector3 spin = vector(atom->omega[i]);
    const bool same_body = same(spin, body.course.spin) && body.kick == columns_[i][KICK];
    body.course.spin = spin;
    body.kick = columns_[i][KICK];
    const Observed now = observed(i, end);
    const bool same_flight = goes_on(i, now, end);
    if (same_body && same_flight) continue;
    if (same_flight) {
      changed_.push_back({i, false});
      continue;
    }
    const Vector3 from = simulation_.flights[i].at(start), place = now.place - dt * now.velocity;
    const double away = norm(place - from);
    Flight flight;
    flight.place = away <= place_rounding_ ? from : place;
    flight.velocity = now.velocity;
    flight.since = start;
    Course course = body.course;
    course.causal_depth = -1;
    changed_.push_back({i, away > MOVED * body.radius});
    simulation_.change_flight(i, flight, course, changed_.back().moved);
  }
}

/// Sets the walls as they are in the step that ends at `when`.
void FixHardEvents::load_walls(double when) {
  simulation_.walls.clear();
  for (const HardWalls* walls : walls_)
    for (int w = 0; w < walls->number_of_walls(); w++)
      simulation_.walls.push_back(walls->wall(w, when));
}

/* ---------------------------------------------------------------------- */

/// What the engine says of a particle or ghost, apart from its motion.
Body FixHardEvents::matter_of(int i) const {
  Body b;
  b.inverse_mass = mobile_.inverse_mass(atom->mask[i], atom->rmass[i]);
  b.radius = atom->radius[i];
  b.inverse_inertia =
      b.inverse_mass / (mobile_.inertia_factor(atom->mask[i]) * b.radius * b.radius);
  b.tag = atom->tag[i];
  b.kind = atom->type[i];
  b.groups = atom->mask[i];
  b.remote = i >= atom->nlocal;
  return b;
}

/// Collective: the particles of other processes that are ghosts here, with one ghost of each; their
/// bodies follow the own ones.
FixHardEvents::RemoteParticles FixHardEvents::remote_particles() {
  RemoteParticles remote;
  if (comm->nprocs == 1) return remote;
  note_origins();
  std::unordered_set<std::int64_t> known;
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++) {
    const auto owner = static_cast<int>(origin_[i][0]), index = static_cast<int>(origin_[i][1]);
    if (owner == comm->me || !known.insert(atom->tag[i]).second) continue;
    const int body = atom->nlocal + static_cast<int>(remote.size());
    remote.push_back({i, {owner, index, body}});
  }
  return remote;
}

/// Collective: flights of remote bodies as they are on their own processes.
void FixHardEvents::share_flights(const RemoteParticles& remote) {
  if (comm->nprocs == 1) return;
  std::vector<BorderExchange::Request> requests;
  for (const auto& [ghost, request] : remote) requests.push_back(request);
  time_warp_.plan(requests);
}

/// Tells ghosts whose they are.
void FixHardEvents::note_origins() {
  for (int i = 0; i < atom->nlocal; i++) {
    origin_[i][0] = comm->me;
    origin_[i][1] = i;
  }
  engine_api::forward_comm(comm, this);
}

/// Finds neighbours and events of all bodies, before a step begins.
void FixHardEvents::set_up_events() {
  const double rate = simulation_.box().strain_rate();
  simulation_.neighbourhoods().bodies_of_box = static_cast<double>(atom->natoms);
  simulation_.set_up(rate > 0.0 ? STRAIN_OF_A_HOME / rate : never, inside_);
}

/// Collective: sets how long the clock can go on: as long as the fastest particle takes for the
/// shortest edge of the box, so that times have as many digits as places.
void FixHardEvents::set_time_of_clock() {
  double mine = 0.0, fastest = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const Vector3& v = simulation_.flights[i].velocity;
    mine = std::max(mine, dot(v, v));
  }
  MPI_Allreduce(&mine, &fastest, 1, MPI_DOUBLE, MPI_MAX, world);
  const PeriodicBox::Edges& edges = simulation_.box().edges;
  double shortest = std::min(edges.xx, edges.yy);
  if (domain->dimension == 3) shortest = std::min(shortest, edges.zz);
  time_of_clock_ = fastest > 0.0 ? shortest / std::sqrt(fastest) : never;
}

/// Collective: the pairs at the edges of their wells of all processes, in order.
std::vector<EventSimulation::Tags> FixHardEvents::all_inside_at_edge() const {
  using Tags = EventSimulation::Tags;
  std::vector<Tags> mine = simulation_.inside_at_edge(), all;
  if (comm->nprocs == 1) return mine;
  const int bytes = static_cast<int>(mine.size() * sizeof(Tags));
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs, 0);
  MPI_Allgather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  for (int p = 1; p < comm->nprocs; p++) starts[p] = starts[p - 1] + sizes[p - 1];
  all.resize((starts.back() + sizes.back()) / sizeof(Tags));
  MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE,
                 world);
  std::sort(all.begin(), all.end());
  return all;
}

/// Collective: the pairs that are in their wells after the events of the step; those through the
/// boundary from both sides.
std::vector<FixHardEvents::PairInWell> FixHardEvents::pairs_in_wells() {
  note_origins();
  // The copies of a body here, the own one first
  std::unordered_map<tagint, std::vector<int> > copies;
  std::vector<PairInWell> pairs;
  simulation_.for_each_pair([&](int i, const Neighbour& n) {
    if (!n.inside || n.is_wall()) return;
    const auto [r, w] = simulation_.relative_motion(i, n.body, n.image, simulation_.end());
    pairs.push_back({i, n.body, r, w});
    copies[simulation_.bodies[n.body].tag];
    if (n.image == 0 || simulation_.bodies[n.body].remote) return;
    pairs.push_back({n.body, i, -r, -w});
    copies[simulation_.bodies[i].tag];
  });
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    const auto found = copies.find(atom->tag[i]);
    if (found != copies.end()) found->second.push_back(i);
  }
  for (PairInWell& pair : pairs) {
    const Vector3 place = vector(atom->x[pair.i]) + pair.separation;
    double nearest = never;
    for (const int copy : copies[simulation_.bodies[pair.j].tag]) {
      const double away = norm(vector(atom->x[copy]) - place);
      if (away >= nearest) continue;
      nearest = away;
      pair.j = copy;
    }
  }
  return pairs;
}
