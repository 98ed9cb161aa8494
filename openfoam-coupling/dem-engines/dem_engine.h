// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <mpi.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "drag/gas_on_particle.h"
#include "drag/in_agglomerate.h"
#include "liquid/liquid_on_particle.h"

/// What the coupling needs of a particle engine, in terms of neither the engine nor OpenFOAM.
/// Each engine is a library of its own that is loaded at run time (load_dem_engine.h), since LAMMPS
/// and LIGGGHTS define the same C++ symbols and never fit into one process.
namespace cohesion::coupling {

/// Raised by an engine for a script that cannot be coupled; the text is for the user.
struct DemEngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The kinds of messages that an engine has while it works. A note tells how far it is; the others
/// are in its own words.
enum class MessageLevel { note, warning, error };

struct DemEngineSettings {
  MPI_Comm communicator;                         ///< every rank of it takes part
  std::string folder;                            ///< in which the engine works: of relative names
  std::string script;                            ///< input script that sets the particles up
  std::string log;                               ///< log file that the engine writes
  std::string restart;                           ///< state to continue from; empty: none
  std::map<std::string, std::string> variables;  ///< given to the script by name
  /// Called on the rank that has a message, while the engine works; never twice at a time.
  std::function<void(MessageLevel, const std::string&)> on_message;
};

/// An engine that has run its script and stands ready to advance. All arrays belong to the engine,
/// are those of the particles on this rank, and stay valid until the next advance().
class DemEngine {
 public:
  struct Particles {
    int count;
    const double (*position)[3];  ///< [length]
    const double (*velocity)[3];  ///< [length/time]
    const double* radius;         ///< [length]
    const double* mass;           ///< [mass]
    const int* id;
    const int* type;  ///< of 1 to the number of the script's types
  };

  struct Impulse {
    std::array<double, 3> drag;
    std::array<double, 3> pressure;
  };

  struct SimulationBox {
    std::array<double, 3> low;
    std::array<double, 3> high;
    std::array<bool, 3> periodic;  ///< what leaves it comes back on the other side, now and then
    std::array<bool, 3> fixed;     ///< both ends stay where the script sets them
  };

  /// The lowest and the highest of accelerations in each direction [length/time^2]; the lowest is
  /// above the highest where there is none.
  struct Accelerations {
    std::array<double, 3> lowest;
    std::array<double, 3> highest;
  };

  virtual ~DemEngine() = default;

  virtual Particles particles() = 0;
  /// The gas on each particle, filled in by the coupling and kept by the engine until the next.
  virtual drag::GasOnParticle* gas() = 0;

  /// The agglomerate of each particle as it is now, by the script's fix agglomerates; looked for
  /// when it is asked for. All ranks ask. Throws DemEngineError, on all ranks, where the script has
  /// no such fix, or several.
  virtual const drag::InAgglomerate* agglomerates() = 0;

  /// What added mass and lift need of a liquid beside it, likewise. Kept from the first call on;
  /// without_liquid() gives it up, with what a state that was read had of it.
  virtual liquid::LiquidOnParticle* liquid() = 0;
  virtual void without_liquid() = 0;

  /// Advances by `steps` of its own steps, gas forces included. With a file named, the state at the
  /// end is also written there, what gas() holds included. Throws DemEngineError, on all ranks,
  /// also where the engine did other than so many steps, and where gas forces miss a particle.
  virtual void advance(int steps, const std::string& restart = "") = 0;

  /// Steps done since the particles were set up, those before a restart included.
  virtual long steps_done() = 0;

  /// What the gas forces have given to the particles of this rank in the last advance(), summed
  /// where the forces are put on: the engine's own sum, to be compared with the coupling's.
  virtual Impulse gas_impulse() = 0;

  /// A command by which a script reads the state that it is given, for a message.
  virtual std::string restart_hint() = 0;

  /// What the script's gravity does to the particles of this rank that the gas acts on and that
  /// the script moves.
  virtual Accelerations gravity() = 0;

  virtual double time_step() = 0;
  virtual std::string units() = 0;
  virtual SimulationBox box() = 0;

  /// Writes the state as it is, to continue from, and changes nothing of it: what follows is as if
  /// it had not been written. A run that continues from it computes the forces anew, as it would
  /// not have done. Throws DemEngineError, on all ranks.
  virtual void keep(const std::string& file) = 0;
};

/// Every engine library exports these two with C linkage; the number changes with this header.
inline constexpr int dem_engine_interface = 8;
using DemEngineInterface = int (*)();
using MakeDemEngine = DemEngine* (*)(const DemEngineSettings&);
inline constexpr const char* dem_engine_interface_symbol = "cohesion_dem_engine_interface";
inline constexpr const char* make_dem_engine_symbol = "cohesion_make_dem_engine";

}  // namespace cohesion::coupling
