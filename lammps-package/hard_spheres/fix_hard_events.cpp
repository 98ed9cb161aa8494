// SPDX-License-Identifier: GPL-2.0-only
#include "fix_hard_events.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "atom.h"
#include "box_shear.h"
#include "comm.h"
#include "domain.h"
#include "engine_api.h"
#include "error.h"
#include "flight_report.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "output.h"
#include "pair_hard_square_well.h"
#include "shear/list_margin.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::vector;
using cohesion::Vector3;

static constexpr char ID[] = "COHESION_HARD_EVENTS";
static constexpr int ORIGIN = 5;
// Fraction of a distance by which a ghost's own position may be off, with room: boxes of up to 1e6
// diameters.
static constexpr double TOLERANCE = 1e-9;
// Overlap that is warned of, as a fraction of a distance: above what a data file's decimals leave.
static constexpr double OVERLAP = 1e-6;
static constexpr int FIXED_BOUNDARY = 1;  // Domain::boundary

static void put(const Vector3& a, double* to) {
  to[0] = a.x;
  to[1] = a.y;
  to[2] = a.z;
}

FixHardEvents::FixHardEvents(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg),
      pair_(nullptr),
      time_warp_(lammps, simulation_),
      origin_(nullptr),
      outside_(nullptr),
      kick_(nullptr),
      farthest_squared_(0.0),
      warned_(false) {
  comm_forward = ORIGIN;
  create_attribute = 1;
  restart_pbc = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
  FixHardEvents::grow_arrays(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) FixHardEvents::set_arrays(i);
  atom->add_callback(Atom::GROW);
}

FixHardEvents::~FixHardEvents() {
  atom->delete_callback(id, Atom::GROW);
  memory->destroy(origin_);
  memory->destroy(outside_);
  memory->destroy(kick_);
}

FixHardEvents* FixHardEvents::of(LAMMPS* lmp) {
  Modify* modify = lmp->modify;
  if (modify->find_fix(ID) < 0) modify->add_fix(std::string(ID) + " all HARD_EVENTS");
  return static_cast<FixHardEvents*>(modify->fix[modify->find_fix(ID)]);
}

int FixHardEvents::setmask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::PRE_EXCHANGE | FixConst::PRE_FORCE;
}

void FixHardEvents::init() {
  pair_ = dynamic_cast<PairHardSquareWell*>(force->pair_match("hard/square_well", 1));
  if (!pair_)
    error->all(FLERR,
               "fix wall/hard/square_well, compute hard/events and compute hard/stress go with "
               "'pair_style hard/square_well'; give it first");
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR,
               "pair_style hard/square_well acts over the whole step; use 'run_style verlet'");
  if (force->newton_pair)
    error->all(FLERR,
               "pair_style hard/square_well follows every pair on both sides; put 'newton off' "
               "before the box is made");
  if (comm->ghost_velocity == 0)
    error->all(FLERR,
               "pair_style hard/square_well needs the velocities of ghost particles; add "
               "'comm_modify vel yes'");
  mobile_.look_up(modify);
  walls_.clear();
  wall_.clear();
  for (int i = 0; i < modify->nfix; i++) {
    Fix* const fix = modify->fix[i];
    if (fix->rigid_flag)
      error->all(FLERR,
                 std::string("pair_style hard/square_well cannot follow rigid bodies (fix ") +
                     fix->id + ")");
    auto* walls = dynamic_cast<HardWalls*>(fix);
    if (!walls) continue;
    walls_.push_back(walls);
    for (int w = 0; w < static_cast<int>(walls->hard_walls().size()); w++)
      wall_.push_back({walls, w});
  }
  if (!record_) record_ = std::make_unique<HardEventRecord>(lmp, pair_->record_file());
  simulation_.rules = pair_->rules();
  simulation_.rules.distributed = comm->nprocs > 1;
  simulation_.laws = pair_->laws();
  for (const HardWalls* walls : walls_)
    for (int type = 0; type <= atom->ntypes; type++)
      simulation_.laws.push_back(type == 0 ? Law{} : walls->law_of_type(type));
}

