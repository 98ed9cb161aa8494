// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_RENUMBERING_H
#define COHESION_RENUMBERING_H

#include <vector>

#include "lmptype.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// The IDs that particles have now, by those that they had before: `delete_atoms`,
/// `reset_atom_ids` and `reset_atoms id` give them others, and the engine tells no style.
class Renumbering : protected Pointers {
 public:
  /// Collective. `before`: the IDs of the own particles as they were; 0: it is new.
  Renumbering(LAMMPS*, const std::vector<tagint>& before);

  /// Whether any particle has another ID, on any process.
  bool any() const { return any_; }
  /// Collective: replaces IDs as they were by those of the same particles now; 0: it is gone.
  void translate(std::vector<tagint>& ids) const;

 private:
  std::vector<tagint> own_;  // of each particle of this process, the ID before and the ID now
  bool any_;
};

}  // namespace LAMMPS_NS

#endif
