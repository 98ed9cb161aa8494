// SPDX-License-Identifier: GPL-2.0-only
#include "hard_spheres/fix_hard_events.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "domain.h"
#include "engine/occasional_lists.h"
#include "error.h"
#include "group.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::vector;
using cohesion::Vector3;

static constexpr char ID[] = "COHESION_HARD_EVENTS";
static constexpr int OWNER_SIZE = 2;
// Steps between resets of the simulation time if particles have left the box. A reset wraps
// positions, which lose digits far from the box.
static constexpr int STEPS_BETWEEN_RESETS = 100;

FixHardEvents::FixHardEvents(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg), time_warp_(lammps, simulation_) {
  comm_forward = OWNER_SIZE;
  create_attribute = 1;
  restart_pbc = 1;
  restart_global = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
  FixHardEvents::grow_arrays(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) FixHardEvents::set_arrays(i);
  atom->add_callback(Atom::GROW);
}

FixHardEvents::~FixHardEvents() {
  atom->delete_callback(id, Atom::GROW);
  memory->destroy(particle_data_);
  memory->destroy(owners_);
}

FixHardEvents* FixHardEvents::find_or_create(LAMMPS* lmp) {
  Modify* modify = lmp->modify;
  if (modify->find_fix(ID) < 0) modify->add_fix(std::string(ID) + " all HARD_EVENTS");
  return static_cast<FixHardEvents*>(modify->fix[modify->find_fix(ID)]);
}

int FixHardEvents::setmask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::PRE_EXCHANGE | FixConst::PRE_FORCE;
}

/// Stores the velocity changes of this step, since the engine clears forces before pre_force.
void FixHardEvents::initial_integrate(int) {
  for (int i = 0; i < atom->nlocal; i++)
    particle_data_[i][SPEED_INCREMENT] = speed_increment(
        vector(atom->f[i]), mobile_.inverse_mass(atom->mask[i], atom->rmass[i]), update->dt);
}

/// Makes the step of a restart file equal to the first step of a run that continues from it. Such a
/// run starts with wrapped particles and builds its list in its first step. So both runs wrap
/// particles at the same steps and round alike.
void FixHardEvents::prepare_restart_step() {
  if (update->ntimestep != output->next_restart) return;
  wrap_into_box(atom, domain);
  round_positions();
  next_reneighbor = update->ntimestep + 1;
  reset_in_next_step_ = true;
}

/// Rounds positions in a tilted box. A run that starts from a restart file has transformed
/// positions to box coordinates and back once more than the run that wrote it. Each transformation
/// has an error of a few 2^-53 of the box; rounding to 2^-44 of the box removes the difference.
void FixHardEvents::round_positions() {
  if (!domain->triclinic) return;
  const double unit = std::ldexp(1.0, std::ilogb(std::max(domain->prd[0], domain->prd[1])) - 44);
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) atom->x[i][k] = unit * std::nearbyint(atom->x[i][k] / unit);
}

static bool has_dynamic_groups(const Group* group) {
  return std::any_of(group->dynamic, group->dynamic + group->ngroup,
                     [](int dynamic) { return dynamic != 0; });
}

/// The bits of the groups that decide which particles have events with each other or with walls.
static int event_group_bits(const std::vector<HardWall>& walls, const Neighbor* neighbor) {
  int bits = 0;
  for (const HardWall& wall : walls) bits |= wall.group_bits;
  for (int n = 0; n < neighbor->nex_group; n++) bits |= neighbor->ex1_bit[n] | neighbor->ex2_bit[n];
  return bits;
}

void FixHardEvents::pre_force(int) {
  const double dt = update->dt;
  const bool new_list = neighbor->ago == 0;
  farthest_squared_ = 0.0;
  changed_bodies_.clear();
  if (new_list) {
    discard_occasional_lists(neighbor);
    restore_clamped_positions();
  }
  const bool reset = reset_in_next_step_ || box_has_changed(dt) || time_reset_is_due();
  const bool shift_origin = !reset && simulation_.end() > time_origin_lifetime_;
  if (reset) {
    bound_at_edge_ = gather_bound_pairs_at_edge();
    reset_simulation_time(dt);
    load_all(dt);
    set_up_events();
    stored_versions_.clear();
    simulation_.begin_step(dt);
  } else {
    if (new_list && (comm->nprocs > 1 || !has_same_bodies())) {
      if (!update_bodies(dt)) {
        set_up_events();
        stored_versions_.clear();
      }
    }
    if (shift_origin) simulation_.shift_time_origin();
    simulation_.begin_step(dt);
    load_changes(dt);
  }
  if (reset || shift_origin) set_time_origin_lifetime();
  reset_in_next_step_ = false;
  if (new_list) {
    store_tags();
    displacements_.set_reference(atom->nlocal > 0 ? atom->x[0] : nullptr, atom->nlocal, domain->xy);
    for (int i = 0; i < atom->nlocal; i++)
      track_displacement(i, vector(atom->x[i]) - dt * vector(atom->v[i]), dt);
  }
  predict_changed_bodies();
  run_events();
  store_events();
  store_flights();
  if (needs_ghosts_) check_neighbour_list();
  // A dynamic group can change the mobility of a particle between two lists.
  if (has_dynamic_groups(group)) {
    const int groups = event_group_bits(simulation_.walls, neighbor);
    int mine = 0, all = 0;
    for (int i = 0; i < atom->nlocal && !mine; i++) {
      const HardSphere& before = simulation_.bodies[i];
      HardSphere now = body_properties(i);
      if (((now.group_bits ^ before.group_bits) & groups) == 0) now.group_bits = before.group_bits;
      mine = !same_properties(now, before);
    }
    MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
    if (all) next_reneighbor = update->ntimestep + 1;
  }
  prepare_restart_step();
}

