// SPDX-License-Identifier: GPL-2.0-only
#include "engine/region_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "common/engine_api.h"
#include "common/message.h"
#include "domain.h"
#include "error.h"
#include "region.h"

using namespace LAMMPS_NS;
using cohesion::norm;
using cohesion::Vector3;
using cohesion::contact_solver::turning_of;

static constexpr double INFINITE = std::numeric_limits<double>::infinity();
/// LAMMPS uses 1e20 for INF: larger extents than this are infinite, [length].
static constexpr double FAR = 1e19;
/// Samples along each line of for_each_sample().
static constexpr int PLACES = 200;

/// The nearest point of a contact of LAMMPS, as seen from the centre of a particle.
static Vector3 to_surface(const Region::Contact& c) { return {-c.delx, -c.dely, -c.delz}; }

/// Towards the particle; exact along an axis, so that flat faces act as planes do to the last bit.
static Vector3 normal_of(const Vector3& separation, double distance) {
  return {-separation.x / distance, -separation.y / distance, -separation.z / distance};
}

RegionFaces::RegionFaces(LAMMPS* lmp, const std::string& where, const std::string& id)
    : lmp_(lmp), id_(id), region_(found()), smallest_curvature_radius_(INFINITE) {
  require_static(where);
  is_open_ = region_->openflag != 0;
  is_cone_ = std::string(region_->style) == "cone";
  if (std::string(region_->style) == "sphere") curvature_per_number_ = 1.0;
  // Outside there is one contact, with the nearest point.
  count_ = region_->interior || is_open_ ? region_->cmax + is_open_ : 1;
  fingerprint_ = measured_fingerprint();
  require_aperiodic(where);
  check_directions(where);
  if (is_open_) smallest_curvature_radius_ = sampled_curvature_radius();
}

Region* RegionFaces::found() const { return engine_api::region_of(lmp_->domain, id_); }

void RegionFaces::require_static(const std::string& where) const {
  const std::string of = where + ": region " + id_;
  if (!region_)
    lmp_->error->all(FLERR, of + " does not exist; define it before the fix, and keep it");
  const std::string style = region_->style;
  const auto is_of = [&style](const std::vector<std::string>& styles) {
    return std::find(styles.begin(), styles.end(), style) != styles.end();
  };
  if (!is_of({"block", "cone", "cylinder", "plane", "prism", "sphere"}))
    lmp_->error->all(FLERR, of + " of style " + style +
                                " cannot be a wall; use block, cone, cylinder, plane, prism or "
                                "sphere, several 'region' keywords for several of them");
  if (region_->dynamic_check())
    lmp_->error->all(FLERR, of + " moves or changes its shape by variables; define it at rest, and "
                                 "move it by wiggle or translate of this fix");
  if (region_->openflag && !region_->interior)
    lmp_->error->all(FLERR, of + " with open faces acts on both sides; define it with side in");
  if (region_->openflag && !is_of({"cone", "cylinder"}))
    lmp_->error->all(FLERR, of + " of style " + style +
                                " has open faces, at whose corners LAMMPS finds one of two edges; "
                                "use xplane, yplane and zplane, or an open cylinder or cone");
}

/// Particles beyond a periodic side would not feel a face there.
void RegionFaces::require_aperiodic(const std::string& where) const {
  const double extents[][2] = {{region_->extent_xlo, region_->extent_xhi},
                               {region_->extent_ylo, region_->extent_yhi},
                               {region_->extent_zlo, region_->extent_zhi}};
  for (int d = 0; d < 3; d++) {
    const bool is_infinite = region_->bboxflag && extents[d][0] <= -FAR && extents[d][1] >= FAR;
    if (lmp_->domain->periodicity[d] && !is_infinite)
      lmp_->error->all(FLERR, where + ": region " + id_ + " ends in the periodic direction " +
                                  "xyz"[d] +
                                  "; use 'boundary f' there, or INF INF for a region with side in");
  }
}

/// Calls what(at, points, curvature) for those of 800 places that are inside the region.
template <class What>
void RegionFaces::for_each_sample(const What& what) const {
  if (!region_->bboxflag) return;
  const double low[] = {region_->extent_xlo, region_->extent_ylo, region_->extent_zlo};
  const double high[] = {region_->extent_xhi, region_->extent_yhi, region_->extent_zhi};
  const auto along = [&](int d, double part) {
    if (low[d] <= -FAR) return (high[d] >= FAR ? 0.0 : high[d]) - part * size();
    return low[d] + part * std::min(high[d] - low[d], size());
  };
  // Along three lines, of which one is next to the axis of a cylinder or cone, and of a
  // low-discrepancy sequence: multiples of 1/g, 1/g^2, 1/g^3 with g^4 = g + 1, modulo 1.
  for (int k = 0; k < 4 * PLACES; k++) {
    const auto part = [k](int d, double step) {
      if (k >= 3 * PLACES) return k * step - std::floor(k * step);
      return k / PLACES == d ? (k % PLACES + 0.5) / PLACES : 0.501;
    };
    const Vector3 at{along(0, part(0, 0.8191725134)), along(1, part(1, 0.6710436067)),
                     along(2, part(2, 0.5497004779))};
    if (!region_->inside(at.x, at.y, at.z)) continue;
    std::vector<WallPoint> here(count_);
    const Curvature curvature = find(at, {}, FAR, here.data());
    what(at, here, curvature);
  }
}

