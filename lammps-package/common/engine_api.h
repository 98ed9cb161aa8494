// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_ENGINE_API_H
#define COHESION_ENGINE_API_H

// What the supported engines spell differently; nothing else in the package asks for a version.
// HISTBITS came with the interface that LAMMPS has had since 2022. Styles that are built for
// LIGGGHTS too (COHESION_FOR_LIGGGHTS: see liggghts-styles/CMakeLists.txt) take what is below
// `styles of both engines` from here, and name nothing else that only one of them has.

#ifdef COHESION_FOR_LIGGGHTS
#include "liggghts_api.h"
#else

#include <string>
#include <utility>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_deform.h"
#include "irregular.h"
#include "lmptype.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "output.h"
#include "pair.h"
#include "utils.h"
#include "vector3.h"

namespace LAMMPS_NS {
namespace engine_api {

/// Ask for a half list by cut-off, not by the particles' size: forces act beyond contact.
inline void request_neighbor_list(Neighbor* neighbor, Pair* pair, int instance) {
#ifdef HISTBITS
  (void)instance;
  neighbor->add_request(pair);
#else
  neighbor->request(pair, instance);
#endif
}

/// The same for a style that keeps a history of each pair (FixNeighHistory).
inline void request_history_list(Neighbor* neighbor, Pair* pair, int instance) {
#ifdef HISTBITS
  (void)instance;
  neighbor->add_request(pair, NeighConst::REQ_HISTORY);
#else
  const int request = neighbor->request(pair, instance);  // moves the array of requests
  neighbor->requests[request]->history = 1;
#endif
}

/// The region of this ID, null if there is none.
inline Region* region_of(const Domain* domain, const std::string& id) {
#ifdef HISTBITS
  return domain->get_region_by_id(id);
#else
  const int region = const_cast<Domain*>(domain)->find_region(id);
  return region < 0 ? nullptr : domain->regions[region];
#endif
}

// ---- styles of both engines ----

using StyleFix = Fix;
using StyleCompute = Compute;
/// Shears the engine's box: FixDeform, which Domain and others look for.
using BoxFix = FixDeform;

using FixConst::POST_NEIGHBOR;
constexpr int GROW = Atom::GROW, RESTART = Atom::RESTART;
/// Of fixes that may exert forces.
constexpr int WITH_FORCES = FixConst::PRE_FORCE | FixConst::PRE_REVERSE | FixConst::POST_FORCE;
/// What takes the velocities of ghosts away in a script.
constexpr const char* NO_GHOST_VELOCITIES = "comm_modify vel no";

inline double numeric(const char* file, int line, char* word, LAMMPS* lmp) {
  return utils::numeric(file, line, word, false, lmp);
}
inline int inumeric(const char* file, int line, char* word, LAMMPS* lmp) {
  return utils::inumeric(file, line, word, false, lmp);
}
/// Rank 0 shows it and writes it to the log.
inline void tell(LAMMPS* lmp, const std::string& message) {
  if (lmp->comm->me == 0) utils::logmesg(lmp, message);
}
/// The engine's error, of all ranks or of one, which ends the run.
inline void error_of_all(const LAMMPS* lmp, const char* file, int line, const std::string& text) {
  lmp->error->all(file, line, text);
}
inline void error_of_one(const LAMMPS* lmp, const char* file, int line, const std::string& text) {
  lmp->error->one(file, line, text);
}
inline bool writes_restart(Output* output, bigint step) { return output->next_restart == step; }

inline bool changes_box(const Fix* fix) {
  return fix->box_change & (Fix::BOX_CHANGE_SIZE | Fix::BOX_CHANGE_SHAPE);
}

/// The acceleration that the fixes gravity give each particle of this rank that is in the group and
/// that forces move (mobile_particles.h), [length/time^2], with its place in the arrays.
std::vector<std::pair<int, cohesion::Vector3> > gravity_of_mobile(LAMMPS* lmp, int groupbit);

/// Bring values of a fix from particles to their ghosts, `size` of each; 0: as many as the fix has.
inline void forward_comm(Comm* comm, Fix* fix, int size = 0) {
#ifdef HISTBITS
  comm->forward_comm(fix, size);
#else
  comm->forward_comm_fix(fix, size);
#endif
}

}  // namespace engine_api
}  // namespace LAMMPS_NS

#endif  // COHESION_FOR_LIGGGHTS

#endif
