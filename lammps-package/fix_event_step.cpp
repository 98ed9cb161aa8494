// SPDX-License-Identifier: GPL-2.0-only
#include "fix_event_step.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "atom.h"
#include "box_shear.h"
#include "comm.h"
#include "domain.h"
#include "energy_companions.h"
#include "engine_api.h"
#include "error.h"
#include "force.h"
#include "gravity.h"
#include "memory.h"
#include "modify.h"
#include "output.h"
#include "pair_members.h"
#include "restart_format.h"
#include "shear/flight.h"
#include "unturned_spheres.h"
#include "update.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;

static constexpr char ID[] = "COHESION_EVENT_STEP";
static constexpr char PLACE[] = "COHESION_EVENT_STEP_PLACE";

// What the next run needs of a particle: forces, torques, what the book notes, and forces of all
// but contacts, where they begin.
static constexpr int TORQUE = 3, NOTED = 6, FROM_OTHERS = NOTED + ContactBook::OF_PARTICLE,
                     LAST = FROM_OTHERS + 3;

static void put(const Vector3& a, double* values) {
  values[0] = a.x;
  values[1] = a.y;
  values[2] = a.z;
}

FixEventStep::FixEventStep(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg),
      owed(nullptr),
      alone(nullptr),
      book(lammps),
      watch(lammps),
      shared(nullptr),
      shared_each(ALONE),
      follows(true),
      resting(false),
      resuming(false),
      starting(false),
      running(false),
      books_begun(false),
      other_box(false),
      said_unturned(false),
      last_dt(0.0),
      last(lammps, LAST),
      outer(lammps, 3),
      contacts(nullptr),
      restless(nullptr),
      inverse_mass(nullptr),
      longest_flight(0.0),
      unresolved(0.0),
      flux_readers(std::make_shared<char>()),
      flux_wanted(false) {
  nevery = 1;
  comm_forward = ALONE;
  restart_peratom = 1;
  restart_global = 1;
  create_attribute = 1;
  FixEventStep::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixEventStep::~FixEventStep() {
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  memory->destroy(owed);
  memory->destroy(alone);
  memory->destroy(contacts);
  memory->destroy(restless);
  memory->destroy(inverse_mass);
}

void FixEventStep::reserve(LAMMPS* lmp) {
  Modify* modify = lmp->modify;
  if (modify->find_fix(ID) < 0 && modify->find_fix(PLACE) < 0)
    modify->add_fix(std::string(PLACE) + " all DUMMY");
}

FixEventStep* FixEventStep::of(LAMMPS* lmp) {
  Modify* modify = lmp->modify;
  reserve(lmp);
  if (modify->find_fix(ID) < 0) modify->replace_fix(PLACE, std::string(ID) + " all EVENT_STEP", 1);
  return static_cast<FixEventStep*>(modify->fix[modify->find_fix(ID)]);
}

int FixEventStep::setmask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::PRE_FORCE | FixConst::POST_FORCE |
         FixConst::END_OF_STEP | FixConst::POST_RUN;
}

void FixEventStep::init() {
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "scheme event follows contacts over the whole step; use 'run_style verlet'");
  if (force->newton_pair)
    error->all(FLERR,
               "scheme event works out every contact on both sides; put 'newton off' before the "
               "box is made");
  if (comm->ghost_velocity == 0)
    error->all(FLERR,
               "scheme event needs the velocities of ghost particles; add 'comm_modify vel yes'");

  styles.clear();
  walls.clear();
  advised.clear();
  mobile.look_up(modify);
  bool before_me = true;
  for (int i = 0; i < modify->nfix; i++) {
    Fix* const fix = modify->fix[i];
    if (auto* wall = dynamic_cast<EventWalls*>(fix)) {
      walls.push_back(wall);
      styles.push_back(wall);
    }
    if (auto* one = dynamic_cast<AdvisedStyle*>(fix)) advised.push_back(one);
    if (fix == this) before_me = false;
    if (fix->rigid_flag)
      error->all(FLERR, std::string("scheme event cannot follow contacts of rigid bodies (fix ") +
                            fix->id + ")");
    if (before_me && MobileParticles::integrates(fix))
      error->all(FLERR, std::string("fix ") + fix->id +
                            " integrates the motion: put it behind the pair_style and wall "
                            "commands of scheme event");
  }
  for (const PairMember& member : pair_members(force)) {
    if (auto* pairs = dynamic_cast<EventContacts*>(member.pair)) styles.push_back(pairs);
    if (auto* one = dynamic_cast<AdvisedStyle*>(member.pair)) advised.push_back(one);
  }
  follows = std::any_of(styles.begin(), styles.end(),
                        [](const EventContacts* some) { return some->follows(); });
  within_step = std::any_of(styles.begin(), styles.end(),
                            [](const EventContacts* some) { return some->within_step(); });
  look_for_unturned();
}

