// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_LIGGGHTS_API_H
#define COHESION_LIGGGHTS_API_H

#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "irregular.h"
#include "lammps.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "universe.h"
#include "update.h"
#include "vector3.h"

// What lammps-package/common/engine_api.h has for styles of both engines, for LIGGGHTS 3.8.

namespace LAMMPS_NS {
namespace engine_api {

// ---- styles of both engines: what each is for is said in engine_api.h ----

/// LIGGGHTS calls no fix when it has made a list of neighbours, but all that want to be called
/// before the forces.
constexpr int POST_NEIGHBOR = FixConst::PRE_FORCE;
constexpr int GROW = 0, RESTART = 1;  // of Atom::add_callback()
constexpr int WITH_FORCES = FixConst::PRE_FORCE | FixConst::POST_FORCE;
constexpr const char* NO_GHOST_VELOCITIES = "communicate ... vel no";

/// A fix with the virtual functions that LAMMPS has.
class StyleFix : public Fix {
 public:
  StyleFix(LAMMPS* lammps, int narg, char** arg) : Fix(lammps, narg, arg) {}

  virtual void post_neighbor() {}
  virtual void setup_post_neighbor() {}
  virtual int pack_forward_comm(int, int*, double*, int, int*) { return 0; }
  virtual void unpack_forward_comm(int, int, double*) {}

  void setup_pre_force(int) final { setup_post_neighbor(); }
  void pre_force(int) final {
    if (neighbor->lastcall == update->ntimestep) post_neighbor();
  }
  int pack_comm(int n, int* list, double* buf, int pbc_flag, int* pbc) final {
    pack_forward_comm(n, list, buf, pbc_flag, pbc);
    return comm_forward;  // numbers of one particle, where LAMMPS wants those of all
  }
  void unpack_comm(int n, int first, double* buf) final { unpack_forward_comm(n, first, buf); }
};

class StyleCompute : public Compute {
 public:
  /// first: where the engine's own keywords of all computes begin.
  StyleCompute(LAMMPS* lammps, int narg, char** arg, int first = 3)
      : Compute(lammps, first, narg, arg) {}
};

/// Shears the engine's box, in place of fix deform, which keeps to itself what is needed of it.
/// LIGGGHTS takes a fix for one that changes velocities at the faces by the name `deform` alone; so
/// this one says it when a run begins, when the engine has looked for that name.
class BoxFix : public StyleFix {
 public:
  BoxFix(LAMMPS* lammps, int narg, char** arg)
      : StyleFix(lammps, narg, arg), irregular(new Irregular(lammps)), h_rate(domain->h_rate) {
    no_change_box = box_change_shape = restart_global = restart_pbc = 1;
    force_reneighbor = 1;
    next_reneighbor = -1;
    // The engine's models forget a contact that has ended only where they see the gap: else its
    // friction goes on when both touch again, until lists are made new, whenever that is.
    neighbor->register_contact_dist_factor(SEEN_APART);
  }
  ~BoxFix() override { clear_rates(); }

  /// Stops when a wall stands across the flow or its gradient; warns when the script has taken back
  /// that gaps are seen.
  void init() override;

 protected:
  std::unique_ptr<Irregular> irregular;
  double* h_rate;

 private:
  /// Distance, over the sum of the radii, up to which models see a pair that has parted: as far as
  /// those of the engine ask for that sum elastic energy.
  static constexpr double SEEN_APART = 1.01;

  void refuse_walls() const;
  void warn_of_unseen_gaps() const;
  void clear_rates() {
    for (int k = 0; k < 6; k++) h_rate[k] = 0.0;
  }
};

inline double numeric(const char* file, int line, char* word, LAMMPS* lmp) {
  return lmp->force->numeric(file, line, word);
}
inline int inumeric(const char* file, int line, char* word, LAMMPS* lmp) {
  return lmp->force->inumeric(file, line, word);
}
/// Rank 0 shows it and writes it to the log.
inline void tell(LAMMPS* lmp, const std::string& message) {
  if (lmp->comm->me != 0) return;
  for (FILE* out : {lmp->screen, lmp->logfile})
    if (out) fputs(message.c_str(), out);
}
/// To one error in five the engine adds a jest, which it prints from memory that it has freed: a
/// line of no readable characters. It does so where its version has the word PUBLIC in it, which
/// nothing reads any more once an error has begun.
inline void print_no_jest(const LAMMPS* lmp) {
  static char version[] = "";
  lmp->universe->version = version;
}
inline void error_of_all(const LAMMPS* lmp, const char* file, int line, const std::string& text) {
  print_no_jest(lmp);
  lmp->error->all(file, line, text.c_str());
}
inline void error_of_one(const LAMMPS* lmp, const char* file, int line, const std::string& text) {
  print_no_jest(lmp);
  lmp->error->one(file, line, text.c_str());
}
inline bool writes_restart(Output* output, bigint step) { return output->restart_requested(step); }

inline bool changes_box(const Fix* fix) { return fix->box_change_size || fix->box_change_shape; }

std::vector<std::pair<int, cohesion::Vector3>> gravity_of_mobile(LAMMPS* lmp, int groupbit);

/// Bring values of a fix from particles to their ghosts.
inline void forward_comm(Comm* comm, Fix* fix) { comm->forward_comm_fix(fix); }

}  // namespace engine_api
}  // namespace LAMMPS_NS

#endif
