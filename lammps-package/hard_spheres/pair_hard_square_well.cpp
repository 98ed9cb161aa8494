// SPDX-License-Identifier: GPL-2.0-only
#include "hard_spheres/pair_hard_square_well.h"

#include <cmath>

#include "atom.h"
#include "comm.h"
#include "common/plausible_sizes.h"
#include "engine/largest_radii.h"
#include "engine/special_pairs.h"
#include "error.h"
#include "force.h"
#include "hard_spheres/fix_hard_events.h"
#include "input/restart_format.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "square_well/capture.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;
using cohesion::Vector3;

// Reach of the neighbour list beyond the contact, as a fraction of the skin. The check of the
// engine keeps the list until a particle has moved by half a skin. The events of the step can then
// deflect particles farther.
static constexpr double REACH = 0.25;
static constexpr int LAYOUT = 4;  // of settings and HardContact in restart files

PairHardSquareWell::PairHardSquareWell(LAMMPS* lammps)
    : Pair(lammps), contacts_(lammps), event_fix_(nullptr) {
  single_enable = 0;
  restartinfo = 1;
  no_virial_fdotr_compute = 1;
  finitecutflag = 1;
  beyond_contact = 1;
}

PairHardSquareWell::~PairHardSquareWell() {
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

PairHardSquareWell* PairHardSquareWell::in_use(Force* force) {
  // By its current and its former name.
  return dynamic_cast<PairHardSquareWell*>(force->pair_match("^hard/square_?well$", 0));
}

void PairHardSquareWell::allocate() {
  allocated = 1;
  const int types = atom->ntypes;
  memory->create(setflag, types + 1, types + 1, "pair:setflag");
  memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
  contacts_.make_room(types, setflag);
}

/// Adds the virial of the executed events and the energy of the wells.
void PairHardSquareWell::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  contacts_.require_committed("pair_style hard/squarewell");
  if (neighbor->ago == 0) check_radii(lmp, "pair_style hard/squarewell", largest_radius_);
  if (vflag_either) {
    const double per_time = -1.0 / update->dt;
    for (const Event& event : event_fix_->simulation().events) {
      if (event.with_wall()) continue;
      const auto on_i = per_time * event.impact.impulse;
      const auto& r = event.separation;
      ev_tally_xyz(event.i, event.j, atom->nlocal, 0, 0.0, 0.0, on_i.x, on_i.y, on_i.z, -r.x, -r.y,
                   -r.z);
    }
  }
  if (!eflag_either) return;
  event_fix_->simulation().for_each_pair([this](int i, const Neighbour& n) {
    if (!n.inside || n.is_wall()) return;
    const HardSphere &a = event_fix_->simulation().bodies[i],
                     &b = event_fix_->simulation().bodies[n.body];
    const double depth = contact(a.material, b.material).well.depth;
    ev_tally(i, n.body, atom->nlocal, 0, -depth, 0.0, 0.0, 0.0, 0.0, 0.0);
  });
}

/// A pair is bound while it is in its well.
void PairHardSquareWell::append_bound(std::vector<std::array<int, 2>>& pairs) const {
  for (const FixHardEvents::PairInWell& pair : event_fix_->pairs_in_wells())
    pairs.push_back({pair.i, pair.j});
}

void PairHardSquareWell::append_held(std::vector<std::array<int, 2>>& pairs) const {
  for (const auto& [i, j, separation, relative_velocity] : event_fix_->pairs_in_wells()) {
    const auto& well = contact(atom->type[i], atom->type[j]).well;
    if (cohesion::square_well::will_be_captured(
            separation, -relative_velocity,
            cohesion::square_well::edge(well, atom->radius[i], atom->radius[j]), well.depth,
            1.0 / atom->rmass[i] + 1.0 / atom->rmass[j]))
      pairs.push_back({i, j});
  }
}

double PairHardSquareWell::list_reach() const { return REACH * neighbor->skin; }

void PairHardSquareWell::set_contact(int i, int j, const HardContact& c) {
  contacts_(i, j) = contacts_(j, i) = c;
  contacts_(j, i).well = cohesion::square_well::reversed(c.well);
}

/* ---------------------------------------------------------------------- */

