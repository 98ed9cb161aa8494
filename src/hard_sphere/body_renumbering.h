// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace cohesion::hard_sphere {

/// How bodies get other numbers, go and come. What it costs to follow it goes with how many bodies
/// are concerned, not with how many there are.
class BodyRenumbering {
 public:
  /// Body n is the one that was old[n] of so many `bodies`, or a new one where that is below 0.
  /// Those that are not there are gone.
  BodyRenumbering(std::vector<int> old_number, std::size_t bodies)
      : old_(std::move(old_number)), now_(bodies, -1) {
    for (int n = 0; n < static_cast<int>(old_.size()); n++) {
      if (old_[n] >= 0) now_[old_[n]] = n;
      if (old_[n] != n) changed_.push_back(n);
    }
    for (int i = 0; i < static_cast<int>(now_.size()); i++)
      if (now_[i] < 0) removed_.push_back(i);
  }

  std::size_t count() const { return old_.size(); }
  /// The number that body n had; below 0: it is new.
  int old_number(int n) const { return old_[n]; }
  /// The number of what was body i; below 0: it is gone.
  int new_number(int i) const { return now_[i]; }
  bool is_unchanged(int i) const { return now_[i] == i; }
  /// The numbers under which there is another body now.
  const std::vector<int>& changed() const { return changed_; }
  /// The numbers that the bodies had that are gone.
  const std::vector<int>& removed() const { return removed_; }

  /// Arranges what there is of each body. New bodies have Item{}.
  template <class Item>
  void reorder(std::vector<Item>& items) const {
    std::vector<Item> changed;
    changed.reserve(changed_.size());
    for (const int n : changed_) changed.push_back(old_[n] < 0 ? Item{} : items[old_[n]]);
    items.resize(old_.size());
    for (std::size_t k = 0; k < changed_.size(); k++) items[changed_[k]] = changed[k];
  }

 private:
  std::vector<int> old_, now_, changed_, removed_;
};

}  // namespace cohesion::hard_sphere
