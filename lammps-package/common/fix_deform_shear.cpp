// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/fix_deform_shear.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "common/message.h"
#include "common/shear_compatibility.h"
#include "common/specified_keywords.h"
#include "domain.h"
#include "group.h"
#include "input.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "shear/list_margin.h"
#include "update.h"
#include "variable.h"

using namespace LAMMPS_NS;
using cohesion::shear::ImageShift;

namespace {

/// The arguments of the engine's fix: flow along x, gradient along y, velocities change across
/// faces. That fix never moves the box; it keeps what Domain and others look for, and flips.
struct EngineArguments {
  static constexpr int count = 9;
  std::array<std::string, count> words;
  std::array<char*, count> pointers;

  EngineArguments(LAMMPS* lmp, char** arg)
      : words{arg[0], arg[1], arg[2], "1", "xy", "erate", "0.0", "remap", "v"} {
    if (!lmp->domain->triclinic)
      stop(lmp, FLERR, "fix ", arg[0],
           " deform/shear tilts the box: make it with 'region ... prism' or "
           "put 'change_box all triclinic' before");
    for (int i = 0; i < count; i++) pointers[i] = &words[i][0];
  }
};

ImageShift shift_of(double start_tilt, double height, double length) {
  return {start_tilt, height, length};
}

}  // namespace

FixDeformShear::FixDeformShear(LAMMPS* lammps, int narg, char** arg)
    : engine_api::BoxFix(lammps, EngineArguments::count,
                         EngineArguments(lammps, arg).pointers.data()) {
  read_keywords(narg, arg);
  const std::string where = std::string("fix ") + id + " deform/shear";
  if (igroup != 0)
    stop(lmp, FLERR, where, " shears the whole box; its group must be all, not ", arg[1]);
  if (!domain->xperiodic || !domain->yperiodic)
    stop(lmp, FLERR, where,
         ": flow is along x and its gradient along y; both must be periodic (boundary p p ...), ",
         domain->xperiodic ? "y" : "x", " is not");
  if (domain->yz != 0.0)
    stop(lmp, FLERR, where, ": tilt yz is ", domain->yz,
         "; the images along z must not be shifted along the gradient: make it 0");
  if (std::abs(domain->xy) > 0.5 * domain->xprd)
    stop(lmp, FLERR, where, ": tilt xy is ", domain->xy,
         "; it must be within half the length of the box, ", 0.5 * domain->xprd);
  scalar_flag = vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extscalar = extvector = 0;
  time_depend = 1;
  state.start_tilt = domain->xy;
  state.lx = domain->xprd;
  state.ly = domain->yprd;
  // As 'comm_modify vel yes' does: contacts across the faces need the velocity of the image.
  comm->ghost_velocity = 1;
}

void FixDeformShear::read_keywords(int narg, char** arg) {
  const std::string where = std::string("fix ") + id + " deform/shear";
  SpecifiedKeywords given(lmp, where);
  for (int i = 3; i < narg; i += 2) {
    const std::string word = arg[i];
    if (word != "rate" && word != "profile" && word != "rebuild")
      stop(lmp, FLERR, where, ": unknown keyword '", word, "'; valid ones: rate, profile, rebuild");
    if (i + 1 == narg) stop(lmp, FLERR, where, ": ", word, " takes a value");
    given.note(1, arg + i);
    const std::string value = arg[i + 1];
    if (word == "rate") {
      if (value.substr(0, 2) == "v_")
        rate_name = value.substr(2);
      else
        constant_rate = engine_api::numeric(FLERR, arg[i + 1], lmp);
      if (!std::isfinite(constant_rate))
        stop(lmp, FLERR, where, ": rate ", value, " must be a finite number or v_name");
    } else if (word == "profile") {
      if (value != "yes" && value != "no")
        stop(lmp, FLERR, where, ": profile '", value, "'; valid ones: yes, no");
      profile = value == "yes";
    } else {
      if (value != "nonaffine" && value != "engine")
        stop(lmp, FLERR, where, ": rebuild '", value, "'; valid ones: nonaffine, engine");
      nonaffine_rebuild = value == "nonaffine";
    }
  }
  if (!given.has("rate"))
    stop(lmp, FLERR, where,
         ": give 'rate R', strain per time, or 'rate v_name' of an equal-style variable");
}

