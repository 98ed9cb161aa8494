// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "../dem_engine.h"
// engine headers
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

/// LAMMPS as particle engine. The script sets everything up, loads the package's plugin and defines
/// `fix gas/coupling`, whose arrays are read and written in place.
namespace cohesion::coupling {

namespace {

// A bad command makes LAMMPS end the process; without this the user would not learn where to look.
std::string log_of_running_engine;

void point_to_log() {
  if (!log_of_running_engine.empty())
    std::fprintf(stderr,
                 "The particle engine ended the run; its reason stands at the end of '%s'\n",
                 log_of_running_engine.c_str());
}

// LAMMPS keeps coordinates as rows of three in one block: the first row's address is all of it.
using Rows = double (*)[3];
Rows rows(double** array) { return array ? reinterpret_cast<Rows>(array[0]) : nullptr; }

class LammpsEngine : public DemEngine {
 public:
  explicit LammpsEngine(const DemEngineSettings& settings) {
    log_of_running_engine = settings.log;
    std::atexit(point_to_log);
    // LAMMPS compares words in `if`, but not file names.
    const bool continued = !settings.restart.empty();
    std::vector<std::string> words{"lammps",
                                   "-screen",
                                   "none",
                                   "-log",
                                   settings.log,
                                   "-var",
                                   "continued",
                                   continued ? "yes" : "no",
                                   "-var",
                                   "restart",
                                   continued ? settings.restart : "none"};
    for (const auto& [name, value] : settings.variables)
      words.insert(words.end(), {"-var", name, value});
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    lammps_ = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()),
                                                  arguments.data(), settings.communicator);
    lammps_->input->file(settings.script.c_str());
    check(settings.script);
    // LAMMPS renews its neighbour lists in steps that write a state, so that what continues from
    // there has the same; it asks at the start of a run with set-up whether there will be such
    // steps.
    write_state_at(last_step, "never");
    lammps_->input->one("run 0 post no");
  }

  ~LammpsEngine() override { log_of_running_engine.clear(); }

  Particles particles() override {
    const auto* atom = lammps_->atom;
    return {atom->nlocal, rows(atom->x), rows(atom->v), atom->radius, atom->rmass, atom->tag};
  }

  drag::GasOnParticle* gas() override {
    auto** const all = static_cast<double**>(extract("gas"));
    return all ? reinterpret_cast<drag::GasOnParticle*>(all[0]) : nullptr;
  }

  void advance(int steps, const std::string& restart) override {
    std::fill_n(static_cast<double*>(extract("gas_impulse")), 6, 0.0);
    const long end = steps_done() + steps;
    if (end >= last_step)
      throw DemEngineError(
          "the particles have done " + std::to_string(steps_done()) +
          " steps; LAMMPS writes states up to step " + std::to_string(last_step) +
          " only. Set a lower step number in the script where it sets the particles "
          "up ('reset_timestep 0'), or take longer steps");
    if (!restart.empty()) write_state_at(end, restart);
    lammps_->input->one("run " + std::to_string(steps) + " pre no post no");
    if (restart.empty()) return;
    // Once is enough: LAMMPS would write at every multiple of the step.
    write_state_at(last_step, "never");
    // LAMMPS appends the step.
    const std::string written = restart + "." + std::to_string(end);
    int failed = lammps_->comm->me == 0 && std::rename(written.c_str(), restart.c_str()) != 0;
    MPI_Bcast(&failed, 1, MPI_INT, 0, lammps_->world);
    if (failed) throw DemEngineError("LAMMPS has not written its state to '" + written + "'");
  }

  long steps_done() override { return static_cast<long>(lammps_->update->ntimestep); }

  Impulse gas_impulse() override {
    const auto* total = static_cast<double*>(extract("gas_impulse"));
    return {{total[0], total[1], total[2]}, {total[3], total[4], total[5]}};
  }

  double time_step() override { return lammps_->update->dt; }
  std::string units() override { return lammps_->update->unit_style; }

  Box box() override {
    const auto* domain = lammps_->domain;
    return {{domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]},
            {domain->boxhi[0], domain->boxhi[1], domain->boxhi[2]}};
  }

 private:
  void check(const std::string& script) {
    if (!lammps_->domain->box_exist)
      throw DemEngineError("the script '" + script + "' makes no simulation box");
    if (!lammps_->atom->radius_flag || lammps_->atom->natoms == 0)
      throw DemEngineError("the script '" + script + "' has no spheres: it needs 'atom_style " +
                           "sphere' and at least one particle, and has atom_style " +
                           lammps_->atom->atom_style + " and " +
                           std::to_string(lammps_->atom->natoms) + " particles");
    const auto* modify = lammps_->modify;
    const auto* end = modify->fix + modify->nfix;
    const auto* found = std::find_if(modify->fix, modify->fix + modify->nfix, [](auto* fix) {
      return std::string(fix->style) == "gas/coupling";
    });
    if (found == end)
      throw DemEngineError("the script '" + script + "' has no fix gas/coupling, through which " +
                           "particles feel the gas; add 'fix gas all gas/coupling' as last fix");
    fix_ = *found;
  }

  /// LAMMPS's command `restart` takes no later one. advance() ends before it, so that the state
  /// called "never" is not written.
  static constexpr long last_step = std::numeric_limits<int>::max();

  void write_state_at(long step, const std::string& file) {
    lammps_->input->one("restart " + std::to_string(step) + " " + file);
  }

  void* extract(const char* name) {
    int dimension = 0;
    return fix_->extract(name, dimension);
  }

  std::unique_ptr<LAMMPS_NS::LAMMPS> lammps_;
  LAMMPS_NS::Fix* fix_ = nullptr;
};

}  // namespace

}  // namespace cohesion::coupling

extern "C" {

int cohesion_dem_engine_interface() { return cohesion::coupling::dem_engine_interface; }

cohesion::coupling::DemEngine* cohesion_make_dem_engine(
    const cohesion::coupling::DemEngineSettings& settings) {
  return new cohesion::coupling::LammpsEngine(settings);
}
}