/// Largest finite extent of the region, [length].
double RegionFaces::size() const {
  const double extents[] = {region_->extent_xhi - region_->extent_xlo,
                            region_->extent_yhi - region_->extent_ylo,
                            region_->extent_zhi - region_->extent_zlo};
  double largest = 0.0;
  for (const double extent : extents)
    if (extent < FAR) largest = std::max(largest, extent);
  return largest > 0.0 ? largest : 1.0;
}

/// Stops LAMMPS where a face has a wrong direction: LAMMPS gives the ends of a cone along y the
/// direction z. Half-way to its nearest point a face is at half the distance. The round-off of a
/// distance is 1e-16 of the size; the limit is 1e7 times this.
void RegionFaces::check_directions(const std::string& where) const {
  const double limit = 1e-9 * size();
  std::vector<WallPoint> half_way(count_);
  for_each_sample([&](const Vector3& at, const std::vector<WallPoint>& here, Curvature) {
    for (int face = 0; face < count_; face++) {
      if (!(here[face].distance < FAR)) continue;
      const Vector3 nearer = at + 0.5 * here[face].separation;
      if (!region_->inside(nearer.x, nearer.y, nearer.z)) continue;  // of an end wider than the end
      find(nearer, {}, FAR, half_way.data());
      const double error = half_way[face].distance - 0.5 * here[face].distance;
      if (!(std::abs(error) <= limit))
        lmp_->error->all(FLERR, where + ": region " + id_ +
                                    ": this LAMMPS has a wrong direction for one of its faces; "
                                    "use a cone along x or z");
    }
  });
}

/// Of the samples next to the axis, one is inside within 3/400 of the length from the narrow end of
/// a cone. The nearest point of the side is not farther from that end. The result is thus too large
/// by at most 3/400 of the difference between the radii of the ends.
double RegionFaces::sampled_curvature_radius() const {
  double smallest = INFINITE;
  for_each_sample([&](const Vector3&, const std::vector<WallPoint>&, Curvature curvature) {
    smallest = std::min(smallest, curvature.radius);
  });
  return smallest;
}

void RegionFaces::require_unchanged(const std::string& where) {
  region_ = found();
  require_static(where);
  require_aperiodic(where);
  if (measured_fingerprint() != fingerprint_)
    lmp_->error->all(FLERR,
                     where + ": region " + id_ +
                         " differs from the region at the time of the fix: restore it, or use "
                         "a new fix ID");
}

/// Hash (FNV-1a) of which faces are open and of the distances from points in four directions, at
/// sizes of 1e-6 to 1e6 length units. It has 53 bits, so that a restart file stores it as a number.
double RegionFaces::measured_fingerprint() const {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&hash](double value) {
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3U;
  };
  add(region_->interior);
  for (int face = 0; face < 6; face++) add(region_->open_faces[face]);
  for (double size = 1e-6; size < 2e6; size *= 10.0)
    for (const Vector3& to : {Vector3{1.1, 0.7, 0.3}, Vector3{-0.9, 0.4, 1.2},
                              Vector3{0.2, -1.3, 0.8}, Vector3{-0.6, -0.5, -1.4}}) {
      const double distance = depth(size * to);
      if (distance < FAR) add(distance);
    }
  constexpr int BITS = std::numeric_limits<double>::digits;
  return static_cast<double>((hash ^ (hash >> BITS)) & ((std::uint64_t{1} << BITS) - 1));
}

/// Distance of a place from the nearest face, on either side of it.
double RegionFaces::depth(const Vector3& at) const {
  double x[] = {at.x, at.y, at.z};
  const bool is_inside = region_->inside(x[0], x[1], x[2]) != 0;
  const int n = is_inside ? region_->surface_interior(x, FAR) : region_->surface_exterior(x, FAR);
  double nearest = INFINITE;
  for (int k = 0; k < n; k++) nearest = std::min(nearest, region_->contact[k].r);
  return nearest;
}

