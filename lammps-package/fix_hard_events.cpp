// SPDX-License-Identifier: GPL-2.0-only
#include "fix_hard_events.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine_api.h"
#include "error.h"
#include "fix_neigh_history.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "output.h"
#include "pair_hard_square_well.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::Vector3;

static constexpr char ID[] = "COHESION_HARD_EVENTS";
static constexpr int ORIGIN = 5;
// A pair nearer to the edge of its well than this share of it is at the edge, to round-off.
static constexpr double AT_EDGE = 1e-10;
// Share of a distance by which a ghost's own position may be off, with room: boxes of up to 1e6
// diameters.
static constexpr double NEARLY = 1e-9;
// Overlap that is told of: of a distance, above what a data file's decimals leave.
static constexpr double OVERLAP = 1e-6;
static constexpr int FIXED_BOUNDARY = 1;  // Domain::boundary
// Of all processes. Short stretches are agreed on at once, long ones have to be repeated.
static constexpr long EVENTS_OF_A_STRETCH = 64;

static Vector3 vector(const double* a) { return {a[0], a[1], a[2]}; }
static void put(const Vector3& a, double* to) {
  to[0] = a.x;
  to[1] = a.y;
  to[2] = a.z;
}

FixHardEvents::FixHardEvents(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg),
      pair_(nullptr),
      border_(world),
      origin_(nullptr),
      outside_(nullptr),
      farthest_(0.0),
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
}

FixHardEvents* FixHardEvents::of(LAMMPS* lmp) {
  Modify* modify = lmp->modify;
  if (modify->find_fix(ID) < 0) modify->add_fix(std::string(ID) + " all HARD_EVENTS");
  return static_cast<FixHardEvents*>(modify->fix[modify->find_fix(ID)]);
}

int FixHardEvents::setmask() { return FixConst::PRE_EXCHANGE | FixConst::PRE_FORCE; }

void FixHardEvents::init() {
  pair_ = dynamic_cast<PairHardSquareWell*>(force->pair_match("hard/square_well", 1));
  if (!pair_)
    error->all(FLERR,
               "fix wall/hard/square_well and compute hard/events go with 'pair_style "
               "hard/square_well'; give it first");
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
  order_.rules = pair_->rules();
  order_.rules.reports = comm->nprocs > 1;
  order_.laws = pair_->laws();
  for (const HardWalls* walls : walls_)
    for (int type = 0; type <= atom->ntypes; type++)
      order_.laws.push_back(type == 0 ? Law{} : walls->law_of_type(type));
}

