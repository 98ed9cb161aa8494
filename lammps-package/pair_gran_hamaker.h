// SPDX-License-Identifier: GPL-2.0-only
#ifdef PAIR_CLASS
// clang-format off
PairStyle(gran/hamaker,PairGranHamaker);
// clang-format on
#else

#ifndef LMP_PAIR_GRAN_HAMAKER_H
#define LMP_PAIR_GRAN_HAMAKER_H

#include <vector>

#include "cohesive_contact_from_script.h"
#include "event_stepping/cohesive_contact.h"
#include "pair.h"

namespace LAMMPS_NS {

/// pair_style gran/hamaker: linear spring-dashpot contact with friction and Hamaker adhesion in the
/// event scheme. The laws are in src/event_stepping, src/contact and src/hamaker; doc:
/// docs/lammps-package/pair_gran_hamaker.md
class PairGranHamaker : public Pair {
 public:
  explicit PairGranHamaker(class LAMMPS*);
  ~PairGranHamaker() override;

  void compute(int, int) override;
  void settings(int, char**) override;
  void coeff(int, char**) override;
  void init_style() override;
  double init_one(int, int) override;
  void write_restart(FILE*) override;
  void read_restart(FILE*) override;
  void write_restart_settings(FILE*) override;
  void read_restart_settings(FILE*) override;

 private:
  using Contact = cohesion::event_stepping::CohesiveContact<cohesion::event_stepping::SpherePair>;

  /// A pair that may touch in this step.
  struct Active {
    int i, j;
    int* kept;        // 1 while the pair has a history
    double* history;  // in-range flag, tangential displacement
    cohesion::event_stepping::PairStep alone;
  };

  void allocate();
  int of_types(int i, int j) const { return i * (atom_types + 1) + j; }
  const Contact& contact(int i, int j);
  cohesion::event_stepping::RelativeState on_grid(int i, int j) const;
  void follow_alone();
  template <bool TALLY, bool FRICTION>
  void follow_together();
  void tally_standing();
  void check_radii();

  int atom_types;
  const cohesion::hamaker::Form* form;
  std::vector<CohesiveContactParameters> given;  // by type pair
  std::vector<cohesion::hamaker::AnyLaw> laws;   // by type pair, built at init
  std::vector<std::vector<Contact> > recent;     // by type pair: the contact worked out last
  std::vector<double> largest_radius;            // by type, at init
  std::vector<Active> active;
  double largest_range;  // of adhesion
  double list_reach;     // gap up to which every pair is in the list
  bool friction;         // whether any contact has friction
  class FixEventStep* step;
  class FixNeighHistory* history;
};

}  // namespace LAMMPS_NS

#endif
#endif
