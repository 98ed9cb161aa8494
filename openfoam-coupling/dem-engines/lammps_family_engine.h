// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "dem_engine.h"
#include "engine_screen.h"
#include "run_watch.h"
#include "working_folder.h"
// engine headers
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "group.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

/// LAMMPS and LIGGGHTS as particle engines, of one origin: their classes have the same names and,
/// as far as they are used here, the same members. Included once by each adapter, with the headers
/// of its engine. The script sets everything up and defines `fix gas/coupling`, whose arrays are
/// read and written in place.
namespace cohesion::coupling {

// The engines keep coordinates as rows of three in one block: the first row's address is all of it.
using Rows = double (*)[3];
inline Rows rows(double** array) { return array ? reinterpret_cast<Rows>(array[0]) : nullptr; }

/// What their scripts spell differently, and what they do.
struct ScriptWords {
  const char* engine;     ///< its name, for messages
  const char* continued;  ///< value of the variable `continued`: there is a state to continue from
  const char* not_continued;
  const char* early_end;  ///< what may have ended a run early, and the cure
  /// Writes a restart file between runs, of the particles where they are and on the ranks that have
  /// them, and of contacts as they are.
  void (*write_state)(LAMMPS_NS::LAMMPS*, const std::string& file);
};

class LammpsFamilyEngine : public DemEngine {
 public:
  LammpsFamilyEngine(const DemEngineSettings& settings, const ScriptWords& words)
      : words_(words),
        communicator_(settings.communicator),
        script_(settings.script),
        log_(settings.log),
        folder_(settings.folder),
        on_message_(
            [this, on_message = settings.on_message](MessageLevel level, const std::string& text) {
              const std::lock_guard lock(messages_);
              on_message(level, text);
            }),
        screen_(on_message_) {
    MPI_Comm_rank(communicator_, &rank_);
    std::atexit(end_of_process);
    work([&] {
      start(settings);
      run_script(settings.script);
      require_step(settings.script);
      require_coupled(settings.script);
      require_all_in_group();
      command("run 0 post no");
    });
  }

  Particles particles() override {
    const auto* atom = lammps_->atom;
    return {atom->nlocal, rows(atom->x), rows(atom->v), atom->radius,
            atom->rmass,  atom->tag,     atom->type};
  }

  drag::GasOnParticle* gas() override {
    auto** const all = static_cast<double**>(extract("gas"));
    return all ? reinterpret_cast<drag::GasOnParticle*>(all[0]) : nullptr;
  }

  const drag::InAgglomerate* agglomerates() override {
    double** all = nullptr;
    work([&] {
      int dimension = 0;
      all = static_cast<double**>(only_fix_agglomerates()->extract("agglomerates", dimension));
    });
    return all ? reinterpret_cast<drag::InAgglomerate*>(all[0]) : nullptr;
  }

  liquid::LiquidOnParticle* liquid() override {
    auto** const all = static_cast<double**>(extract("liquid"));
    return reinterpret_cast<liquid::LiquidOnParticle*>(all[0]);
  }

  void without_liquid() override { extract("no_liquid"); }

  void advance(int steps, const std::string& restart) override {
    work([&] {
      std::fill_n(static_cast<double*>(extract("gas_impulse")), 6, 0.0);
      run(steps);
      require_all_in_group();
      if (restart.empty()) return;
      // The command `restart` would write what contacts remember of the step before.
      // `write_restart` hands particles on to other ranks, which must have been done before,
      // together with what their contacts remember. And a run that is continued begins by computing
      // the forces of this state anew; so does this one, to go on alike.
      command("run 0 post no");
      command("write_restart " + restart);
      command("run 0 post no");
    });
  }

  void keep(const std::string& file) override {
    work([&] {
      // Particles that have left a periodic box are taken back when the list of neighbours is made.
      // A file must have them in it.
      auto* const atom = lammps_->atom;
      const int n = atom->nlocal;
      const std::vector<double> places(atom->x[0], atom->x[0] + (n > 0 ? 3 * n : 0));
      const std::vector images(atom->image, atom->image + n);
      for (int i = 0; i < n; i++) lammps_->domain->remap(atom->x[i], atom->image[i]);
      words_.write_state(lammps_.get(), file);
      std::copy(places.begin(), places.end(), atom->x[0]);
      std::copy(images.begin(), images.end(), atom->image);
    });
  }

  long steps_done() override { return static_cast<long>(lammps_->update->ntimestep); }

  Impulse gas_impulse() override {
    const auto* total = static_cast<double*>(extract("gas_impulse"));
    return {{total[0], total[1], total[2]}, {total[3], total[4], total[5]}};
  }

