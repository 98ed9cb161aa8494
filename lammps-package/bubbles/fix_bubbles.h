// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(bubbles,FixBubbles);
// clang-format on
#else

#ifndef LMP_FIX_BUBBLES_H
#define LMP_FIX_BUBBLES_H

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bubbles/population.h"
#include "fix.h"

namespace LAMMPS_NS {

/// fix ID group bubbles N ...: bubbles come from nozzles, merge, break and leave at the top.
/// Doc: docs/lammps-package/fix_bubbles.md
///
/// Every N steps each rank gets a list of all bubbles, sorted by their IDs, and works out by itself
/// what happens to them (src/bubbles): the same everywhere. It then does to its own what is theirs.
class FixBubbles : public Fix {
 public:
  FixBubbles(class LAMMPS*, int, char**);

  int setmask() override;
  void init() override;
  void setup_pre_exchange() override;
  void pre_exchange() override;
  double compute_vector(int) override;
  void write_restart(FILE*) override;
  void restart(char*) override;

 private:
  struct Gathered {
    std::vector<cohesion::bubbles::Bubble> bubbles;  // of all ranks, sorted by ID
    std::vector<int> owner, index;                   // rank, and place in its arrays
  };

  void read_keywords(int, char**);
  int read_nozzles(int, int, char**);
  long highest_id() const;
  cohesion::bubbles::BubbleBox box() const;
  Gathered gather() const;
  std::vector<std::vector<double> > gas_rows(const Gathered&,
                                             const cohesion::bubbles::Events&) const;
  void merge_and_halve(std::vector<std::vector<double> >&, const Gathered&,
                       const cohesion::bubbles::Events&) const;
  void apply(const Gathered&, const cohesion::bubbles::Events&);
  void note_rests(const Gathered&, const cohesion::bubbles::Events&);
  void change(int, const cohesion::bubbles::Bubble&);
  void create(const cohesion::bubbles::Events::New&, int owner, const std::vector<double>& row);
  bool is_mine(const cohesion::Vector3&) const;
  void remove(const std::vector<int>&);
  void tell_engine(long change);

  std::string where;
  cohesion::bubbles::Rules rules;
  std::optional<cohesion::bubbles::Nozzles> nozzles;
  cohesion::bubbles::BubbleTotals totals;
  std::map<long, double> resting;  // until when bubbles do not merge, by ID
  double elapsed = 0.0;            // time since the fix was defined, of all runs
  long next_id = -1;               // -1: not known yet
  bigint last_step;                // at which events were looked for, or the fix began
  int type = 1;
  class FixGasCoupling* coupling = nullptr;  // null without
};

}  // namespace LAMMPS_NS

#endif
#endif
