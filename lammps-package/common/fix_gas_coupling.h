// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS
// clang-format off
FixStyle(gas/coupling,FixGasCoupling);
// clang-format on
#else

#ifndef LMP_FIX_GAS_COUPLING_H
#define LMP_FIX_GAS_COUPLING_H

#include <string>
#include <vector>

#include "drag/gas_on_particle.h"
#include "fix.h"
#include "liquid/liquid_on_particle.h"

namespace LAMMPS_NS {

/// fix gas/coupling: the gas as each particle feels it. A gas solver sets it through
/// extract(); the fix keeps it until it is set again, moves it with the particles and applies the
/// forces in every step, with the particle's own velocity. The laws are in
/// src/drag/particle_drag.h; doc: docs/lammps-package/fix_gas_coupling.md
class FixGasCoupling : public Fix {
 public:
  FixGasCoupling(class LAMMPS*, int, char**);
  ~FixGasCoupling() override;

  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  /// Data of the solver, by name; rows are valid until the engine runs again. A set-up adds forces,
  /// but records no impulse.
  ///   gas           double**, a GasOnParticle for each particle of this rank. The solver may set
  ///                 the drag impulse to minus the impulse that the gas has already received
  ///   liquid        double**, a LiquidOnParticle each, stored from the first call on
  ///   no_liquid     null; ends the storage of liquid
  ///   gravity       double[6], lowest, then highest components of the accelerations that fixes
  ///                 gravity give to integrated particles of this rank and group that no fix
  ///                 holds; lowest above highest: no such particles
  ///   unseen_fixes  char*, names of the fixes that add forces after this one; null: none
  ///   box_fixes     char*, names of the fixes that change size or shape of the box; null: none
  ///   gas_impulse   double[6], impulse of drag (3) and of pressure (3) on the particles of this
  ///                 rank, summed until the solver sets it to zero; not in restart files
  void* extract(const char*, int&) override;
  double compute_vector(int) override;
  double memory_usage() override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  int pack_restart(int, double*) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

 private:
  cohesion::drag::GasOnParticle& gas(int i) {
    return *reinterpret_cast<cohesion::drag::GasOnParticle*>(rows[i]);
  }
  cohesion::liquid::LiquidOnParticle& liquid(int i) {
    return *reinterpret_cast<cohesion::liquid::LiquidOnParticle*>(liquid_rows[i]);
  }
  void apply_forces(bool setting_up);
  void apply_gas(int i, bool setting_up);
  void apply_liquid(int i, bool setting_up);
  void add_forces(cohesion::drag::GasOnParticle&, const double* pressure, const double* drag_force,
                  bool setting_up);
  void use_liquid();
  int row_size() const;
  void copy_row(int i, double* to) const;
  void set_row(int i, const double* from);
  std::string unseen_fixes() const;
  std::string box_fixes() const;
  std::vector<bool> components_set_afterwards();
  void find_gravity();

  double** rows;         // per atom, a GasOnParticle
  double** liquid_rows;  // per atom, a LiquidOnParticle; null where nobody has asked for them
  double impulse[6];     // of this rank since the solver reset it: drag, pressure
  double force[6];       // of this rank in this step: drag, pressure
  double gravity[6];     // of this rank's particles, lowest and highest: extract()
  std::string listed;    // fixes: extract()
};

}  // namespace LAMMPS_NS

#endif
#endif