/// Notes the kicks of this step, whose forces the engine clears before pre_force.
void FixHardEvents::initial_integrate(int) {
  for (int i = 0; i < atom->nlocal; i++)
    kick_[i] = kick_of(vector(atom->f[i]), mobile_.inverse_mass(atom->mask[i], atom->rmass[i]),
                       update->dt);
}

/// Keeps particles at the boundary whose free flight leads through a wall out of the box, until
/// their event turns them round: they would be lost before. One that was outside before the step is
/// lost as in any run.
void FixHardEvents::pre_exchange() {
  for (int axis = 0; axis < 3; axis++)
    for (int i = 0; domain->periodicity[axis] && i < atom->nlocal; i++)
      if (std::abs(update->dt * atom->v[i][axis]) >= domain->prd[axis])
        error->one(FLERR,
                   "pair_style hard/square_well: in step {} particle {} flies {} along {}, and the "
                   "box is {} long: use a smaller time step",
                   update->ntimestep, atom->tag[i], update->dt * atom->v[i][axis], "xyz"[axis],
                   domain -> prd[axis]);
  if (domain->triclinic) return;
  for (int axis = 0; axis < 3; axis++) {
    const double low = domain->boxlo[axis], high = domain->boxhi[axis];
    for (int side = 0; side < 2; side++) {
      if (domain->boundary[axis][side] != FIXED_BOUNDARY) continue;
      const double last = side == 0 ? low : std::nextafter(high, low);
      for (int i = 0; i < atom->nlocal; i++) {
        double& x = atom->x[i][axis];
        const double before = x - update->dt * atom->v[i][axis];
        if ((side == 0 ? x >= low : x < high) || before < low || before >= high) continue;
        outside_[i][axis] = x - last;
        x = last;
      }
    }
  }
}

/// The run starts here: nothing has moved.
void FixHardEvents::setup_pre_force(int) {
  simulation_.begin_step(0.0);
  round_positions();
  set_up_candidates();
  warn_of_overlaps();
  next_reneighbor = update->ntimestep + 1;
}

/// Warns of cores that overlap. They part as soon as they move apart, but no event accounts for
/// their energy.
void FixHardEvents::warn_of_overlaps() const {
  double mine[2] = {0.0, 0.0}, all[2];  // number, deepest as a fraction of the distance
  for (int n = 0; n < static_cast<int>(simulation_.candidates.size()); n++) {
    const CandidatePair& candidate = simulation_.candidates[n];
    const double overlap = 1.0 - simulation_.distance_at_start(n) / candidate.surfaces.core;
    if (overlap < OVERLAP || candidate.i >= atom->nlocal) continue;
    mine[0] += 1.0;
    mine[1] = std::max(mine[1], overlap);
  }
  MPI_Allreduce(&mine[0], &all[0], 1, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(&mine[1], &all[1], 1, MPI_DOUBLE, MPI_MAX, world);
  if (all[0] > 0.0 && comm->me == 0)
    error->warning(
        FLERR,
        "pair_style hard/square_well: {} pairs of hard cores (or core and wall) overlap, "
        "up to {} of the distance; they collide at once where they approach. Start from "
        "particles that do not overlap",
        static_cast<bigint>(all[0]), all[1]);
}

/// Does in the step of a restart file what a run does that continues from it: that begins with
/// particles in the box and makes its list anew in its first step. So both wrap particles into the
/// box at the same times and round alike.
void FixHardEvents::match_restart() {
  if (update->ntimestep != output->next_restart) return;
  wrap_into_box(atom, domain);
  round_positions();
  next_reneighbor = update->ntimestep + 1;
}

/// Rounds positions in a tilted box. A run begins there with positions that the engine has
/// transformed to the box's own coordinates and back, once more than where the file was written:
/// some roundings, each a few 2^-53 of the box. Rounded to 2^-44 of it both are the same again.
void FixHardEvents::round_positions() {
  if (!domain->triclinic) return;
  const double unit = std::ldexp(1.0, std::ilogb(std::max(domain->prd[0], domain->prd[1])) - 44);
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) atom->x[i][k] = unit * std::nearbyint(atom->x[i][k] / unit);
}

