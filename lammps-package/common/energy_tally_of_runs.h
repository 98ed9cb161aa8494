// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_ENERGY_TALLY_OF_RUNS_H
#define COHESION_ENERGY_TALLY_OF_RUNS_H

#include <string>

#include "atom.h"
#include "comm.h"
#include "common/box_sides.h"
#include "common/engine_api.h"
#include "common/message.h"
#include "compute.h"
#include "energy_tally.h"
#include "modify.h"
#include "update.h"

// What the energy tallies of both engines share.

namespace LAMMPS_NS {

/// Stops when a fix changes the box, for which the tally has no entry.
inline void require_fixed_box(LAMMPS* lmp, const std::string& where) {
  for (int i = 0; i < lmp->modify->nfix; i++) {
    const Fix* const fix = lmp->modify->fix[i];
    if (engine_api::changes_box(fix))
      stop(
          lmp, FLERR, where, ": fix ", fix->id, " ", fix->style,
          " changes the box, which changes velocities at its faces and does work, and no entry has "
          "that: use one without the other");
  }
}

/// Stops when a tally is read in a step without stored energies.
inline void require_read(LAMMPS* lmp, const std::string& where, bool is_read) {
  if (!is_read)
    stop(lmp, FLERR, where, ": step ", lmp->update->ntimestep,
         " has no stored energies, because no output requested them in advance; read this compute "
         "by thermo_style, fix print or fix ave/time");
}

/// Warns, once, when particles have come or gone since the last check.
class SameParticles {
 public:
  void check(LAMMPS* lmp, const std::string& where) {
    const bigint before = number_;
    number_ = lmp->atom->natoms;
    if (warned_ || before < 0 || before == number_) return;
    warned_ = true;
    if (lmp->comm->me == 0)
      lmp->error->warning(
          FLERR, message(where, ": there were ", before, " particles and now are ", number_,
                         "; the energy that came or went with them is in entry 10, "
                         "which is not the error of the time step then")
                     .c_str());
  }

 private:
  bigint number_ = -1;
  bool warned_ = false;
};

/// The energy tally of one script from run to run.
class TallyOfRuns {
 public:
  /// Sets what is missing in `entries`. In a run that begins with another box than the last one
  /// ended with, what the change has put in becomes work of others; of the first one it warns.
  void update(LAMMPS* lmp, const std::string& where, double* entries) {
    const bool in_a_run = lmp->update->whichflag != 0;
    if (in_a_run && residual_.has_begun() && box_.changed(lmp->domain))
      warn_of_change(lmp, where, residual_.update_after_change(entries));
    else
      residual_.update(entries);
    if (in_a_run) box_.store(lmp->domain);
  }
  /// The same when all fixes of a run are set up. The first time is the begin of the tally, whoever
  /// asked for it before while some were not.
  void begin_run(LAMMPS* lmp, const std::string& where, double* entries) {
    if (!begun_) residual_ = {};
    begun_ = true;
    update(lmp, where, entries);
  }
  /// At the end of a run.
  void end_run(double* entries) { residual_.end_run(entries); }

 private:
  void warn_of_change(LAMMPS* lmp, const std::string& where, double work) {
    if (work == 0.0) return;
    if (!warned_ && lmp->comm->me == 0)
      lmp->error->warning(
          FLERR, message(where, ": the box was changed between two runs; the energy ", work,
                         " that this put in is in entry 9, as that of any "
                         "later change")
                     .c_str());
    warned_ = true;
  }

  cohesion::energy_tally::Residual residual_;
  BoxSides box_;
  bool begun_ = false;
  bool warned_ = false;
};

/// compute gran/energy of both engines: an energy tally, which goes on whether anybody asks for it
/// or not.
class EnergyTallyCompute : public engine_api::StyleCompute {
 public:
  EnergyTallyCompute(LAMMPS* lammps, int narg, char** arg)
      : engine_api::StyleCompute(lammps, narg, arg),
        where(std::string("compute ") + id + " gran/energy") {
    if (narg != 3) stop(lmp, FLERR, where, " takes no further arguments; '", arg[3], "' was given");
    if (igroup != 0)
      stop(lmp, FLERR, where, " balances all particles; its group must be 'all', not '", arg[1],
           "'");
    scalar_flag = vector_flag = timeflag = 1;
    extscalar = extvector = 1;
    size_vector = cohesion::energy_tally::ENTRIES;
    vector = new double[size_vector];
  }
  ~EnergyTallyCompute() override { delete[] vector; }

  void init() override { require_fixed_box(lmp, where); }
  void compute_vector() override {
    invoked_vector = update->ntimestep;
    require_read(lmp, where, is_read());
    sum();
    tally_.update(lmp, where, vector);
  }
  /// Kinetic and stored energy.
  double compute_scalar() override {
    if (invoked_vector != update->ntimestep) compute_vector();
    invoked_scalar = update->ntimestep;
    return scalar = cohesion::energy_tally::stored(vector);
  }
  /// What a run begins with is known, and nothing has moved.
  virtual void begin_run() {
    sum();
    tally_.begin_run(lmp, where, vector);
  }
  void end_run() {
    sum();
    tally_.end_run(vector);
  }

 protected:
  const std::string where;

 private:
  /// Whether stored energies are known in this step.
  virtual bool is_read() = 0;
  /// Adds what this rank has: all entries but what is missing.
  virtual void add_to(double* entries) = 0;

  void sum() {
    particles_.check(lmp, where);
    double mine[cohesion::energy_tally::ENTRIES] = {};
    add_to(mine);
    MPI_Allreduce(mine, vector, size_vector, MPI_DOUBLE, MPI_SUM, world);
  }

  TallyOfRuns tally_;
  SameParticles particles_;
};

/// Calls what(compute) for each there is.
template <class What>
void for_each_energy_tally(const Modify* modify, What what) {
  for (int k = 0; k < modify->ncompute; k++)
    if (auto* const compute = dynamic_cast<EnergyTallyCompute*>(modify->compute[k])) what(*compute);
}

/// Whether an output reads one of them in this step. Outputs request that from the engine in
/// advance.
inline bool reads_energy_tally(const Modify* modify, bigint step) {
  for (int k = 0; k < modify->ncompute; k++) {
    Compute* const compute = modify->compute[k];
    if (dynamic_cast<EnergyTallyCompute*>(compute) && compute->matchstep(step)) return true;
  }
  return false;
}

}  // namespace LAMMPS_NS

#endif