/// Writes the contacts of a centre to region_->contact and returns their number; none behind a
/// region without open faces. Region::surface() evaluates both sides of an open region: for a
/// centre exactly in the plane of an open end both find contacts, and write them to the same
/// entries.
int RegionFaces::contacts_at(const Vector3& at, double reach) const {
  double x[] = {at.x, at.y, at.z};
  const bool is_inside = region_->inside(x[0], x[1], x[2]) != 0;
  if (!is_open_ && is_inside != (region_->interior != 0)) return 0;
  return is_inside ? region_->surface_interior(x, reach) : region_->surface_exterior(x, reach);
}

/// LAMMPS divides by the distance from the axis of a cone. An offset of 1e-13 of the box length
/// avoids 0; in boxes below 1 m it is below 1e-3 of H_cut = 4e-10 m.
Vector3 RegionFaces::in_region(const Vector3& centre, const WallState& now) const {
  const Vector3 at = centre - now.displacement;
  if (!is_cone_) return at;
  const double offset = 1e-13 * (norm(at) + lmp_->domain->xprd);
  return at + offset * Vector3{0.83, 0.59, 0.71};
}

RegionFaces::Curvature RegionFaces::find(const Vector3& centre, const WallState& now, double reach,
                                         WallPoint* points) const {
  std::fill_n(points, count_, WallPoint{INFINITE, {}, now.velocity});
  const Vector3 at = in_region(centre, now);
  const bool is_inside = region_->inside(at.x, at.y, at.z) != 0;
  Curvature curvature{INFINITE, is_inside};
  if (!is_open_ && is_inside != (region_->interior != 0)) {
    const double behind = -depth(at);
    std::fill_n(points, count_, WallPoint{behind, {}, now.velocity});
    return curvature;
  }
  const int n = contacts_at(at, reach);
  for (int k = 0; k < n; k++) {
    const Region::Contact& c = region_->contact[k];
    const int face = is_inside ? c.iwall : count_ - 1;
    points[face] = {c.r, to_surface(c), now.velocity};
    if (c.radius != 0.0)
      curvature.radius = std::min(curvature.radius, curvature_per_number_ * std::abs(c.radius));
  }
  if (is_open_ && !is_inside && n > 0)  // LAMMPS finds one point of the rim of an open end
    curvature = {smallest_curvature_radius_, true};
  if (is_cone_ && is_inside) drop_edges_of_ends(points);
  return curvature;
}

/// Where the nearest point of the side of a cone is on the edge of an end, the end alone acts: at
/// an obtuse angle, what touches the end there would touch the edge too.
void RegionFaces::drop_edges_of_ends(WallPoint* points) const {
  WallPoint& side = points[2];
  for (const WallPoint* end : {points, points + 1}) {
    if (!(std::isfinite(side.distance) && end->distance < FAR && end->distance > 0.0)) continue;
    const double beside = dot(side.separation, end->separation) / end->distance;
    if (beside > end->distance * (1.0 - 1e-9)) side.distance = INFINITE;
  }
}

bool RegionFaces::is_far(const Vector3& centre, const WallState& now, double reach) const {
  const Vector3 at = in_region(centre, now);
  return region_->match(at.x, at.y, at.z) && contacts_at(at, reach) == 0;
}

/// The normal of a face, towards the particle, where the centre was a step before: of the contact
/// there whose normal is nearest to that of `point`, or that of `point` if there is none.
Vector3 RegionFaces::normal_before(const Vector3& centre, const Vector3& velocity,
                                   const WallPoint& point, const WallState& now,
                                   double last_step) const {
  const Vector3 normal = normal_of(point.separation, point.distance);
  const Vector3 way = last_step * (velocity - now.velocity);
  const Vector3 at = in_region(centre - way, now);
  const int n = contacts_at(at, 2.0 * (point.distance + norm(way)));
  Vector3 before = normal;
  double largest = -INFINITE;
  for (int k = 0; k < n; k++) {
    const Region::Contact& c = region_->contact[k];
    if (!(c.r > 0.0)) continue;
    const Vector3 other = normal_of(to_surface(c), c.r);
    if (!(dot(other, normal) > largest)) continue;
    largest = dot(other, normal);
    before = other;
  }
  return before;
}

RegionFaces::RelativeWallMotion RegionFaces::relative_motion(const Vector3& centre,
                                                             const Vector3& velocity,
                                                             const WallPoint& point,
                                                             const WallState& now,
                                                             double last_step) const {
  RelativeWallMotion motion{point.separation, point.velocity - velocity, now.acceleration};
  if (last_step == 0.0) return motion;
  const Vector3 normal = normal_of(point.separation, point.distance);
  const Vector3 turned = normal - normal_before(centre, velocity, point, now, last_step);
  motion.add(turning_of(normal, turned, velocity - now.velocity, last_step), last_step);
  return motion;
}

bool RegionFaces::has_passed(const Vector3& centre, const Vector3& velocity, const WallPoint& point,
                             const WallState& now, double last_step) const {
  return dot(point.separation, normal_before(centre, velocity, point, now, last_step)) > 0.0;
}
