// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "script_reader.h"

namespace cohesion::tools {

/// Time step, gravity and speeds of a LIGGGHTS script, in its units.
class ScriptRun {
 public:
  void read(const ScriptCommand& c) {
    const std::string& name = c.words[0];
    if (name == "timestep") {
      step_ = c.number(1, "the time step");
      timestep_ = c;
    }
    if (name == "region" && c.has(2)) regions_[c.words[1]] = extents_of(c);
    if (name == "create_box" && c.has(2)) box_ = regions_[c.words[2]];
    if (name != "fix" || !c.has(3)) return;
    if (c.words[3] == "gravity") read_gravity(c);
    if (c.words[3].rfind("insert/", 0) == 0) read_insertion(c);
  }

  const std::optional<double>& step() const { return step_; }
  const std::optional<ScriptCommand>& timestep() const { return timestep_; }
  const std::optional<double>& gravity() const { return gravity_; }
  /// Of the fastest insertion.
  const std::optional<double>& insertion_speed() const { return insertion_speed_; }
  /// sqrt(2 |g| h) after a fall through the box, 0 if box or gravity is unknown. h: extent of the
  /// box along gravity, or its diagonal if the direction is unknown.
  double fall_speed() const {
    if (!box_ || !gravity_) return 0.0;
    double height = 0.0;
    if (direction_)
      for (std::size_t k = 0; k < 3; k++) height += std::abs((*direction_)[k]) * (*box_)[k];
    else
      height = length_of(*box_);
    return std::sqrt(2.0 * std::abs(*gravity_) * height);
  }

 private:
  using Vector = std::array<double, 3>;

  static double length_of(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }
  static bool is_finite(const Vector& v) { return std::isfinite(v[0] + v[1] + v[2]); }
  /// NaN: not known.
  static double number_or_none(const ScriptCommand& c, std::size_t k) {
    const auto value = c.has(k) ? ScriptCommand::number_of(c.words[k]) : std::nullopt;
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
  }

  /// Empty: not known.
  static std::optional<Vector> extents_of(const ScriptCommand& c) {
    const auto number = [&](std::size_t k) { return number_or_none(c, k); };
    const std::string& style = c.words[2];
    Vector extents;
    extents.fill(std::numeric_limits<double>::quiet_NaN());
    if (style == "block" || style == "prism")
      extents = {number(4) - number(3), number(6) - number(5), number(8) - number(7)};
    if (style == "prism") {
      extents[0] += std::abs(number(9)) + std::abs(number(10));
      extents[1] += std::abs(number(11));
    }
    if (style == "cylinder" && c.has(3)) {
      extents.fill(2.0 * number(6));
      const std::size_t axis = std::string("xyz").find(c.words[3]);
      if (axis < extents.size()) extents[axis] = number(8) - number(7);
    }
    return is_finite(extents) ? std::optional(extents) : std::nullopt;
  }

  void read_gravity(const ScriptCommand& c) {
    gravity_ = c.number(4, "the acceleration");
    direction_.reset();
    const Vector v{number_or_none(c, 6), number_or_none(c, 7), number_or_none(c, 8)};
    const double length = length_of(v);
    if (c.has(5) && c.words[5] == "vector" && length > 0.0)
      direction_ = Vector{v[0] / length, v[1] / length, v[2] / length};
  }

  void read_insertion(const ScriptCommand& c) {
    const std::size_t at = c.find("vel");
    if (!c.has(at + 1) || (c.words[at + 1] != "constant" && c.words[at + 1] != "uniform")) return;
    double square = 0.0;
    for (std::size_t k = at + 2; k < at + 5; k++) {
      const double v = c.number(k, "a velocity");
      square += v * v;
    }
    if (square > 0.0)
      insertion_speed_ = std::max(insertion_speed_.value_or(0.0), std::sqrt(square));
  }

  std::optional<ScriptCommand> timestep_;
  std::optional<double> step_, gravity_, insertion_speed_;
  std::map<std::string, std::optional<Vector>> regions_;
  std::optional<Vector> box_, direction_;
};

}  // namespace cohesion::tools
