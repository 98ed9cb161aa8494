// SPDX-License-Identifier: GPL-2.0-only
// The part of FixHardEvents that updates the bodies of the simulation: the own particles and those
// shared with other processes.
#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "atom.h"
#include "comm.h"
#include "common/engine_api.h"
#include "common/renumbering.h"
#include "hard_spheres/fix_hard_events.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::vector;
using cohesion::Vector3;

// Strain of the box during the lifetime of a bounding neighbourhood. A larger strain means longer
// neighbour lists that are rebuilt less often.
static constexpr double NEIGHBOURHOOD_STRAIN = 0.4;

/// Whether the bodies of the simulation are the own particles, in the same order and with the same
/// properties.
bool FixHardEvents::has_same_bodies() const {
  if (static_cast<int>(simulation_.bodies.size()) != atom->nlocal) return false;
  for (int i = 0; i < atom->nlocal; i++)
    if (!same_properties(body_properties(i), simulation_.bodies[i])) return false;
  return true;
}

/// Loads all bodies and their flights, before a step of length `dt` begins.
void FixHardEvents::load_all(double dt) {
  load_walls(simulation_.end() + dt);
  const RemoteParticles remote = find_remote_particles();
  load_bodies(remote, dt);
  request_remote_particles(remote);
  time_warp_.exchange_flights();
}

/// Loads all own bodies with their flights, and the properties of remote ones.
void FixHardEvents::load_bodies(const RemoteParticles& remote, double dt) {
  simulation_.bodies.assign(atom->nlocal + remote.size(), HardSphere{});
  simulation_.flights.resize(simulation_.bodies.size());
  for (int i = 0; i < atom->nlocal; i++) load_body(i, dt);
  for (const auto& [ghost, request] : remote)
    simulation_.bodies[request.local] = body_properties(ghost);
}

/// Collective: replaces the bodies by the present particles of the engine, before a step of length
/// `dt` begins; bodies that remain keep their predictions. Returns false if that is impossible;
/// then all bodies have been loaded, and the caller calls set_up_events().
bool FixHardEvents::update_bodies(double dt) {
  RemoteParticles remote = find_remote_particles();
  const NumbersByTag displaced = displaced_bodies();
  preserve_numbers(remote, displaced);
  request_remote_particles(remote);
  std::vector<int> old, added;
  bool same = true;
  const auto enter_body = [&](int i) {
    const HardSphere now = body_properties(i);
    const int number = static_cast<int>(old.size());
    const int last = find_body(now, number, displaced);
    if (last >= 0)
      same = same && same_properties(simulation_.bodies[last], now);
    else
      added.push_back(number);
    old.push_back(last);
  };
  for (int i = 0; i < atom->nlocal; i++) enter_body(i);
  for (const auto& [ghost, request] : remote) enter_body(ghost);
  update_bound_at_edge(displaced, old);
  if (!same) {
    add_own_bound_at_edge();
    load_bodies(remote, dt);
    time_warp_.exchange_flights();
    return false;
  }
  simulation_.renumber(old);
  for (const int n : added)
    if (n < atom->nlocal)
      load_body(n, dt);
    else
      simulation_.bodies[n] = body_properties(remote[n - atom->nlocal].first);
  time_warp_.exchange_flights();
  stored_versions_.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++)
    if (old[i] != i) stored_versions_[i] = simulation_.flights[i].version - 1;
  if (simulation_.add_bodies(added, bound_at_edge_)) return true;
  add_own_bound_at_edge();
  return false;
}

/// The number of a body in the simulation, which is probably `number`; -1: none.
int FixHardEvents::find_body(const HardSphere& now, int number,
                             const NumbersByTag& displaced) const {
  const auto matches = [&](int n) {
    return n < static_cast<int>(simulation_.bodies.size()) &&
           simulation_.bodies[n].tag == now.tag && simulation_.bodies[n].remote == now.remote;
  };
  if (matches(number)) return number;
  const auto found = displaced.find(now.tag);
  return found != displaced.end() && matches(found->second) ? found->second : -1;
}

