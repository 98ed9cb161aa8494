// SPDX-License-Identifier: GPL-2.0-only
// The part of FixHardEvents that transfers flights, bodies and walls from the engine to the
// simulation.
#include <algorithm>
#include <cmath>
#include <limits>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "domain.h"
#include "error.h"
#include "hard_spheres/fix_hard_events.h"
#include "hard_spheres/pair_hard_square_well.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::vector;
using cohesion::Vector3;

// Difference between the flight of the simulation and the straight motion of the engine, as a
// fraction of the box length: some roundings on each side.
static constexpr double ROUND_OFF = 64.0 * std::numeric_limits<double>::epsilon();
// Displacement from the flight, in radii, above which the engine has relocated a particle.
static constexpr double RELOCATION_DISTANCE = 0.1;
static constexpr int FIXED_BOUNDARY = 1;  // Domain::boundary
// Distance outside the box, in boxes, up to which the wrapping of the engine is sufficient.
// It shifts by one box at most; half a box leaves a margin for round-off.
static constexpr double WRAPPED_BY_ENGINE = 0.5;

static PeriodicBox::Edges edges(const double* h) { return {h[0], h[1], h[2], h[3], h[4], h[5]}; }

static PeriodicBox::Edges rates(const Domain* domain) {
  return domain->deform_vremap ? edges(domain->h_rate) : PeriodicBox::Edges{};
}

void FixHardEvents::pre_exchange() {
  require_flights_within_box();
  clamp_to_boundary();
  wrap_far_particles();
}

/// Stops if the flight of a particle in one step is longer than the box.
void FixHardEvents::require_flights_within_box() const {
  for (int axis = 0; axis < 3; axis++)
    for (int i = 0; domain->periodicity[axis] && i < atom->nlocal; i++)
      if (std::abs(update->dt * atom->v[i][axis]) >= domain->prd[axis])
        error->one(FLERR,
                   "pair_style hard/squarewell: in step {} particle {} flies {} along {}, and the "
                   "box is {} long: use a smaller time step",
                   update->ntimestep, atom->tag[i], update->dt * atom->v[i][axis], "xyz"[axis],
                   domain -> prd[axis]);
}

/// Shift of the boundaries of an axis at a position relative to the corner of the box, since the
/// boundaries of a tilted box depend on the other axes.
static double boundary_shift(const Domain* domain, int axis, const Vector3& x) {
  if (!domain->triclinic || axis == 2) return 0.0;
  const double fraction_z = (x.z - domain->boxlo[2]) / domain->prd[2];
  if (axis == 1) return fraction_z * domain->yz;
  const double fraction_y = (x.y - domain->boxlo[1] - fraction_z * domain->yz) / domain->prd[1];
  return fraction_y * domain->xy + fraction_z * domain->xz;
}

/// Distance from a boundary within which the engine may round a position to the other side, by its
/// transformation to the coordinates of a tilted box and back.
static double boundary_width(const Domain* domain, int axis) {
  if (!domain->triclinic) return 0.0;
  const double tilts = std::abs(domain->xy) + std::abs(domain->xz) + std::abs(domain->yz);
  return ROUND_OFF * (domain->prd[axis] + tilts + std::abs(domain->boxlo[axis]));
}

/// Clamps particles to the boundary whose free flight leads through a wall out of the box, since
/// the engine would delete them before their event reverses them. A particle that was outside
/// before the step is deleted as in any run.
void FixHardEvents::clamp_to_boundary() {
  // An axis comes after the axes on which its boundaries depend.
  for (int axis = 2; axis >= 0; axis--) {
    const double low = domain->boxlo[axis], high = domain->boxhi[axis];
    const double width = boundary_width(domain, axis);
    for (int side = 0; side < 2; side++) {
      if (domain->boundary[axis][side] != FIXED_BOUNDARY) continue;
      const double last = side == 0 ? low + width : std::nextafter(high, low) - width;
      for (int i = 0; i < atom->nlocal; i++) {
        double& x = atom->x[i][axis];
        const Vector3 position = vector(atom->x[i]),
                      start = position - update->dt * vector(atom->v[i]);
        const double shift = boundary_shift(domain, axis, position), now = x - shift;
        const double before =
            x - update->dt * atom->v[i][axis] - boundary_shift(domain, axis, start);
        if ((side == 0 ? now >= last : now <= last) || before < low || before >= high) continue;
        particle_data_[i][CLAMPED + axis] = now - last;
        x = last + shift;
      }
    }
  }
}