/// A warning that was given is not given again.
void FixEventStep::look_for_unturned() {
  if (said_unturned) return;
  std::vector<bool> rubs(atom->ntypes + 1, false);
  for (int type = 1; type <= atom->ntypes; type++)
    for (const EventContacts* some : styles) rubs[type] = rubs[type] || some->rubs(type);
  said_unturned = warn_of_unturned(lmp, mobile, rubs);
}

/// Then a step does nothing for any particle.
bool FixEventStep::rests() const {
  return !follows && !book.is_read() && flux_readers.use_count() == 1;
}

/// The fastest particle or ghost, and what each weighs.
void FixEventStep::look_round() {
  const int all = atom->nlocal + atom->nghost;
  longest_flight =
      cohesion::shear::longest_flight(fastest_of(atom, domain, all), rate_of_shear(domain).amount,
                                      neighbor->cutneighmax, 0.5 * update->dt);
  weigh(all);
}

/// Masses may change in any step (fix adapt); to see that they have not costs next to nothing.
/// Groups count as they were when the list of neighbours was new: ghosts hear of them only then.
void FixEventStep::weigh(int all) {
  const double* const mass = atom->rmass;
  if (neighbor->ago == 0 || weighed.empty()) {
    for (int i = 0; i < all; i++) inverse_mass[i] = mobile.inverse_mass(atom->mask[i], mass[i]);
  } else {
    if (std::equal(weighed.begin(), weighed.end(), mass, mass + all)) return;
    for (int i = 0; i < all; i++)
      if (inverse_mass[i] != 0.0) inverse_mass[i] = 1.0 / mass[i];
  }
  weighed.assign(mass, mass + all);
}

double FixEventStep::half_kick() const { return 0.5 * update->dt; }

/* ---------------------------------------------------------------------- */

void FixEventStep::setup_pre_force(int) {
  resuming = last_dt > 0.0;
  starting = !resuming;
  other_box = resuming && box.changed(domain);
  pending = false;
  resting = rests();
  if (resting) {
    weighed.clear();
    sums_contacts = false;
  }
  if (!resuming) {
    const std::vector<double> weight = weights(lmp);
    for (int i = 0; i < atom->nlocal; i++) std::copy_n(&weight[3 * i], 3, outer.of(i));
    judge(true);
    pending = true;
    return;
  }
  look_round();
  look_for_readers();
  judge(true);
  if (other_box)
    for (EventWalls* wall : walls) wall->take_where_they_are();
  if (!book.is_kept()) return;
  for (int i = 0; i < atom->nlocal; i++) book.take_motion(i, last.of(i) + NOTED);
  book.begin_again();
  for (EventContacts* some : styles) some->book_standing();
}

/// With the first forces of a step, when fixes have changed what they change before.
void FixEventStep::work_out() {
  if (!pending) return;
  pending = false;
  clear();
  for (EventContacts* some : styles) some->gather();
  if (within_step) {
    share(nullptr, 1);
    const int all = atom->nlocal + atom->nghost;
    some_restless = std::any_of(restless, restless + all, [](double is) { return is != 0.0; });
    for (EventContacts* some : styles) some->unsettle();
    for (EventContacts* some : styles) some->join();
    if (some_announced || comm->nprocs > 1) {
      share(owed, OWED);
      for (EventContacts* some : styles) some->follow_alone();
      share(alone, ALONE);
    }
    hand_over();
  }
  handed_over = true;
}

/// What contacts have done so far, to the engine.
void FixEventStep::hand_over() {
  const int n = 3 * atom->nlocal;
  if (n == 0) return;
  double* const f = atom->f[0];
  double* const torque = atom->torque[0];
  const double* const pushed = &contact_impulse[0].x;
  const double* const turned = &contact_turn[0].x;
  for (int k = 0; k < n; k++) f[k] += kick * pushed[k];
  for (int k = 0; k < n; k++) torque[k] += kick * turned[k];
}

/// The first step has no half kick before it: what its velocities are, they truly are.
void FixEventStep::setup(int) {
  work_out();
  if (resting) sums_contacts = false;
  constexpr double none[ContactBook::OF_PARTICLE] = {};
  if (book.is_kept() && starting)
    for (int i = 0; i < atom->nlocal; i++) book.take_motion(i, none);
}

