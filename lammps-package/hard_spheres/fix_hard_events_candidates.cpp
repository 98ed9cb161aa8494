// SPDX-License-Identifier: GPL-2.0-only
// The part of FixHardEvents that a new list of neighbours calls: the candidate pairs.
#include <algorithm>
#include <cmath>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine_api.h"
#include "fix_hard_events.h"
#include "neigh_list.h"
#include "pair_hard_square_well.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::vector;
using cohesion::Vector3;

// A pair nearer to the edge of its well than this fraction of it is at the edge, to round-off.
static constexpr double AT_EDGE = 1e-10;

/// Sets bodies, candidate pairs and remote particles by a new list of neighbours.
void FixHardEvents::set_up_candidates() {
  for (int i = 0; i < atom->nlocal; i++) {
    origin_[i][0] = comm->me;
    origin_[i][1] = i;
    std::copy_n(atom->x[i], 3, origin_[i] + 2);
  }
  engine_api::forward_comm(comm, this);
  displacements_.set_reference(atom->nlocal > 0 ? atom->x[0] : nullptr, atom->nlocal, domain->xy);
  for (int i = 0; i < atom->nlocal; i++) {
    for (int axis = 0; axis < 3; axis++) atom->x[i][axis] += outside_[i][axis];
    std::fill_n(outside_[i], 3, 0.0);
    track_displacement(i, vector(atom->x[i]) - simulation_.dt() * vector(atom->v[i]),
                       simulation_.dt());
  }

  simulation_.candidates.clear();
  simulation_.images.assign(1, Image{});
  shifts_.assign(1, Shift{0, 0, 0});
  slots_.clear();
  remote_.clear();
  remote_body_.clear();
  simulation_.bodies.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) set_body(i, i);
  add_pairs();
  add_walls();
  simulation_.index_candidates();
  add_second_entries();

  std::vector<BorderExchange::Request> requests;
  for (const RemoteParticle& f : remote_)
    requests.push_back({f.owner, static_cast<int>(origin_[f.ghost][1]), f.body});
  if (comm->nprocs > 1) time_warp_.plan(requests);
  load_flights();
  if (comm->nprocs > 1) time_warp_.load_borders();
  find_wells_of_new_pairs();
}

void FixHardEvents::set_body(int body, int i) {
  Body& b = simulation_.bodies[body];
  b.inverse_mass = mobile_.inverse_mass(atom->mask[i], atom->rmass[i]);
  b.radius = atom->radius[i];
  b.inverse_inertia =
      b.inverse_mass / (mobile_.inertia_factor(atom->mask[i]) * b.radius * b.radius);
  b.tag = atom->tag[i];
}

/// Returns the body of a particle or ghost, and makes that of a remote particle that has none yet.
int FixHardEvents::body_of(int i) {
  if (i < atom->nlocal) return i;
  const double* const origin = origin_[i];
  if (origin[0] == comm->me) return static_cast<int>(origin[1]);
  const auto key =
      (static_cast<std::uint64_t>(origin[0]) << 32) | static_cast<std::uint64_t>(origin[1]);
  const int next = static_cast<int>(simulation_.bodies.size());
  const auto found = remote_body_.emplace(key, next);
  if (found.second) {
    remote_.push_back({next, i, image_of(shift_of(i)), static_cast<int>(origin[0])});
    simulation_.bodies.emplace_back();
    set_body(next, i);
  }
  return found.first->second;
}

/// Returns by how many boxes a ghost is away from its owner.
FixHardEvents::Shift FixHardEvents::shift_of(int ghost) const {
  const double* const x = atom->x[ghost];
  const double* const from = origin_[ghost] + 2;
  const double* const h = domain->h;
  const double z = std::round((x[2] - from[2]) / h[2]);
  const double y = std::round((x[1] - from[1] - z * h[3]) / h[1]);
  const double along = std::round((x[0] - from[0] - y * h[5] - z * h[4]) / h[0]);
  return {static_cast<int>(along), static_cast<int>(y), static_cast<int>(z)};
}

int FixHardEvents::image_of(const Shift& shift) {
  const auto found = std::find(shifts_.begin(), shifts_.end(), shift);
  const int n = static_cast<int>(found - shifts_.begin());
  if (found == shifts_.end()) shifts_.push_back(shift);
  return n;
}

void FixHardEvents::update_images() {
  const double* const h = domain->h;
  const double* const rate = domain->h_rate;
  const bool sheared = domain->deform_vremap != 0;
  simulation_.images.resize(shifts_.size());
  for (std::size_t n = 0; n < shifts_.size(); n++) {
    const auto [x, y, z] = shifts_[n];
    const auto in_box = [x = x, y = y, z = z](const double* a) {
      return Vector3{x * a[0] + y * a[5] + z * a[4], y * a[1] + z * a[3], z * a[2]};
    };
    simulation_.images[n] = {in_box(h), sheared ? in_box(rate) : Vector3{}};
  }
}

