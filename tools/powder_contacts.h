// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "contact/linear_spring_dashpot.h"
#include "contact/stiffness_scaling.h"
#include "hamaker/forms.h"
#include "hamaker/roughness.h"
#include "powder/grain_contact.h"
#include "powder/wells.h"
#include "script_text.h"
#include "sphere.h"

namespace cohesion::tools {

/// Hertz's or JKR's contact in place of linear springs. SI units.
struct ElasticWords {
  double young = 0.0, poisson = 0.0;  ///< of the run; E 0: springs are linear
  double of_material = 0.0;           ///< E that it stands for
  double surface_energy = 0.0;        ///< of JKR's contact; 0: Hertz's
};

/// How the engines' scripts name the contacts of spheres of some sizes. SI units.
struct PowderContacts {
  std::vector<double> diameters;  ///< of atom types 1, 2, ..
  double density;
  double stiffness, restitution, friction;
  hamaker::HamakerParameters hamaker;
  contact::Material material;  ///< that the springs stand for
  /// Its stiffness between types i and j, at [i * number of types + j]; empty: as of `material`.
  std::vector<double> material_of_pairs{};
  double well_ratio = 0.0;  ///< r_out/r of wells in place of the attraction; 0: no wells
  ElasticWords elastic{};   ///< in place of `stiffness` and that of `material`

  bool has_wells() const { return well_ratio > 0.0; }
  bool is_elastic() const { return elastic.young > 0.0; }
  bool is_jkr() const { return elastic.surface_energy > 0.0; }

  /// Whether the attraction is that of a stiffer material: else material_stiffness changes nothing.
  bool tells_material() const {
    if (is_elastic())
      return elastic.of_material != elastic.young && (hamaker.hamaker_constant > 0.0 || is_jkr());
    const auto is_stiffer = [&](double of_material) { return of_material != stiffness; };
    return !has_wells() && hamaker.hamaker_constant > 0.0 &&
           (is_stiffer(material.stiffness) ||
            std::any_of(material_of_pairs.begin(), material_of_pairs.end(), is_stiffer));
  }

  /// LAMMPS' pair_style, and its pair_coeffs: one for all types, or one for each two where each two
  /// have a well or a stiffness of the material of their own. lammps_for_all(): that of the first
  /// for all.
  std::string lammps_style() const {
    return has_wells() ? "gran/squarewell" : is_jkr() ? "gran/jkr" : "gran/hamaker";
  }
  std::string lammps_for_all() const {
    return "pair_coeff * * " + (has_wells() ? lammps_well(pair(0, 0)) : lammps());
  }
  std::vector<std::string> lammps_pairs() const {
    const bool own_material = tells_material() && !material_of_pairs.empty();
    if ((!has_wells() && !own_material) || diameters.size() == 1) return {lammps_for_all()};
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < diameters.size(); i++)
      for (std::size_t j = i; j < diameters.size(); j++)
        lines.push_back("pair_coeff " + std::to_string(i + 1) + ' ' + std::to_string(j + 1) + ' ' +
                        (has_wells() ? lammps_well(pair(i, j)) : lammps(pair(i, j).material)));
    return lines;
  }

  /// Particles that walls have the same contact with, and its words.
  struct LammpsWall {
    std::string group;     // of the script's, `all` too
    std::string of_group;  // the line that makes it; empty: it is there
    std::string contact;
  };
  std::vector<LammpsWall> lammps_walls() const {
    if (!has_wells()) return {{"all", "", lammps()}};
    const std::size_t wall = diameters.size();
    if (wall == 1) return {{"all", "", lammps_well(pair(0, wall))}};
    std::vector<LammpsWall> walls;
    for (std::size_t i = 0; i < wall; i++) {
      const std::string type = std::to_string(i + 1), name = "size_" + type;
      walls.push_back({name, "group " + name + " type " + type, lammps_well(pair(i, wall))});
    }
    return walls;
  }