void FixEventStep::initial_integrate(int) {
  running = true;  // a run without set-up begins here
  starting = false;
  if (book.is_kept() && !books_begun) {
    // They begin with what there is before this step.
    update->ntimestep--;
    begin_books();
    update->ntimestep++;
  }
  if (!resuming) {
    look_for_outer();
    return;
  }
  // The same momentum, should the step be another now.
  const double ratio = last_dt / update->dt;
  for (int i = 0; i < atom->nlocal; i++) {
    const double* const then = last.of(i);
    put(ratio * vector(then), atom->f[i]);
    put(ratio * vector(then + TORQUE), atom->torque[i]);
    std::copy_n(then + FROM_OTHERS, 3, outer.of(i));
  }
  resuming = false;
  last.free();
}

/// Forces are all there when the next step begins.
void FixEventStep::look_for_outer() {
  if (resting || !within_step || atom->nlocal == 0) return;
  const double* const f = atom->f[0];
  const double* const pushed = &contact_impulse[0].x;
  double* const rest = outer.of(0);
  const int n = 3 * atom->nlocal;
  for (int k = 0; k < n; k++) rest[k] = f[k] - kick * pushed[k];
}

Vector3 FixEventStep::outer_now(int i) const {
  return sums_contacts ? vector(atom->f[i]) - kick * contact_impulse[i] : Vector3{};
}

/// The books begin when all fixes have been set up; a run of no step ends then.
void FixEventStep::begin_books() {
  for_each_energy_book(modify, [](EnergyBookKeeper& keeper) { keeper.begin_run(); });
  books_begun = true;
}

void FixEventStep::pre_force(int) {
  if (resting) return;
  judge(false);
  pending = true;
}

void FixEventStep::post_force(int) { work_out(); }

/// Forces that a run takes over from the last one excuse nothing: its step, its coefficients and
/// its particles may be others.
void FixEventStep::judge(bool setup) {
  if (advised.empty() || !watch.due(setup)) return;
  for (AdvisedStyle* one : advised) one->give_advice(watch.now());
}

void FixEventStep::clear() {
  const int all = atom->nlocal + atom->nghost;
  look_round();
  look_for_readers();
  handed_over = false;
  kick = (starting ? 2.0 : 1.0) / update->dt;
  sums_contacts = within_step || book.is_kept();
  if (sums_contacts) {
    contact_impulse.assign(atom->nlocal, {});
    contact_turn.assign(atom->nlocal, {});
  }
  if (within_step) {
    std::fill_n(contacts, all, 0);
    std::fill_n(restless, all, 0.0);
    some_announced = false;
  }
  book.begin_step();
}

void FixEventStep::look_for_readers() {
  book.look_for_readers();
  flux_wanted = flux_readers.use_count() > 1;
}

void FixEventStep::end_of_step() {
  if (resting || !book.is_kept()) return;
  book.end_step(contact_impulse, contact_turn, half_kick() * kick,
                [this](int i) { return body(i); });
  const std::vector<double> weight = weights(lmp);
  double power = 0.0;  // of all forces but those of contacts, and gravity
  for (int i = 0; i < atom->nlocal; i++)
    if (inverse_mass[i] != 0.0)
      power += dot(outer_now(i) - vector(&weight[3 * i]), book.true_velocity(i));
  book.work(2.0 * half_kick() * power);
}

void FixEventStep::post_run() {
  report_unresolved();
  if (book.is_kept()) {
    if (!books_begun) begin_books();
    for_each_energy_book(modify, [](EnergyBookKeeper& keeper) { keeper.end_run(); });
  }
  books_begun = false;
  running = false;
  box.look(domain);
  if (resuming) return;  // no step was made: what was taken over is what the next run goes on from
  last.grow(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) note_last(i, last.of(i));
  last_dt = update->dt;
}

/// What the next run needs of a particle.
void FixEventStep::note_last(int i, double* values) const {
  std::copy_n(atom->f[i], 3, values);
  std::copy_n(atom->torque[i], 3, values + TORQUE);
  book.note_motion(i, values + NOTED);
  put(outer_now(i), values + FROM_OTHERS);
}

