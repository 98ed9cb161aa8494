// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_PAIR_HISTORY_H
#define COHESION_PAIR_HISTORY_H

#include <algorithm>
#include <cctype>
#include <string>

#include "error.h"
#include "lammps.h"
#include "modify.h"
#include "soft_contacts/fix_contact_history.h"

namespace LAMMPS_NS {

/// The ID of the fix with the histories of pair_style `style`: NEIGH_HISTORY_GRAN_HAMAKER of
/// gran/hamaker.
inline std::string history_id(const std::string& style) {
  std::string id = "NEIGH_HISTORY_" + style;
  std::transform(id.begin(), id.end(), id.begin(),
                 [](unsigned char c) { return c == '/' ? '_' : std::toupper(c); });
  return id;
}

/// The contact histories of a pair style, stored by a fix. The position in the list
/// of fixes is reserved when the pair style is created, since the fix has to precede those that
/// move particles to other ranks, such as fix deform.
class PairHistory {
 public:
  /// The ID of the fix ends with the number of values, since restart files do not contain it. Stops
  /// LAMMPS where the same style stands twice in a hybrid one.
  PairHistory(class LAMMPS* lmp, const std::string& style)
      : modify_(lmp->modify), id_(history_id(style)), fix_(nullptr) {
    if (modify_->find_fix(place()) >= 0)
      lmp->error->all(FLERR, "pair_style hybrid: " + style +
                                 " can be given only once; put the coefficients of all its types "
                                 "into lines of pair_coeff");
    modify_->add_fix(place() + " all DUMMY");
  }
  ~PairHistory() { modify_->delete_fix(fix_ ? id_ : place()); }
  PairHistory(const PairHistory&) = delete;
  PairHistory& operator=(const PairHistory&) = delete;

  /// To be called in the init of `pair`: creates the fix, with `values` numbers per pair, if there
  /// is none.
  void init(Pair* pair, int values) {
    if (fix_) return;
    const std::string number = std::to_string(values), place_id = place();
    id_ += "_" + number;
    modify_->replace_fix(place_id, id_ + " all CONTACT_HISTORY " + number, 1);
    fix_ = static_cast<FixContactHistory*>(modify_->fix[modify_->find_fix(id_)]);
    fix_->pair = pair;
  }

  FixContactHistory* operator->() const { return fix_; }
  const FixContactHistory& operator*() const { return *fix_; }

  void renumber(const Renumbering& renumbering) {
    if (fix_) fix_->renumber(renumbering);
  }

 private:
  std::string place() const { return id_ + "_PLACE"; }

  Modify* modify_;
  std::string id_;
  FixContactHistory* fix_;
};

}  // namespace LAMMPS_NS

#endif