int FixDeformShear::setmask() {
  return FixConst::POST_INTEGRATE | FixConst::PRE_EXCHANGE | engine_api::POST_NEIGHBOR |
         FixConst::END_OF_STEP | FixConst::POST_RUN;
}

void FixDeformShear::init() {
  require_compatible_setup();
  find_rate();
  engine_api::BoxFix::init();
  h_rate[5] = shift_of(state.start_tilt, state.ly, state.lx).velocity(state.strain.rate);
}

void FixDeformShear::require_compatible_setup() const {
  const std::string where = std::string("fix ") + id + " deform/shear";
  if (std::string(update->integrate_style).rfind("respa", 0) == 0)
    stop(lmp, FLERR, where, " moves the box once per step; use 'run_style verlet'");
  if (comm->ghost_velocity == 0)
    stop(lmp, FLERR, where, " needs the velocities of ghost particles; take '",
         engine_api::NO_GHOST_VELOCITIES, "' away");
  if (domain->xprd != state.lx || domain->yprd != state.ly || domain->yz != 0.0)
    stop(lmp, FLERR, where,
         ": the box has been changed since the fix was made; give the fix again");
  require_compatible_fixes(lmp, this, where);
}

void FixDeformShear::find_rate() {
  if (rate_name.empty()) return;
  rate_variable = input->variable->find(const_cast<char*>(rate_name.c_str()));
  if (rate_variable < 0 || !input->variable->equalstyle(rate_variable))
    stop(lmp, FLERR, "fix ", id, " deform/shear: there is no equal-style variable '", rate_name,
         "'");
}

double FixDeformShear::rate_now() {
  if (rate_variable < 0) return constant_rate;
  modify->clearstep_compute();
  const double rate = input->variable->compute_equal(rate_variable);
  modify->addstep_compute(update->ntimestep + 1);
  if (!std::isfinite(rate))
    stop(lmp, FLERR, "fix ", id, " deform/shear: variable ", rate_name, " is ", rate, " at step ",
         update->ntimestep, ", no rate of shear");
  return rate;
}

/* ---------------------------------------------------------------------- */

void FixDeformShear::setup_pre_exchange() {
  auto& strain = state.strain;
  const bigint now = update->ntimestep;
  const ImageShift shift = shift_of(state.start_tilt, state.ly, state.lx);
  if (!state.begun) {
    strain = {0.0, now, rate_now(), update->dt};
    state.next_rate = strain.rate;
    if (profile) add_profile();
    state.begun = 1;
  } else if (rate_variable < 0) {
    state.next_rate = constant_rate;  // another one than that of a restart
  }
  lengths = shift.lengths_before(strain.at(now), domain->xy);
  h_rate[5] = shift.velocity(strain.rate);
}

/// Adds the linear profile, zero in the middle of the box, to the velocities of the particles, and
/// takes the net momentum away.
void FixDeformShear::add_profile() {
  const cohesion::shear::BoxShear flow{state.strain.rate, middle_height(domain)};
  double mine[4] = {}, all[4];
  for (int i = 0; i < atom->nlocal; i++) {
    double* const v = atom->v[i];
    v[0] += flow.affine(atom->x[i][1]);
    const double m = atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
    for (int k = 0; k < 3; k++) mine[k] += m * v[k];
    mine[3] += m;
  }
  MPI_Allreduce(mine, all, 4, MPI_DOUBLE, MPI_SUM, world);
  if (all[3] == 0.0) return;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) atom->v[i][k] -= all[k] / all[3];
  engine_api::tell(
      lmp, message("fix ", id, " deform/shear: added the profile vx = ", flow.amount, " (y - ",
                   flow.middle, ") to the velocities and took the net momentum away\n"));
}

/// The list that a run begins with exists. From here on this fix decides when the next is made.
void FixDeformShear::setup(int) {
  if (!nonaffine_rebuild || checks_suspended || !neighbor->dist_check) return;
  engine_delay = neighbor->delay;
  engine_every = neighbor->every;
  neighbor->delay = INT_MAX;
  neighbor->every = 1;
  checks_suspended = true;
}

void FixDeformShear::post_run() {
  if (!checks_suspended) return;
  neighbor->delay = engine_delay;
  neighbor->every = engine_every;
  checks_suspended = false;
}