/// The bodies except the own particles that have kept their numbers.
FixHardEvents::NumbersByTag FixHardEvents::displaced_bodies() const {
  NumbersByTag displaced;
  for (int n = 0; n < static_cast<int>(simulation_.bodies.size()); n++) {
    const HardSphere& body = simulation_.bodies[n];
    if (n >= atom->nlocal || body.remote || body.tag != atom->tag[n]) displaced[body.tag] = n;
  }
  return displaced;
}

/// Reorders remote particles so that those of the last step, by tag, keep their numbers where
/// possible.
void FixHardEvents::preserve_numbers(RemoteParticles& remote, const NumbersByTag& displaced) const {
  constexpr int unassigned = -1;
  RemoteParticles reordered(remote.size(), {unassigned, {}}), others;
  for (const auto& particle : remote) {
    const auto found = displaced.find(atom->tag[particle.first]);
    const int n = found == displaced.end() ? -1 : found->second - atom->nlocal;
    if (n >= 0 && n < static_cast<int>(remote.size()) && simulation_.bodies[found->second].remote)
      reordered[n] = particle;
    else
      others.push_back(particle);
  }
  for (auto& particle : reordered)
    if (particle.first == unassigned) {
      particle = others.back();
      others.pop_back();
    }
  for (std::size_t n = 0; n < reordered.size(); n++)
    reordered[n].second.local = atom->nlocal + static_cast<int>(n);
  remote = std::move(reordered);
}

/// Properties of a particle or ghost, without its motion.
HardSphere FixHardEvents::body_properties(int i) const {
  HardSphere b;
  b.inverse_mass = mobile_.inverse_mass(atom->mask[i], atom->rmass[i]);
  b.radius = atom->radius[i];
  b.inverse_inertia =
      b.inverse_mass / (mobile_.inertia_factor(atom->mask[i]) * b.radius * b.radius);
  b.tag = atom->tag[i];
  b.material = atom->type[i];
  b.group_bits = atom->mask[i];
  b.remote = i >= atom->nlocal;
  return b;
}

/// Collective: the particles of other processes that have ghosts here, each with one ghost. Their
/// bodies have the numbers after the own ones.
FixHardEvents::RemoteParticles FixHardEvents::find_remote_particles() {
  RemoteParticles remote;
  if (comm->nprocs == 1) return remote;
  send_owners();
  std::unordered_set<std::int64_t> tags_found;
  for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++) {
    const auto owner = static_cast<int>(owners_[i][0]), index = static_cast<int>(owners_[i][1]);
    if (owner == comm->me || !tags_found.insert(atom->tag[i]).second) continue;
    const int body = atom->nlocal + static_cast<int>(remote.size());
    remote.push_back({i, {owner, index, body}});
  }
  return remote;
}

/// Collective: requests remote particles from their owners.
void FixHardEvents::request_remote_particles(const RemoteParticles& remote) {
  if (comm->nprocs == 1) return;
  std::vector<BorderExchange::ParticleRequest> requests;
  for (const auto& [ghost, request] : remote) requests.push_back(request);
  time_warp_.set_remote_particles(requests);
}

/// Sends the owners and indices of particles to their ghosts.
void FixHardEvents::send_owners() {
  for (int i = 0; i < atom->nlocal; i++) {
    owners_[i][0] = comm->me;
    owners_[i][1] = i;
  }
  engine_api::forward_comm(comm, this);
}

/// Finds neighbours and events of all bodies, before a step begins.
void FixHardEvents::set_up_events() {
  const double rate = simulation_.box().strain_rate();
  simulation_.neighbour_lists().bodies_in_box = static_cast<double>(atom->natoms);
  simulation_.set_up(rate > 0.0 ? NEIGHBOURHOOD_STRAIN / rate : never, bound_at_edge_);
}

