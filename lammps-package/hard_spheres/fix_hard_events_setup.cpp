// SPDX-License-Identifier: GPL-2.0-only
// The part of FixHardEvents that prepares a run.
#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <tuple>

#include "atom.h"
#include "comm.h"
#include "common/bound_pairs.h"
#include "common/distinct_places.h"
#include "engine/occasional_lists.h"
#include "engine/rerun.h"
#include "engine/special_pairs.h"
#include "error.h"
#include "force.h"
#include "hard_spheres/fix_hard_events.h"
#include "hard_spheres/pair_hard_square_well.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;

// Relative overlap of two cores that causes a warning: larger than the rounding of a data file.
static constexpr double OVERLAP = 1e-6;

void FixHardEvents::init() {
  pair_ = PairHardSquareWell::in_use(force);
  if (!pair_)
    error->all(FLERR,
               "fix wall/hard/squarewell, compute hard/events and compute hard/stress go with "
               "'pair_style hard/squarewell'; give it first");
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR,
               "pair_style hard/squarewell acts over the whole step; use 'run_style verlet'");
  if (force->newton_pair)
    error->all(FLERR,
               "pair_style hard/squarewell follows every pair on both sides; put 'newton off' "
               "before the box is made");
  if (comm->ghost_velocity == 0)
    error->all(FLERR,
               "pair_style hard/squarewell needs the velocities of ghost particles; add "
               "'comm_modify vel yes'");
  if (neighbor->nex_mol > 0)
    error->all(FLERR,
               "pair_style hard/squarewell does not know 'neigh_modify exclude molecule'; exclude "
               "types or groups");
  refuse_rerun(lmp, "pair_style hard/squarewell");
  mobile_.look_up(lmp);
  require_whole_holds(lmp, "pair_style hard/squarewell", true);
  walls_.clear();
  needs_ghosts_ = comm->nprocs > 1 || utils::strmatch(force->pair_style, "^hybrid");
  for (int i = 0; i < modify->nfix; i++) {
    Fix* const fix = modify->fix[i];
    if (fix->rigid_flag)
      error->all(FLERR, std::string("pair_style hard/squarewell cannot follow rigid bodies (fix ") +
                            fix->id + ")");
    if (auto* walls = dynamic_cast<HardWallSource*>(fix)) walls_.push_back(walls);
    if (dynamic_cast<BoundPairsReader*>(fix)) needs_ghosts_ = true;
  }
  if (!record_) record_ = std::make_unique<HardEventRecord>(lmp, pair_->record_file());
  simulation_.rules = pair_->rules();
  simulation_.single_process = comm->nprocs == 1;
  wrap_far_particles();
}

/// At the start of a run no particle has moved yet.
void FixHardEvents::setup_pre_force(int) {
  discard_occasional_lists(neighbor);
  round_positions();
  set_rules();
  PairsByTag last_run = gather_bound_pairs_at_edge();
  apply_new_tags(last_run);
  bound_at_edge_.insert(bound_at_edge_.end(), last_run.begin(), last_run.end());
  std::sort(bound_at_edge_.begin(), bound_at_edge_.end());
  reset_simulation_time(0.0);
  load_all(0.0);
  require_distinct_positions();
  set_up_events();
  warn_of_overlaps();
  next_reneighbor = update->ntimestep + 1;
  reset_in_next_step_ = true;
}

/// Stops if two bodies, ghosts included, have the same position.
void FixHardEvents::require_distinct_positions() const {
  std::vector<int> order(atom->nlocal + atom->nghost);
  std::iota(order.begin(), order.end(), 0);
  const auto position = [this](int i) {
    const double* const x = atom->x[i];
    return std::make_tuple(x[0], x[1], x[2]);
  };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return position(i) < position(j); });
  for (std::size_t n = 1; n < order.size(); n++) {
    const int i = order[n - 1], j = order[n];
    if (position(i) == position(j) &&
        simulation_.pairs.interact(body_properties(i), body_properties(j)))
      refuse_one_place(lmp, "pair_style hard/squarewell", i, j);
  }
}

/// Sets the impacts between types, and the exclusions of the script.
void FixHardEvents::set_rules() {
  const int materials = atom->ntypes + 1;
  simulation_.pairs = PairRules(materials);
  for (int i = 0; i < materials; i++)
    for (int j = i; j < materials; j++) {
      if (i > 0 && pair_->acts_between(i, j))
        simulation_.pairs.set(i, j, pair_->contact(i, j));
      else
        simulation_.pairs.exclude(i, j);
    }
  for (int n = 0; n < neighbor->nex_type; n++)
    simulation_.pairs.exclude(neighbor->ex1_type[n], neighbor->ex2_type[n]);
  for (int n = 0; n < neighbor->nex_group; n++)
    simulation_.pairs.exclude_groups(neighbor->ex1_bit[n], neighbor->ex2_bit[n]);
  if (atom->nspecial) simulation_.pairs.exclude_pairs(excluded_bonded_pairs());
}

/// Collective: the bonded pairs that special_bonds excludes from impacts, sorted.
FixHardEvents::PairsByTag FixHardEvents::excluded_bonded_pairs() const {
  const double* const factors = special_factors(lmp, pair_);
  PairsByTag mine;
  for (int i = 0; i < atom->nlocal; i++)
    for (int bonds = 1, n = 0; bonds <= 3; bonds++)
      for (; n < atom->nspecial[i][bonds - 1]; n++)
        if (factors[bonds] == 0.0 && atom->tag[i] < atom->special[i][n])
          mine.push_back({atom->tag[i], atom->special[i][n]});
  std::sort(mine.begin(), mine.end());
  return gather_pairs(mine);
}

/// Warns of overlapping cores. They separate without an event, which the energy balance then lacks.
void FixHardEvents::warn_of_overlaps() const {
  double mine[2] = {0.0, 0.0}, all[2];  // number, and largest overlap relative to the distance
  simulation_.for_each_pair([&](int i, const Neighbour& n) {
    if (n.is_wall()) return;  // the fixes of the walls warn of these
    if (simulation_.bodies[n.body].tag < simulation_.bodies[i].tag &&
        simulation_.bodies[n.body].remote)
      return;
    const double overlap =
        1.0 - simulation_.distance(i, n, simulation_.end()) / simulation_.surfaces(i, n.body).core;
    if (overlap < OVERLAP) return;
    mine[0] += 1.0;
    mine[1] = std::max(mine[1], overlap);
  });
  MPI_Allreduce(&mine[0], &all[0], 1, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(&mine[1], &all[1], 1, MPI_DOUBLE, MPI_MAX, world);
  if (all[0] > 0.0 && comm->me == 0)
    error->warning(FLERR,
                   "pair_style hard/squarewell: {} pairs of hard cores overlap, "
                   "up to {} of the distance; they collide at once where they approach. Start from "
                   "particles that do not overlap",
                   static_cast<bigint>(all[0]), all[1]);
}
