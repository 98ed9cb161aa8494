// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "drag/drag_closure.h"
#include "gas/named_gases.h"
#include "hamaker/roughness.h"
#include "named_table.h"
#include "powder/fluidisation.h"
#include "powder/grain_contact.h"
#include "powder/plan.h"
#include "powder/wells.h"
#include "validation.h"

namespace cohesion::tools {

/// What the command line says, in SI units.
struct PowderRequest {
  std::vector<double> diameters, shares, percentiles;
  double density = 0.0;
  powder::Elastic elastic{0.0, 0.3};
  std::string contact = "linear";
  double stiffness = 0.0;   // of the springs; 0: the softest that will do
  double soft_young = 0.0;  // of Hertz's and JKR's contact; 0: the same
  double overlap = 0.01;
  double restitution = 0.9, friction = 0.3;
  double hamaker = 0.0, surface_energy = 0.0, asperity = 0.0;
  std::vector<double> roughness;  // rms and wavelength, in place of the asperity
  std::vector<double> cutoffs{4e-10, 1e-7};
  std::string law = "hamaker";
  double well_ratio = 0.0;  // 0: not given
  powder::Gas gas{1.205, 1.82e-5};
  std::string gas_name;  // empty: the gas is that above
  double pressure = 101325.0, temperature = 293.15;
  double gravity = 9.81, speed = 0.0;
  double width = 0.0, depth = 0.0, column = 0.0, height = 0.0, void_fraction = 0.42;
  std::string keep = "velocity";
  std::string use = "bed";  // of the run: a fluidised bed, or a packing without gas
  double coarse_graining = 1.0;
  double cell = powder::cell_over_diameter;  // over the largest diameter of what is computed
  std::string engine = "lammps";
  std::string drag = "beetstra";  // of the case
  std::string lammps = "lmp-cohesion", plugin = "cohesionplugin.so";
  bool measure = false, csv = false;
  std::string folder;  // of a case to write
  double grains = 20000.0;
  unsigned seed = 4711;

