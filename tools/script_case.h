// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "advice/si_units.h"
#include "script_reader.h"
#include "script_run.h"
#include "sphere.h"

namespace cohesion::tools {

/// The contact models of a pair_style or wall.
struct GranularModel {
  ScriptCommand where;
  std::string normal, cohesion = "off";

  bool has_on(const std::string& keyword) const {
    const std::size_t at = where.find(keyword);
    return where.has(at + 1) && where.words[at + 1] == "on";
  }
  /// The same for models of the same names and switches.
  std::string words() const {
    std::string all = normal + ' ' + cohesion;
    for (std::size_t k = 1; k < where.words.size(); k++)
      if (where.words[k] == "on" || where.words[k] == "off")
        all += ' ' + where.words[k - 1] + ' ' + where.words[k];
    return all;
  }
};

struct WallOfScript {
  std::string id;
  int type;
  GranularModel model;
};

/// Sphere of one size, in the units of the script.
struct ScriptGrain {
  double radius, density;
  double mass() const { return density * sphere_volume(radius); }
};

/// The smallest grain of an atom type, and the median by mass.
struct Grains {
  ScriptGrain smallest, median;
  ScriptCommand where;
};

/// fix property/global.
class ScriptProperty {
 public:
  explicit ScriptProperty(ScriptCommand where) : where_(std::move(where)) {}

  const ScriptCommand& where() const { return where_; }
  double scalar() const {
    require_kind("scalar", "a value");
    return where_.number(first, name());
  }
  double of_type(int type) const {
    require_kind("atomtype", "a value for each atom type");
    return where_.number(first + static_cast<std::size_t>(type) - 1,
                         name() + " of type " + std::to_string(type));
  }
  double of_pair(int i, int j) const {
    require_kind("atomtypepair", "the number of types and a value for each pair");
    const int types = where_.integer(first, "the number of types");
    if (i > types || j > types)
      where_.fail(name() + " has no value for types " + std::to_string(i) + " and " +
                  std::to_string(j) + ": list the pairs of all types");
    const auto value = [&](int a, int b) {
      return where_.number(first + static_cast<std::size_t>(types * (a - 1) + b),
                           name() + " of types " + std::to_string(a) + " and " + std::to_string(b));
    };
    if (value(i, j) != value(j, i))
      where_.fail(name() + " of types " + std::to_string(i) + " and " + std::to_string(j) +
                  " differs from that of " + std::to_string(j) + " and " + std::to_string(i) +
                  ": list a symmetric matrix");
    return value(i, j);
  }

 private:
  static constexpr std::size_t first = 6;  // word of the first value

  const std::string& name() const { return where_.words[4]; }
  /// LIGGGHTS accepts the kinds with and without "per".
  void require_kind(const std::string& kind, const std::string& values) const {
    const std::string& given = where_.word(5, "its kind");
    const std::string full = kind == "scalar" ? kind : "per" + kind;
    if (given != kind && given != full)
      where_.fail(name() + " is of kind '" + given + "': write '" + full + "' and " + values);
  }

  ScriptCommand where_;
};

/// Contact models, properties and grain sizes of a LIGGGHTS script, in its units.
class ScriptCase {
 public:
  explicit ScriptCase(const std::vector<ScriptCommand>& commands) {
    for (const ScriptCommand& command : commands) read(command);
    note_second_mesh_wall();
    for (const ScriptCommand& command : set_commands_) read_set(command);
    for (const int type : template_types()) grains_.emplace(type, grains_of_templates(type));
  }

  const advice::SiUnits* units() const { return advice::find_si_units(units_); }
  const std::string& unit_name() const { return units_; }
  const std::optional<GranularModel>& pairs() const { return pairs_; }
  const std::vector<WallOfScript>& walls() const { return walls_; }
  /// Of walls that are there in the same run: the engine allows one of meshes.
  const std::vector<ScriptCommand>& second_mesh_walls() const { return second_mesh_walls_; }
  const std::map<int, Grains>& grains() const { return grains_; }
  std::set<int> wall_types() const {
    std::set<int> types;
    for (const WallOfScript& wall : walls_) types.insert(wall.type);
    return types;
  }
  const ScriptRun& run() const { return run_; }

