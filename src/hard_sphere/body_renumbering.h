// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace cohesion::hard_sphere {

/// Permutation, insertion and removal of bodies. Applying it costs time in proportion to the number
/// of bodies that change, not to their total number.
class BodyRenumbering {
 public:
  /// Body n had the number old_numbers[n] among `bodies` bodies; a negative entry is a new body.
  /// Bodies that are absent from old_numbers are removed.
  BodyRenumbering(std::vector<int> old_numbers, std::size_t bodies)
      : old_numbers_(std::move(old_numbers)), new_numbers_(bodies, -1) {
    for (int n = 0; n < static_cast<int>(old_numbers_.size()); n++) {
      if (old_numbers_[n] >= 0) new_numbers_[old_numbers_[n]] = n;
      if (old_numbers_[n] != n) changed_.push_back(n);
    }
    for (int i = 0; i < static_cast<int>(new_numbers_.size()); i++)
      if (new_numbers_[i] < 0) removed_.push_back(i);
  }

  std::size_t count() const { return old_numbers_.size(); }
  /// The previous number of body n; negative: the body is new.
  int old_number(int n) const { return old_numbers_[n]; }
  /// The new number of body i; negative: the body is removed.
  int new_number(int i) const { return new_numbers_[i]; }
  bool is_unchanged(int i) const { return new_numbers_[i] == i; }
  /// The numbers that refer to a different body from now on.
  const std::vector<int>& changed() const { return changed_; }
  /// The previous numbers of the removed bodies.
  const std::vector<int>& removed() const { return removed_; }

  /// Reorders one item per body. Items of new bodies are default-constructed.
  template <class Item>
  void reorder(std::vector<Item>& items) const {
    std::vector<Item> changed;
    changed.reserve(changed_.size());
    for (const int n : changed_)
      changed.push_back(old_numbers_[n] < 0 ? Item{} : items[old_numbers_[n]]);
    items.resize(old_numbers_.size());
    for (std::size_t k = 0; k < changed_.size(); k++) items[changed_[k]] = changed[k];
  }

 private:
  std::vector<int> old_numbers_, new_numbers_, changed_, removed_;
};

}  // namespace cohesion::hard_sphere