  bool is_jkr() const { return contact == "jkr"; }
  bool is_elastic() const { return contact != "linear"; }
  bool is_packing() const { return use == "packing"; }
};

inline void add_gas_options(CLI::App& app, PowderRequest& r) {
  auto* density = app.add_option("--gas-density", r.gas.density, "[kg/m3]")->capture_default_str();
  auto* viscosity =
      app.add_option("--gas-viscosity", r.gas.viscosity, "[Pa s]")->capture_default_str();
  std::vector<std::string> names;
  for (const gas::NamedGas& gas : gas::named_gases) names.emplace_back(gas.name);
  auto* name = app.add_option("--gas", r.gas_name, "in place of its density and viscosity")
                   ->check(CLI::IsMember(names))
                   ->excludes(density)
                   ->excludes(viscosity);
  app.add_option("--pressure", r.pressure, "of this gas, absolute [Pa]")
      ->capture_default_str()
      ->needs(name);
  app.add_option("--temperature", r.temperature, "of this gas [K]")
      ->capture_default_str()
      ->needs(name);
}

inline void add_options(CLI::App& app, PowderRequest& r) {
  auto* sizes = app.add_option_group("sizes");
  sizes->add_option("--diameter", r.diameters, "diameter, or those of a distribution [m]");
  sizes->add_option("--percentiles", r.percentiles, "d10 d50 d90 by mass, in place of it [m]")
      ->expected(3);
  sizes->require_option(1);
  app.add_option("--mass-share", r.shares, "of each diameter, of any unit; not given: equal");
  app.add_option("--density", r.density, "of the grains [kg/m3]")->required();
  auto* springs = app.add_option_group("elasticity");
  springs->add_option("--young", r.elastic.young, "Young's modulus [Pa]")
      ->check(CLI::PositiveNumber);
  springs->add_option("--stiffness", r.stiffness, "of the springs of the run [N/m]")
      ->check(CLI::PositiveNumber);
  springs->require_option(1, 2);
  app.add_option("--contact", r.contact, "law of the contact")
      ->check(CLI::IsMember({"linear", "hertz", "jkr"}))
      ->capture_default_str();
  app.add_option("--soft-young", r.soft_young, "Young's modulus of the run, hertz and jkr [Pa]")
      ->check(CLI::PositiveNumber);
  app.add_option("--poisson", r.elastic.poisson, "Poisson's ratio")->capture_default_str();
  app.add_option("--restitution", r.restitution, "without cohesion")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  app.add_option("--friction", r.friction, "coefficient of friction")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  auto* cohesion = app.add_option_group("cohesion");
  cohesion->add_option("--hamaker", r.hamaker, "Hamaker constant [J]")
      ->check(CLI::NonNegativeNumber);
  cohesion->add_option("--surface-energy", r.surface_energy, "of each surface [J/m2]")
      ->check(CLI::NonNegativeNumber);
  cohesion->require_option(0, 1);
  app.add_option("--cutoff", r.cutoffs, "H_cut H_out of the attraction [m]")
      ->expected(2)
      ->capture_default_str();
  auto* asperity = app.add_option("--asperity", r.asperity, "radius of asperities, 0: smooth [m]")
                       ->check(CLI::NonNegativeNumber)
                       ->capture_default_str();
  app.add_option("--roughness", r.roughness,
                 "rms and wavelength of the surface, in place of it [m]")
      ->expected(2)
      ->excludes(asperity);
  app.add_option("--law", r.law, "that the run has for the cohesion")
      ->check(CLI::IsMember({"hamaker", "square_well"}))
      ->capture_default_str();
  app.add_option("--well-ratio", r.well_ratio, "r_out/r of a square well; not given: 1.01")
      ->check(CLI::PositiveNumber);
  app.add_option("--keep", r.keep, "what springs softer than the material keep of it")
      ->check(CLI::IsMember({"velocity", "force"}))
      ->capture_default_str();
  app.add_option("--use", r.use, "bed: fluidised; packing: without gas")
      ->check(CLI::IsMember({"bed", "packing"}))
      ->capture_default_str();
  app.add_option("--overlap", r.overlap, "largest overlap over the diameter")
      ->check(CLI::Range(1e-5, 0.1))
      ->capture_default_str();
  app.add_option("--speed", r.speed,
                 "of impacts; not given: twice the largest u_mf, "
                 "or of a fall of one diameter if larger, or in a packing [m/s]")
      ->check(CLI::PositiveNumber);
  add_gas_options(app, r);
  app.add_option("--gravity", r.gravity, "[m/s2]")->capture_default_str();
  app.add_option("--void-fraction", r.void_fraction, "of the settled bed")->capture_default_str();
  auto* width = app.add_option("--width", r.width, "of a bed in a box [m]");
  auto* depth = app.add_option("--depth", r.depth, "of a bed in a box [m]");
  width->needs(depth);
  depth->needs(width);
  auto* column =
      app.add_option("--column", r.column, "diameter of a round bed [m]")->excludes(width);
  auto* height = app.add_option("--height", r.height, "of the settled bed [m]");
  for (auto* length : {width, depth, column, height}) length->check(CLI::PositiveNumber);
  app.add_option("--coarse-graining", r.coarse_graining,
                 "diameter of the spheres that are computed over that of the grains")
      ->check(CLI::Range(1.0, 100.0))
      ->capture_default_str();
  app.add_option("--cell", r.cell, "edge of the cells over the largest diameter that is computed")
      ->check(CLI::Range(1.5, 20.0))
      ->capture_default_str();
  app.add_option("--engine", r.engine, "of the run: steps, script and case are for it")
      ->check(CLI::IsMember({"lammps", "liggghts"}))
      ->capture_default_str();
  std::vector<std::string> closures;
  for (const drag::Closure& closure : drag::closures) closures.emplace_back(closure.name);
  app.add_option("--drag", r.drag, "closure of the case; the gas has twice its u_mf")
      ->check(CLI::IsMember(closures))
      ->capture_default_str();
  app.add_flag("--measure", r.measure, "measure what a step takes in a short run of LAMMPS");
  app.add_option("--lammps", r.lammps, "program for --measure")->capture_default_str();
  app.add_option("--plugin", r.plugin, "file that it loads")->capture_default_str();
  app.add_option("--write", r.folder, "folder of a coupled case of the bed")->needs(height);
  app.add_option("--grains", r.grains, "the most that it has; a larger bed is written smaller")
      ->check(CLI::Range(100.0, 1e8))
      ->capture_default_str();
  app.add_option("--seed", r.seed, "of the places from which they are poured")
      ->capture_default_str();
  app.add_flag("--csv", r.csv, "comma-separated values with all digits");
}

/// Throws InvalidParameter as hamaker::asperity_of.
inline hamaker::Asperity asperity_of(const PowderRequest& r) {
  return hamaker::asperity_of(r.asperity, r.roughness);
}

/// The gas given by its density and viscosity, or by its name and state. Throws InvalidParameter as
/// gas::density_and_viscosity.
inline powder::Gas gas_of(const PowderRequest& r) {
  if (r.gas_name.empty()) return r.gas;
  const auto state = gas::density_and_viscosity(find_by_name(gas::named_gases, "gas", r.gas_name),
                                                r.pressure, r.temperature);
  return {state.density, state.viscosity};
}

/// r_out/r of square wells in place of the attraction; 0: no wells.
inline double well_ratio_of(const PowderRequest& r) {
  if (r.law != "square_well") return 0.0;
  return r.well_ratio > 0.0 ? r.well_ratio : powder::usual_well_ratio;
}

/// The part of require_together() about Hertz's and JKR's contact.
inline void require_contact(const PowderRequest& r) {
  if (!r.is_elastic()) {
    require(r.soft_young == 0.0, "Young's modulus of the run", r.soft_young,
            "is of --contact hertz and jkr: give --stiffness");
    return;
  }
  require(r.stiffness == 0.0, "stiffness K", r.stiffness,
          "is of linear springs: with --contact " + r.contact + " give --young and --soft-young");
  require(r.soft_young <= r.elastic.young, "Young's modulus of the run", r.soft_young,
          "must not be above that of the material, --young");
  require(r.law == "hamaker", "square well", r.well_ratio,
          "stands for the cohesion of --contact linear alone");
  if (!r.is_jkr()) return;
  require(r.surface_energy > 0.0, "surface energy", r.surface_energy,
          "--contact jkr takes its cohesion from --surface-energy");
  require(asperity_of(r).radius == 0.0, "asperity radius", asperity_of(r).radius,
          "JKR's contact is of smooth spheres: take --contact hertz");
}

/// Throws InvalidParameter for what would have no effect, and where what belongs together is not.
inline void require_together(const PowderRequest& r) {
  require(r.shares.empty() || r.percentiles.empty(), "mass share",
          r.shares.empty() ? 0.0 : r.shares.front(),
          "percentiles have their own: leave --mass-share out, or give --diameter");
  const bool area = r.width > 0.0 || r.column > 0.0;
  require(area == (r.height > 0.0), "height of the bed", r.height,
          "a bed takes --height and either --width and --depth or --column");
  if (r.is_packing() && !r.folder.empty()) {
    throw InvalidParameter(
        "--use packing: --write writes a fluidised bed: leave --use packing out");
  }
  require(!r.measure || r.engine == "lammps", "measurement", 1.0,
          "--measure runs LAMMPS: leave --engine out");
  const bool well = r.law == "square_well";
  require(well || r.well_ratio == 0.0, "ratio r_out/r of the well", r.well_ratio,
          "add --law square_well, or leave --well-ratio out");
  require(!well || r.hamaker > 0.0 || r.surface_energy > 0.0, "Hamaker constant", r.hamaker,
          "a square well stands for a cohesion: give --hamaker or --surface-energy");
  require(!well || r.keep == "velocity", "pull-off force", 0.0,
          "a square well has none to keep: leave --keep out");
  require_contact(r);
  const double asperity = asperity_of(r).radius;
  require(asperity == 0.0 || well || r.keep == "force" || r.elastic.young == 0.0, "asperity radius",
          asperity,
          "the adhesion of rough grains is not scaled to soft springs: add --keep force, or give "
          "--stiffness in place of --young");
}

}  // namespace cohesion::tools