  /// Null: the script has none.
  const ScriptProperty* find(const std::string& name) const {
    const auto found = properties_.find(name);
    return found == properties_.end() ? nullptr : &found->second;
  }
  /// Throws std::runtime_error at the line of the model that needs it.
  const ScriptProperty& need(const std::string& name, const GranularModel& model) const {
    if (const ScriptProperty* found = find(name)) return *found;
    model.where.fail("needs 'fix ID all property/global " + name + " ...': add this line");
  }

  /// Sizes of the command line, for types that the script leaves without.
  void add_grains(const ScriptGrain& grain) {
    for (const int type : types_of_grains())
      grains_.emplace(type, Grains{grain, grain, {"the command line", 0, {"--diameter"}, 0}});
  }

 private:
  struct Template {
    int type = 1;
    double smallest = 0.0, median = 0.0, density = 0.0;
    ScriptCommand where;
  };

  void read(const ScriptCommand& c) {
    run_.read(c);
    const std::string& name = c.words[0];
    if (name == "units") units_ = c.word(1, "the name of the units");
    if (name == "create_atoms") created_.insert(c.integer(1, "the atom type"));
    if (name == "set") set_commands_.push_back(c);
    if (name == "pair_style") read_pair_style(c);
    if (name == "fix" && c.has(3)) read_fix(c, c.words[3]);
    if (name == "unfix" && c.has(1)) remove_mesh_wall(c.words[1]);
    if (name == "run") note_second_mesh_wall();
  }

  void remove_mesh_wall(const std::string& id) {
    mesh_walls_.erase(std::remove_if(mesh_walls_.begin(), mesh_walls_.end(),
                                     [&](const ScriptCommand& c) { return c.words[1] == id; }),
                      mesh_walls_.end());
  }
  void note_second_mesh_wall() {
    if (mesh_walls_.size() < 2) return;
    second_mesh_walls_.push_back(mesh_walls_[1]);
    mesh_walls_.resize(1);
  }

  void read_pair_style(const ScriptCommand& c) {
    const std::size_t at = c.find("gran");
    if (at == c.words.size()) {
      if (c.word(1, "a style").rfind("hybrid", 0) == 0 || c.words[1] == "none") return;
      if (c.words[1] == "granular")
        c.fail(
            "pair_style granular of LAMMPS is not evaluated: use gran/jkr for jkr, and "
            "gran/hamaker with the constant 24 pi gamma H_cut^2 for dmt");
      c.fail("pair_style " + c.words[1] +
             " is not evaluated: write it as 'pair_style gran model hertz tangential history "
             "cohesion sjkr', the syntax of LIGGGHTS 3");
    }
    pairs_ = model_of(c);
  }

  static GranularModel model_of(const ScriptCommand& c) {
    GranularModel model{c, {}};
    model.normal = c.word(c.find("model") + 1, "'model' and its name");
    if (const std::size_t at = c.find("cohesion"); c.has(at))
      model.cohesion = c.word(at + 1, "the name of the cohesion model");
    return model;
  }

  void read_fix(const ScriptCommand& c, const std::string& style) {
    if (style == "property/global") {
      properties_.insert_or_assign(c.word(4, "the name of the property"), ScriptProperty(c));
    } else if (style == "particletemplate/sphere") {
      read_template(c);
    } else if (style.rfind("particledistribution/discrete", 0) == 0) {
      read_distribution(c, style);
    } else if (style.rfind("mesh/surface", 0) == 0) {
      if (const std::size_t at = c.find("type"); c.has(at))
        mesh_types_[c.words[1]] = c.integer(at + 1, "the type of the mesh");
    } else if (style == "wall/gran") {
      read_wall(c);
    } else if (style.rfind("wall/gran/", 0) == 0) {
      c.fail("fix " + style +
             " is not evaluated: write it as 'fix ID all wall/gran model hertz tangential history "
             "cohesion sjkr primitive type 1 zplane 0.0', the syntax of LIGGGHTS 3");
    }
  }