void FixHardEvents::pre_force(int) {
  simulation_.begin_step(update->dt);
  farthest_squared_ = 0.0;
  if (neighbor->ago == 0)
    set_up_candidates();
  else
    load_flights();
  const bool alone = comm->nprocs == 1;
  long counts[2] = {0, 0}, all[2] = {0, 0};
  for (int n = 0; n < static_cast<int>(simulation_.candidates.size()); n++)
    counts[0] += with_remote_body(simulation_.candidates[n]) ? simulation_.may_meet(n, TOLERANCE)
                                                             : simulation_.predict(n);
  counts[1] = !warned_ && totals_.elastic > 0.0;
  if (alone)
    std::copy_n(counts, 2, all);
  else
    MPI_Allreduce(counts, all, 2, MPI_LONG, MPI_SUM, world);
  if (all[1] > 0 && !warned_) {
    warned_ = true;
    if (comm->me == 0)
      error->warning(FLERR,
                     "pair_style hard/square_well: the rule against inelastic collapse (keywords "
                     "collapse and contact_time) has made collisions elastic and frictionless; "
                     "compute hard/events counts them");
  }
  if (all[0] > 0) {
    run_events(all[0]);
    store_results();
    record_->write(simulation_);
    comm->forward_comm();
  }
  check_list();
  match_restart();
}

/* ---------------------------------------------------------------------- */

/// Sets the flights of this step. Those of remote particles come from their ghosts, which are right
/// but for round-off.
void FixHardEvents::load_flights() {
  update_images();
  for (int i = 0; i < atom->nlocal; i++) {
    Flight& flight = simulation_.bodies[i].flight;
    flight = {vector(atom->x[i]), vector(atom->v[i]), 0.0, vector(atom->omega[i]), 0, 0};
    flight.kick = kick_[i];
  }
  for (const RemoteParticle& remote : remote_) {
    const int g = remote.ghost;
    const Image& image = simulation_.images[remote.image];
    simulation_.bodies[remote.body].flight = {vector(atom->x[g]) - image.displacement,
                                              vector(atom->v[g]) - image.velocity,
                                              0.0,
                                              vector(atom->omega[g]),
                                              0,
                                              0};
  }
  for (std::size_t n = 0; n < wall_.size(); n++)
    simulation_.walls[n] = wall_[n].first->over_step(wall_[n].second);
}

/// Executes the events of the step.
void FixHardEvents::run_events(long expected_events) {
  if (comm->nprocs == 1) {
    simulation_.order_queue();
    simulation_.run(update->dt);
  } else {
    time_warp_.load_borders();
    time_warp_.run_step(expected_events);
  }
  if (simulation_.overrun() >= 0) stop_at_limit();
}

void FixHardEvents::stop_at_limit() const {
  const CandidatePair& candidate = simulation_.candidates[simulation_.overrun()];
  const Body& a = simulation_.bodies[candidate.i];
  const auto tag_j = candidate.with_wall() ? static_cast<std::int64_t>(candidate.j)
                                           : simulation_.bodies[candidate.j].tag;
  error->one(FLERR,
             "pair_style hard/square_well: more than {} events of one particle in step {}, at "
             "particles {} and {} (negative: a wall); they had {} and {}. Particles are pressed "
             "together: use a smaller time step, keyword rest or contact_time, or a larger limit",
             simulation_.rules.limit, update->ntimestep, a.tag, tag_j, a.flight.events,
             candidate.with_wall() ? 0 : simulation_.bodies[candidate.j].flight.events);
}

