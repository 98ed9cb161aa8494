// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_ENERGY_COMPANIONS_H
#define COHESION_ENERGY_COMPANIONS_H

#include <string>

#include "atom.h"
#include "box_sides.h"
#include "comm.h"
#include "compute.h"
#include "energy_book.h"
#include "engine_api.h"
#include "message.h"
#include "modify.h"
#include "update.h"

// What an energy book has no entry for, in both engines.

namespace LAMMPS_NS {

/// Stops when a fix changes the box.
inline void refuse_moving_box(LAMMPS* lmp, const std::string& where) {
  for (int i = 0; i < lmp->modify->nfix; i++) {
    const Fix* const fix = lmp->modify->fix[i];
    if (engine_api::changes_box(fix))
      stop(
          lmp, FLERR, where, ": fix ", fix->id, " ", fix->style,
          " changes the box, which changes velocities at its faces and does work, and no entry has "
          "that: use one without the other");
  }
}

/// A compute that keeps an energy book, whether anybody asks for it or not.
class EnergyBookKeeper {
 public:
  /// What a run begins with is known, and nothing has moved.
  virtual void begin_run() = 0;
  virtual void end_run() = 0;

 protected:
  ~EnergyBookKeeper() = default;
};

/// Calls what(keeper) for each there is.
template <class What>
void for_each_energy_book(const Modify* modify, What what) {
  for (int k = 0; k < modify->ncompute; k++)
    if (auto* const keeper = dynamic_cast<EnergyBookKeeper*>(modify->compute[k])) what(*keeper);
}

/// Warns, once, when particles have come or gone since the last check.
class SameParticles {
 public:
  void check(LAMMPS* lmp, const std::string& where) {
    const bigint before = number_;
    number_ = lmp->atom->natoms;
    if (said_ || before < 0 || before == number_) return;
    said_ = true;
    if (lmp->comm->me == 0)
      lmp->error->warning(
          FLERR, message(where, ": there were ", before, " particles and now are ", number_,
                         "; the energy that came or went with them is in entry 10, "
                         "which is not the error of the time step then")
                     .c_str());
  }

 private:
  bigint number_ = -1;
  bool said_ = false;
};

/// The book of one script from run to run.
class BookOfRuns {
 public:
  /// Sets what is missing in `entries`. In a run that begins with another box than the last one
  /// ended with, what the change has put in becomes work of others; once it is told.
  void close(LAMMPS* lmp, const std::string& where, double* entries) {
    const bool in_a_run = lmp->update->whichflag != 0;
    if (in_a_run && opened_.is_open() && box_.changed(lmp->domain))
      tell(lmp, where, opened_.close_after_change(entries));
    else
      opened_.close(entries);
    if (in_a_run) box_.store(lmp->domain);
  }
  /// The same when all fixes of a run are set up. The first time the book is opened, whoever looked
  /// before while some were not.
  void begin_run(LAMMPS* lmp, const std::string& where, double* entries) {
    if (!begun_) opened_ = {};
    begun_ = true;
    close(lmp, where, entries);
  }
  /// At the end of a run.
  void close_run(double* entries) { opened_.close_run(entries); }

 private:
  void tell(LAMMPS* lmp, const std::string& where, double work) {
    if (work == 0.0) return;
    if (!said_ && lmp->comm->me == 0)
      lmp->error->warning(
          FLERR, message(where, ": the box was changed between two runs; the energy ", work,
                         " that this put in is in entry 9, as that of any "
                         "later change")
                     .c_str());
    said_ = true;
  }

  cohesion::energy_book::Opened opened_;
  BoxSides box_;
  bool begun_ = false;
  bool said_ = false;
};

}  // namespace LAMMPS_NS

#endif