void PairHardSquareWell::settings(int narg, char** arg) {
  const std::string message_prefix = "pair_style hard/squarewell";
  SpecifiedKeywords specified(lmp, message_prefix);
  for (int i = 0; i < narg; i += 2) {
    const std::string word = arg[i];
    if (word != "collapse" && word != "contact_time" && word != "rest" && word != "limit" &&
        word != "record")
      error->all(FLERR, message_prefix + ": unknown keyword '" + word +
                            "'; valid ones: rest, collapse, contact_time, limit, record");
    if (i + 1 == narg)
      error->all(FLERR, message_prefix + ": " + word +
                            (word == "record" ? " takes a file name" : " takes a number"));
    specified.note(1, arg + i);
    const std::string value = arg[i + 1];
    if (word == "record") {
      record_file_ = value;
    } else if ((word == "collapse" || word == "rest") && value == "off") {
      if (word == "rest")
        rules_.rest_factor = 0.0;
      else
        rules_.collapse_limit = 0;
    } else if (word == "contact_time" || word == "rest") {
      const double number = utils::numeric(FLERR, arg[i + 1], false, lmp);
      if (!(std::isfinite(number) && number >= 0.0))
        error->all(FLERR, message_prefix + ": " + word + " " + value +
                              " must be a finite number not below zero");
      (word == "rest" ? rules_.rest_factor : rules_.contact_time) = number;
    } else {
      const int number = utils::inumeric(FLERR, arg[i + 1], false, lmp);
      if (number < 1)
        error->all(FLERR, message_prefix + ": " + word + " " + value + " must be at least 1" +
                              (word == "collapse" ? ", or 'off'" : ""));
      (word == "collapse" ? rules_.collapse_limit : rules_.event_limit) = number;
    }
  }
}

void PairHardSquareWell::coeff(int narg, char** arg) {
  if (narg < 4)
    error->all(FLERR,
               "pair_coeff of hard/squarewell takes 'i j restitution e [friction mu] [well D "
               "ratio]'");
  if (!allocated) allocate();
  const std::string message_prefix =
      std::string("pair_coeff ") + arg[0] + " " + arg[1] + " of hard/squarewell";
  HardContact c;
  SpecifiedKeywords specified(lmp, message_prefix);
  for (int at = 2; at < narg;) {
    const int words = read_hard_keyword(lmp, message_prefix, at, narg, arg, c, specified);
    if (words == 0)
      error->all(FLERR, message_prefix + ": unknown keyword '" + arg[at] +
                            "'; valid ones: restitution, friction, well");
    at += words;
  }
  require_valid(lmp, message_prefix, c, specified);
  contacts_.assign(message_prefix, arg, [&](int i, int j) { set_contact(i, j, c); });
}

void PairHardSquareWell::init_style() {
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "pair_style hard/squarewell acts between spheres; use 'atom_style sphere'");
  if (update->whichflag == 2)
    error->all(FLERR, "pair_style hard/squarewell follows motion in time; it cannot be minimized");
  event_fix_ = FixHardEvents::find_or_create(lmp);
  contacts_.commit();
  require_time_step(lmp, "pair_style hard/squarewell");
  require_plausible_spheres(lmp, "pair_style hard/squarewell");
  require_whole_special_factors(lmp, this, "pair_style hard/squarewell", false);
  largest_radius_ = largest_radii(lmp);
  active_.assign(contacts_.size(), false);
}

double PairHardSquareWell::init_one(int i, int j) {
  if (contacts_.to_mix("pair_style hard/squarewell", i, j))
    set_contact(i, j, {mixed(contacts_(i, i), contacts_(j, j))});
  active_[contacts_.number(i, j)] = active_[contacts_.number(j, i)] = true;
  const double edge =
      cohesion::square_well::edge(contacts_(i, j).well, largest_radius_[i], largest_radius_[j]);
  require_plausible_range(lmp, "pair_style hard/squarewell", edge);
  return edge + list_reach();
}

/* ---------------------------------------------------------------------- */

void PairHardSquareWell::write_restart(FILE* fp) {
  write_restart_settings(fp);
  contacts_.write(fp);
}

void PairHardSquareWell::read_restart(FILE* fp) {
  read_restart_settings(fp);
  allocate();
  contacts_.read(fp, [this](int i, int j, const HardContact& c) { set_contact(i, j, c); });
}

void PairHardSquareWell::write_restart_settings(FILE* fp) {
  write_layout(fp, LAYOUT);
  const int numbers[2] = {rules_.collapse_limit, rules_.event_limit};
  fwrite(numbers, sizeof(int), 2, fp);
  const double reals[2] = {rules_.contact_time, rules_.rest_factor};
  fwrite(reals, sizeof(double), 2, fp);
}

void PairHardSquareWell::read_restart_settings(FILE* fp) {
  require_layout(lmp, fp, "pair_style hard/squarewell", LAYOUT);
  int numbers[2] = {0, 0};
  double reals[2] = {0.0, 0.0};
  if (comm->me == 0) {
    utils::sfread(FLERR, numbers, sizeof(int), 2, fp, nullptr, error);
    utils::sfread(FLERR, reals, sizeof(double), 2, fp, nullptr, error);
  }
  MPI_Bcast(numbers, 2, MPI_INT, 0, world);
  MPI_Bcast(reals, 2, MPI_DOUBLE, 0, world);
  rules_.collapse_limit = numbers[0];
  rules_.event_limit = numbers[1];
  rules_.contact_time = reals[0];
  rules_.rest_factor = reals[1];
}