void FixDeformShear::post_integrate() {
  auto& strain = state.strain;
  const bigint now = update->ntimestep;
  strain.continue_with(now - 1, state.next_rate, update->dt);
  tilt_box(strain.at(now));
  const double next_rate = rate_now();
  // A particle outside the box must be put back before its image becomes faster: nothing may depend
  // on when lists are made.
  if (next_rate != state.next_rate) next_reneighbor = now;
  state.next_rate = next_rate;
  if (checks_suspended && next_reneighbor != now) {
    int mine = list_may_miss_a_pair(), any;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    if (any) next_reneighbor = now;
  }
}

void FixDeformShear::tilt_box(double gamma) {
  const ImageShift shift = shift_of(state.start_tilt, state.ly, state.lx);
  h_rate[5] = shift.velocity(state.strain.rate);
  const double half = 0.5 * state.lx;
  if (std::abs(h_rate[5]) * update->dt >= half)
    stop(lmp, FLERR, "fix ", id, " deform/shear: the image above moves by ", h_rate[5] * update->dt,
         " in a step, half a box is ", half, "; use a smaller time step");

  const double xy = shift.tilt(gamma, lengths);
  flipped_lengths = xy > half ? -1 : xy < -half ? 1 : 0;
  domain->xy = xy;
  domain->set_global_box();
  domain->set_local_box();
  if (flipped_lengths == 0) return;
  lengths -= flipped_lengths;
  tilt_after_flip = shift.tilt(gamma, lengths);
  next_reneighbor = update->ntimestep;
}

/// A flip chooses another lattice vector for the image above: nothing moves, but particles have
/// other places in the box and other ranks.
void FixDeformShear::pre_exchange() {
  if (flipped_lengths == 0) return;
  domain->xy = tilt_after_flip;
  domain->set_global_box();
  domain->set_local_box();
  domain->image_flip(flipped_lengths, 0, 0);
  domain->x2lamda(atom->nlocal);
  domain->pbc();
  irregular->migrate_atoms();
  domain->lamda2x(atom->nlocal);
  flipped_lengths = 0;
}

bool FixDeformShear::list_may_miss_a_pair() const {
  const auto n = static_cast<std::size_t>(atom->nlocal);
  if (list_step != neighbor->lastcall || displacements.count() != n) return true;
  const cohesion::shear::BoxShear shear = shear_since(displacements, domain);
  // Lists with a longer range of their own need ghosts from as far, by comm_modify cutoff.
  const double reach = std::max(neighbor->cutneighmax, comm->cutghostuser);
  const double margin = cohesion::shear::list_margin(reach, reach - neighbor->skin, shear.amount);
  if (margin <= 0.0) return true;
  const double* x = n > 0 ? atom->x[0] : nullptr;
  double farthest = 0.0;
  for (std::size_t i = 0; i < n; i++, x += 3)
    farthest = std::max(farthest, displacements.squared(i, {x[0], x[1], x[2]}, shear));
  return farthest > margin * margin;
}

void FixDeformShear::post_neighbor() {
  list_step = neighbor->lastcall;
  if (!nonaffine_rebuild) return;
  displacements.set_reference(atom->nlocal > 0 ? atom->x[0] : nullptr, atom->nlocal, domain->xy);
}

/// The engine wraps particles into the box that a restart file finds outside, but leaves them their
/// velocity; so this fix wraps them before.
void FixDeformShear::end_of_step() {
  if (!engine_api::writes_restart(output, update->ntimestep)) return;
  wrap_into_box(atom, domain);
  next_reneighbor = update->ntimestep + 1;
}

/* ---------------------------------------------------------------------- */

double FixDeformShear::compute_scalar() { return state.strain.at(update->ntimestep); }

double FixDeformShear::compute_vector(int n) {
  if (n == 0) return state.strain.rate;
  return n == 1 ? h_rate[5] : lengths;
}

void FixDeformShear::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  const int size = sizeof(ShearState);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&state, sizeof(ShearState), 1, fp);
}

void FixDeformShear::restart(char* buf) {
  ShearState saved;
  memcpy(&saved, buf, sizeof(ShearState));
  if (saved.lx != state.lx || saved.ly != state.ly)
    stop(lmp, FLERR, "fix ", id, " deform/shear: the box of the restart was ", saved.lx, " by ",
         saved.ly, ", it is now ", state.lx, " by ", state.ly,
         "; give the fix another ID to begin anew");
  state = saved;
}

double FixDeformShear::memory_usage() {
  return engine_api::BoxFix::memory_usage() +
         static_cast<double>(3 * sizeof(double) * displacements.count());
}