/// Adds the pairs of the list of neighbours. A pair through the boundary between two particles of
/// this process is in the list twice; the entry of the lower tag makes the candidate pair.
void FixHardEvents::add_pairs() {
  NeighList* const list = pair_->list;
  const PairHistory& history = pair_->history();
  second_entries_.clear();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      if (j >= atom->nlocal && origin_[j][0] == comm->me && origin_[j][1] == i) continue;
      const int other = body_of(j);
      const Body &a = simulation_.bodies[i], &b = simulation_.bodies[other];
      if (a.inverse_mass + b.inverse_mass == 0.0) continue;
      Shift shift = j < atom->nlocal ? Shift{0, 0, 0} : shift_of(j);
      const bool first = a.tag < b.tag;
      if (!first) shift = {-shift.x, -shift.y, -shift.z};
      const int image = image_of(shift);
      int* const flag = &history->firstflag[i][jj];
      double* const value = &history->firstvalue[i][jj];
      if (j >= atom->nlocal && other < atom->nlocal && !first) {
        second_entries_.push_back({other, i, image, flag, value});
        continue;
      }
      CandidatePair candidate{first ? i : other, first ? other : i, image, 0, {0.0, 0.0}};
      candidate.law = pair_->of_types(atom->type[i], atom->type[j]);
      candidate.surfaces = pair_->surfaces(i, j);
      candidate.inside = *flag && candidate.surfaces.has_well();
      simulation_.candidates.push_back(candidate);
      slots_.push_back({{flag, nullptr}, {value, nullptr}});
    }
  }
}

void FixHardEvents::add_second_entries() {
  for (const SecondEntry& entry : second_entries_) {
    const int candidate = simulation_.find(entry.i, entry.j, entry.image);
    if (candidate < 0) continue;
    slots_[candidate].flag[1] = entry.flag;
    slots_[candidate].value[1] = entry.value;
  }
}

/// Adds each particle with the walls at rest that it can reach while this list holds, and with all
/// walls that move.
void FixHardEvents::add_walls() {
  const double range = 0.5 * (pair_->list_reach() + neighbor->skin);
  const int laws_of_walls = static_cast<int>(simulation_.laws.size()) -
                            static_cast<int>(walls_.size()) * (atom->ntypes + 1);
  simulation_.walls.clear();
  for (int n = 0; n < static_cast<int>(wall_.size()); n++) {
    const auto [walls, w] = wall_[n];
    simulation_.walls.push_back(walls->over_step(w));
    const MovingWall& wall = simulation_.walls.back();
    const auto fix = std::find(walls_.begin(), walls_.end(), walls) - walls_.begin();
    for (int i = 0; i < atom->nlocal; i++) {
      if (!walls->acts_on(i) || simulation_.bodies[i].inverse_mass == 0.0) continue;
      CandidatePair candidate{i, -1 - n, 0, 0, walls->surfaces_of(i)};
      const Vector3 end = vector(atom->x[i]);
      const Vector3 start = end - simulation_.dt() * vector(atom->v[i]);
      const double distance = wall.wall.nearest(end, wall.end, 0.0).distance;
      // A wall is not felt from behind.
      if (wall.wall.nearest(start, wall.at(simulation_.dt()), 0.0).distance <= 0.0) continue;
      if (walls->still() &&
          distance > std::max(candidate.surfaces.core, candidate.surfaces.edge) + range) {
        walls->inside(i, w) = 0.0;
        continue;
      }
      candidate.law = laws_of_walls + static_cast<int>(fix) * (atom->ntypes + 1) + atom->type[i];
      candidate.inside = walls->inside(i, w) > 0.0 && candidate.surfaces.has_well();
      simulation_.candidates.push_back(candidate);
      slots_.push_back({{nullptr, nullptr}, {&walls->inside(i, w), nullptr}});
    }
  }
}

/// Sets from the distance whether a pair is in its well. One that was no candidate before has not
/// fallen into its well, nor has one that was put elsewhere climbed out of it: neither is an event.
void FixHardEvents::find_wells_of_new_pairs() {
  for (int n = 0; n < static_cast<int>(simulation_.candidates.size()); n++) {
    CandidatePair& candidate = simulation_.candidates[n];
    if (candidate.surfaces.has_well()) {
      const double over = simulation_.distance_at_start(n) / candidate.surfaces.edge - 1.0;
      if (over < -AT_EDGE) candidate.inside = true;
      if (over > AT_EDGE) candidate.inside = false;
    }
    store_inside(n);
  }
}

/// Writes the state of a candidate to the history of pairs and walls.
void FixHardEvents::store_inside(int n) {
  const HistorySlots& slots = slots_[n];
  const int inside = simulation_.candidates[n].inside;
  for (int side = 0; side < 2; side++) {
    if (slots.flag[side]) *slots.flag[side] = inside;
    if (slots.value[side]) *slots.value[side] = inside;
  }
}