  void read_wall(const ScriptCommand& c) {
    const GranularModel model = model_of(c);
    if (const std::size_t at = c.find("primitive"); c.has(at)) {
      walls_.push_back(
          {c.words[1], c.integer(c.find("type", at) + 1, "the type of the wall"), model});
      return;
    }
    const std::size_t meshes = c.find("meshes"), count = c.find("n_meshes");
    if (!c.has(meshes)) c.fail("has neither 'primitive' nor 'meshes': add the kind of the wall");
    if (!c.has(count)) c.fail("has 'meshes' without 'n_meshes': add 'n_meshes' and their number");
    remove_mesh_wall(c.words[1]);
    mesh_walls_.push_back(c);
    const int number = c.integer(count + 1, "the number of meshes");
    for (int k = 1; k <= number; k++) {
      const std::string& id = c.word(meshes + static_cast<std::size_t>(k), "the ID of a mesh");
      const auto type = mesh_types_.find(id);
      if (type == mesh_types_.end())
        c.fail("mesh '" + id + "' has no 'fix mesh/surface ... type': define it before the wall");
      walls_.push_back({id, type->second, model});
    }
  }

  /// Smallest radius, and median by mass, of the distribution after `at`:
  ///
  ///   constant R                    R; R
  ///   uniform [mass] a b            a; (a + b)/2: equal mass in equal ranges of the radius
  ///   uniform number a b            a; ((a^4 + b^4)/2)^(1/4)
  ///   gaussian [number] mu sigma    mu - 3 sigma, where it is cut off; mu + 3 sigma^2/mu, to
  ///                                 second order of sigma/mu
  ///
  /// Source: probability_distribution.h of LIGGGHTS 3 (uniform number) and 3.8 (all others).
  static std::pair<double, double> radii_of(const ScriptCommand& c, std::size_t at) {
    const std::string& kind = c.word(at, "a distribution");
    const bool by_number = c.has(at + 1) && c.words[at + 1] == "number";
    const bool by_mass = c.has(at + 1) && c.words[at + 1] == "mass";
    const std::size_t k = at + (by_number || by_mass ? 2 : 1);
    if (kind == "constant") {
      const double radius = c.number(k, "the radius");
      return {radius, radius};
    }
    if ((kind != "uniform" && kind != "gaussian") || (kind == "gaussian" && by_mass))
      c.fail("the distribution '" + kind + (by_mass ? " mass" : "") +
             "' is not evaluated: use constant, uniform or gaussian number for this check");
    const double one = c.number(k, "a value of the distribution");
    const double other = c.number(k + 1, "a value of the distribution");
    if (kind == "uniform" && by_number)
      return {one, std::pow(0.5 * (std::pow(one, 4) + std::pow(other, 4)), 0.25)};
    if (kind == "uniform") return {one, 0.5 * (one + other)};
    if (!(one > 3.0 * other))
      c.fail("LIGGGHTS stops at a gaussian this wide: use a mean above three deviations");
    return {one - 3.0 * other, one + 3.0 * other * other / one};
  }

  void read_template(const ScriptCommand& c) {
    Template t;
    t.where = c;
    if (const std::size_t at = c.find("atom_type"); c.has(at))
      t.type = c.integer(at + 1, "the atom type");
    const std::size_t radius = c.find("radius"), density = c.find("density");
    if (!c.has(radius) || !c.has(density))
      c.fail("a template needs 'radius constant R' and 'density constant RHO': add both");
    std::tie(t.smallest, t.median) = radii_of(c, radius + 1);
    if (c.word(density + 1, "a distribution") != "constant")
      c.fail(
          "a distribution of densities is not evaluated: use 'density constant RHO' for this "
          "check");
    t.density = c.number(density + 2, "the density");
    require_size(c, t.smallest, t.density);
    templates_.insert_or_assign(c.words[1], t);
  }
  static void require_size(const ScriptCommand& c, double radius, double density) {
    if (!(radius > 0.0) || !(density > 0.0))
      c.fail("radius and density must be greater than zero: correct them");
  }