/// A particle whose straight flight leads through a wall into the outside of the box would be lost
/// before its event turns it round: until then it waits at the boundary. One that was outside
/// before the step is lost as in any run.
void FixHardEvents::pre_exchange() {
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

/// Nothing has moved: the run starts here.
void FixHardEvents::setup_pre_force(int) {
  order_.begin_step(0.0);
  connect();
  tell_of_overlaps();
  next_reneighbor = update->ntimestep + 1;
}

/// Cores that overlap part as soon as they move apart, but their energy is nobody's.
void FixHardEvents::tell_of_overlaps() const {
  double mine[2] = {0.0, 0.0}, all[2];  // number, deepest as a share of the distance
  for (int n = 0; n < static_cast<int>(order_.links.size()); n++) {
    const Link& link = order_.links[n];
    const double overlap = 1.0 - order_.distance_at_start(n) / link.at.core;
    if (overlap < OVERLAP || link.i >= atom->nlocal) continue;
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

/// A run that goes on from a restart file begins with particles in the box and makes its list anew
/// in its first step. A run that writes one does the same, so that both put particles back into the
/// box at the same times and round alike.
void FixHardEvents::match_restart() {
  if (update->ntimestep != output->next_restart) return;
  for (int i = 0; i < atom->nlocal; i++) domain->remap(atom->x[i], atom->image[i]);
  next_reneighbor = update->ntimestep + 1;
}

void FixHardEvents::pre_force(int) {
  order_.begin_step(update->dt);
  farthest_ = 0.0;
  if (neighbor->ago == 0)
    connect();
  else
    load();
  const bool alone = comm->nprocs == 1;
  long counts[2] = {0, 0}, all[2] = {0, 0};
  for (int n = 0; n < static_cast<int>(order_.links.size()); n++)
    counts[0] += shared(order_.links[n]) ? order_.may_meet(n, NEARLY) : order_.predict(n);
  counts[1] = !warned_ && totals_.elastic > 0.0;
  if (alone)
    std::copy_n(counts, 2, all);
  else
    MPI_Allreduce(counts, all, 2, MPI_LONG, MPI_SUM, world);
  if (all[1] > 0 && !warned_) {
    warned_ = true;
    if (comm->me == 0)
      error->warning(FLERR,
                     "pair_style hard/square_well: a particle had {} collisions in one step; its "
                     "further ones in a step are elastic and frictionless (keyword collapse). "
                     "compute hard/events counts them",
                     order_.rules.collapse);
  }
  if (all[0] > 0) {
    if (!alone) load_borders();
    order_.sort();
    follow(all[0]);
    store();
    record_->write(order_);
    comm->forward_comm();
  }
  check_reach();
  match_restart();
}

/* ---------------------------------------------------------------------- */

/// With a new list of neighbours: bodies, links, and who needs news of whom.
void FixHardEvents::connect() {
  for (int i = 0; i < atom->nlocal; i++) {
    origin_[i][0] = comm->me;
    origin_[i][1] = i;
    std::copy_n(atom->x[i], 3, origin_[i] + 2);
  }
  engine_api::forward_comm(comm, this);
  hold_.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) {
    hold_[i] = vector(atom->x[i]);
    for (int axis = 0; axis < 3; axis++) atom->x[i][axis] += outside_[i][axis];
    FixHardEvents::set_arrays(i);
    stray(i, vector(atom->x[i]) - order_.dt() * vector(atom->v[i]));
  }

  order_.links.clear();
  order_.images.assign(1, Image{});
  shifts_.assign(1, Shift{0, 0, 0});
  slots_.clear();
  foreign_.clear();
  foreign_body_.clear();
  order_.bodies.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) describe(i, i);
  add_pairs();
  add_walls();
  order_.connect();
  add_twins();

  std::vector<BorderExchange::Request> requests;
  for (const Foreign& f : foreign_)
    requests.push_back({f.owner, static_cast<int>(origin_[f.ghost][1]), f.body});
  if (comm->nprocs > 1) border_.plan(requests, atom->nlocal);
  load();
  if (comm->nprocs > 1) load_borders();
  know_where_new_pairs_are();
}

void FixHardEvents::describe(int body, int i) {
  Body& b = order_.bodies[body];
  b.inverse_mass = mobile_.inverse_mass(atom->mask[i], atom->rmass[i]);
  b.radius = atom->radius[i];
  b.inverse_inertia =
      b.inverse_mass / (mobile_.inertia_factor(atom->mask[i]) * b.radius * b.radius);
  b.tag = atom->tag[i];
}

/// The body of a particle or ghost; made when it is another process's and not known yet.
int FixHardEvents::body_of(int i) {
  if (i < atom->nlocal) return i;
  const double* const origin = origin_[i];
  if (origin[0] == comm->me) return static_cast<int>(origin[1]);
  const auto key =
      (static_cast<std::uint64_t>(origin[0]) << 32) | static_cast<std::uint64_t>(origin[1]);
  const int next = static_cast<int>(order_.bodies.size());
  const auto found = foreign_body_.emplace(key, next);
  if (found.second) {
    foreign_.push_back({next, i, image_of(shift_of(i)), static_cast<int>(origin[0])});
    order_.bodies.emplace_back();
    describe(next, i);
  }
  return found.first->second;
}

/// By how many boxes a ghost is away from its owner.
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

void FixHardEvents::place_images() {
  const double* const h = domain->h;
  const double* const rate = domain->h_rate;
  const bool sheared = domain->deform_vremap != 0;
  order_.images.resize(shifts_.size());
  for (std::size_t n = 0; n < shifts_.size(); n++) {
    const auto [x, y, z] = shifts_[n];
    const auto in_box = [x = x, y = y, z = z](const double* a) {
      return Vector3{x * a[0] + y * a[5] + z * a[4], y * a[1] + z * a[3], z * a[2]};
    };
    order_.images[n] = {in_box(h), sheared ? in_box(rate) : Vector3{}};
  }
}

/// A pair through the boundary between two particles of this process is in the list twice; the
/// entry of the lower tag makes the link.
void FixHardEvents::add_pairs() {
  NeighList* const list = pair_->list;
  FixNeighHistory* const history = pair_->history();
  twins_.clear();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      if (j >= atom->nlocal && origin_[j][0] == comm->me && origin_[j][1] == i) continue;
      const int other = body_of(j);
      const Body &a = order_.bodies[i], &b = order_.bodies[other];
      if (a.inverse_mass + b.inverse_mass == 0.0) continue;
      Shift shift = j < atom->nlocal ? Shift{0, 0, 0} : shift_of(j);
      const bool first = a.tag < b.tag;
      if (!first) shift = {-shift.x, -shift.y, -shift.z};
      const int image = image_of(shift);
      int* const kept = &history->firstflag[i][jj];
      double* const value = &history->firstvalue[i][jj];
      if (j >= atom->nlocal && other < atom->nlocal && !first) {
        twins_.push_back({other, i, image, kept, value});
        continue;
      }
      Link link{first ? i : other, first ? other : i, image, 0, {0.0, 0.0}};
      link.law = pair_->of_types(atom->type[i], atom->type[j]);
      link.at = pair_->surfaces(i, j);
      link.inside = *kept && link.at.well();
      order_.links.push_back(link);
      slots_.push_back({{kept, nullptr}, {value, nullptr}});
    }
  }
}

