// SPDX-License-Identifier: GPL-2.0-only
// The part of FixHardEvents that transfers the results of the events to the engine.
#include <algorithm>
#include <cmath>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "domain.h"
#include "engine/flight_report.h"
#include "error.h"
#include "hard_spheres/fix_hard_events.h"
#include "hard_spheres/pair_hard_square_well.h"
#include "neighbor.h"
#include "shear/list_margin.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::vector;
using cohesion::Vector3;

// Events between the prefetch of the particles of an event and their use.
static constexpr std::size_t PREFETCH_DISTANCE = 8;

static void put(const Vector3& a, double* to) {
  to[0] = a.x;
  to[1] = a.y;
  to[2] = a.z;
}

/// Writes the spins to the engine and adds the events to the totals.
void FixHardEvents::store_events() {
  for (const Event& event : simulation_.events) {
    for (const int body : {event.i, event.j}) {
      if (body < 0 || body >= atom->nlocal) continue;
      const EventState& event_state = simulation_.bodies[body].event_state;
      put(event_state.spin, atom->omega[body]);
      totals_.most_events = std::max(totals_.most_events, static_cast<double>(event_state.events));
    }
    if (event.i < atom->nlocal) totals_.add(event, event.with_wall());
  }
  record_->write(simulation_);
}

/// Writes the flights to the engine: positions at the end of the step, wrapped as the image flags
/// require.
void FixHardEvents::store_flights() {
  const double end = simulation_.end();
  const PeriodicBox::Edges h = simulation_.box().edges_at(end), &rates = simulation_.box().rates;
  const bool all = stored_versions_.empty();
  stored_versions_.resize(atom->nlocal);
  crossed_boundary_.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) {
    const VersionedFlight& flight = simulation_.flights[i];
    const Vector3 boxes = boxes_crossed(i);
    crossed_boundary_[i] = !same(boxes, {});
    if (simulation_.bodies[i].inverse_mass == 0.0) {
      // The engine integrates immobile bodies itself.
    } else if (!crossed_boundary_[i]) {
      put(flight.at(end), atom->x[i]);
      put(flight.velocity, atom->v[i]);
    } else {
      put(flight.at(end) - h * boxes, atom->x[i]);
      put(flight.velocity - rates * boxes, atom->v[i]);
    }
    if (!all && stored_versions_[i] == flight.version) continue;
    stored_versions_[i] = flight.version;
    put(flight.position, particle_data_[i] + POSITION);
    put(flight.velocity, particle_data_[i] + VELOCITY);
    particle_data_[i][START_TIME] = flight.start_time;
    particle_data_[i][CAUSAL_DEPTH] = simulation_.bodies[i].event_state.causal_depth;
  }
  if (!simulation_.events.empty() || comm->nprocs > 1) comm->forward_comm();
}

/// Records the nonaffine displacement of particle i, which is at `position` at the time `left`
/// before the end of the step.
void FixHardEvents::track_displacement(int i, const Vector3& position, double left) {
  farthest_squared_ =
      std::max(farthest_squared_,
               displacements_.squared(i, position, shear_since(displacements_, domain, left)));
}

/// Prefetches the data for the displacements of the particles of an event.
void FixHardEvents::prefetch_displacements(const Event& event) const {
  for (const int i : {event.i, event.j}) {
    if (i < 0 || i >= atom->nlocal) continue;
    displacements_.foresee(i);
  }
}

/// Stops if a particle may have met one that is not a ghost of this process.
void FixHardEvents::check_neighbour_list() {
  const double dt = update->dt, end = simulation_.end();
  for (int i = 0; i < atom->nlocal; i++) track_displacement(i, vector(atom->x[i]), 0.0);
  const std::vector<Event>& events = simulation_.events;
  for (std::size_t n = 0; n < events.size(); n++) {
    const Event& event = events[n];
    prefetch_displacements(events[std::min(n + PREFETCH_DISTANCE, events.size() - 1)]);
    const double left = end - event.key.time;
    // Few particles are outside the box: only for these the number of boxes is read.
    const auto in_box = [&](int i, const Vector3& position) {
      return crossed_boundary_[i]
                 ? position - simulation_.box().edges_at(event.key.time) * boxes_crossed(i)
                 : position;
    };
    if (event.i < atom->nlocal) track_displacement(event.i, in_box(event.i, event.position), left);
    if (event.with_wall() || event.j >= atom->nlocal) continue;
    const Vector3 image =
        simulation_.neighbour_lists().image(event.image).displacement_at(event.key.time);
    track_displacement(event.j, in_box(event.j, event.position + event.separation - image), left);
  }
  const double extra = pair_->list_reach() + neighbor->skin;
  const double largest = std::max(std::abs(shear_since(displacements_, domain).amount),
                                  std::abs(shear_since(displacements_, domain, dt).amount));
  const double margin =
      cohesion::shear::list_margin(neighbor->cutneighmax, neighbor->cutneighmax - extra, largest);
  const double flown = std::sqrt(farthest_squared_);
  if (flown <= margin) return;
  error->one(FLERR,
             "pair_style hard/squarewell: in step {} particles are up to {} away from where they "
             "were when the neighbour list was made, and could miss a partner; the list allows for "
             "{}. Use a smaller time step or 'neighbor' with a skin above {}, with 'neigh_modify "
             "delay 0 every 1 check yes'. The fastest: {}",
             update->ntimestep, flown, margin,
             neighbor->skin * (1.0 + 2.0 * (flown - margin) / extra), report_fastest(lmp));
}
