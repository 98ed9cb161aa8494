// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "contact/stiffness_scaling.h"

/// A wall decides by other rules than the pairs which particles stick: what to say of that.
namespace cohesion::advice {

/// How much softer than its material a contact is that attracts.
struct Softening {
  contact::Material material;  ///< given or not
  double stiffness;            ///< of the contact, what Material::stiffness is of its material

  double ratio() const { return stiffness / material.stiffness; }
  /// f of StiffnessScaling.
  double factor() const { return contact::StiffnessScaling(material, stiffness).factor(); }
};

/// What decides in the contacts of a pair style, or of a wall, which particles stick.
struct StickingRules {
  std::string name;                   ///< in messages: 'pair_style NAME', 'fix ID NAME'
  bool is_exact = true;               ///< scheme exact; else sampled
  std::string adhesion;               ///< the law that attracts; empty: nothing does
  bool meant_without = false;         ///< the script says that nothing shall
  std::string wall_words;             ///< how a script has a wall with this law
  std::string without_words;          ///< how it says that nothing shall attract
  std::string material_words;         ///< how it gives the material; empty: it cannot
  std::vector<Softening> softenings;  ///< of contacts that attract
};

namespace detail {

/// Factors of softening that differ by less are one: so are then both escape velocities and both
/// pull-off forces.
inline constexpr double same_factor = 0.01;

inline bool is_soft(const Softening& s) { return std::abs(s.factor() - 1.0) > same_factor; }

/// Whether both are softened alike, as far as their materials are given. What they keep of these
/// may differ: a wall on which particles rest, and pairs that collide.
inline bool alike(const Softening& a, const Softening& b) {
  if (a.material.is_specified() && b.material.is_specified())
    return std::abs(a.factor() / b.factor() - 1.0) <= same_factor;
  const Softening& given = a.material.is_specified() ? a : b;
  return !given.material.is_specified() || given.material.keep == contact::Keep::force ||
         !is_soft(given);
}

inline std::string numbers(const Softening& s) {
  std::ostringstream out;
  out.precision(3);
  out << s.ratio() << " times the " << name_of_stiffness(s.material)
      << " of the material (f = " << s.factor() << ')';
  return out.str();
}

/// The cure of a wall that is softened otherwise than the pairs.
inline std::string softening_cure(const Softening& wall, const Softening& pair) {
  std::ostringstream out;
  out.precision(3);
  const bool linear = wall.material.exponent == contact::linear_power;
  const double times = std::pow(pair.factor() / wall.factor(), wall.material.exponent + 1.0);
  out << "give both the same f: multiply " << (linear ? "the stiffness" : "Young's modulus")
      << " of the wall by " << times;
  return out.str();
}

inline std::string other_criteria() {
  return ": a particle sticks to the wall and to another particle by different criteria";
}

}  // namespace detail

/// Of a wall that has another scheme than all `pairs`; empty: it has not. by_default: what the
/// scheme is without the keyword.
inline std::string other_scheme(const StickingRules& wall, const std::vector<StickingRules>& pairs,
                                const std::string& by_default) {
  if (pairs.empty() || std::any_of(pairs.begin(), pairs.end(), [&](const StickingRules& some) {
        return some.is_exact == wall.is_exact;
      }))
    return {};
  const std::string exact = "'scheme exact'", sampled = "'scheme sampled'";
  return wall.name + " has " + (wall.is_exact ? exact : sampled) + ", and " + pairs.front().name +
         " has " + (wall.is_exact ? sampled : exact) + detail::other_criteria() +
         ", since that of scheme sampled depends on the time step; give both the same scheme (" +
         by_default + ")";
}

/// Of a wall that attracts by another law than all `pairs` that attract, or not at all although
/// its script does not say so; empty: of no such wall. A wall that attracts next to pairs that do
/// not is left alone.
inline std::string other_adhesion(const StickingRules& wall,
                                  const std::vector<StickingRules>& pairs) {
  const StickingRules* first = nullptr;
  for (const StickingRules& some : pairs) {
    if (some.adhesion.empty()) continue;
    if (some.adhesion == wall.adhesion) return {};
    if (!first) first = &some;
  }
  if (!first || (wall.adhesion.empty() && wall.meant_without)) return {};
  const std::string has = " has the adhesion of ";
  const std::string cure = "; use " + first->wall_words + " for the wall";
  if (!wall.adhesion.empty())
    return wall.name + has + wall.adhesion + ", and " + first->name + " that of " +
           first->adhesion + detail::other_criteria() + cure;
  return wall.name + " has no adhesion, and " + first->name + " has that of " + first->adhesion +
         ": particles stick to each other, but not to the wall" + cure + ", or " +
         wall.without_words + " if nothing shall stick to it";
}

/// Of a wall that attracts as pairs do, and of which a contact is softened otherwise than all of
/// theirs, where the materials are given; empty: of no such wall.
inline std::string other_softening(const StickingRules& wall,
                                   const std::vector<StickingRules>& pairs) {
  const StickingRules* first = nullptr;
  std::vector<Softening> of_pairs;
  for (const StickingRules& some : pairs) {
    if (some.adhesion.empty() || some.adhesion != wall.adhesion) continue;
    if (!first) first = &some;
    of_pairs.insert(of_pairs.end(), some.softenings.begin(), some.softenings.end());
  }
  if (of_pairs.empty()) return {};
  for (const Softening& mine : wall.softenings) {
    if (std::any_of(of_pairs.begin(), of_pairs.end(),
                    [&](const Softening& theirs) { return detail::alike(mine, theirs); }))
      continue;
    const Softening& theirs = of_pairs.front();
    if (!mine.material.is_specified() || !theirs.material.is_specified()) {
      const bool of_wall = mine.material.is_specified();
      const Softening& given = of_wall ? mine : theirs;
      const StickingRules &has = of_wall ? wall : *first, &lacks = of_wall ? *first : wall;
      return has.name + " has " + detail::numbers(given) +
             ", by which its adhesion is scaled, and " + lacks.name + " has no material" +
             detail::other_criteria() + "; give " + has.material_words + " for both";
    }
    return wall.name + " has " + detail::numbers(mine) + ", and " + first->name + " has " +
           detail::numbers(theirs) +
           ": what soft contacts do not keep of their materials (the pull-off force, or with "
           "'material_keep force' the escape velocity) differs; " +
           detail::softening_cure(mine, theirs);
  }
  return {};
}

/// All that there is to say of `walls` next to `pairs`.
inline std::vector<std::string> warnings_of_walls(const std::vector<StickingRules>& walls,
                                                  const std::vector<StickingRules>& pairs,
                                                  const std::string& scheme_by_default) {
  std::vector<std::string> all;
  for (const StickingRules& wall : walls)
    for (const std::string& text : {other_scheme(wall, pairs, scheme_by_default),
                                    other_adhesion(wall, pairs), other_softening(wall, pairs)})
      if (!text.empty()) all.push_back(text);
  return all;
}

}  // namespace cohesion::advice