  std::string restart_hint() override {
    return std::string("if \"${continued} == ") + words_.not_continued +
           "\" then <set up> else \"read_restart ${restart}\"";
  }

  Accelerations gravity() override {
    const auto* range = static_cast<double*>(extract("gravity"));
    return {{range[0], range[1], range[2]}, {range[3], range[4], range[5]}};
  }

  double time_step() override { return lammps_->update->dt; }
  std::string units() override { return lammps_->update->unit_style; }

  SimulationBox box() override {
    const auto* domain = lammps_->domain;
    // In two dimensions nothing leaves along z, which the engine calls periodic.
    const auto fixed = [&](int d) {
      constexpr int f = 1;  // as the engine numbers p, f, s, m
      return domain->boundary[d][0] == f && domain->boundary[d][1] == f;
    };
    return {{domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]},
            {domain->boxhi[0], domain->boxhi[1], domain->boxhi[2]},
            {domain->xperiodic != 0, domain->yperiodic != 0,
             domain->zperiodic != 0 && domain->dimension == 3},
            {fixed(0), fixed(1), fixed(2)}};
  }

 private:
  void start(const DemEngineSettings& settings) {
    // `if` compares no file names, so whether there is one is a variable of its own.
    const bool continued = !settings.restart.empty();
    std::vector<std::string> line{
        words_.engine, "-log",      settings.log,
        "-var",        "continued", continued ? words_.continued : words_.not_continued,
        "-var",        "restart",   continued ? settings.restart : "none"};
    for (const auto& [name, value] : settings.variables)
      line.insert(line.end(), {"-var", name, value});
    std::vector<char*> arguments;
    for (auto& word : line) arguments.push_back(word.data());
    const EngineScreen::AsStandardOutput screen(screen_);
    lammps_ = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()),
                                                  arguments.data(), communicator_);
  }

  void run_script(const std::string& script) {
    std::unique_ptr<RunWatch> watch;
    if (rank_ == 0)
      watch = std::make_unique<RunWatch>([this] { return steps_of_run(); },
                                         [this, script](const std::string& how_far) {
                                           on_message_(MessageLevel::note, script + ": " + how_far);
                                         });
    lammps_->input->file(script.c_str());
  }

  /// Called by another thread than that which makes the steps: a step that is just over will do.
  /// The command `clear` of a script replaces `update`; a call at that very moment, of four in a
  /// second, would read what has just been freed, since engines offer no lock.
  RunWatch::Steps steps_of_run() const {
    const auto* update = __atomic_load_n(&lammps_->update, __ATOMIC_RELAXED);
    if (!update || __atomic_load_n(&update->whichflag, __ATOMIC_RELAXED) == 0) return {0, 0, 0};
    const auto step = [](const LAMMPS_NS::bigint& of) {
      return static_cast<long>(__atomic_load_n(&of, __ATOMIC_RELAXED));
    };
    return {step(update->firststep), step(update->ntimestep), step(update->laststep)};
  }

  /// Does all that lets the engine work, in its folder; tells the user when the engine ends the
  /// run.
  template <class Task>
  void work(Task&& task) {
    const WorkingFolder::Visit visit(folder_);
    at_work_ = this;
    try {
      task();
    } catch (const std::exception& error) {
      at_work_ = nullptr;
      // In the middle of its work an engine cannot be taken down.
      static_cast<void>(lammps_.release());
      const std::string text = error.what();
      // For an error of all ranks the first has the message, and ends the others, which wait for
      // it.
      if (text.rfind("ERROR:", 0) == 0 && rank_ != 0) MPI_Barrier(communicator_);
      // The engine has shown its own errors, each on the rank that has it.
      if (text.rfind("ERROR", 0) == 0) throw DemEngineError(end_text(true));
      throw DemEngineError(text);
    }
    at_work_ = nullptr;
  }

  std::string end_text(bool with_error) const {
    return std::string("The particle engine ended the run") +
           (with_error ? ", for the reason above."
                       : " and named no error: has its script a 'quit'?") +
           " Its log is '" + log_ + "'";
  }

  /// Engines without exceptions end the process, after `quit` as if all had gone well.
  static void end_of_process() {
    if (!at_work_) return;
    if (at_work_->rank_ == 0)
      at_work_->on_message_(MessageLevel::error,
                            at_work_->end_text(at_work_->screen_.has_shown_error()));
    std::fflush(nullptr);
    // With the first rank that fails a launcher ends all: let it be the one that has the message.
    int finalized = 0;
    MPI_Finalized(&finalized);
    std::_Exit(at_work_->rank_ == 0 || !finalized ? EXIT_FAILURE : EXIT_SUCCESS);
  }

  /// Throws DemEngineError unless the script has set a time step of finite length. Without one the
  /// drag and the forces of contacts would not be numbers.
  void require_step(const std::string& script) const {
    const double dt = lammps_->update->dt;
    if (!(dt > 0.0 && std::isfinite(dt)))
      throw DemEngineError("the script '" + script + "' has timestep " + std::to_string(dt) +
                           " s: give the command timestep a number greater than zero, of which " +
                           "deltaT in system/controlDict is a whole multiple");
  }

  /// Throws DemEngineError unless the script has made spheres that feel the gas.
  void require_coupled(const std::string& script) {
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
    if (const auto* fixes = static_cast<const char*>(extract("unseen_fixes")))
      throw DemEngineError("the script '" + script + "' has fix " + fix_->id +
                           " gas/coupling before " + fixes + ". The drag of a step follows from " +
                           "all other forces of that step, and does not see those: put fix " +
                           "gas/coupling behind");
    if (const auto* fixes = static_cast<const char*>(extract("box_fixes")))
      throw DemEngineError("the script '" + script + "' has " + fixes + ", which changes the " +
                           "simulation box while the gas flows. The mesh of the gas stays as it " +
                           "is: remove the fix, or use 'unfix' before the script ends");
  }

  /// The gas is charged with the drag of all particles, so that all must feel it. Particles that
  /// fixes insert during a run may be outside the group.
  void require_all_in_group() const {
    const auto* atom = lammps_->atom;
    const auto outside = [&](int mask) { return !(mask & fix_->groupbit); };
    long mine = std::count_if(atom->mask, atom->mask + atom->nlocal, outside), all = 0;
    MPI_Allreduce(&mine, &all, 1, MPI_LONG, MPI_SUM, communicator_);
    if (all == 0) return;
    const std::string id = fix_->id;
    throw DemEngineError(
        "fix " + id + " gas/coupling of the script '" + script_ + "' acts on group " +
        lammps_->group->names[fix_->igroup] + ", and " + std::to_string(all) + " of " +
        std::to_string(static_cast<long>(atom->natoms)) + " particles are outside this group. " +
        "They would feel no gas, and the gas would be charged with their drag: use 'fix " + id +
        " all gas/coupling'. To hold particles against the gas, put fix freeze or setforce behind");
  }

  /// Some commands end a run early and report no error.
  void run(int steps) {
    const long before = steps_done();
    command("run " + std::to_string(steps) + " pre no post no");
    const long done = steps_done() - before;
    if (done == steps) return;
    throw DemEngineError("the particle engine did " + std::to_string(done) + " of the " +
                         std::to_string(steps) + " steps of this gas step and stands at its step " +
                         std::to_string(steps_done()) + ". " + words_.early_end + " Its log is '" +
                         log_ + "'");
  }

  /// Throws DemEngineError where there is none, or several.
  LAMMPS_NS::Fix* only_fix_agglomerates() {
    const auto* modify = lammps_->modify;
    LAMMPS_NS::Fix* found = nullptr;
    for (int k = 0; k < modify->nfix; k++) {
      if (std::string(modify->fix[k]->style) != "agglomerates") continue;
      if (found)
        throw DemEngineError(
            "the script '" + script_ + "' has two fixes agglomerates, " + found->id + " and " +
            modify->fix[k]->id +
            ", and the drag of agglomerates is that of the one there is: keep one");
      found = modify->fix[k];
    }
    if (!found)
      throw DemEngineError("the script '" + script_ +
                           "' has no fix agglomerates, which says what " +
                           "particles are bound to each other; add 'fix sets all agglomerates " +
                           "1000', and a pair style of this package that binds them, or take " +
                           "agglomerateDrag none");
    return found;
  }

  void command(const std::string& line) { lammps_->input->one(line.c_str()); }

  void* extract(const char* name) {
    int dimension = 0;
    return fix_->extract(name, dimension);
  }

  static inline LammpsFamilyEngine* at_work_ = nullptr;

  const ScriptWords words_;
  const MPI_Comm communicator_;
  const std::string script_;
  const std::string log_;
  WorkingFolder folder_;
  int rank_ = 0;
  std::mutex messages_;
  const EngineScreen::OnMessage on_message_;
  EngineScreen screen_;  // which outlives the engine
  std::unique_ptr<LAMMPS_NS::LAMMPS> lammps_;
  LAMMPS_NS::Fix* fix_ = nullptr;
};

}  // namespace cohesion::coupling
