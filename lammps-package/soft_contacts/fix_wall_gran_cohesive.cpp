// SPDX-License-Identifier: GPL-2.0-only
#include "soft_contacts/fix_wall_gran_cohesive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "advice/warning_filter.h"
#include "atom.h"
#include "comm.h"
#include "common/message.h"
#include "common/plausible_sizes.h"
#include "domain.h"
#include "engine/flight_report.h"
#include "engine/largest_radii.h"
#include "engine/particles_at_walls.h"
#include "error.h"
#include "input/walls_from_script.h"
#include "neighbor.h"
#include "soft_contacts/cohesion_laws.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::contact_solver;
using cohesion::Vector3;

template <class Cohesion>
FixWallGranCohesive<Cohesion>::FixWallGranCohesive(LAMMPS* lammps, int narg, char** arg)
    : FixWithWallHistory(lammps, narg, arg),
      where(std::string("fix ") + arg[0] + " wall/" + Cohesion::STYLE),
      advice_filter(std::make_unique<cohesion::advice::WarningFilter>()),
      scheme(Scheme::exact),
      law(attraction.no_law()),
      per_wall(ContactHistory::normal_only),
      sizes(),
      travelled(0.0),
      contact_step(nullptr) {
  read(narg, arg);
  if (parameters.contact.friction > 0.0) per_wall = ContactHistory::with_friction;
  if (parameters.contact.rolling_friction > 0.0) per_wall = ContactHistory::with_rolling;
  history.start(faces(), per_wall);
  const int all_walls = static_cast<int>(walls.size() + regions.size());
  forces.start(all_walls);

  vector_flag = array_flag = 1;
  size_vector = WallForces::EACH;
  size_array_rows = all_walls;
  size_array_cols = WallForces::EACH;
  extvector = extarray = 1;
  global_freq = 1;
  restart_peratom = restart_global = 1;
  create_attribute = 1;
  FixWallGranCohesive<Cohesion>::grow_arrays(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) FixWallGranCohesive<Cohesion>::set_arrays(i);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

template <class Cohesion>
FixWallGranCohesive<Cohesion>::~FixWallGranCohesive() {
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::post_constructor() {
  contact_step = FixContactStep::of(lmp);
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::read(int narg, char** arg) {
  std::vector<char*> contact_words;
  SpecifiedKeywords given(lmp, where);
  WallsFromScript from_words(lmp, where, WallsFromScript::Regions::accepted);
  for (int iarg = 3; iarg < narg;) {
    const std::string word = arg[iarg];
    const int left = narg - iarg - 1;
    const int values = values_of_contact_keyword<Cohesion>(lmp, where, iarg, narg, arg);
    if (values >= 0) {
      has_adhesion_word = has_adhesion_word || word == Cohesion::ADHESION;
      contact_words.insert(contact_words.end(), arg + iarg, arg + iarg + 1 + values);
      iarg += 1 + values;
    } else if (word == "scheme" || is_setting<Cohesion>(word)) {
      if (left < 1) error->all(FLERR, where + ": " + word + " takes a name");
      given.note(1, arg + iarg);
      if (word == "scheme")
        scheme = scheme_from_script(lmp, where, arg[iarg + 1]);
      else
        attraction.set(lmp, where, word, arg[iarg + 1]);
      iarg += 2;
    } else if (const int taken = from_words.read(left + 1, arg + iarg)) {
      iarg += taken;
    } else {
      error->all(FLERR, where + ": unknown keyword '" + word + "'; valid ones: " +
                            contact_keyword_names<Cohesion>() + ", " + setting_names<Cohesion>() +
                            ", " + WallsFromScript::keywords_with_region);
    }
  }
  from_words.finish();
  walls = from_words.walls;
  start_faces(from_words.regions);
  motion = from_words.motion;
  course = WallCourse(motion);
  parameters = cohesive_contact_from_script<Cohesion>(
      lmp, where, 0, static_cast<int>(contact_words.size()), contact_words.data());
  if (parameters.contact.rolling_friction > 0.0 && motion.rim_speed != 0.0)
    error->all(FLERR, where +
                          ": rolling_friction does not know how fast a cylinder turns, and would "
                          "resist what rolls along with it: take it away, or shear along z only");
  require_computable(lmp, where, scheme, parameters.contact);
  unscaled_parameters = parameters;
  parameters = attraction.scaled(lmp, where, parameters);
  law = attraction.law(lmp, where, parameters);
  if (scheme == Scheme::sampled) contacts.template emplace<static_cast<int>(Scheme::sampled)>();
}

template <class Cohesion>
int FixWallGranCohesive<Cohesion>::setmask() {
  return FixConst::POST_FORCE | (motion.still() ? 0 : FixConst::INITIAL_INTEGRATE);
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::initial_integrate(int) {
  course.begin_step(update->dt);
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::init() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, where + " acts on spheres; use 'atom_style sphere'");
  if (update->whichflag == 2)
    error->all(FLERR, where + " follows motion in time; it cannot be minimized");
  require_time_step(lmp, where);
  require_plausible_spheres(lmp, where);
  const std::vector<double> smallest = smallest_radii(lmp, largest_radii(lmp, groupbit), groupbit);
  for (int type = 1; type <= atom->ntypes; type++)
    attraction.require_short(lmp, where, unscaled_parameters, smallest[type],
                             std::numeric_limits<double>::infinity());
  sizes = {};  // not known: particles may have come since the last run
  for (RegionFaces& region : regions) region.require_unchanged(where);
  warn_of_particles();
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::setup(int) {
  post_force(0);
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::post_force(int) {
  if (contact_step->resumes()) return repeat_forces();
  contact_step->compute_contacts([this] {
    forces.clear();
    with_contacts([this](auto& shared, auto size) { compute_contacts<size>(shared); });
  });
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::check_flight(int i, int w, const WallPoint& point,
                                                 const WallState& now) {
  if (point.distance <= 0.0)
    error->one(FLERR, message(where, ": the centre of particle ", atom->tag[i], " went through '",
                              name_of(w, now), "'; use a larger stiffness"));
  const double flight = update->dt * norm(vector(atom->v[i]) - point.velocity);
  if (flight > atom->radius[i])
    error->one(FLERR, where + ": particle " + std::to_string(atom->tag[i]) + " moves " +
                          std::to_string(flight / atom->radius[i]) +
                          " radii in one step and could miss the wall; use a smaller time step. " +
                          "There " + report_flight(lmp, i));
}

/// Displacement of the walls in a step, [length]. Infinite if the box moves particles: by a mean
/// flow, which contact_step->flight() excludes, or by rescaling.
template <class Cohesion>
double FixWallGranCohesive<Cohesion>::wall_travel(const WallState& now) const {
  if (domain->box_change) return std::numeric_limits<double>::infinity();
  if (motion.still()) return 0.0;
  return update->dt * norm(now.velocity);
}

template <class Cohesion>
void FixWallGranCohesive<Cohesion>::update_sizes() {
  sizes = {std::numeric_limits<double>::infinity(), 0.0, 0.0};
  for (int i = 0; i < atom->nlocal; i++) {
    const double radius = atom->radius[i];
    sizes = {std::min(sizes.smallest_radius, radius), std::max(sizes.largest_radius, radius),
             std::max(sizes.largest_range, Cohesion::range(scheme, parameters, radius, 0.0))};
  }
}

/// Finds the particles that may touch a wall until one of them has moved by the largest radius.
template <class Cohesion>
void FixWallGranCohesive<Cohesion>::find_beside(const WallState& now) {
  const double reach = 2.0 * sizes.largest_radius + sizes.largest_range;
  const double far_away = reach + sizes.largest_radius;
  const FarFromWalls far(walls, now.displacement, far_away);
  const auto is_far_from_regions = [&](const Vector3& centre) {
    return std::all_of(regions.begin(), regions.end(), [&](const RegionFaces& region) {
      return region.is_far(centre, now, far_away);
    });
  };
  beside.clear();
  for (int i = 0; i < atom->nlocal; i++)
    if (!far.contains(atom->x[i]) || atom->radius[i] > sizes.largest_radius ||
        !is_far_from_regions(vector(atom->x[i])))
      beside.push_back(i);
  radii_version = contact_step->version_of_radii();
  travelled = 0.0;
}

/// Selects the particles that may be near a wall in this step: all if some may be new, or faster. A
/// particle that moves less than a radius per step cannot reach a wall from beyond two radii.
template <class Cohesion>
void FixWallGranCohesive<Cohesion>::select_particles(const WallState& now, double flight,
                                                     bool new_list) {
  if (new_list || flight > sizes.smallest_radius) {
    update_sizes();
    beside.resize(atom->nlocal);
    std::iota(beside.begin(), beside.end(), 0);
    travelled = std::numeric_limits<double>::infinity();
  } else {
    travelled += 2.0 * flight;  // fix recenter may displace all by as much as the fastest flies
    if (travelled > sizes.largest_radius || radii_version != contact_step->version_of_radii())
      find_beside(now);
  }
}

/// Whether a particle may touch a face in this step; updates its history where it does not.
template <class Cohesion>
bool FixWallGranCohesive<Cohesion>::may_touch(int i, int face, const WallState& now, double flight,
                                              double range) {
  double& phase = *history.of(i, face);
  const WallPoint& point = points[face];
  if (WallHistory::keep_behind(phase, point.distance, atom->radius[i] + range)) return false;
  // A particle without a history is in range or not by its position.
  if (phase < 0.0) ContactHistory::unknown().store(&phase, per_wall);
  // No particle is faster than the step's fastest.
  if (phase != 0.0 || flight > atom->radius[i]) check_flight(i, wall_of_face[face], point, now);
  if (contact_step->body(i).inverse_mass == 0.0) {
    if (contact_step->is_led(i) &&
        contact_step->carries_along(i, vector(atom->v[i]) - point.velocity))
      phase = WallHistory::NOT_KNOWN;
    else
      ContactState::stored(&phase).hold().store(&phase);
    return false;
  }
  if (point.distance <= 2.0 * atom->radius[i] + range) return true;
  phase = ContactState::outside;
  return false;
}

/// A particle and the face that it may touch.
template <class Cohesion>
typename FixWallGranCohesive<Cohesion>::Near FixWallGranCohesive<Cohesion>::near_face(
    int i, int face, const WallState& now) const {
  const WallPoint& point = points[face];
  const double last_step = contact_step->starts() ? 0.0 : update->dt;
  const std::size_t w = wall_of_face[face];
  const Vector3 centre = vector(atom->x[i]), velocity = vector(atom->v[i]);
  return {i, wall_of_face[face], point.velocity,
          w < walls.size()
              ? walls[w].relative_motion(centre, velocity, point, now, last_step)
              : regions[w - walls.size()].relative_motion(centre, velocity, point, now, last_step),
          history.of(i, face)};
}

/// Calls what(Near) for the particles that may touch a wall in this step.
template <class Cohesion>
template <class What>
void FixWallGranCohesive<Cohesion>::for_each_near(const What& what) {
  const WallState now = state();
  for (RegionFaces& region : regions) region.refresh(where);
  const double flight = 2.0 * contact_step->flight() + wall_travel(now);
  const bool new_list = contact_step->starts() || neighbor->ago == 0;
  select_particles(now, flight, new_list);
  for (const int i : beside) {
    if (!(atom->mask[i] & groupbit)) {
      if (new_list) history.begin(i);  // it may join the group later
      continue;
    }
    const double range = Cohesion::range(scheme, parameters, atom->radius[i], 0.0);
    find_points(vector(atom->x[i]), now, 2.0 * atom->radius[i] + range, points);
    if (!regions.empty()) {
      continue_around_open_edges(i, now);
      check_curvature(i, range);
    }
    for (int face = 0; face < faces(); face++)
      if (may_touch(i, face, now, flight, range)) what(near_face(i, face, now));
  }
}

template <class Cohesion>
template <int SIZE, class Contact>
void FixWallGranCohesive<Cohesion>::compute_contacts(std::vector<Contact>& shared) {
  shared.clear();
  const ContactForces<Contact, SIZE> contact_forces(atom, contact_step);
  for_each_near([&](const Near& near) {
    compute_contact<SIZE>(contact_forces, contact(shared, near.i), near);
  });
}

template <class Cohesion>
template <int SIZE, class Contact>
void FixWallGranCohesive<Cohesion>::compute_contact(
    const ContactForces<Contact, SIZE>& contact_forces, const Contact& c, const Near& near) {
  const PairMotion now{
      near.motion.separation, near.motion.velocity, vector(atom->omega[near.i]), {}};
  ContactHistory known = contact_step->starts() ? ContactHistory::unknown()
                                                : ContactHistory::stored(near.history, SIZE);
  if (known.normal.is_outside() &&
      !c.within_reach(now.separation, now.velocity, contact_step->moved_by_forces())) {
    *near.history = ContactState::outside;
    return;
  }
  ContactEnergies energies;
  const FrictionalStep result =
      contact_forces.apply(c, near.i, -1, now, near.motion.acceleration, known,
                           contact_step->energy_tally.is_active() ? &energies : nullptr,
                           contact_step->energy_tally.is_read());
  known.store(near.history, SIZE);
  const Vector3& impulse = result.impulse;
  contact_step->add_wall_work(-dot(near.wall_velocity, impulse),
                              dot(near.wall_velocity, result.friction));
  const double kick = contact_forces.kick();
  forces.add(near.wall, kick * impulse, kick * (impulse - c.by_contact(now, result)));
}

/// The force on one wall: three components of the whole, three of the adhesive part.
template <class Cohesion>
double FixWallGranCohesive<Cohesion>::compute_array(int wall, int which) {
  return forces.all(world)[WallForces::EACH * wall + which];
}

/// The force on all walls.
template <class Cohesion>
double FixWallGranCohesive<Cohesion>::compute_vector(int which) {
  return forces.sum(world, which);
}

#define COHESION_INSTANTIATE(style, Law) template class LAMMPS_NS::FixWallGranCohesive<Law>;
COHESION_CONTACT_LAWS(COHESION_INSTANTIATE)