/// Collective: the bound pairs at the edges of their wells on all processes, sorted.
FixHardEvents::PairsByTag FixHardEvents::gather_bound_pairs_at_edge() const {
  return gather_pairs(simulation_.bound_pairs_at_edge());
}

/// Collective: sets bound_at_edge_ to the bound pairs at the edge that can be new to a process:
/// those of own bodies that have migrated or that are shared. `old`: EventSimulation::renumber().
void FixHardEvents::update_bound_at_edge(const NumbersByTag& displaced,
                                         const std::vector<int>& old) {
  std::vector<int> bodies_to_check;
  for (const auto& [tag, n] : displaced)
    if (!simulation_.bodies[n].remote) bodies_to_check.push_back(n);
  for (int i = 0; i < atom->nlocal; i++)
    if (old[i] == i && time_warp_.is_shared(i)) bodies_to_check.push_back(i);
  bound_at_edge_ = gather_pairs(simulation_.bound_pairs_at_edge(bodies_to_check));
}

/// Adds the bound pairs at the edge of this process to bound_at_edge_.
void FixHardEvents::add_own_bound_at_edge() {
  const auto own = simulation_.bound_pairs_at_edge();
  bound_at_edge_.insert(bound_at_edge_.end(), own.begin(), own.end());
  std::sort(bound_at_edge_.begin(), bound_at_edge_.end());
}

void FixHardEvents::store_tags() {
  for (int i = 0; i < atom->nlocal; i++) particle_data_[i][TAG] = static_cast<double>(atom->tag[i]);
}

/// Collective: replaces the tags in `pairs` of the previous run by the present ones.
void FixHardEvents::apply_new_tags(PairsByTag& pairs) {
  std::vector<tagint> before;
  for (int i = 0; i < atom->nlocal; i++)
    before.push_back(static_cast<tagint>(particle_data_[i][TAG]));
  store_tags();
  const Renumbering renumbering(lmp, before);
  if (!renumbering.any()) return;
  std::vector<tagint> tags;
  for (const auto& [i, j] : pairs)
    tags.insert(tags.end(), {tagint(i), tagint(std::max<std::int64_t>(j, 0))});
  renumbering.translate(tags);
  PairsByTag now;
  for (std::size_t k = 0; k < pairs.size(); k++) {
    const std::int64_t i = tags[2 * k], j = pairs[k].j < 0 ? pairs[k].j : tags[2 * k + 1];
    if (i == 0 || j == 0) continue;  // a particle has been deleted
    now.push_back(j < 0 ? TagPair{i, j} : TagPair{std::min(i, j), std::max(i, j)});
  }
  pairs = std::move(now);
}

/// Collective: the pairs of all processes, sorted.
FixHardEvents::PairsByTag FixHardEvents::gather_pairs(const PairsByTag& mine) const {
  if (comm->nprocs == 1) return mine;
  const int bytes = static_cast<int>(mine.size() * sizeof(TagPair));
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs, 0);
  MPI_Allgather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  for (int p = 1; p < comm->nprocs; p++) starts[p] = starts[p - 1] + sizes[p - 1];
  std::vector<TagPair> all((starts.back() + sizes.back()) / sizeof(TagPair));
  MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE,
                 world);
  std::sort(all.begin(), all.end());
  return all;
}

/// Collective: the pairs in their wells after the events of the step. Pairs across a periodic
/// boundary are included from both sides.
std::vector<FixHardEvents::PairInWell> FixHardEvents::pairs_in_wells() {
  send_owners();
  // The own particle and the ghosts of a body, the own one first
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
    const Vector3 position = vector(atom->x[pair.i]) + pair.separation;
    double nearest = never;
    for (const int copy : copies[simulation_.bodies[pair.j].tag]) {
      const double away = norm(vector(atom->x[copy]) - position);
      if (away >= nearest) continue;
      nearest = away;
      pair.j = copy;
    }
  }
  return pairs;
}