  /// Words of LAMMPS' pair_coeff and walls of gran/hamaker and gran/jkr.
  std::string lammps() const { return lammps(material.stiffness); }
  /// The same with another stiffness of the material, of linear springs.
  std::string lammps(double of_material) const {
    if (is_jkr())
      return lammps_contact() + text(" surface_energy %.6g", elastic.surface_energy) +
             lammps_material(of_material);
    std::string words =
        lammps_contact() + text(" hamaker %.6g cutoff %.6g %.6g", hamaker.hamaker_constant,
                                hamaker.surface_cutoff, hamaker.outer_cutoff);
    if (hamaker.asperity_height > 0.0) {
      const hamaker::Roughness r = hamaker::roughness_of(hamaker);
      words += text(" roughness %.6g %.6g", r.rms, r.wavelength);
    } else if (hamaker.asperity_radius > 0.0) {
      words += text(" asperity %.6g", hamaker.asperity_radius);
    }
    return words + lammps_material(of_material);
  }

  /// LIGGGHTS' properties, a fix each; the last type is that of the walls. Its dashpot is of the
  /// mass of a pair and its attraction has no asperities: each two types have the A of their
  /// pull-off force.
  std::vector<std::string> liggghts() const {
    using contact::LinearSpringDashpot;
    const auto dashpot = [&](double mass) {
      return LinearSpringDashpot::from_restitution(stiffness, restitution, mass).damping();
    };
    if (is_elastic()) return liggghts_hertz();
    std::vector<std::string> lines{
        matrix("kn", [&](const TypePair&) { return stiffness; }),
        matrix("kt", [&](const TypePair&) { return tangential * stiffness; }),
        matrix("gamman_abs", [&](const TypePair& p) { return dashpot(p.mass); }),
        matrix("gammat_abs", [&](const TypePair& p) { return 0.5 * dashpot(p.mass); }),
        matrix("coefficientFriction", [&](const TypePair&) { return friction; })};
    if (hamaker.hamaker_constant == 0.0) return lines;
    if (has_wells()) {
      lines.push_back(matrix("wellDepth", [&](const TypePair& p) { return depth(p); }));
      lines.push_back(type_line("wellRatio", well_ratio, 1.0));  // a wall's is not used
      return lines;
    }
    append_liggghts_attraction(lines);
    if (tells_material())
      lines.push_back(matrix("materialStiffness", [&](const TypePair& p) { return p.material; }));
    return lines;
  }

  /// The models that go with these properties, and their keywords.
  std::string liggghts_model() const {
    const std::string engine = std::string("model ") +
                               (is_elastic() ? "hertz" : "hooke/stiffness") + " tangential history";
    if (is_jkr()) return engine + " cohesion jkr";
    if (hamaker.hamaker_constant == 0.0) return engine;
    return engine + " cohesion " + (has_wells() ? "square_well" : "hamaker");
  }
  std::string liggghts_keywords() const {
    std::string words =
        is_elastic() ? "tangential_damping on" : "absolute_damping on tangential_damping on";
    if (tells_material())
      words += (is_elastic() ? " material_modulus on material_keep "
                             : " material_stiffness on material_keep ") +
               kept();
    return words;
  }

 private:
  static constexpr double tangential = 2.0 / 7.0;  // over K, as gran/hamaker has it

  /// Two types, of which the second may be the wall's.
  struct TypePair {
    PairGeometry geometry;
    double mass;      // reduced
    double material;  // stiffness that the springs stand for
  };

  std::string kept() const {
    for (const contact::KeepName& k : contact::keeps)
      if (k.keep == material.keep) return k.name;
    return "";
  }

  std::string lammps_contact() const {
    if (is_elastic())
      return text("normal hertz %.6g %.6g restitution %.6g friction %.6g", elastic.young,
                  elastic.poisson, restitution, friction);
    return text("stiffness %.6g restitution %.6g friction %.6g", stiffness, restitution, friction);
  }
  std::string lammps_material(double of_material) const {
    if (!tells_material()) return "";
    return (is_elastic() ? text(" material_modulus %.6g %.6g", elastic.of_material, elastic.poisson)
                         : text(" material_stiffness %.6g", of_material)) +
           " material_keep " + kept();
  }
  std::string lammps_well(const TypePair& p) const {
    return lammps_contact() + text(" well %.6g %.12g", depth(p), well_ratio);
  }

