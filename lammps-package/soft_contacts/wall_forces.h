// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_WALL_FORCES_H
#define COHESION_WALL_FORCES_H

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <vector>

#include "vector3.h"

namespace LAMMPS_NS {

/// Forces on each wall of a fix in a step: three components of the whole force, three of its
/// adhesive part. They are summed over the ranks when an output needs them.
class WallForces {
 public:
  static constexpr int EACH = 6;

  void start(int walls) {
    mine_.assign(EACH * walls, 0.0);
    total_ = mine_;
  }
  void clear() {
    std::fill(mine_.begin(), mine_.end(), 0.0);
    summed_ = false;
  }
  void add(int wall, const cohesion::Vector3& force, const cohesion::Vector3& adhesion) {
    double* const on = &mine_[EACH * wall];
    add_to(on, force);
    add_to(on + 3, adhesion);
  }

  /// The sums over all ranks, wall after wall. All ranks call it, once after clear().
  const std::vector<double>& all(MPI_Comm world) {
    if (!summed_)
      MPI_Allreduce(mine_.data(), total_.data(), static_cast<int>(mine_.size()), MPI_DOUBLE,
                    MPI_SUM, world);
    summed_ = true;
    return total_;
  }
  /// The sum over all walls of one of the EACH numbers. All ranks call it.
  double sum(MPI_Comm world, int which) {
    double force = 0.0;
    for (std::size_t k = which; k < mine_.size(); k += EACH) force += all(world)[k];
    return force;
  }
  /// Writes a fix's part of a restart file: `values` and all(). All ranks call it, rank 0 writes.
  void write_restart(FILE* fp, MPI_Comm world, std::vector<double> values) {
    values.insert(values.end(), all(world).begin(), all(world).end());
    int me = 0;
    MPI_Comm_rank(world, &me);
    if (me != 0) return;
    const int size = static_cast<int>(values.size() * sizeof(double));
    fwrite(&size, sizeof(int), 1, fp);
    fwrite(values.data(), sizeof(double), values.size(), fp);
  }
  /// Rank 0 restores all().
  void put_back(const double* values) { std::copy_n(values, mine_.size(), mine_.begin()); }

 private:
  static void add_to(double* to, const cohesion::Vector3& a) {
    to[0] += a.x;
    to[1] += a.y;
    to[2] += a.z;
  }

  std::vector<double> mine_;   // of this process
  std::vector<double> total_;  // of all
  bool summed_ = false;
};

}  // namespace LAMMPS_NS

#endif