/// Wraps particles that are far outside the box. The engine shifts by one box at most, but an event
/// near the end of a flight can lead back by more than one box from the wrapped position.
void FixHardEvents::wrap_far_particles() { wrap_into_box(atom, domain, WRAPPED_BY_ENGINE); }

/// Restores the positions that clamp_to_boundary() has changed.
void FixHardEvents::restore_clamped_positions() {
  for (int i = 0; i < atom->nlocal; i++)
    for (int axis = 0; axis < 3; axis++) {
      atom->x[i][axis] += particle_data_[i][CLAMPED + axis];
      particle_data_[i][CLAMPED + axis] = 0.0;
    }
}

/// Number of boxes along each axis by which a particle has left the box since the last reset of the
/// simulation time.
Vector3 FixHardEvents::boxes_crossed(int i) const {
  const auto before = static_cast<imageint>(ubuf(particle_data_[i][IMAGE]).i);
  const imageint now = atom->image[i];
  return now == before ? Vector3{} : boxes_between(now, before);
}

void FixHardEvents::store_image_flags(int i) { particle_data_[i][IMAGE] = ubuf(atom->image[i]).d; }

/// Whether the box at the end of this step differs from that of the simulation.
bool FixHardEvents::box_has_changed(double dt) const {
  const PeriodicBox& box = simulation_.box();
  const double end = simulation_.end() + dt;
  const PeriodicBox::Edges expected = box.edges_at(end), now = edges(domain->h),
                           rate = rates(domain);
  const auto differ = [&](double PeriodicBox::Edges::* k) {
    return std::abs(expected.*k - now.*k) > ROUND_OFF * (now.xx + now.yy + now.zz) ||
           box.rates.*k != rate.*k;
  };
  return (box.periodic[0] && differ(&PeriodicBox::Edges::xx)) ||
         (box.periodic[1] &&
          (differ(&PeriodicBox::Edges::yy) || differ(&PeriodicBox::Edges::xy))) ||
         (box.periodic[2] && (differ(&PeriodicBox::Edges::zz) || differ(&PeriodicBox::Edges::xz) ||
                              differ(&PeriodicBox::Edges::yz)));
}

/// Sets the simulation time to 0 at the beginning of this step, with the box of that time.
void FixHardEvents::reset_simulation_time(double dt) {
  PeriodicBox box;
  box.origin = vector(domain->boxlo);
  box.rates = rates(domain);
  box.edges = edges(domain->h);
  box.edges = box.edges_at(-dt);
  for (int k = 0; k < 3; k++) box.periodic[k] = domain->periodicity[k] && k < domain->dimension;
  simulation_.reset_time(box);
  position_tolerance_ = ROUND_OFF * (box.edges.xx + box.edges.yy + box.edges.zz + norm(box.origin));
  steps_since_reset_ = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    particle_data_[i][START_TIME] = std::nan("");
    store_image_flags(i);
  }
}

/// Unwrapped position of a particle at the end of the step, and its velocity.
FixHardEvents::EngineMotion FixHardEvents::engine_motion(int i, double end) const {
  const Vector3 x = vector(atom->x[i]), v = vector(atom->v[i]), boxes = boxes_crossed(i);
  if (same(boxes, {})) return {x, v, 0.0};
  const Vector3 flow = simulation_.box().rates * boxes;
  return {x + simulation_.box().edges_at(end) * boxes, v + flow,
          ROUND_OFF * (norm(v) + norm(flow))};
}

/// Whether the motion in the engine agrees with the flight of the simulation.
bool FixHardEvents::continues_flight(int i, const EngineMotion& now, double end) const {
  const VersionedFlight& flight = simulation_.flights[i];
  if (particle_data_[i][SPEED_INCREMENT] > 0.0) return false;
  const bool same_velocity = now.velocity_tolerance > 0.0
                                 ? norm(now.velocity - flight.velocity) <= now.velocity_tolerance
                                 : same(now.velocity, flight.velocity);
  const Vector3 deviation = now.position - flight.at(end);
  return same_velocity && dot(deviation, deviation) <= position_tolerance_ * position_tolerance_;
}

