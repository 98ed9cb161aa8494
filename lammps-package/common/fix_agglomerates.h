// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS
// clang-format off
FixStyle(agglomerates,FixAgglomerates);
// clang-format on
#else

#ifndef LMP_FIX_AGGLOMERATES_H
#define LMP_FIX_AGGLOMERATES_H

#include <array>
#include <vector>

#include "agglomerates/disjoint_sets.h"
#include "agglomerates/fragment.h"
#include "agglomerates/membership.h"
#include "agglomerates/size_statistics.h"
#include "common/bound_pairs.h"
#include "common/engine_api.h"

namespace LAMMPS_NS {

/// fix ID group agglomerates N ...: connected sets of bound particles, their sizes and how long
/// particles belong to one. Doc: docs/lammps-package/fix_agglomerates.md
///
/// Every rank joins the bound pairs that it has into sets. Then the smallest label and the position
/// of the first particle propagate from owners to ghosts and through the bonds until nothing
/// changes. The fragments of an agglomerate are merged on the rank that its label belongs to, and
/// its size is sent back; no rank has them all.
class FixAgglomerates : public engine_api::StyleFix, public BoundPairsReader {
 public:
  FixAgglomerates(class LAMMPS*, int, char**);
  ~FixAgglomerates() override;

  int setmask() override;
  void init() override;
  void setup_post_neighbor() override { post_neighbor(); }
  void post_neighbor() override;
  void setup(int) override;
  void end_of_step() override;
  double compute_scalar() override { return compute_vector(0); }
  double compute_vector(int) override;
  double compute_array(int, int) override;
  void* extract(const char*, int&) override;

  int pack_forward_comm(int, int*, double*, int, int*) override;
  void unpack_forward_comm(int, int, double*) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  void write_restart(FILE*) override;
  void restart(char*) override;
  int pack_restart(int, double*) override;
  void unpack_restart(int, int) override;
  int maxsize_restart() override { return 2; }
  int size_restart(int) override { return 2; }
  double memory_usage() override;

 private:
  void read_keywords(int, char**);
  void find_agglomerates(double elapsed);
  void join_bound_pairs();
  bool propagate_labels();
  std::vector<cohesion::agglomerates::Fragment> own_fragments();
  void store_extents(const std::vector<cohesion::agglomerates::Extent>&);
  void compute_statistics(const std::vector<cohesion::agglomerates::Fragment>&, double elapsed);
  void add_durations();

  std::vector<imageint> list_images;  // of own particles, when the list of neighbours was made
  std::vector<const BoundPairs*> sources;
  std::vector<std::array<int, 2> > pairs;
  cohesion::agglomerates::DisjointSets sets;
  std::vector<int> bound;  // particles and ghosts with a partner
  std::vector<double> set_label, set_wraps;
  std::vector<int> set_fragment;  // index of the fragment of a set with own particles, by its root
  std::vector<cohesion::Vector3> set_shift;  // from a position in the box to the unfolded one

  double* label = nullptr;      // per atom and ghost
  double** position = nullptr;  // per atom and ghost: unfolded
  double** of_each = nullptr;   // per atom: agglomerate, its size, radius of gyration
  cohesion::agglomerates::Membership* since = nullptr;  // per atom

  bool held_only = false;  // partners are pairs that would not part by themselves
  cohesion::agglomerates::SizeDistribution distribution;
  struct FragmentTotals {
    double time = 0.0;  // since the fix was defined
    cohesion::agglomerates::TimeWeightedSize size;
    double durations = 0.0, finished = 0.0;
  } totals;
  bigint last_step = -1;  // the last sample; -1: none yet
  bigint last_look = -1;  // the step for which particles know their agglomerate
  double number = 0.0, particles = 0.0, largest = 0.0, group_size = 0.0, gyration = 0.0,
         unfolded = 0.0, wrapping = 0.0;
};

}  // namespace LAMMPS_NS

#endif
#endif
