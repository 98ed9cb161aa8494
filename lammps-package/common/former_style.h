// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FORMER_STYLE_H
#define COHESION_FORMER_STYLE_H

#include "common/former_words.h"

namespace LAMMPS_NS {

/// A style that a script calls by its former name: the same style, with one line that states the
/// current name. `NAME` is in cohesion::former_names.
template <class Style, const char* NAME>
class FormerStyle : public Style {
 public:
  template <class... Words>
  explicit FormerStyle(LAMMPS* lammps, Words... words) : Style(lammps, words...) {
    current_word(lammps, NAME, "style", NAME);
  }
};

}  // namespace LAMMPS_NS

#endif
