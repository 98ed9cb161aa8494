// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

// engine headers
#include "atom.h"
#include "fix.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "variable.h"

#include "drag/gas_on_particle.h"
#include "liquid/liquid_on_particle.h"
#include GAS_COUPLING_WORDS

inline constexpr double gravity = 9.81;

/// A real LAMMPS or LIGGGHTS with the package's styles, and the gas rows of its fix gas/coupling.
/// Built once for each, with the words of each (GAS_COUPLING_WORDS).
class Engine {
 public:
  Engine() {
    const char* words[] = {"lammps", "-screen", "none", "-log", "none"};
    std::vector<char*> arguments;
    for (const char* word : words) arguments.push_back(const_cast<char*>(word));
    lammps_ = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()),
                                                  arguments.data(), MPI_COMM_WORLD);
    commands(load_styles());
  }

  void command(const std::string& line) { lammps_->input->one(line.c_str()); }

  void commands(const std::vector<std::string>& lines) {
    for (const auto& line : lines) command(line);
  }

  /// A periodic box with `n` spheres of different size and speed; `fall` turns gravity on.
  void fill(int n, double dt, bool fall) {
    for (const char* line :
         {"units si", "atom_style sphere", "atom_modify map array sort 10 2e-3", "boundary p p p",
          "newton off", "region b block 0 .1 0 .02 0 .02", "create_box 2 b", "neighbor 1e-3 bin",
          "neigh_modify delay 0 every 1 check yes", "thermo 1000000"})
      command(line);
    commands(no_contacts());
    for (int i = 0; i < n; i++) {
      command("create_atoms 1 single " + std::to_string(0.1 * (i + 0.5) / n) + " 0.01 0.01");
      const std::string atom = "set atom " + std::to_string(i + 1);
      command(atom + " diameter " + std::to_string(1e-3 * (1 + 0.5 * i / n)) + " density 2650");
      command(atom + " vx " + std::to_string(2.0 + i) + " vy 0.5 vz -0.1");
    }
    command("timestep " + std::to_string(dt * 1e6) + "e-6");
    command("fix move all nve/sphere");
    if (fall) command("fix fall all gravity " + std::to_string(gravity) + " vector 0 0 -1");
    command("fix gas all gas/coupling");
    command("run 0");  // LIGGGHTS initialises the rows of a new fix in its first run
  }

  LAMMPS_NS::Atom& atom() { return *lammps_->atom; }

  cohesion::drag::GasOnParticle& gas(int i, const std::string& fix = "gas") {
    return *reinterpret_cast<cohesion::drag::GasOnParticle*>(
        static_cast<double**>(extract("gas", fix))[i]);
  }

  /// Kept from the first call on.
  cohesion::liquid::LiquidOnParticle& liquid(int i, const std::string& fix = "gas") {
    return *reinterpret_cast<cohesion::liquid::LiquidOnParticle*>(
        static_cast<double**>(extract("liquid", fix))[i]);
  }

  double* impulse() { return static_cast<double*>(extract("gas_impulse")); }

  void* extract(const char* name, const std::string& fix = "gas") {
    int dimension = 0;
    for (int i = 0; i < lammps_->modify->nfix; i++)
      if (lammps_->modify->fix[i]->id == fix)
        return lammps_->modify->fix[i]->extract(name, dimension);
    return nullptr;
  }

  double variable(const std::string& formula) {
    command("variable asked equal " + formula);
    char name[] = "asked";
    auto* variables = lammps_->input->variable;
    return variables->compute_equal(variables->find(name));
  }

 private:
  std::unique_ptr<LAMMPS_NS::LAMMPS> lammps_;
};
