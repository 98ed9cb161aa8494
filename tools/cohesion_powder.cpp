// SPDX-License-Identifier: BSD-3-Clause
// cohesion-powder: from the data of a powder to the parameters of a run.
// Manual: docs/tools/cohesion-powder.md

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "bed/geldart.h"
#include "cohesion_version.h"
#include "command_line.h"
#include "drag/drag_closure.h"
#include "engine_cost.h"
#include "powder/fluidisation.h"
#include "powder/grain_contact.h"
#include "powder_case.h"
#include "powder_contacts.h"
#include "powder_numbers.h"
#include "powder_request.h"
#include "powder_units.h"
#include "powder_vessel.h"
#include "printed_lines.h"

namespace {

using namespace cohesion;
using namespace cohesion::powder;
using tools::Lines;
using tools::Powder;
using tools::PowderRequest;

void print_powder(const Lines& print, const PowderRequest& r, const Powder& p) {
  print.heading("Powder and gas");
  print({"gas_density", "density of the gas", r.gas.density, "kg/m3"});
  print({"gas_viscosity", "viscosity of the gas", r.gas.viscosity, "Pa s"});
  print({"sauter_mean", "Sauter mean diameter", p.mean.diameter, "m"});
  if (p.sizes.largest() > p.sizes.smallest())
    print({"size_ratio", "largest over smallest diameter", p.sizes.largest() / p.sizes.smallest(),
           "1"});
  print({"archimedes", "Archimedes number", archimedes(p.mean, r.gas, r.gravity), "1"});
  const char group[] = {
      static_cast<char>(bed::geldart_group(r.density - r.gas.density, p.mean.diameter)), 0};
  print.note("Geldart's group (ambient air, not cohesive)     " + std::string(group));
  print({"terminal_speed", "terminal speed of the mean sphere",
         terminal_speed(p.mean, r.gas, r.gravity), "m/s"});
  print.heading("Minimum fluidisation, superficial");
  for (const drag::Closure& closure : drag::closures)
    print({"u_mf_" + std::string(closure.name),
           std::string(closure.name) + " at the void fraction given", p.fluidisation(closure),
           "m/s"});
  print({"u_mf_wen_yu", "Wen and Yu's correlation",
         wen_yu_minimum_fluidisation(p.mean, r.gas, r.gravity), "m/s"});
}

void print_adhesion(const Lines& print, const Powder& p) {
  print.heading("Cohesion, two of the smallest grains");
  if (p.contacts().is_jkr())
    print({"work_of_adhesion", "work of adhesion of two surfaces",
           p.elastic->material.contact().work_of_adhesion, "J/m2"});
  else
    print({"hamaker", "Hamaker constant A", p.hamaker.hamaker_constant, "J"});
  print({"pull_off", "pull-off force F_ad", p.adhesion.force, "N"});
  print({"bond", "Bond number F_ad/(m g)", p.adhesion.force / p.weight(p.sizes.smallest()), "1"});
  if (p.sizes.largest() > p.sizes.smallest())
    print({"bond_largest", "of two of the largest",
           p.adhesion_at(p.sizes.largest()).force / p.weight(p.sizes.largest()), "1"});
}

/// Of the well in place of the attraction.
void print_well(const Lines& print, const PowderRequest& r, const Powder& p) {
  const double smallest = p.sizes.smallest(), depth = p.well_depth(smallest);
  const double width = square_well::width(square_well::well(depth, well_ratio_of(r)),
                                          0.5 * smallest, 0.5 * smallest);
  print({"well_depth", "depth of the square well", depth, "J"});
  if (p.sizes.largest() > smallest)
    print({"well_depth_largest", "of two of the largest", p.well_depth(p.sizes.largest()), "J"});
  print({"well_depth_wall", "of the smallest at a wall", p.well_depth_at_wall(smallest), "J"});
  print({"well_width", "width of the well", width, "m"});
  const double weight = p.weight(smallest), bond = pull_over_force(depth, width, weight);
  print({"well_bond", "depth over width and weight", bond, "1"});
  print(
      {"well_width_bond", "width at which that is the Bond number", depth / p.adhesion.force, "m"});
  if (bond < 1.0 && p.adhesion.force > weight)
    std::cerr
        << "cohesion-powder: wells as wide as these hold pairs up to the escape velocity, but "
           "not against a weight (depth over width and weight "
        << bond << ", Bond number " << p.adhesion.force / weight
        << "): where grains hang on each other take a narrower --well-ratio, or --law "
           "hamaker\n";
}

/// Of Hertz's and JKR's contact.
void print_elastic(const Lines& print, const PowderRequest& r, const Powder& p) {
  const ElasticContacts& c = *p.elastic;
  const double tabor = p.tabor(), d = p.sizes.smallest();
  if (tabor > 0.0) print({"tabor", "Tabor's parameter of the material", tabor, "1"});
  print({"material_modulus", "Young's modulus of the material", r.elastic.young, "Pa"});
  print(
      {"material_escape", "escape velocity of the material", c.material.escape_velocity(), "m/s"});
  print({"modulus", "Young's modulus of the run", c.young, "Pa"});
  print({"contact_time", "contact time of the run", c.used.contact_time(p.speed), "s"});
  print({"impact_overlap", "overlap of an impact over the diameter",
         c.used.largest_overlap(p.speed) / d, "1"});
  print(
      {"escape_over_material", "escape velocity over the material's", c.over.escape_velocity, "1"});
  print({"pull_off_over_material", "pull-off force over the material's", c.over.force, "1"});
  if (r.is_jkr() && tabor < 0.1)
    std::cerr << "cohesion-powder: Tabor's parameter is " << tabor << ", and JKR's contact is of "
              << "soft, large and sticky grains (above 5): take --contact hertz\n";
  if (!r.is_jkr() && tabor > 5.0 && p.hamaker.asperity_radius == 0.0)
    std::cerr << "cohesion-powder: Tabor's parameter is " << tabor << ", and an attraction around "
              << "Hertz's contact is of hard, small grains (below 0.1): take --contact jkr with "
              << "--surface-energy\n";
}

/// Where the material itself is pressed more than the overlap that is asked for.
void print_soft_material(const PowderRequest& r, const Powder& p) {
  if (r.stiffness > 0.0 || p.impact_overlap() <= 1.01 * r.overlap) return;
  std::cerr << "cohesion-powder: impacts of " << p.speed
            << " m/s press grains of this Young's modulus by " << 100.0 * p.impact_overlap()
            << " % of the diameter, and their springs too: the engine warns above 1 %. Give the "
            << "Young's modulus of the material, or the --speed of impacts in the run\n";
}

void print_contact(const Lines& print, const PowderRequest& r, const Powder& p) {
  const Springs& s = p.springs;
  print.heading("Contact of two of the smallest grains");
  print({"impact_speed", "speed of impacts", p.speed, "m/s"});
  if (r.elastic.young > 0.0)
    print({"hertz_time", "contact time, Hertz",
           hertz_contact_time(r.elastic, p.sizes.smallest(), p.mass(p.sizes.smallest()), p.speed),
           "s"});
  if (p.elastic) return print_elastic(print, r, p);
  print_soft_material(r, p);
  print({"material_stiffness", "stiffness of the material, linear", s.material.stiffness, "N/m"});
  print({"material_escape", "escape velocity of the material", s.material.escape_velocity, "m/s"});
  print({"stiffness", "stiffness of the springs", s.used.stiffness, "N/m"});
  print({"contact_time", "contact time of the springs", s.used.contact_time, "s"});
  print(
      {"escape_over_material", "escape velocity over the material's", s.over.escape_velocity, "1"});
  print({"pull_off_over_material", "pull-off force over the material's", s.over.force, "1"});
  if (well_ratio_of(r) > 0.0) print_well(print, r, p);
}

tools::PowderVessel::Section section_of(const PowderRequest& r) {
  return {r.width, r.depth, r.column};
}

Bed bed_of(const PowderRequest& r) { return {section_of(r).area(), r.height, r.void_fraction}; }

void print_plan(const Lines& print, const PowderRequest& r, const Powder& p) {
  print.heading("Run, " + r.engine);
  const bool coarse = p.parcels.ratio() > 1.0;
  if (coarse) {
    print(
        {"coarse_graining", "spheres computed, over the grains' diameter", p.parcels.ratio(), "1"});
    print({"bond_computed", "their Bond number, of the smallest",
           p.adhesion.force / p.weight(p.sizes.smallest()) / p.parcels.ratio(), "1"});
  }
  char step[80];
  const double contact_time = p.parcels.time(p.elastic ? p.elastic->used.contact_time(p.speed)
                                                       : p.springs.used.contact_time);
  std::snprintf(step, sizeof step, "particle step, t_c/%.3g, scheme exact",
                contact_time / p.steps.particle);
  print({"particle_step", step, p.steps.particle, "s"});
  if (p.elastic)
    print({"fastest", "fastest sphere that this step allows", advice::fastest_over_impact * p.speed,
           "m/s"});
  print({"cell", "edge of the cells", p.cell, "m"});
  print({"gas_step", "gas step, a whole number of these", p.steps.gas, "s"});
  print({"gas_velocity", "superficial gas velocity, twice u_mf by " + r.drag, p.velocity, "m/s"});
  print({"steps_per_second", "particle steps in a second", 1.0 / p.steps.particle, "1"});
  if (r.height == 0.0) return;
  const Bed bed = bed_of(r);
  const double grains = number_of_grains(bed, p.sizes);
  print({"grains", "grains of the bed", grains, "1"});
  if (coarse) print({"spheres", "spheres computed of the bed", p.parcels.number(grains), "1"});
  const double across = r.column > 0.0 ? r.column : std::min(r.width, r.depth);
  const double parcels_across = across / p.parcels.length(p.mean.diameter);
  if (coarse && parcels_across < Parcels::narrowest_vessel)
    std::cerr
        << "cohesion-powder: the bed is " << parcels_across << " parcels across; with fewer than "
        << Parcels::narrowest_vessel
        << " it was found looser than one of grains, most likely for its walls, and its minimum "
        << "fluidisation more than a tenth too high: take a smaller --coarse-graining\n";
  print({"mass", "mass of the bed", mass_of(bed, r.density), "kg"});
  print({"pressure_drop", "pressure drop, fluidised",
         pressure_of(bed.height, bed.void_fraction, (r.density - r.gas.density) * r.gravity),
         "Pa"});
}

/// Lines that define the contacts, for the engine of the run.
std::vector<std::string> script_lines(const PowderRequest& r, const Powder& p) {
  const tools::PowderContacts contacts = p.contacts();
  if (r.engine == "lammps") {
    std::vector<std::string> lines = contacts.lammps_pairs();
    lines.insert(lines.begin(), "pair_style " + contacts.lammps_style() + " scheme exact");
    return lines;
  }
  std::vector<std::string> lines = contacts.liggghts();
  lines.push_back("pair_style gran " + contacts.liggghts_model() + " " +
                  contacts.liggghts_keywords());
  lines.push_back("pair_coeff * *");
  return lines;
}

void print_script(const Lines& print, const PowderRequest& r, const Powder& p) {
  print.heading("In a script, " + r.engine);
  for (const std::string& line : script_lines(r, p)) print.note(line);
  if (r.engine == "lammps" && (r.is_packing() || well_ratio_of(r) > 0.0))
    for (const auto& wall : p.contacts().lammps_walls())
      print.note("# walls, " + wall.group + ": " + wall.contact);
  char text[80];
  std::snprintf(text, sizeof text, "timestep %.6g", p.steps.particle);
  print.note(text);
}

/// What a second of the bed takes, from a short run of LAMMPS.
void print_cost(const Lines& print, const PowderRequest& r, const Powder& p) {
  const tools::PowderContacts contacts = p.contacts();
  const std::string lines = "pair_style " + contacts.lammps_style() + " scheme exact\n" +
                            contacts.lammps_for_all() + "\n";
  tools::EngineCost engine(r.lammps, r.plugin);
  const auto cost =
      engine.seconds(p.parcels.length(p.mean.diameter), r.density, lines, p.steps.particle);
  print.heading("On this machine, the particles alone, one process");
  if (!cost) {
    std::cerr << "cohesion-powder: '" << r.lammps << "' did not run, so that nothing is measured; "
              << "name LAMMPS by --lammps and the plugin by --plugin. It said:\n"
              << engine.said();
    return;
  }
  print({"seconds_per_grain_step", "per sphere and step, in a packing", *cost, "s"});
  if (r.height == 0.0) return;
  const double spheres = p.parcels.number(number_of_grains(bed_of(r), p.sizes));
  print({"hours_per_second", "for a second of the bed", *cost * spheres / p.steps.particle / 3600.0,
         "h"});
}

/// The vessel of `computed` that holds no more than so many, or the smallest.
tools::PowderVessel vessel_of(const PowderRequest& r, const Powder& p, const PowderSizes& computed,
                              double most) {
  return {computed, section_of(r), r.height, r.void_fraction,
          p.cell,   most,          r.seed,   std::max(1.0, well_ratio_of(r))};
}

/// Says which number would do where the smallest vessel holds more: the bed of more grains is
/// higher, too.
void require_enough_grains(const PowderRequest& r, const Powder& p, const PowderSizes& computed) {
  int enough = vessel_of(r, p, computed, r.grains).grains();
  if (enough <= r.grains) return;
  for (int n = 0; (n = vessel_of(r, p, computed, enough).grains()) > enough;) enough = n;
  const int across = section_of(r).is_round() ? tools::PowderVessel::least_across_column
                                              : tools::PowderVessel::least_across;
  require(false, "--grains", r.grains,
          "the smallest vessel of this shape, " + std::to_string(across) + " cells across, has " +
              std::to_string(enough) + ": give that or more, or a lower bed");
}

/// Says how long a long run will take, its particles alone.
void print_run_time(const tools::PowderCase& written, const tools::PowderVessel& vessel) {
  // Of pairs in contact, docs/verification/feature_costs.md, and of a step of hardly any
  constexpr double per_sphere = 2e-7, per_step = 1e-5, long_run = 600.0;
  const double steps = written.particle_steps(vessel);
  const double seconds = steps * std::max(per_step, per_sphere * vessel.grains());
  if (seconds < long_run) return;
  std::fprintf(
      stderr,
      "cohesion-powder: the run has %.2g particle steps of %.2g s: about %.2g h for the "
      "particles, on one process; a larger --overlap, a smaller --speed, fewer --grains or "
      "a shorter endTime in system/controlDict shorten it\n",
      steps, written.steps.particle, seconds / 3600.0);
}

void write_case(const PowderRequest& r, const Powder& p) {
  const PowderSizes computed = p.computed();
  require_enough_grains(r, p, computed);
  const tools::PowderVessel vessel = vessel_of(r, p, computed, r.grains);
  const tools::PowderCase written{r.engine == "liggghts",
                                  computed,
                                  p.parcels.ratio(),
                                  p.contacts(),
                                  p.steps,
                                  r.gas,
                                  r.gravity,
                                  r.drag,
                                  p.velocity,
                                  p.speed};
  written.write(r.folder, vessel);
  std::fprintf(
      stderr,
      "cohesion-powder: wrote a case to %s for %s: a %s of %.3g x %.3g x %.3g m with %d spheres, "
      "the bed has %.4g grains, %.3g m/s of gas; to run it: %s/Allrun\n",
      r.folder.c_str(), r.engine == "liggghts" ? "LIGGGHTS" : "LAMMPS",
      vessel.is_round() ? "column" : "box", vessel.edge(0), vessel.edge(1), vessel.edge(2),
      vessel.grains(), number_of_grains(bed_of(r), p.sizes), p.velocity, r.folder.c_str());
  print_run_time(written, vessel);
}

void print_all(PowderRequest& request) {
  tools::require_si(request);
  tools::require_together(request);
  request.gas = tools::gas_of(request);
  const Powder powder(request);
  const Lines print(request.csv);
  print_powder(print, request, powder);
  print_adhesion(print, powder);
  print_contact(print, request, powder);
  print_plan(print, request, powder);
  print_script(print, request, powder);
  if (request.measure) print_cost(print, request, powder);
  if (!request.folder.empty()) write_case(request, powder);
}

}  // namespace

int main(int argc, char** argv) {
  PowderRequest request;
  CLI::App app{
      "From the data of a powder to the parameters of a run. SI units.\n"
      "Manual: docs/tools/cohesion-powder.md"};
  app.set_version_flag("--version", "cohesion-powder, Cohesion " COHESION_VERSION);
  tools::add_options(app, request);
  try {
    app.parse(argc, argv);
    tools::reject_repeated_options(app, argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }

  return tools::exit_code_of("cohesion-powder", [&] { print_all(request); });
}
