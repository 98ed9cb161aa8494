// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_PAIR_HISTORY_H
#define COHESION_PAIR_HISTORY_H

#include <algorithm>
#include <cctype>
#include <string>

#include "fix_neigh_history.h"
#include "modify.h"

namespace LAMMPS_NS {

/// The fix ID of what pair_style `style` remembers: NEIGH_HISTORY_GRAN_HAMAKER of gran/hamaker.
inline std::string history_id(const std::string& style) {
  std::string id = "NEIGH_HISTORY_" + style;
  std::transform(id.begin(), id.end(), id.begin(),
                 [](unsigned char c) { return c == '/' ? '_' : std::toupper(c); });
  return id;
}

/// What a pair style remembers of each pair, kept by a fix of the engine. The fix gets its place in
/// the list of fixes when the pair style is made: the engine wants it before fixes that move
/// particles to other processes, such as fix deform.
class PairHistory {
 public:
  /// `id` of the fix; the number of values is added, which restart files do not tell.
  PairHistory(Modify* modify, const std::string& id) : modify_(modify), id_(id), fix_(nullptr) {
    modify_->add_fix(place() + " all DUMMY");
  }
  ~PairHistory() { modify_->delete_fix(fix_ ? id_ : place()); }
  PairHistory(const PairHistory&) = delete;
  PairHistory& operator=(const PairHistory&) = delete;

  /// In the init of `pair`: with `values` numbers per pair, made the first time.
  void init(Pair* pair, int values) {
    if (fix_) return;
    const std::string number = std::to_string(values), place_id = place();
    id_ += "_" + number;
    modify_->replace_fix(place_id, id_ + " all NEIGH_HISTORY " + number, 1);
    fix_ = static_cast<FixNeighHistory*>(modify_->fix[modify_->find_fix(id_)]);
    fix_->pair = pair;
  }

  FixNeighHistory* operator->() const { return fix_; }

 private:
  std::string place() const { return id_ + "_PLACE"; }

  Modify* modify_;
  std::string id_;
  FixNeighHistory* fix_;
};

}  // namespace LAMMPS_NS

#endif