void FixHardEvents::add_twins() {
  for (const Twin& twin : twins_) {
    const int link = order_.find(twin.i, twin.j, twin.image);
    if (link < 0) continue;
    slots_[link].kept[1] = twin.kept;
    slots_[link].value[1] = twin.value;
  }
}

/// The walls at rest that a particle can reach while this list holds, and all that move.
void FixHardEvents::add_walls() {
  const double range = 0.5 * (pair_->list_reach() + neighbor->skin);
  const int laws_of_walls =
      static_cast<int>(order_.laws.size()) - static_cast<int>(walls_.size()) * (atom->ntypes + 1);
  order_.walls.clear();
  for (int n = 0; n < static_cast<int>(wall_.size()); n++) {
    const auto [walls, w] = wall_[n];
    order_.walls.push_back(walls->over_step(w));
    const MovingWall& wall = order_.walls.back();
    const auto fix = std::find(walls_.begin(), walls_.end(), walls) - walls_.begin();
    for (int i = 0; i < atom->nlocal; i++) {
      if (!walls->acts_on(i) || order_.bodies[i].inverse_mass == 0.0) continue;
      Link link{i, -1 - n, 0, 0, walls->surfaces_of(i)};
      const Vector3 end = vector(atom->x[i]);
      const Vector3 start = end - order_.dt() * vector(atom->v[i]);
      const double distance = wall.wall.nearest(end, wall.end, 0.0).distance;
      // A wall is not felt from behind.
      if (wall.wall.nearest(start, wall.at(order_.dt()), 0.0).distance <= 0.0) continue;
      if (walls->still() && distance > std::max(link.at.core, link.at.edge) + range) {
        walls->inside(i, w) = 0.0;
        continue;
      }
      link.law = laws_of_walls + static_cast<int>(fix) * (atom->ntypes + 1) + atom->type[i];
      link.inside = walls->inside(i, w) > 0.0 && link.at.well();
      order_.links.push_back(link);
      slots_.push_back({{nullptr, nullptr}, {&walls->inside(i, w), nullptr}});
    }
  }
}

