// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(CONTACT_HISTORY,FixContactHistory);
// clang-format on
#else

#ifndef LMP_FIX_CONTACT_HISTORY_H
#define LMP_FIX_CONTACT_HISTORY_H

#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "common/renumbering.h"
#include "contact_step/fix_contact_step.h"
#include "fix_neigh_history.h"

namespace LAMMPS_NS {

/// The contact histories of a pair style. In a run they are stored by the neighbour list, between
/// runs by the particles. The engine's fix reads the neighbour list whenever a restart file is
/// written; between runs its indices may be obsolete, since commands delete and exchange particles.
class FixContactHistory : public FixNeighHistory {
 public:
  FixContactHistory(class LAMMPS* lammps, int narg, char** arg)
      : FixNeighHistory(lammps, narg, EngineWords(narg, arg).words.data()) {}

  void write_restart(FILE* fp) override {
    if (FixContactStep::of(lmp)->is_running()) return FixNeighHistory::write_restart(fp);
    constexpr int size = 0;
    if (comm->me == 0) fwrite(&size, sizeof(int), 1, fp);
  }

  /// Partners are stored by their IDs. The history of a deleted partner is never used.
  void renumber(const Renumbering& renumbering) {
    std::vector<tagint> ids;
    for (int i = 0; i < atom->nlocal; i++)
      ids.insert(ids.end(), partner[i], partner[i] + npartner[i]);
    renumbering.translate(ids);
    auto next = ids.begin();
    for (int i = 0; i < atom->nlocal; i++)
      for (int m = 0; m < npartner[i]; m++) partner[i][m] = *next++;
  }

 private:
  /// The words of the command with the style of the engine's fix, which stands in restart files.
  struct EngineWords {
    EngineWords(int narg, char** arg) : words(arg, arg + narg) { words[2] = style.data(); }

    std::string style = "NEIGH_HISTORY";
    std::vector<char*> words;
  };
};

}  // namespace LAMMPS_NS

#endif
#endif