  void read_distribution(const ScriptCommand& c, const std::string& style) {
    const bool by_number = style.find("numberbased") != std::string::npos;
    const int count = c.integer(5, "the number of templates");
    for (std::size_t k = 6; k < 6 + 2 * static_cast<std::size_t>(std::max(count, 0)); k += 2) {
      const auto found = templates_.find(c.word(k, "the name of a template"));
      if (found == templates_.end()) continue;
      const Template& t = found->second;
      const double weight = c.number(k + 1, "the weight of a template");
      shares_[c.words[k]] = by_number ? weight * ScriptGrain{t.median, t.density}.mass() : weight;
    }
  }

  void read_set(const ScriptCommand& c) {
    const std::size_t diameter = c.find("diameter"), density = c.find("density");
    if (!c.has(diameter) || !c.has(density)) return;
    const ScriptGrain grain{0.5 * c.number(diameter + 1, "the diameter"),
                            c.number(density + 1, "the density")};
    require_size(c, grain.radius, grain.density);
    const std::set<int> types =
        c.words[1] == "type" ? std::set<int>{c.integer(2, "the atom type")} : created_types();
    for (const int type : types) {
      Grains& g = grains_.emplace(type, Grains{grain, grain, c}).first->second;
      if (grain.radius < g.smallest.radius) g.smallest = grain;
    }
  }

  std::set<int> created_types() const { return created_.empty() ? types_of_grains() : created_; }

  /// All types that are no wall's.
  std::set<int> types_of_grains() const {
    const std::set<int> of_walls = wall_types();
    std::set<int> types = created_;
    for (int type = 1; type <= number_of_types(); type++)
      if (!of_walls.count(type)) types.insert(type);
    return types.empty() ? std::set<int>{1} : types;
  }
  /// Of Young's moduli, or of stiffnesses.
  int number_of_types() const {
    if (const ScriptProperty* modulus = find("youngsModulus"))
      return static_cast<int>(modulus->where().words.size()) - 6;
    const ScriptProperty* stiffness = find("kn");
    return stiffness ? stiffness->where().integer(6, "the number of types") : 1;
  }

  std::set<int> template_types() const {
    std::set<int> types;
    for (const auto& [name, t] : templates_) types.insert(t.type);
    return types;
  }
  /// Median by the shares of mass of the distribution; templates in none have equal shares.
  Grains grains_of_templates(int type) const {
    std::vector<std::pair<Template, double>> all;
    double total = 0.0;
    for (const auto& [name, t] : templates_) {
      if (t.type != type) continue;
      const auto share = shares_.find(name);
      all.emplace_back(t, share != shares_.end() ? share->second : shares_.empty() ? 1.0 : 0.0);
      total += all.back().second;
    }
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return a.first.median < b.first.median; });
    double passed = 0.0;
    const Template* median = &all.front().first;
    for (const auto& [t, share] : all) {
      median = &t;
      if ((passed += share) >= 0.5 * total) break;
    }
    const auto smallest = std::min_element(
        all.begin(), all.end(),
        [](const auto& a, const auto& b) { return a.first.smallest < b.first.smallest; });
    return {{smallest->first.smallest, smallest->first.density},
            {median->median, median->density},
            smallest->first.where};
  }

  std::string units_ = "lj";
  std::optional<GranularModel> pairs_;
  std::vector<WallOfScript> walls_;
  std::vector<ScriptCommand> mesh_walls_, second_mesh_walls_;  // first: those that are there
  std::map<std::string, ScriptProperty> properties_;
  std::map<std::string, int> mesh_types_;
  std::map<std::string, Template> templates_;
  std::map<std::string, double> shares_;
  std::map<int, Grains> grains_;
  std::set<int> created_;
  std::vector<ScriptCommand> set_commands_;
  ScriptRun run_;
};

}  // namespace cohesion::tools
