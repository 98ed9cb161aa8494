// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hard_sphere/bodies.h"
#include "hard_sphere/contact_parameters.h"

namespace cohesion::hard_sphere {

/// What happens between bodies of each two kinds, and between which of them nothing does.
class PairRules {
 public:
  explicit PairRules(int kinds = 1)
      : kinds_(kinds), of_kinds_(kinds * kinds), shallowest_(kinds, never) {}

  /// Sets what happens between kinds i and j; the ratios of the well are those of i and j.
  void set(int i, int j, const ContactParameters& given) {
    at(i, j) = {given, given.law(), true};
    at(j, i) = {given, given.law(), true};
    at(j, i).given.well = square_well::reversed(given.well);
    if (given.well.depth == 0.0) return;
    for (const int kind : {i, j}) shallowest_[kind] = std::min(shallowest_[kind], given.well.depth);
  }
  /// Kinds that pass through each other.
  void forbid(int i, int j) { at(i, j).meet = at(j, i).meet = false; }
  /// Bodies of two groups that pass through each other, by a bit of each group.
  void forbid_groups(int bit_a, int bit_b) { apart_.emplace_back(bit_a, bit_b); }

  /// Pairs that pass through each other, in order, the lower tag first.
  void forbid_pairs(std::vector<Tags> pairs) { pairs_apart_ = std::move(pairs); }

  const Law& law(const Body& a, const Body& b) const { return at(a.kind, b.kind).law; }

  Surfaces surfaces(const Body& a, const Body& b) const {
    const OfKinds& rule = at(a.kind, b.kind);
    const double core = a.radius + b.radius;
    if (rule.law.depth == 0.0) return {core, core};
    return {core, square_well::edge(rule.given.well, a.radius, b.radius)};
  }

  /// The least depth of the wells that a body has with others, [energy]; `never`: it has none.
  double shallowest_well(const Body& a) const { return shallowest_[a.kind]; }

  /// Whether two bodies can have an event with each other, and this process has to know of it.
  bool meet(const Body& a, const Body& b) const {
    if (!at(a.kind, b.kind).meet || (a.remote && b.remote) ||
        a.inverse_mass + b.inverse_mass == 0.0)
      return false;
    if (!pairs_apart_.empty() &&
        std::binary_search(pairs_apart_.begin(), pairs_apart_.end(),
                           Tags{std::min(a.tag, b.tag), std::max(a.tag, b.tag)}))
      return false;
    return std::none_of(apart_.begin(), apart_.end(), [&](const std::pair<int, int>& bits) {
      return (a.groups & bits.first && b.groups & bits.second) ||
             (a.groups & bits.second && b.groups & bits.first);
    });
  }

  /// The largest distance of centres at which something happens over the sum of the radii, [1].
  double largest_ratio() const {
    double largest = 1.0;
    for (const OfKinds& rule : of_kinds_)
      if (rule.law.depth > 0.0) largest = std::max(largest, rule.given.well.ratio_i);
    return largest;
  }

 private:
  struct OfKinds {
    ContactParameters given;
    Law law;
    bool meet = true;
  };

  OfKinds& at(int i, int j) { return of_kinds_[i * kinds_ + j]; }
  const OfKinds& at(int i, int j) const { return of_kinds_[i * kinds_ + j]; }

  int kinds_;
  std::vector<OfKinds> of_kinds_;
  std::vector<double> shallowest_;  // by kind
  std::vector<std::pair<int, int> > apart_;
  std::vector<Tags> pairs_apart_;
};

/// A wall in uniform motion, and what happens between it and bodies of each kind.
struct HardWall {
  struct Rule {
    Law law;
    double ratio = 1.0;  ///< of the edge of its well to the radius of a body, [1]
  };

  MovingWall moving;
  std::vector<Rule> of_kind;
  int groups = -1;     ///< bits of the groups that it acts on
  bool moves = false;  ///< not always at the same place

  const Law& law(const Body& a) const { return of_kind[a.kind].law; }
  Surfaces surfaces(const Body& a) const {
    const Rule& rule = of_kind[a.kind];
    return {a.radius, rule.law.depth > 0.0 ? rule.ratio * a.radius : a.radius};
  }
  bool acts_on(const Body& a) const { return (a.groups & groups) != 0; }
  bool meets(const Body& a) const { return acts_on(a) && a.inverse_mass > 0.0 && !a.remote; }
};

}  // namespace cohesion::hard_sphere