/// A pair that was not followed before is where it is: it did not fall into its well, nor did one
/// that was put elsewhere climb out of it.
void FixHardEvents::know_where_new_pairs_are() {
  for (int n = 0; n < static_cast<int>(order_.links.size()); n++) {
    Link& link = order_.links[n];
    if (link.at.well()) {
      const double over = order_.distance_at_start(n) / link.at.edge - 1.0;
      if (over < -AT_EDGE) link.inside = true;
      if (over > AT_EDGE) link.inside = false;
    }
    keep(n);
  }
}

/// The state of a link goes to the history of pairs and walls.
void FixHardEvents::keep(int n) {
  const Slots& slots = slots_[n];
  const int inside = order_.links[n].inside;
  for (int side = 0; side < 2; side++) {
    if (slots.kept[side]) *slots.kept[side] = inside;
    if (slots.value[side]) *slots.value[side] = inside;
  }
}

/* ---------------------------------------------------------------------- */

/// The flights of this step. Those of other processes' particles are as the ghosts tell them, which
/// is right but for round-off.
void FixHardEvents::load() {
  place_images();
  for (int i = 0; i < atom->nlocal; i++)
    order_.bodies[i].flight = {
        vector(atom->x[i]), vector(atom->v[i]), 0.0, vector(atom->omega[i]), 0, 0};
  for (const Foreign& known : foreign_) {
    const int g = known.ghost;
    const Image& image = order_.images[known.image];
    order_.bodies[known.body].flight = {vector(atom->x[g]) - image.displacement,
                                        vector(atom->v[g]) - image.velocity,
                                        0.0,
                                        vector(atom->omega[g]),
                                        0,
                                        0};
  }
  for (std::size_t n = 0; n < wall_.size(); n++)
    order_.walls[n] = wall_[n].first->over_step(wall_[n].second);
}

/// The flights of other processes' particles, as they are there.
void FixHardEvents::load_borders() {
  std::vector<std::vector<Flight> > out(border_.peers().size());
  std::vector<std::vector<Flight> > in;
  for (int p = 0; p < static_cast<int>(out.size()); p++)
    for (const int i : border_.told(p)) out[p].push_back(order_.bodies[i].flight);
  border_.swap(out, in);
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (int slot = 0; slot < static_cast<int>(in[p].size()); slot++)
      order_.bodies[border_.local(p, slot)].flight = in[p][slot];
}

/// Carries out the events of the step.
void FixHardEvents::follow(long candidates) {
  const double dt = update->dt;
  if (comm->nprocs == 1) {
    order_.run(dt);
    if (order_.overrun() >= 0) stop_at_limit();
    return;
  }
  for (int n = 0; n < static_cast<int>(order_.links.size()); n++)
    if (shared(order_.links[n])) order_.predict(n);
  order_.sort();
  const int stretches = std::clamp(static_cast<int>(candidates / EVENTS_OF_A_STRETCH), 1, 1000);
  for (int n = 1; n <= stretches; n++) follow_stretch(n == stretches ? dt : n * dt / stretches);
}

/// Again and again with the news of the others, until no news change.
void FixHardEvents::follow_stretch(double until) {
  order_.begin_stretch();
  std::vector<News> told;
  for (int mine = 1, again = 1; again;) {
    if (mine) {
      order_.take_back();
      order_.foreign = told;
      order_.run(until);
    }
    told = exchange_news();
    mine = told != order_.foreign;
    MPI_Allreduce(&mine, &again, 1, MPI_INT, MPI_MAX, world);
  }
  if (order_.overrun() >= 0) stop_at_limit();
}