/// Collective: whether enough steps have passed since the last reset of the simulation time, and a
/// particle has left the box since.
bool FixHardEvents::time_reset_is_due() {
  if (++steps_since_reset_ <= STEPS_BETWEEN_RESETS) return false;
  steps_since_reset_ = 0;
  int mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal && !mine; i++) mine = !same(boxes_crossed(i), {});
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  return all;
}

/// Collective: predicts the events of bodies whose flights the engine has changed on any process.
void FixHardEvents::predict_changed_bodies() {
  int mine[2] = {!changed_bodies_.empty(), !warned_ && totals_.elastic > 0.0}, all[2];
  if (comm->nprocs == 1)
    std::copy_n(mine, 2, all);
  else
    MPI_Allreduce(mine, all, 2, MPI_INT, MPI_MAX, world);
  if (all[0] && comm->nprocs > 1) time_warp_.exchange_changes(changed_bodies_);
  for (const auto& changed : changed_bodies_) simulation_.predict(changed.body);
  simulation_.predict_at_moving_walls();
  if (!all[1]) return;
  warned_ = true;
  if (comm->me == 0)
    error->warning(FLERR,
                   "pair_style hard/squarewell: the rule against inelastic collapse (keywords "
                   "collapse and contact_time) has made collisions elastic and frictionless; "
                   "compute hard/events counts them");
}

/// Executes the events of the step.
void FixHardEvents::run_events() {
  if (comm->nprocs == 1)
    simulation_.run(simulation_.end());
  else
    time_warp_.run_step();
  if (simulation_.overrun().first >= 0) stop_at_limit();
}

void FixHardEvents::stop_at_limit() const {
  const auto [i, j] = simulation_.overrun();
  const HardSphere& a = simulation_.bodies[i];
  error->one(FLERR,
             "pair_style hard/squarewell: more than {} events of one particle in step {}, at "
             "particles {} and {} (negative: a wall); they had {} and {}. Particles are pressed "
             "together: use a smaller time step, keyword rest or contact_time, or a larger limit",
             simulation_.rules.event_limit, update->ntimestep, a.tag,
             j < 0 ? static_cast<std::int64_t>(j) : simulation_.bodies[j].tag, a.event_state.events,
             j < 0 ? 0 : simulation_.bodies[j].event_state.events);
}

/* ---------------------------------------------------------------------- */

int FixHardEvents::pack_forward_comm(int n, int* list, double* buf, int, int*) {
  for (int i = 0; i < n; i++) std::copy_n(owners_[list[i]], OWNER_SIZE, buf + OWNER_SIZE * i);
  return OWNER_SIZE * n;
}

void FixHardEvents::unpack_forward_comm(int n, int first, double* buf) {
  std::copy_n(buf, OWNER_SIZE * n, owners_[first]);
}

void FixHardEvents::grow_arrays(int nmax) {
  memory->grow(owners_, nmax, OWNER_SIZE, "hard_events:origin");
  memory->grow(particle_data_, nmax, DATA_COLUMNS, "hard_events:columns");
}

void FixHardEvents::copy_arrays(int i, int j, int) {
  std::copy_n(particle_data_[i], DATA_COLUMNS, particle_data_[j]);
}

/// A NaN marks a particle without a stored flight.
void FixHardEvents::set_arrays(int i) {
  std::fill_n(particle_data_[i], DATA_COLUMNS, 0.0);
  particle_data_[i][START_TIME] = std::nan("");
}

int FixHardEvents::pack_exchange(int i, double* buf) {
  std::copy_n(particle_data_[i], DATA_COLUMNS, buf);
  return DATA_COLUMNS;
}

int FixHardEvents::unpack_exchange(int i, double* buf) {
  std::copy_n(buf, DATA_COLUMNS, particle_data_[i]);
  return DATA_COLUMNS;
}

/// Writes the tags of bound pairs at the edges of their wells, since their distances do not show
/// whether they are bound.
void FixHardEvents::write_restart(FILE* fp) {
  const auto pairs = gather_bound_pairs_at_edge();
  if (comm->me != 0) return;
  const auto number = static_cast<std::int64_t>(pairs.size());
  const int bytes = static_cast<int>(sizeof(number) + pairs.size() * sizeof(pairs[0]));
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(&number, sizeof(number), 1, fp);
  fwrite(pairs.data(), sizeof(pairs[0]), pairs.size(), fp);
}

void FixHardEvents::restart(char* buf) {
  std::int64_t number = 0;
  memcpy(&number, buf, sizeof(number));
  bound_at_edge_.resize(number);
  memcpy(bound_at_edge_.data(), buf + sizeof(number), number * sizeof(bound_at_edge_[0]));
}

double FixHardEvents::memory_usage() {
  return static_cast<double>((OWNER_SIZE + DATA_COLUMNS) * sizeof(double)) * atom->nmax +
         simulation_.bytes();
}
