// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hard_sphere/bodies.h"
#include "hard_sphere/hard_contact_parameters.h"

namespace cohesion::hard_sphere {

/// Parameters of the impacts for each pair of materials, and the pairs that do not interact.
class PairRules {
 public:
  explicit PairRules(int materials = 1)
      : materials_(materials),
        material_pairs_(materials * materials),
        least_well_depths_(materials, never) {}

  /// Sets the parameters of materials i and j; the ratios of the well are those of i and j.
  void set(int i, int j, const HardContactParameters& parameters) {
    material_pair(i, j) = {parameters, parameters.law(), true};
    material_pair(j, i) = {parameters, parameters.law(), true};
    material_pair(j, i).parameters.well = square_well::reversed(parameters.well);
    if (parameters.well.depth == 0.0) return;
    for (const int material : {i, j})
      least_well_depths_[material] = std::min(least_well_depths_[material], parameters.well.depth);
  }
  /// Excludes impacts between two materials.
  void exclude(int i, int j) {
    material_pair(i, j).interacts = material_pair(j, i).interacts = false;
  }
  /// Excludes impacts between bodies of two groups, by a bit of each group.
  void exclude_groups(int bit_a, int bit_b) { excluded_groups_.emplace_back(bit_a, bit_b); }

  /// Excludes impacts of pairs of bodies. The list is sorted, with the lower tag first in each
  /// pair.
  void exclude_pairs(std::vector<TagPair> pairs) { excluded_pairs_ = std::move(pairs); }

  const ImpactLaw& law(const HardSphere& a, const HardSphere& b) const {
    return material_pair(a.material, b.material).law;
  }

  SurfaceDistances surfaces(const HardSphere& a, const HardSphere& b) const {
    const MaterialPair& contact = material_pair(a.material, b.material);
    const double core = a.radius + b.radius;
    if (contact.law.depth == 0.0) return {core, core};
    return {core, square_well::edge(contact.parameters.well, a.radius, b.radius)};
  }

  /// The least depth of the wells of a body with others, [energy]; `never`: no wells.
  double least_well_depth(const HardSphere& a) const { return least_well_depths_[a.material]; }

  /// Whether two bodies can have events with each other that this process has to execute.
  bool interact(const HardSphere& a, const HardSphere& b) const {
    if (!material_pair(a.material, b.material).interacts || (a.remote && b.remote) ||
        a.inverse_mass + b.inverse_mass == 0.0)
      return false;
    if (!excluded_pairs_.empty() &&
        std::binary_search(excluded_pairs_.begin(), excluded_pairs_.end(),
                           TagPair{std::min(a.tag, b.tag), std::max(a.tag, b.tag)}))
      return false;
    return std::none_of(excluded_groups_.begin(), excluded_groups_.end(),
                        [&](const std::pair<int, int>& bits) {
                          return (a.group_bits & bits.first && b.group_bits & bits.second) ||
                                 (a.group_bits & bits.second && b.group_bits & bits.first);
                        });
  }

  /// The largest ratio of a surface distance to the sum of the radii, [1].
  double largest_ratio() const {
    double largest = 1.0;
    for (const MaterialPair& contact : material_pairs_)
      if (contact.law.depth > 0.0) largest = std::max(largest, contact.parameters.well.ratio_i);
    return largest;
  }

 private:
  struct MaterialPair {
    HardContactParameters parameters;
    ImpactLaw law;
    bool interacts = true;
  };

  MaterialPair& material_pair(int i, int j) { return material_pairs_[i * materials_ + j]; }
  const MaterialPair& material_pair(int i, int j) const {
    return material_pairs_[i * materials_ + j];
  }

  int materials_;
  std::vector<MaterialPair> material_pairs_;
  std::vector<double> least_well_depths_;  // by material
  std::vector<std::pair<int, int> > excluded_groups_;
  std::vector<TagPair> excluded_pairs_;
};

/// A wall in uniform motion with the parameters of its impacts for each material.
struct HardWall {
  struct WallContact {
    ImpactLaw law;
    double ratio = 1.0;  ///< of the edge of the well to the radius of a body, [1]
  };

  MovingWall motion;
  std::vector<WallContact> by_material;
  int group_bits = -1;  ///< bit mask of the groups that the wall acts on
  bool moves = false;   ///< whether its position changes

  const ImpactLaw& law(const HardSphere& a) const { return by_material[a.material].law; }
  SurfaceDistances surfaces(const HardSphere& a) const {
    const WallContact& contact = by_material[a.material];
    return {a.radius, contact.law.depth > 0.0 ? contact.ratio * a.radius : a.radius};
  }
  bool acts_on(const HardSphere& a) const { return (a.group_bits & group_bits) != 0; }
  bool interacts_with(const HardSphere& a) const {
    return acts_on(a) && a.inverse_mass > 0.0 && !a.remote;
  }
};

}  // namespace cohesion::hard_sphere
