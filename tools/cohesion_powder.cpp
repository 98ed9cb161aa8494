// SPDX-License-Identifier: BSD-3-Clause
// cohesion-powder: from the data of a powder to the parameters of a run.
// Manual: docs/tools/cohesion-powder.md

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "bed/geldart.h"
#include "cohesion_version.h"
#include "drag/drag_closure.h"
#include "engine_cost.h"
#include "hamaker/range_of_validity.h"
#include "powder/fluidisation.h"
#include "powder/grain_contact.h"
#include "powder/plan.h"
#include "powder/sizes.h"
#include "powder_case.h"
#include "powder_request.h"

namespace {

using namespace cohesion;
using namespace cohesion::powder;
using tools::Request;

/// A line of what is printed.
struct Line {
  std::string name;  // of the value in --csv
  std::string text;
  double value;
  const char* unit;
};

class Lines {
 public:
  explicit Lines(bool csv) : csv_(csv) {
    if (csv_) std::puts("name,value,unit");
  }

  void heading(const char* text) const {
    if (!csv_) std::printf("\n%s\n", text);
  }
  void operator()(const Line& line) const {
    if (csv_)
      std::printf("%s,%.17g,%s\n", line.name.c_str(), line.value, line.unit);
    else
      std::printf("  %-46s %-11.4g %s\n", line.text.c_str(), line.value, line.unit);
  }
  void note(const std::string& text) const {
    if (!csv_) std::printf("  %s\n", text.c_str());
  }

 private:
  bool csv_;
};

Sizes sizes_of(const Request& r) {
  if (!r.percentiles.empty())
    return Sizes::of_percentiles(r.percentiles[0], r.percentiles[1], r.percentiles[2]);
  require(r.shares.empty() || r.shares.size() == r.diameters.size(), "number of mass shares",
          static_cast<double>(r.shares.size()), "give one for each diameter, or none");
  std::vector<Size> sizes;
  for (std::size_t k = 0; k < r.diameters.size(); k++)
    sizes.push_back({r.diameters[k], r.shares.empty() ? 1.0 : r.shares[k]});
  return Sizes(sizes);
}

/// The numbers of a powder that the lines are made of.
class Powder {
 public:
  explicit Powder(const Request& r)
      : sizes(sizes_of(r)), mean{sizes.sauter(), r.density}, request_(r) {
    require_lifted(mean, r.gas, r.gravity);
    require_positive("cut-off H_cut", r.cutoffs.at(0));
    slowest_fluidisation = fastest_fluidisation = fluidisation(drag::closures.front());
    for (const drag::Closure& closure : drag::closures) {
      slowest_fluidisation = std::min(slowest_fluidisation, fluidisation(closure));
      fastest_fluidisation = std::max(fastest_fluidisation, fluidisation(closure));
    }
    speed = r.speed > 0.0 ? r.speed : 2.0 * fastest_fluidisation;
    hamaker_constant = r.surface_energy > 0.0
                           ? hamaker_of_surface_energy(r.surface_energy, r.cutoffs[0])
                           : r.hamaker;
    adhesion = adhesion_at(sizes.smallest());
  }

  double fluidisation(const drag::Closure& closure) const {
    return minimum_fluidisation(closure, request_.void_fraction, mean, request_.gas,
                                request_.gravity);
  }

  double mass(double diameter) const { return request_.density * sphere_volume(0.5 * diameter); }
  double weight(double diameter) const { return mass(diameter) * request_.gravity; }

  /// Of two grains of a diameter, with the asperities of the request.
  contact::Adhesion adhesion_at(double diameter) const {
    const hamaker::Asperity asperity = asperity_of(request_);
    const hamaker::Parameters p{hamaker_constant, request_.cutoffs.at(0), request_.cutoffs.at(1),
                                asperity.radius, asperity.height};
    const hamaker::AnyLaw law = hamaker::forms.front().law(p, asperity.radius > 0.0);
    const PairGeometry geometry = two_spheres(0.5 * diameter, 0.5 * diameter);
    hamaker::require_weakened_by_asperities(hamaker::forms.front(), p, geometry);
    return std::visit([&](const auto& l) { return contact::adhesion_of(l, geometry); }, law);
  }

  Sizes sizes;
  Grain mean;
  double slowest_fluidisation, fastest_fluidisation;  // by the closures
  double speed;                                       // of impacts
  double hamaker_constant;
  contact::Adhesion adhesion;  // of two of the smallest