/// Loads a body and its flight: the flight stored with the particle, if the motion in the engine
/// agrees with it.
void FixHardEvents::load_body(int i, double dt) {
  const double start = simulation_.end(), end = start + dt;
  HardSphere& body = simulation_.bodies[i];
  body = body_properties(i);
  body.speed_increment = particle_data_[i][SPEED_INCREMENT];
  body.event_state.spin = vector(atom->omega[i]);
  VersionedFlight& flight = simulation_.flights[i];
  const bool is_known = !std::isnan(particle_data_[i][START_TIME]);
  if (is_known) {
    flight.position = vector(particle_data_[i] + POSITION);
    flight.velocity = vector(particle_data_[i] + VELOCITY);
    flight.start_time = particle_data_[i][START_TIME];
    body.event_state.causal_depth = static_cast<int>(particle_data_[i][CAUSAL_DEPTH]);
  } else {
    store_image_flags(i);
  }
  const EngineMotion now = engine_motion(i, end);
  if (is_known && continues_flight(i, now, end)) return;
  const Vector3 position = now.position - dt * now.velocity;
  const bool from_there = is_known && norm(position - flight.at(start)) <= position_tolerance_;
  flight.position = from_there ? flight.at(start) : position;
  flight.velocity = now.velocity;
  flight.start_time = start;
  body.event_state.causal_depth = -1;
}

/// Loads the changes of flights by the engine in the current step, and of the state that events
/// depend on.
void FixHardEvents::load_changes(double dt) {
  const double start = simulation_.start(), end = simulation_.end();
  load_walls(end);
  for (int i = 0; i < atom->nlocal; i++) {
    HardSphere& body = simulation_.bodies[i];
    const Vector3 spin = vector(atom->omega[i]);
    const bool same_body = same(spin, body.event_state.spin) &&
                           body.speed_increment == particle_data_[i][SPEED_INCREMENT];
    body.event_state.spin = spin;
    body.speed_increment = particle_data_[i][SPEED_INCREMENT];
    const EngineMotion now = engine_motion(i, end);
    const bool same_flight = continues_flight(i, now, end);
    if (same_body && same_flight) continue;
    if (same_flight) {
      changed_bodies_.push_back({i, false});
      continue;
    }
    const Vector3 from = simulation_.flights[i].at(start),
                  position = now.position - dt * now.velocity;
    const double away = norm(position - from);
    VersionedFlight flight;
    flight.position = away <= position_tolerance_ ? from : position;
    flight.velocity = now.velocity;
    flight.start_time = start;
    EventState event_state = body.event_state;
    event_state.causal_depth = -1;
    changed_bodies_.push_back({i, away > RELOCATION_DISTANCE * body.radius});
    simulation_.change_flight(i, flight, event_state, changed_bodies_.back().relocated);
  }
}

/// Sets the walls of the step that ends at `when`.
void FixHardEvents::load_walls(double when) {
  simulation_.walls.clear();
  for (const HardWallSource* walls : walls_)
    for (int w = 0; w < walls->number_of_walls(); w++)
      simulation_.walls.push_back(walls->wall(w, when));
}

/* ---------------------------------------------------------------------- */

/// Collective: sets the time until the next shift of the time origin to that in which the fastest
/// particle crosses the shortest edge of the box, so that times have as many digits as positions.
void FixHardEvents::set_time_origin_lifetime() {
  double mine = 0.0, fastest = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const Vector3& v = simulation_.flights[i].velocity;
    mine = std::max(mine, dot(v, v));
  }
  MPI_Allreduce(&mine, &fastest, 1, MPI_DOUBLE, MPI_MAX, world);
  const PeriodicBox::Edges& edges = simulation_.box().edges;
  double shortest = std::min(edges.xx, edges.yy);
  if (domain->dimension == 3) shortest = std::min(shortest, edges.zz);
  time_origin_lifetime_ = fastest > 0.0 ? shortest / std::sqrt(fastest) : never;
}
