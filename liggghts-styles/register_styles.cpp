// SPDX-License-Identifier: GPL-2.0-or-later
// Fixes for the stock LIGGGHTS, added to the styles of each engine instance.
//
// LIGGGHTS calls LAMMPS::post_create() whenever its styles have been created: at the start and
// after `clear`. It does so through the dynamic linker, so the definition here, linked or preloaded
// in front of libliggghts, comes first. It does the engine's own work, then adds the fixes.

#include <dlfcn.h>

#include <map>
#include <string>

#include "error.h"
#include "fix.h"
#include "fix_gas_coupling.h"
#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;

namespace {

using MakeFix = Fix* (*)(LAMMPS*, int, char**);
using Fixes = std::map<std::string, MakeFix>;

template <class Style>
Fix* make(LAMMPS* lmp, int narg, char** arg) {
  return new Style(lmp, narg, arg);
}

// The engine's table of fixes is private; an explicit instantiation may name it all the same.
Fixes& fixes_of(Modify& modify);

template <Fixes* Modify::*table>
struct Reach {
  friend Fixes& fixes_of(Modify& modify) { return *(modify.*table); }
};
template struct Reach<&Modify::fix_map>;

}  // namespace

__attribute__((visibility("default"))) void LAMMPS::post_create() {
  using PostCreate = void (*)(LAMMPS*);
  // The mangled name is that of this very function.
  static const auto engine_own =
      reinterpret_cast<PostCreate>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  if (!engine_own)
    error->all(FLERR, "the library that adds fixes to LIGGGHTS must come before libliggghts");
  engine_own(this);

  fixes_of(*modify)["gas/coupling"] = &make<FixGasCoupling>;
}
