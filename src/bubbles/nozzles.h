// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "bubbles/bubble.h"
#include "validation.h"

namespace cohesion::bubbles {

/// Nozzles on a rectangular grid that share a volume flow [length^3/time] and give bubbles of one
/// volume [length^3]. Each owes its share of the flow since the start less what it has given, and
/// gives a bubble when it owes one, unless another is in its place: it then waits, and owes on. The
/// flow is thus kept whatever the size and whatever waits, as long as nozzles get rid of what they
/// owe. Bubbles that wait may grow on: one then has all that is pending, as far as there is room,
/// up to a volume. Where bubbles merge they blow into the one that is in their place. They begin in
/// turn, each with the part of a bubble that spreads the first of all evenly over the time of one.
class Nozzles {
 public:
  /// nx by ny of them about `centre`, `spacing` [length] apart. Throws InvalidParameter.
  Nozzles(int nx, int ny, const Vector3& centre, double spacing, double flow, double volume)
      : flow_(flow), volume_(volume) {
    require(nx > 0, "nozzles along x", nx, "must be 1 or more");
    require(ny > 0, "nozzles along y", ny, "must be 1 or more");
    require_non_negative("spacing of the nozzles", spacing);
    require_non_negative("flow of the nozzles", flow);
    require_positive("volume of a bubble", volume);
    for (int j = 0; j < ny; j++)
      for (int i = 0; i < nx; i++)
        places_.push_back(
            centre + Vector3{(i - 0.5 * (nx - 1)) * spacing, (j - 0.5 * (ny - 1)) * spacing, 0.0});
    const auto n = places_.size();
    for (std::size_t k = 0; k < n; k++) {
      // Neighbours do not follow each other: steps of the golden section around the turn.
      const double turn = 0.6180339887498949 * static_cast<double>(k);
      pending_.push_back(volume * (turn - std::floor(turn)));
    }
  }

  /// Bubbles that wait grow on up to a volume [length^3]. Throws InvalidParameter.
  void grow_up_to(double volume) {
    require(volume >= volume_, "volume that bubbles grow to", volume,
            "must not be below that of a bubble");
    most_ = volume;
  }

  std::size_t count() const { return places_.size(); }
  const Vector3& place(std::size_t k) const { return places_[k]; }
  double volume() const { return volume_; }
  /// Of the largest bubble that they may give.
  double most() const { return std::max(volume_, most_); }

  /// What each nozzle owes [length^3], to be kept with a state.
  std::vector<double>& pending() { return pending_; }

  /// Adds the flow of a time [time].
  void flow_on(double elapsed) {
    for (double& volume : pending_) volume += flow_ * elapsed / static_cast<double>(places_.size());
  }

  /// The volume of the bubble that nozzle k gives now, beside these, and has then given; 0: none.
  double gives(std::size_t k, const std::vector<Bubble>& bubbles, const BubbleBox& box) {
    if (pending_[k] < volume_) return 0.0;
    const double radius = radius_of(volume_);
    double given = std::min(pending_[k], most());
    for (const Bubble& other : bubbles) {
      const double distance = norm(box.between(places_[k], other.position));
      if (distance < radius + other.radius) return 0.0;
      if (given > volume_) given = std::min(given, sphere_volume(distance - other.radius));
    }
    // Where there is room for one and no more, rounding may have taken some of it.
    given = std::max(given, volume_);
    pending_[k] -= given;
    return given;
  }

  /// Which bubble a nozzle blows into, its place in the list, and how much [length^3].
  struct Fed {
    std::size_t bubble;
    double volume;
  };

  /// Whether nozzle k, whose place is taken, blows into the bubble that is there, the nearest one
  /// that it may merge with: one that does not rest at this time, up to a joint volume of
  /// `most_together` [length^3]. `gone`: those of the list that are not there any more.
  std::optional<Fed> feeds(std::size_t k, const std::vector<Bubble>& bubbles,
                           const std::vector<bool>& gone, const BubbleBox& box,
                           double most_together, double time) {
    if (pending_[k] < volume_) return std::nullopt;
    std::optional<Fed> found;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bubbles.size(); i++) {
      const double room = most_together - bubbles[i].volume();
      if (gone[i] || room < volume_ || bubbles[i].rests_until > time) continue;
      const double distance = norm(box.between(places_[k], bubbles[i].position));
      if (distance >= radius_of(volume_) + bubbles[i].radius || distance >= nearest) continue;
      nearest = distance;
      found = Fed{i, std::min({pending_[k], most(), room})};
    }
    if (found) pending_[k] -= found->volume;
    return found;
  }

 private:
  double flow_, volume_, most_ = 0.0;
  std::vector<Vector3> places_;
  std::vector<double> pending_;
};

}  // namespace cohesion::bubbles
