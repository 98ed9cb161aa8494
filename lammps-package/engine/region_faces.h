// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_REGION_FACES_H
#define COHESION_REGION_FACES_H

#include <cmath>
#include <string>

#include "contact_solver/wall.h"
#include "lammps.h"

namespace LAMMPS_NS {

class Region;

/// The surface of a static LAMMPS region as walls: each face acts through its tangent plane at the
/// point nearest to the particle's centre. A particle inside the region may touch several faces,
/// one outside it touches the nearest point, which may be on an edge.
class RegionFaces {
 public:
  using WallPoint = cohesion::contact_solver::WallPoint;
  using WallState = cohesion::contact_solver::WallState;
  using RelativeWallMotion = cohesion::contact_solver::RelativeWallMotion;

  /// Stops LAMMPS, with `where` in front of the message, where the region cannot be a wall.
  RegionFaces(LAMMPS* lmp, const std::string& where, const std::string& id);

  const std::string& id() const { return id_; }
  /// Largest number of contacts of one particle, each with a history.
  int count() const { return count_; }
  /// A number that differs for a region elsewhere, or of another shape.
  double fingerprint() const { return fingerprint_; }
  /// Finds the region again as a run begins. Stops LAMMPS if it does not exist, or differs.
  void require_unchanged(const std::string& where);
  /// The same within a run, as a step begins.
  void refresh(const std::string& where) {
    if (found() != region_) require_unchanged(where);
  }

  /// Of the faces near a centre: the smallest radius of curvature, infinite for flat ones,
  /// [length], and whether their centre of curvature is on the particle's side.
  struct Curvature {
    double radius;
    bool is_concave;
  };

  /// Sets points[face] for all count() faces. A face that is `reach` [length] or farther away has
  /// an infinite distance; behind the region all distances are negative. Returns the curvature of
  /// the faces within `reach`.
  Curvature find(const cohesion::Vector3& centre, const WallState& now, double reach,
                 WallPoint* points) const;
  /// Whether a centre is in front of the region and farther than `reach` from all its faces.
  bool is_far(const cohesion::Vector3& centre, const WallState& now, double reach) const;

  /// The motion of the wall at `point` relative to a particle, as Wall::relative_motion(), with the
  /// turn of the normal from the last step to this one.
  RelativeWallMotion relative_motion(const cohesion::Vector3& centre,
                                     const cohesion::Vector3& velocity, const WallPoint& point,
                                     const WallState& now, double last_step) const;
  /// Whether the particle came from the back of the face at `point` in the last step.
  bool has_passed(const cohesion::Vector3& centre, const cohesion::Vector3& velocity,
                  const WallPoint& point, const WallState& now, double last_step) const;
  /// Where a face ends at an open one, its contact continues around the open edge. Returns the face
  /// whose history continues on the face `to`, or -1. in_range(face): whether its history is in
  /// range.
  template <class InRange>
  int handed_over(const WallPoint* points, const InRange& in_range, int& to) const {
    int from = -1;
    to = -1;
    for (int face = 0; is_open_ && face < count_; face++) {
      const bool is_near = std::isfinite(points[face].distance);
      if (!is_near && in_range(face)) from = face;
      if (is_near && !in_range(face)) to = face;
    }
    return to < 0 ? -1 : from;
  }

 private:
  Region* found() const;
  void require_static(const std::string& where) const;
  void require_aperiodic(const std::string& where) const;
  template <class What>
  void for_each_sample(const What& what) const;
  double size() const;
  void check_directions(const std::string& where) const;
  double sampled_curvature_radius() const;
  int contacts_at(const cohesion::Vector3& at, double reach) const;
  cohesion::Vector3 in_region(const cohesion::Vector3& centre, const WallState& now) const;
  cohesion::Vector3 normal_before(const cohesion::Vector3& centre,
                                  const cohesion::Vector3& velocity, const WallPoint& point,
                                  const WallState& now, double last_step) const;
  double depth(const cohesion::Vector3& at) const;
  double measured_fingerprint() const;
  void drop_edges_of_ends(WallPoint* points) const;

  LAMMPS* lmp_;
  std::string id_;
  Region* region_ = nullptr;
  int count_ = 0;
  bool is_open_ = false;
  bool is_cone_ = false;
  double curvature_per_number_ = 0.5;  // radius of curvature over LAMMPS' number of a contact
  double fingerprint_ = 0.0;
  double smallest_curvature_radius_;  // of an open region, [length]
};

}  // namespace LAMMPS_NS

#endif
