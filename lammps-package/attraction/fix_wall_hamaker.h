// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/hamaker,FixWallHamaker);
// clang-format on
#else

#ifndef LMP_FIX_WALL_HAMAKER_H
#define LMP_FIX_WALL_HAMAKER_H

#include <string>
#include <vector>

#include "contact_solver/wall.h"
#include "hamaker/forms.h"
#include "soft_contacts/contact_advice.h"
#include "soft_contacts/wall_history.h"

namespace LAMMPS_NS {

/// fix wall/hamaker hamaker A cutoff H_cut H_out [form name] [asperity r_a | roughness rms lambda]
/// xplane lo hi ...: Hamaker attraction of spheres to plane walls, by the law of the pairs. Doc:
/// docs/lammps-package/pair_hamaker.md
class FixWallHamaker : public FixWithWallHistory {
 public:
  FixWallHamaker(class LAMMPS*, int, char**);
  ~FixWallHamaker() override;

  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;

 private:
  void read(int, char**);
  template <class Law>
  void attract(const Law&);
  void stop_at_passage(int i) const;
  std::vector<FixWallHamaker*> all_of_style() const;
  void give_advice();
  void add_advice(const RunConditions&, AdviceOfStyles&);
  void sum();

  cohesion::hamaker::HamakerParameters given;
  const cohesion::hamaker::Form* form;
  cohesion::hamaker::AnyLaw law;
  std::vector<cohesion::contact_solver::Wall> planes;
  LammpsWatch watch;
  bool gives_advice = false;  // for all fixes of this style
  cohesion::advice::WarningFilter advice_filter;
  double mine[4];  // energy, force on the walls
  double total[4];
  bool summed = false;
};

}  // namespace LAMMPS_NS

#endif
#endif