/// Writes what the events have changed to the engine's arrays, to histories and sums.
void FixHardEvents::store_results() {
  for (const Event& event : simulation_.events) {
    const CandidatePair& candidate = simulation_.candidates[event.candidate];
    for (const int body : {candidate.i, candidate.j}) {
      if (body < 0 || body >= atom->nlocal) continue;
      const Flight& now = simulation_.bodies[body].flight;
      put(now.end, atom->x[body]);
      put(now.velocity, atom->v[body]);
      put(now.spin, atom->omega[body]);
      totals_.most_events = std::max(totals_.most_events, static_cast<double>(now.events));
      const double left = update->dt - event.key.time;
      const Vector3 position =
          body == candidate.i ? event.position : event.position + event.separation;
      if (body == candidate.i || candidate.image == 0)
        track_displacement(body, position, left);
      else
        track_displacement(body, position - simulation_.images[candidate.image].at(left), left);
    }
    store_inside(event.candidate);
    if (candidate.i < atom->nlocal) totals_.add(event, candidate.with_wall());
  }
}

/// Notes the nonaffine displacement of particle i, which is at `position`, `left` before the end of
/// the step.
void FixHardEvents::track_displacement(int i, const Vector3& position, double left) {
  farthest_squared_ =
      std::max(farthest_squared_,
               displacements_.squared(i, position, shear_since(displacements_, domain, left)));
}

/// Stops when the list of neighbours may have missed a pair.
void FixHardEvents::check_list() {
  for (int i = 0; i < atom->nlocal; i++) track_displacement(i, vector(atom->x[i]), 0.0);
  const double extra = pair_->list_reach() + neighbor->skin;
  const double largest = std::max(std::abs(shear_since(displacements_, domain).amount),
                                  std::abs(shear_since(displacements_, domain, update->dt).amount));
  const double margin =
      cohesion::shear::list_margin(neighbor->cutneighmax, neighbor->cutneighmax - extra, largest);
  const double flown = std::sqrt(farthest_squared_);
  if (flown <= margin) return;
  error->one(FLERR,
             "pair_style hard/square_well: in step {} particles are up to {} away from where they "
             "were when the neighbour list was made, and could miss a partner; the list allows for "
             "{}. Use a smaller time step or 'neighbor' with a skin above {}, with 'neigh_modify "
             "delay 0 every 1 check yes'. The fastest: {}",
             update->ntimestep, flown, margin,
             neighbor->skin * (1.0 + 2.0 * (flown - margin) / extra), report_fastest(lmp));
}

/* ---------------------------------------------------------------------- */

int FixHardEvents::pack_forward_comm(int n, int* list, double* buf, int, int*) {
  for (int i = 0; i < n; i++) std::copy_n(origin_[list[i]], ORIGIN, buf + ORIGIN * i);
  return ORIGIN * n;
}

void FixHardEvents::unpack_forward_comm(int n, int first, double* buf) {
  std::copy_n(buf, ORIGIN * n, origin_[first]);
}

void FixHardEvents::grow_arrays(int nmax) {
  memory->grow(origin_, nmax, ORIGIN, "hard_events:origin");
  memory->grow(outside_, nmax, 3, "hard_events:outside");
  memory->grow(kick_, nmax, "hard_events:kick");
}

void FixHardEvents::copy_arrays(int i, int j, int) {
  std::copy_n(outside_[i], 3, outside_[j]);
  kick_[j] = kick_[i];
}

void FixHardEvents::set_arrays(int i) {
  std::fill_n(outside_[i], 3, 0.0);
  kick_[i] = 0.0;
}

int FixHardEvents::pack_exchange(int i, double* buf) {
  std::copy_n(outside_[i], 3, buf);
  buf[3] = kick_[i];
  return 4;
}

int FixHardEvents::unpack_exchange(int i, double* buf) {
  std::copy_n(buf, 3, outside_[i]);
  kick_[i] = buf[3];
  return 4;
}

double FixHardEvents::memory_usage() {
  return static_cast<double>((ORIGIN + 4) * sizeof(double)) * atom->nmax +
         static_cast<double>(sizeof(Body) * simulation_.bodies.size() +
                             (sizeof(CandidatePair) + sizeof(HistorySlots) + 2 * sizeof(int)) *
                                 simulation_.candidates.size());
}