/// What happened to this process's particles without those that a peer owns, to all who follow
/// them.
std::vector<News> FixHardEvents::exchange_news() {
  std::vector<std::vector<News> > out(border_.peers().size()), in;
  for (const News& news : order_.news) {
    if (news.body >= atom->nlocal) continue;
    const int owner =
        news.partner >= atom->nlocal ? foreign_[news.partner - atom->nlocal].owner : -1;
    for (const BorderExchange::Follower& follower : border_.followers(news.body)) {
      if (border_.peers()[follower.peer] == owner) continue;
      out[follower.peer].push_back(news);
      out[follower.peer].back().body = follower.slot;
    }
  }
  border_.swap(out, in);
  std::vector<News> all;
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (News news : in[p]) {
      news.body = border_.local(p, news.body);
      all.push_back(news);
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const News& a, const News& b) { return a.key < b.key; });
  return all;
}

void FixHardEvents::stop_at_limit() const {
  const Link& link = order_.links[order_.overrun()];
  const Body& a = order_.bodies[link.i];
  const auto tag_j = link.of_wall() ? static_cast<std::int64_t>(link.j) : order_.bodies[link.j].tag;
  error->one(FLERR,
             "pair_style hard/square_well: more than {} events of one particle in step {}, at "
             "particles {} and {} (negative: a wall); they had {} and {}. Particles are pressed "
             "together or clustering: use a smaller time step, collapse, or a larger limit",
             order_.rules.limit, update->ntimestep, a.tag, tag_j, a.flight.events,
             link.of_wall() ? 0 : order_.bodies[link.j].flight.events);
}

/// What the events changed goes to the engine's arrays, to histories and sums.
void FixHardEvents::store() {
  for (const Event& event : order_.events) {
    const Link& link = order_.links[event.link];
    for (const int body : {link.i, link.j}) {
      if (body < 0 || body >= atom->nlocal) continue;
      const Flight& now = order_.bodies[body].flight;
      put(now.end, atom->x[body]);
      put(now.velocity, atom->v[body]);
      put(now.spin, atom->omega[body]);
      totals_.busiest = std::max(totals_.busiest, static_cast<double>(now.events));
      const Vector3 place = body == link.i ? event.place : event.place + event.separation;
      if (body == link.i || link.image == 0)
        stray(body, place);
      else
        stray(body, place - order_.images[link.image].displacement);
    }
    keep(event.link);
    if (link.i < atom->nlocal) totals_.add(event, link.of_wall());
  }
}

void FixHardEvents::stray(int i, const Vector3& place) {
  const Vector3 way = place - hold_[i];
  farthest_ = std::max(farthest_, dot(way, way));
}

/// Whether the list of neighbours still holds all pairs that may have met.
void FixHardEvents::check_reach() {
  for (int i = 0; i < atom->nlocal; i++) stray(i, vector(atom->x[i]));
  const double reach = pair_->list_reach() + neighbor->skin, flown = std::sqrt(farthest_);
  if (2.0 * flown <= reach) return;
  error->one(FLERR,
             "pair_style hard/square_well: in step {} particles are up to {} away from where they "
             "were when the neighbour list was made, and could miss a partner; the list allows for "
             "{}. Use a smaller time step or 'neighbor' with a skin above {}, with 'neigh_modify "
             "delay 0 every 1 check yes'",
             update->ntimestep, flown, 0.5 * reach, neighbor->skin * 2.0 * flown / reach);
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
}

void FixHardEvents::copy_arrays(int i, int j, int) { std::copy_n(outside_[i], 3, outside_[j]); }

void FixHardEvents::set_arrays(int i) { std::fill_n(outside_[i], 3, 0.0); }

int FixHardEvents::pack_exchange(int i, double* buf) {
  std::copy_n(outside_[i], 3, buf);
  return 3;
}

int FixHardEvents::unpack_exchange(int i, double* buf) {
  std::copy_n(buf, 3, outside_[i]);
  return 3;
}

double FixHardEvents::memory_usage() {
  return static_cast<double>((ORIGIN + 3) * sizeof(double)) * atom->nmax +
         static_cast<double>(sizeof(Body) * order_.bodies.size() +
                             (sizeof(Link) + sizeof(Slots) + 2 * sizeof(int)) *
                                 order_.links.size());
}
