// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_ENGINE_API_H
#define COHESION_ENGINE_API_H

// What the supported LAMMPS versions spell differently; nothing else in the package asks for a
// version. HISTBITS came with the interface that LAMMPS has had since 2022.

#include "comm.h"
#include "lmptype.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "pair.h"

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

#endif
