// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_TYPE_MATRIX_H
#define COHESION_TYPE_MATRIX_H

#include <sstream>
#include <string>
#include <vector>

#include "common/message.h"
#include "lammps.h"
#include "validation.h"

namespace LIGGGHTS {
namespace Cohesion {

/// What a model knows of each pair of atom types, counted from 1.
template <class Entry>
class TypeMatrix {
 public:
  const Entry& of(int itype, int jtype) const { return entries_[(itype - 1) * types_ + jtype - 1]; }

  /// Fills the table with make(i, j). What that rejects stops the engine with the model, the types
  /// and given(i, j): where the numbers stand in the script.
  template <class Make, class Given>
  void fill(LAMMPS_NS::LAMMPS* lmp, const char* model, int types, Make make, Given given) {
    types_ = types;
    entries_.clear();
    for (int i = 1; i <= types; i++)
      for (int j = 1; j <= types; j++) try {
          entries_.push_back(make(i, j));
        } catch (const cohesion::InvalidParameter& bad) {
          LAMMPS_NS::stop(lmp, FLERR, "cohesion model ", model, ", atom types ", i, " and ", j,
                          ": ", bad.what(), " (fix property/global ", given(i, j), ")");
        }
  }

 private:
  int types_ = 0;
  std::vector<Entry> entries_;
};

/// "name = value", as messages show what was given.
inline std::string shown(const char* name, double value) {
  std::ostringstream text;
  text << name << " = " << value;
  return text.str();
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