  /// D of the well that holds the two up to the escape velocity of their material.
  double depth(const TypePair& p) const {
    const auto attraction = hamaker::forms.front().law(hamaker, hamaker.asperity_radius > 0.0);
    return powder::well_depth(
        material.stiffness, restitution, p.mass,
        std::visit([&](const auto& law) { return contact::adhesion_of(law, p.geometry); },
                   attraction));
  }

  /// Of model hertz.
  std::vector<std::string> liggghts_hertz() const {
    std::vector<std::string> lines;
    // Outside of what the engine takes for plausible.
    if (elastic.young < 5e6) lines.push_back("soft_particles yes");
    if (elastic.young > 1e9) lines.push_back("hard_particles yes");
    const std::vector<std::string> properties{
        type_line("youngsModulus", elastic.young, elastic.young),
        type_line("poissonsRatio", elastic.poisson, elastic.poisson),
        matrix("coefficientRestitution", [&](const TypePair&) { return restitution; }),
        matrix("coefficientFriction", [&](const TypePair&) { return friction; })};
    lines.insert(lines.end(), properties.begin(), properties.end());
    if (is_jkr())
      lines.push_back(
          matrix("surfaceEnergy", [&](const TypePair&) { return elastic.surface_energy; }));
    else if (hamaker.hamaker_constant > 0.0)
      append_liggghts_attraction(lines);
    if (tells_material())
      lines.push_back(type_line("materialYoungsModulus", elastic.of_material, elastic.of_material));
    return lines;
  }

  void append_liggghts_attraction(std::vector<std::string>& lines) const {
    lines.push_back(matrix("hamakerConstant", [&](const TypePair& p) {
      return smooth_constant(hamaker, p.geometry);
    }));
    lines.push_back(scalar("hamakerSurfaceCutoff", hamaker.surface_cutoff));
    lines.push_back(scalar("hamakerOuterCutoff", hamaker.outer_cutoff));
  }

  /// A of smooth surfaces whose pull-off force is that of the attraction.
  static double smooth_constant(const hamaker::HamakerParameters& hamaker, const PairGeometry& g) {
    if (hamaker.asperity_radius == 0.0) return hamaker.hamaker_constant;
    const double force = std::visit([&](const auto& law) { return law.adhesion_force(g); },
                                    hamaker::forms.front().law(hamaker, true));
    return powder::hamaker_of_pull_off(force, g.reduced_radius, hamaker.surface_cutoff);
  }

  TypePair pair(std::size_t i, std::size_t j) const {
    const std::size_t wall = diameters.size();
    const double r = 0.5 * diameters[std::min(i, j)], m = density * sphere_volume(r);
    // Of two walls, which have no contact, as of the last size with one.
    if (std::max(i, j) == wall) return {sphere_and_plane(r), m, material.stiffness};
    const double other = 0.5 * diameters[std::max(i, j)];
    return {two_spheres(r, other), reduced_mass(m, density * sphere_volume(other)),
            material_of_pairs.empty() ? material.stiffness : material_of_pairs[i * wall + j]};
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

  /// A property of each type, and of the walls.
  std::string type_line(const char* name, double value, double of_wall) const {
    std::string line = "fix " + std::string(name) + " all property/global " + name + " peratomtype";
    for (std::size_t i = 0; i < diameters.size(); i++) line += text(" %.12g", value);
    return line + text(" %.12g", of_wall);
  }

  static std::string scalar(const char* name, double value) {
    return "fix " + std::string(name) + " all property/global " + name +
           text(" scalar %.6g", value);
  }
};

}  // namespace cohesion::tools
