// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hard_sphere/body_renumbering.h"
#include "prefetch.h"

namespace cohesion::hard_sphere {

/// Many short lists of variable length in one contiguous array.
template <class Item>
class PackedLists {
 public:
  /// Empties all lists and sets their number and initial capacities.
  void reset(const std::vector<int>& capacities) {
    slices_.resize(capacities.size());
    std::size_t first = 0;
    for (std::size_t n = 0; n < capacities.size(); n++) {
      slices_[n] = {first, 0, capacities[n]};
      first += capacities[n];
    }
    items_.resize(first);
  }

  /// Renumbers lists. New ones are empty and reuse the memory of removed ones.
  void renumber(const BodyRenumbering& renumbering) {
    std::vector<Slice> free;
    for (const int list : renumbering.removed()) free.push_back(slices_[list]);
    renumbering.reorder(slices_);
    for (const int list : renumbering.changed()) {
      if (renumbering.old_number(list) >= 0 || free.empty()) continue;
      slices_[list] = {free.back().first, 0, free.back().capacity};
      free.pop_back();
    }
  }

  /// Capacity for a list of this size whose size varies.
  static int capacity_for(int size) { return size + 2 + size / 8; }

  Item* begin(int list) { return items_.data() + slices_[list].first; }
  Item* end(int list) { return begin(list) + slices_[list].size; }
  const Item* begin(int list) const { return items_.data() + slices_[list].first; }
  const Item* end(int list) const { return begin(list) + slices_[list].size; }

  /// Prefetches the address of a list.
  void prefetch_slice(int list) const { prefetch(slices_[list]); }

  void add(int list, const Item& item) {
    Slice& slice = slices_[list];
    if (slice.size == slice.capacity) relocate_to_end(slice);
    items_[slice.first + slice.size++] = item;
  }

  /// Removes an item; the last one replaces it.
  void remove(int list, Item* item) {
    *item = *(end(list) - 1);
    slices_[list].size--;
  }

  double bytes() const {
    return static_cast<double>(slices_.capacity() * sizeof(Slice) +
                               items_.capacity() * sizeof(Item));
  }

 private:
  struct Slice {
    std::size_t first = 0;
    int size = 0, capacity = 0;
  };

  /// Doubles the capacity of a full list. The previous memory stays unused until reset().
  void relocate_to_end(Slice& slice) {
    const std::size_t to = items_.size();
    const int capacity = std::max(4, 2 * slice.capacity);
    items_.resize(to + capacity);
    std::copy_n(items_.begin() + static_cast<std::ptrdiff_t>(slice.first), slice.size,
                items_.begin() + static_cast<std::ptrdiff_t>(to));
    slice.first = to;
    slice.capacity = capacity;
  }

  std::vector<Slice> slices_;
  std::vector<Item> items_;
};

}  // namespace cohesion::hard_sphere
