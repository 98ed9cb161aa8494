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

#include "contact_advice.h"
#include "fix.h"
#include "hamaker/forms.h"

namespace LAMMPS_NS {

/// fix wall/hamaker hamaker A cutoff H_cut H_out [form name] [asperity r_a | roughness rms lambda]
/// xplane lo hi ...: Hamaker attraction of spheres to plane walls, by the law of the pairs. Doc:
/// docs/lammps-package/fix_wall_hamaker.md
class FixWallHamaker : public Fix {
 public:
  FixWallHamaker(class LAMMPS*, int, char**);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;

 private:
  struct Plane {
    int dimension;
    int side;  // +1: particles are above the plane, -1: below
    double position;
  };

  void read(int, char**);
  void read_planes(const std::string& word, char** positions);
  void add_plane(int dimension, int side, const std::string& word, char* text);
  template <class Law>
  void attract(const Law&);
  void give_advice();
  void sum();

  cohesion::hamaker::Parameters given;
  const cohesion::hamaker::Form* form;
  cohesion::hamaker::AnyLaw law;
  std::vector<Plane> planes;
  ContactWatch watch;
  cohesion::advice::GivenAdvice given_advice;
  double mine[4];  // energy, force on the walls
  double total[4];
  bool summed;
};

}  // namespace LAMMPS_NS

#endif
#endif
