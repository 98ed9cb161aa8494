// SPDX-License-Identifier: GPL-2.0-only
#ifdef PAIR_CLASS
// clang-format off
PairStyle(hard/squarewell,PairHardSquareWell);
PairStyle(hard/square_well,FormerPairHardSquareWell);
// clang-format on
#else

#ifndef LMP_PAIR_HARD_SQUARE_WELL_H
#define LMP_PAIR_HARD_SQUARE_WELL_H

#include <array>
#include <string>
#include <vector>

#include "common/bound_pairs.h"
#include "common/former_style.h"
#include "hard_sphere/event_simulation.h"
#include "input/hard_contact_from_script.h"
#include "input/type_pair_table.h"
#include "pair.h"

namespace LAMMPS_NS {

/// pair_style hard/squarewell: hard spheres with square wells, whose impulses act at their exact
/// times within the step. src/hard_sphere and src/square_well contain the laws and the event-driven
/// simulation; FixHardEvents runs it. Doc: docs/lammps-package/pair_hard_squarewell.md
class PairHardSquareWell : public Pair, public BoundPairs {
 public:
  explicit PairHardSquareWell(class LAMMPS*);

  /// That of the script, alone or in a hybrid style; nullptr if there is none.
  static PairHardSquareWell* in_use(class Force*);

  ~PairHardSquareWell() override;

  void compute(int, int) override;
  void settings(int, char**) override;
  void coeff(int, char**) override;
  void init_style() override;
  double init_one(int, int) override;
  void write_restart(FILE*) override;
  void read_restart(FILE*) override;
  void write_restart_settings(FILE*) override;
  void read_restart_settings(FILE*) override;
  void append_bound(std::vector<std::array<int, 2> >&) const override;
  void append_held(std::vector<std::array<int, 2> >&) const override;

  const cohesion::hard_sphere::EventRules& rules() const { return rules_; }
  const std::string& record_file() const { return record_file_; }
  const HardContact& contact(int i, int j) const { return contacts_(i, j); }
  /// Whether this style acts between two types; in pair_style hybrid it acts between some only.
  bool acts_between(int i, int j) const { return active_[contacts_.number(i, j)]; }
  /// Reach of the neighbour list beyond the range of a contact, in addition to the skin, [length].
  double list_reach() const;

 private:
  void allocate();
  void set_contact(int i, int j, const HardContact&);

  cohesion::hard_sphere::EventRules rules_;
  std::string record_file_;
  TypePairTable<HardContact> contacts_;
  std::vector<double> largest_radius_;
  class FixHardEvents* event_fix_;
  std::vector<bool> active_;  // by pair of types
};

inline constexpr char former_hard_square_well[] = "hard/square_well";
using FormerPairHardSquareWell = FormerStyle<PairHardSquareWell, former_hard_square_well>;

}  // namespace LAMMPS_NS

#endif
#endif
