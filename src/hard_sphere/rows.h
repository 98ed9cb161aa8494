// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hard_sphere/renumbering.h"
#include "prefetch.h"

namespace cohesion::hard_sphere {

/// Many short lists that grow and shrink, side by side in one piece of memory.
template <class Item>
class Rows {
 public:
  /// Empties all and sets their number and the items that each has room for at first.
  void reset(const std::vector<int>& rooms) {
    rows_.resize(rooms.size());
    std::size_t first = 0;
    for (std::size_t n = 0; n < rooms.size(); n++) {
      rows_[n] = {first, 0, rooms[n]};
      first += rooms[n];
    }
    items_.resize(first);
  }

  /// Gives rows other numbers. New ones are empty, and take the room of those that are gone.
  void arrange(const Renumbering& to) {
    std::vector<Row> free;
    for (const int row : to.gone()) free.push_back(rows_[row]);
    to.apply(rows_);
    for (const int row : to.changed()) {
      if (to.old(row) >= 0 || free.empty()) continue;
      rows_[row] = {free.back().first, 0, free.back().room};
      free.pop_back();
    }
  }

  /// The room of a row of this size that will grow and shrink.
  static int room_for(int size) { return size + 2 + size / 8; }

  Item* begin(int row) { return items_.data() + rows_[row].first; }
  Item* end(int row) { return begin(row) + rows_[row].size; }
  const Item* begin(int row) const { return items_.data() + rows_[row].first; }
  const Item* end(int row) const { return begin(row) + rows_[row].size; }

  /// Asks for the memory of where a row is.
  void foresee(int row) const { prefetch(rows_[row]); }

  void add(int row, const Item& item) {
    Row& r = rows_[row];
    if (r.size == r.room) move_to_the_end(r);
    items_[r.first + r.size++] = item;
  }

  /// Takes an item out; the last one takes its place.
  void remove(int row, Item* item) {
    *item = *(end(row) - 1);
    rows_[row].size--;
  }

  double bytes() const {
    return static_cast<double>(rows_.capacity() * sizeof(Row) + items_.capacity() * sizeof(Item));
  }

 private:
  struct Row {
    std::size_t first = 0;
    int size = 0, room = 0;
  };

  /// Gives a row that is full twice the room. The old place stays unused until reset().
  void move_to_the_end(Row& r) {
    const std::size_t to = items_.size();
    const int room = std::max(4, 2 * r.room);
    items_.resize(to + room);
    std::copy_n(items_.begin() + static_cast<std::ptrdiff_t>(r.first), r.size,
                items_.begin() + static_cast<std::ptrdiff_t>(to));
    r.first = to;
    r.room = room;
  }

  std::vector<Row> rows_;
  std::vector<Item> items_;
};

}  // namespace cohesion::hard_sphere