void FixEventStep::report_unresolved() {
  double all = 0.0;
  MPI_Allreduce(&unresolved, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  unresolved = 0.0;
  if (all > 0.0 && comm->me == 0)
    error->warning(FLERR,
                   "scheme event: {} times in this run a pair, or a particle and a wall, turned "
                   "round a thousand times within one step, between contact and the edge of the "
                   "adhesion or along that edge, and was not followed to the end of that step: use "
                   "a smaller time step",
                   all);
}

/* ---------------------------------------------------------------------- */

/// Brings `each` values of particles that have been announced to their ghosts; nullptr:
/// whether particles are restless.
void FixEventStep::share(double** values, int each) {
  shared = values;
  shared_each = each;
  engine_api::forward_comm(comm, this, each);
}

int FixEventStep::pack_forward_comm(int n, int* list, double* buf, int, int*) {
  if (shared == nullptr) {
    for (int i = 0; i < n; i++) buf[i] = restless[list[i]];
    return n;
  }
  for (int i = 0; i < n; i++, buf += shared_each) {
    // A ghost that is passed on has what its owner sent.
    const int from = list[i];
    if (from < atom->nlocal && contacts[from] == 0)
      std::fill_n(buf, shared_each, 0.0);
    else
      std::copy_n(shared[from], shared_each, buf);
  }
  return shared_each * n;
}

void FixEventStep::unpack_forward_comm(int n, int first, double* buf) {
  if (shared == nullptr)
    std::copy_n(buf, n, restless + first);
  else
    std::copy_n(buf, shared_each * n, shared[first]);
}

void FixEventStep::grow_arrays(int nmax) {
  memory->grow(owed, nmax, OWED, "event_step:owed");
  memory->grow(alone, nmax, ALONE, "event_step:alone");
  memory->grow(contacts, nmax, "event_step:contacts");
  memory->grow(restless, nmax, "event_step:restless");
  if (last.has_room()) last.grow(nmax);
  outer.grow(nmax);
  memory->grow(inverse_mass, nmax, "event_step:inverse_mass");
}

void FixEventStep::copy_arrays(int i, int j, int) {
  outer.copy(i, j);
  if (last.has_room()) last.copy(i, j);
}

void FixEventStep::set_arrays(int i) {
  outer.clear(i);
  if (last.has_room()) last.clear(i);
}

int FixEventStep::pack_exchange(int i, double* buf) {
  const int taken = outer.pack(i, buf);
  return last.has_room() ? taken + last.pack(i, buf + taken) : taken;
}

int FixEventStep::unpack_exchange(int i, double* buf) {
  const int taken = outer.unpack(i, buf);
  return last.has_room() ? taken + last.unpack(i, buf + taken) : taken;
}

// Numbers of a restart file in front of the book's: its layout, and the step.
static constexpr int LAYOUT = 2, HEAD = 2;
static constexpr int OF_RESTART = HEAD + static_cast<int>(std::tuple_size_v<ContactBook::OfAll>);

void FixEventStep::write_restart(FILE* fp) {
  const ContactBook::OfAll mine = book.of_all();
  double values[OF_RESTART] = {RESTART_MARK + LAYOUT, running ? update->dt : last_dt};
  MPI_Reduce(mine.data(), values + HEAD, static_cast<int>(mine.size()), MPI_DOUBLE, MPI_SUM, 0,
             world);
  if (comm->me != 0) return;
  constexpr int size = sizeof(values);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(values, size, 1, fp);
}

void FixEventStep::restart(char* buf) {
  const auto* values = reinterpret_cast<const double*>(buf);
  require_layout(lmp, values[0], "scheme event", LAYOUT);
  last_dt = values[1];
  if (last_dt > 0.0) last.grow(atom->nmax);
  if (comm->me != 0) return;
  ContactBook::OfAll all;
  std::copy_n(values + HEAD, all.size(), all.begin());
  book.take_of_all(all);
}

int FixEventStep::pack_restart(int i, double* buf) {
  // The engine's own forces may have stayed behind when particles changed rank.
  if (!running && last.has_room()) return last.pack_restart(i, buf);
  buf[0] = last.size_restart();
  std::fill_n(buf + 1, LAST, 0.0);  // before the first run
  if (running) note_last(i, buf + 1);
  return last.size_restart();
}

void FixEventStep::unpack_restart(int i, int nth) {
  if (last.has_room()) last.unpack_restart(i, atom->extra[i], nth);
}

int FixEventStep::maxsize_restart() { return last.size_restart(); }
int FixEventStep::size_restart(int) { return last.size_restart(); }

double FixEventStep::memory_usage() {
  const double numbers = OWED + ALONE + 2;
  return (numbers * sizeof(double) + sizeof(int)) * atom->nmax +
         sizeof(Vector3) * (contact_impulse.capacity() + contact_turn.capacity()) +
         sizeof(double) * weighed.capacity() + outer.bytes() + last.bytes() + book.bytes();
}
