// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include "advice/stiffness_scaling.h"
#include "contact/linear_spring_dashpot.h"
#include "hamaker/forms.h"
#include "hamaker/roughness.h"
#include "powder/grain_contact.h"
#include "sphere.h"

namespace cohesion::tools {

/// How the engines' scripts name the contacts of spheres of some sizes. SI units.
struct PowderContacts {
  std::vector<double> diameters;  ///< of atom types 1, 2, ..
  double density;
  double stiffness, restitution, friction;
  hamaker::Parameters hamaker;
  advice::Material material;  ///< that the springs stand for

  /// Whether the attraction is that of a stiffer material: else material_stiffness changes nothing.
  bool tells_material() const {
    return material.stiffness != stiffness && hamaker.hamaker_constant > 0.0;
  }

  /// Words of LAMMPS' pair_coeff and walls of gran/hamaker.
  std::string lammps() const {
    std::string words =
        text("stiffness %.6g restitution %.6g friction %.6g", stiffness, restitution, friction) +
        text(" hamaker %.6g cutoff %.6g %.6g", hamaker.hamaker_constant, hamaker.surface_cutoff,
             hamaker.outer_cutoff);
    if (hamaker.asperity_height > 0.0) {
      const hamaker::Roughness r = hamaker::roughness_of(hamaker);
      words += text(" roughness %.6g %.6g", r.rms, r.wavelength);
    } else if (hamaker.asperity_radius > 0.0) {
      words += text(" asperity %.6g", hamaker.asperity_radius);
    }
    if (tells_material())
      words += text(" material_stiffness %.6g material_keep ", material.stiffness) + kept();
    return words;
  }

  /// LIGGGHTS' properties, a fix each; the last type is that of the walls. Its dashpot is of the
  /// mass of a pair and its attraction has no asperities: each two types have the A of their
  /// pull-off force.
  std::vector<std::string> liggghts() const {
    using contact::LinearSpringDashpot;
    const auto dashpot = [&](double mass) {
      return LinearSpringDashpot::from_restitution(stiffness, restitution, mass).damping();
    };
    std::vector<std::string> lines{
        matrix("kn", [&](const Pair&) { return stiffness; }),
        matrix("kt", [&](const Pair&) { return tangential * stiffness; }),
        matrix("gamman_abs", [&](const Pair& p) { return dashpot(p.mass); }),
        matrix("gammat_abs", [&](const Pair& p) { return 0.5 * dashpot(p.mass); }),
        matrix("coefficientFriction", [&](const Pair&) { return friction; })};
    if (hamaker.hamaker_constant == 0.0) return lines;
    lines.push_back(
        matrix("hamakerConstant", [&](const Pair& p) { return smooth_constant(p.geometry); }));
    lines.push_back(scalar("hamakerSurfaceCutoff", hamaker.surface_cutoff));
    lines.push_back(scalar("hamakerOuterCutoff", hamaker.outer_cutoff));
    if (tells_material())
      lines.push_back(matrix("materialStiffness", [&](const Pair&) { return material.stiffness; }));
    return lines;
  }

  /// The models that go with these properties, and their keywords.
  std::string liggghts_model() const {
    const std::string engine = "model hooke/stiffness tangential history";
    return hamaker.hamaker_constant == 0.0 ? engine : engine + " cohesion hamaker";
  }
  std::string liggghts_keywords() const {
    std::string words = "absolute_damping on tangential_damping on";
    if (hamaker.hamaker_constant == 0.0) return words;
    words += " scheme event";
    if (tells_material()) words += " material_stiffness on material_keep " + kept();
    return words;
  }

 private:
  static constexpr double tangential = 2.0 / 7.0;  // over K, as gran/hamaker has it

  /// Two types, of which the second may be the wall's.
  struct Pair {
    PairGeometry geometry;
    double mass;  // reduced
  };

  template <class... Values>
  static std::string text(const char* format, Values... values) {
    char line[200];
    std::snprintf(line, sizeof line, format, values...);
    return line;
  }

  std::string kept() const {
    for (const advice::KeepName& k : advice::keeps)
      if (k.keep == material.keep) return k.name;
    return "";
  }

  /// A of smooth surfaces whose pull-off force is that of the attraction.
  double smooth_constant(const PairGeometry& g) const {
    if (hamaker.asperity_radius == 0.0) return hamaker.hamaker_constant;
    const double force = std::visit([&](const auto& law) { return law.adhesion_force(g); },
                                    hamaker::forms.front().law(hamaker, true));
    return powder::hamaker_of_pull_off(force, g.reduced_radius, hamaker.surface_cutoff);
  }

  Pair pair(std::size_t i, std::size_t j) const {
    const std::size_t wall = diameters.size();
    const double r = 0.5 * diameters[std::min(i, j)], m = density * sphere_volume(r);
    // Of two walls, which have no contact, as of the last size with one.
    if (std::max(i, j) == wall) return {sphere_and_plane(r), m};
    const double other = 0.5 * diameters[std::max(i, j)];
    return {two_spheres(r, other), reduced_mass(m, density * sphere_volume(other))};
  }

  template <class Value>
  std::string matrix(const char* name, const Value& value) const {
    const std::size_t types = diameters.size() + 1;
    std::string line = "fix " + std::string(name) + " all property/global " + name +
                       " peratomtypepair " + std::to_string(types);
    for (std::size_t i = 0; i < types; i++)
      for (std::size_t j = 0; j < types; j++)
        line += text(" %.6g", value(pair(std::min({i, j, types - 2}), std::max(i, j))));
    return line;
  }

  static std::string scalar(const char* name, double value) {
    return "fix " + std::string(name) + " all property/global " + name +
           text(" scalar %.6g", value);
  }
};

}  // namespace cohesion::tools