 private:
  const Request& request_;
};

void print_powder(const Lines& print, const Request& r, const Powder& p) {
  print.heading("Powder and gas");
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
  print({"hamaker", "Hamaker constant A", p.hamaker_constant, "J"});
  print({"pull_off", "pull-off force F_ad", p.adhesion.force, "N"});
  print({"bond", "Bond number F_ad/(m g)", p.adhesion.force / p.weight(p.sizes.smallest()), "1"});
  if (p.sizes.largest() > p.sizes.smallest())
    print({"bond_largest", "of two of the largest",
           p.adhesion_at(p.sizes.largest()).force / p.weight(p.sizes.largest()), "1"});
}

/// The springs of a run.
struct Springs {
  PairNumbers material, used;
  advice::OverMaterial over;
};

/// Of a powder that is given by a stiffness, the springs are the material.
Springs springs_of(const Request& r, const Powder& p) {
  const double d = p.sizes.smallest(), mass = p.mass(d);
  const bool elastic = r.elastic.young > 0.0;
  const double real =
      elastic ? sticking_stiffness(r.elastic, d, mass, r.restitution, p.adhesion, p.speed)
              : r.stiffness;
  double soft = r.stiffness;
  if (soft == 0.0) {
    const double pressure = r.density * (1.0 - r.void_fraction) * r.gravity * r.height;
    const bool scales = r.keep == "velocity";
    soft = softest_stiffness(d, mass, r.restitution, p.adhesion.force, {p.speed, pressure},
                             r.overlap, scales ? real : 0.0);
    // The scaled cut-off has to stay below the outer one.
    const double k = r.cutoffs[0] / r.cutoffs[1];
    if (scales) soft = std::max(soft, 1.1 * real * std::pow(k * (2.0 - k), 2));
    soft = std::min(two_digits_below(1.1 * soft), real);
  }
  const advice::Material material{
      real, r.keep == "force" ? advice::Keep::force : advice::Keep::escape_velocity};
  const bool scaled = advice::is_scaled(material, soft) && p.adhesion.force > 0.0;
  contact::Adhesion used = p.adhesion;
  if (scaled) {
    const advice::StiffnessScaling scaling(real, soft);
    used = scaling.adhesion(p.adhesion);
    // As the engine will: throws where the outer cut-off leaves no room.
    scaling.hamaker({p.hamaker_constant, r.cutoffs[0], r.cutoffs[1]});
  }
  const auto spring =
      contact::LinearSpringDashpot::from_restitution(soft, r.restitution, 0.5 * mass);
  return {pair_numbers(real, r.restitution, mass, p.adhesion),
          pair_numbers(soft, r.restitution, mass, used),
          used.force > 0.0 ? advice::over_material(contact::AdhesiveContact(spring, used), material)
                           : advice::OverMaterial{1.0, 1.0}};
}

void print_contact(const Lines& print, const Request& r, const Powder& p, const Springs& s) {
  print.heading("Contact of two of the smallest grains");
  print({"impact_speed", "speed of impacts", p.speed, "m/s"});
  if (r.elastic.young > 0.0)
    print({"hertz_time", "contact time, Hertz",
           hertz_contact_time(r.elastic, p.sizes.smallest(), p.mass(p.sizes.smallest()), p.speed),
           "s"});
  print({"material_stiffness", "stiffness of the material, linear", s.material.stiffness, "N/m"});
  print({"material_escape", "escape velocity of the material", s.material.escape_velocity, "m/s"});
  print({"stiffness", "stiffness of the springs", s.used.stiffness, "N/m"});
  print({"contact_time", "contact time of the springs", s.used.contact_time, "s"});
  print(
      {"escape_over_material", "escape velocity over the material's", s.over.escape_velocity, "1"});
  print({"pull_off_over_material", "pull-off force over the material's", s.over.force, "1"});
}

/// Area of the bed: of a box or of a round column.
double area_of(const Request& r) {
  return r.column > 0.0 ? 0.25 * pi * r.column * r.column : r.width * r.depth;
}

void print_plan(const Lines& print, const Request& r, const Powder& p, const Springs& s) {
  const double step = particle_step(s.used.contact_time);
  const double cell = cell_over_diameter * p.sizes.largest();
  const double velocity = 2.0 * p.fastest_fluidisation / r.void_fraction;
  const double gas = gas_step(cell, velocity, r.gravity, step);
  print.heading("Run");
  print({"particle_step", "particle step, t_c/8, scheme event", step, "s"});
  print({"cell", "cells, three of the largest diameter", cell, "m"});
  print({"gas_step", "gas step, a whole number of these", gas, "s"});
  print({"steps_per_second", "particle steps in a second", 1.0 / step, "1"});
  if (r.height == 0.0) return;
  const Bed bed{area_of(r), r.height, r.void_fraction};
  print({"grains", "grains of the bed", number_of_grains(bed, p.sizes), "1"});
  print({"mass", "mass of the bed", (1.0 - bed.void_fraction) * bed.area * bed.height * r.density,
         "kg"});
  print({"pressure_drop", "pressure drop, fluidised",
         (1.0 - bed.void_fraction) * (r.density - r.gas.density) * r.gravity * bed.height, "Pa"});
}

/// Words of pair_coeff for gran/hamaker.
std::string contact_words(const Request& r, const Powder& p, const Springs& s) {
  char text[400];
  std::snprintf(text, sizeof text,
                "stiffness %.6g restitution %.6g friction %.6g hamaker %.6g cutoff %.6g %.6g",
                s.used.stiffness, r.restitution, r.friction, p.hamaker_constant, r.cutoffs[0],
                r.cutoffs[1]);
  std::string line(text);
  if (!r.roughness.empty()) {
    std::snprintf(text, sizeof text, " roughness %.6g %.6g", r.roughness[0], r.roughness[1]);
    line += text;
  } else if (r.asperity > 0.0) {
    std::snprintf(text, sizeof text, " asperity %.6g", r.asperity);
    line += text;
  }
  if (s.used.stiffness != s.material.stiffness) {
    std::snprintf(text, sizeof text, " material_stiffness %.6g material_keep %s",
                  s.material.stiffness, r.keep.c_str());
    line += text;
  }
  return line;
}

/// Pair style and coefficients for LAMMPS, each a line.
std::vector<std::string> script_lines(const Request& r, const Powder& p, const Springs& s) {
  return {"pair_style  gran/hamaker scheme event", "pair_coeff  * * " + contact_words(r, p, s)};
}

void print_script(const Lines& print, const Request& r, const Powder& p, const Springs& s) {
  print.heading("In a LAMMPS script");
  for (const std::string& line : script_lines(r, p, s)) print.note(line);
  char text[80];
  std::snprintf(text, sizeof text, "timestep    %.6g", particle_step(s.used.contact_time));
  print.note(text);
}

/// What a second of the bed takes, from a short run of LAMMPS.
void print_cost(const Lines& print, const Request& r, const Powder& p, const Springs& s) {
  const double step = particle_step(s.used.contact_time);
  std::string lines;
  for (const std::string& line : script_lines(r, p, s)) lines += line + "\n";
  tools::EngineCost engine(r.lammps, r.plugin);
  const auto cost = engine.seconds(p.mean.diameter, r.density, lines, step);
  print.heading("On this machine, the particles alone, one process");
  if (!cost) {
    std::cerr << "cohesion-powder: '" << r.lammps << "' did not run, so that nothing is measured; "
              << "name LAMMPS by --lammps and the plugin by --plugin. It said:\n"
              << engine.said();
    return;
  }
  print({"seconds_per_grain_step", "per grain and step, in a packing", *cost, "s"});
  if (r.height > 0.0)
    print(
        {"hours_per_second", "for a second of the bed",
         *cost * number_of_grains({area_of(r), r.height, r.void_fraction}, p.sizes) / step / 3600.0,
         "h"});
}

void write_case(const Request& r, const Powder& p, const Springs& s) {
  const double step = particle_step(s.used.contact_time);
  const double cell = cell_over_diameter * p.sizes.largest();
  const double velocity = 2.0 * p.fastest_fluidisation;
  const tools::PowderCase written{p.sizes,
                                  r.density,
                                  contact_words(r, p, s),
                                  step,
                                  gas_step(cell, velocity / r.void_fraction, r.gravity, step),
                                  cell,
                                  r.gas.density,
                                  r.gas.viscosity,
                                  r.gravity,
                                  velocity};
  const Bed bed{r.width * r.depth, r.height, r.void_fraction};
  const auto box = written.box(r.width, r.depth, bed, r.grains);
  written.write(r.folder, box);
  std::fprintf(
      stderr,
      "cohesion-powder: wrote a case to %s: a box of %.3g x %.3g x %.3g m with %.0f grains "
      "of the %.4g of the bed, %.3g m/s of gas; to run it: %s/Allrun\n",
      r.folder.c_str(), box.edge(0, cell), box.edge(1, cell), box.edge(2, cell), box.grains,
      number_of_grains(bed, p.sizes), velocity, r.folder.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Request request;
  CLI::App app{
      "From the data of a powder to the parameters of a run. SI units.\n"
      "Manual: docs/tools/cohesion-powder.md"};
  app.set_version_flag("--version", "cohesion-powder, Cohesion " COHESION_VERSION);
  tools::add_options(app, request);
  CLI11_PARSE(app, argc, argv);
  try {
    tools::require_together(request);
    const Powder powder(request);
    const Springs springs = springs_of(request, powder);
    const Lines print(request.csv);
    print_powder(print, request, powder);
    print_adhesion(print, powder);
    print_contact(print, request, powder, springs);
    print_plan(print, request, powder, springs);
    print_script(print, request, powder, springs);
    if (request.measure) print_cost(print, request, powder, springs);
    if (!request.folder.empty()) write_case(request, powder, springs);
  } catch (const std::exception& error) {
    std::cerr << "cohesion-powder: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
