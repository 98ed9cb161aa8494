// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_GUARDED_H
#define COHESION_GUARDED_H

#include <new>
#include <stdexcept>
#include <string>

#include "common/engine_api.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// Does `work`, of one rank: where the core, or the library, throws, the engine ends with an error
/// that has `where` (a style) in front. The engine's own exceptions, which are none of these, go
/// on.
template <class Work>
auto guarded(LAMMPS* lmp, const std::string& where, Work work) {
  const auto stop = [&](const char* what) {
    engine_api::error_of_one(lmp, FLERR, where + ": " + what);
  };
  try {
    return work();
  } catch (const std::logic_error& bad) {  // among them cohesion::InvalidParameter
    stop(bad.what());
    throw;
  } catch (const std::runtime_error& bad) {
    stop(bad.what());
    throw;
  } catch (const std::bad_alloc&) {
    stop("not enough memory");
    throw;
  }
}

}  // namespace LAMMPS_NS

#endif
