// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hard_sphere/body_renumbering.h"
#include "prefetch.h"

namespace cohesion::hard_sphere {

/// Many short lists that grow and shrink, side by side in one piece of memory.
template <class Item>
class PackedLists {
 public:
  /// Empties all and sets their number and the items that each has room for at first.
  void reset(const std::vector<int>& capacities) {
    slices_.resize(capacities.size());
    std::size_t first = 0;
    for (std::size_t n = 0; n < capacities.size(); n++) {
      slices_[n] = {first, 0, capacities[n]};
      first += capacities[n];
    }
    items_.resize(first);
  }

  /// Gives rows other numbers. New ones are empty, and take the room of those that are gone.
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

  /// The room of a row of this size that will grow and shrink.
  static int capacity_for(int size) { return size + 2 + size / 8; }

  Item* begin(int list) { return items_.data() + slices_[list].first; }
  Item* end(int list) { return begin(list) + slices_[list].size; }
  const Item* begin(int list) const { return items_.data() + slices_[list].first; }
  const Item* end(int list) const { return begin(list) + slices_[list].size; }

  /// Asks for the memory of where a row is.
  void prefetch_slice(int list) const { prefetch(slices_[list]); }

  void add(int list, const Item& item) {
    Slice& r = slices_[list];
    if (r.size == r.capacity) relocate_to_end(r);
    items_[r.first + r.size++] = item;
  }

  /// Takes an item out; the last one takes its place.
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

  /// Gives a row that is full twice the room. The old place stays unused until reset().
  void relocate_to_end(Slice& r) {
    const std::size_t to = items_.size();
    const int capacity = std::max(4, 2 * r.capacity);
    items_.resize(to + capacity);
    std::copy_n(items_.begin() + static_cast<std::ptrdiff_t>(r.first), r.size,
                items_.begin() + static_cast<std::ptrdiff_t>(to));
    r.first = to;
    r.capacity = capacity;
  }

  std::vector<Slice> slices_;
  std::vector<Item> items_;
};

}  // namespace cohesion::hard_sphere
