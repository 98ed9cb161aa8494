// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hard_sphere/bodies.h"
#include "hard_sphere/box_flow.h"
#include "hard_sphere/cells.h"
#include "hard_sphere/renumbering.h"

namespace cohesion::hard_sphere {

/// A sphere that a body is in when it gets it, and that flows with the box.
struct Home {
  Vector3 place;     ///< at time 0, of the flow that goes through it, [length]
  Vector3 velocity;  ///< of that flow, [length/time]
  double radius;     ///< [length]
  double made;       ///< when, [time]
  // How the cells know it.
  Vector3 folded;      ///< the place, folded into the box, [length]
  Cells::Folds folds;  ///< how many boxes away it is from there
  int cell;
  int size;  ///< class of sizes

  Vector3 at(double time) const { return place + time * velocity; }
};

/// The homes of all bodies, and which of them are near each other. Cells find those; each class of
/// sizes has its own: so a few large bodies do not make wide cells for many small ones.
class Homes {
 public:
  /// The radius of a home over that of the largest body of its class of sizes, [1].
  double margin = 0.6;
  /// How many bodies the box has, those included that only other processes have; bounds the cells.
  double bodies_of_box = 0.0;

  /// When a body needs a new home: when it leaves this one, or when that is too old, [time].
  double leave_time(int body, const Flight& flight) const {
    const Home& home = homes_[body];
    const Vector3 r = flight.place - home.at(flight.since);
    const Vector3 w = flight.velocity - home.velocity;
    // Before it could meet another there, whatever both round to.
    constexpr double early = 1.0 - 1e-9;
    const double border = early * home.radius * home.radius;
    const double leave = flight.since + time_to_rise(dot(r, w), dot(w, w), dot(r, r) - border);
    return flow_ ? std::min(leave, home.made + flow_.lifetime()) : leave;
  }

  /// Whether a body that is at a place now is in its home.
  bool is_home(int body, const Vector3& place, double now) const {
    const Home& home = homes_[body];
    const Vector3 r = place - home.at(now);
    return dot(r, r) <= home.radius * home.radius && !(flow_ && now < home.made);
  }

 protected:
  using Folds = Cells::Folds;

  /// Gives all bodies homes. `largest_ratio`: PairRules::largest_ratio(). In a box that flows a
  /// home lasts for `lifetime` [time].
  void make_homes(const PeriodicBox& box, const std::vector<Body>& bodies,
                  const std::vector<Flight>& flights, double largest_ratio, double now,
                  double lifetime) {
    flow_.set(box, lifetime);
    bodies_ = &bodies;
    largest_ratio_ = largest_ratio;
    homes_.resize(bodies.size());
    set_classes(now);
    for (int i = 0; i < static_cast<int>(homes_.size()); i++) set_home(i, flights[i], now);
    fill_cells();
  }

  /// Time 0 is at the time `now` from here on. Homes that rest know no time.
  void set_clock_of_homes_back(double now) {
    if (!flow_) return;
    flow_.set_clock_back(now);
    steep_until_ = -never;
    for (Home& home : homes_) {
      home.made -= now;
      put_at(home, home.at(now), 0.0);
    }
    fill_cells();
  }

  const BoxFlow& flow() const { return flow_; }
  const Body& body(int i) const { return (*bodies_)[i]; }
  const Home& home(int body) const { return homes_[body]; }

  /// Gives a body a new home, in which others look for it from the time `since` on. It is found by
  /// the former one, too, until take_out().
  void move_home(int body, const Flight& flight, double now, double since) {
    set_home(body, flight, now);
    homes_[body].made = since;
    put_in(body);
  }

  /// Gives bodies other numbers. New ones have no home yet, those that are gone have been taken
  /// out.
  void arrange_homes(const Renumbering& to) {
    for (const int n : to.changed()) {
      if (to.old(n) < 0) continue;
      const Home& home = homes_[to.old(n)];
      cells_.renumber(home.cell, home.folded, to.old(n), home.folds, n);
    }
    to.apply(homes_);
  }

  /// Whether the class of sizes of a body that is new has been there since make_homes(); sets it.
  bool find_size(int i) {
    const double radius = body(i).radius;
    const int size = size_of(radius);
    if (size >= static_cast<int>(classes_.size()) || radius > classes_[size].largest_radius)
      return false;
    homes_[i].size = size;
    return true;
  }

  /// A body is not found by a home that it has or had any more.
  void take_out(int body, const Home& home) {
    cells_.remove(home.cell, home.folded, body, home.folds);
  }

  /// Calls near(j, boxes, square) for all homes that may be so near to that of a body that the two
  /// could meet: those of the images of j that are so many boxes away, with the square of the least
  /// distance of the two places from now on for a lifetime.
  template <class Near>
  void find(int i, double now, const Near& near) {
    if (now > steep_until_) look_at_box(now);
    for (const SizeClass& c : classes_)
      if (c.members > 0) find_in(c, i, now, near);
  }

  /// Whether i and the image of j with a displacement [length] could come nearer to each other than
  /// a distance [length] while they are in their homes, from now on for a lifetime.
  bool can_be_within(double distance, int i, int j, const Vector3& displacement, double now) const {
    const Vector3 r = homes_[j].place - homes_[i].place + displacement;
    const double reach = distance + homes_[i].radius + homes_[j].radius;
    return flow_.least_square(r, now) < reach * reach;
  }

  double bytes_of_homes() const {
    return cells_.bytes() + static_cast<double>(homes_.capacity() * sizeof(Home));
  }

 private:
  struct SizeClass {
    double largest_radius = 0.0;
    double home_radius = 0.0;
    int members = 0;
    int cells[3] = {1, 1, 1};
    int first_cell = 0;
  };
  struct Range {  // of cells
    int first, last;
  };

  /// Sizes that differ by a factor of up to two are a class.
  void set_classes(double now) {
    least_radius_ = never;
    for (const Body& b : *bodies_)
      if (b.radius > 0.0) least_radius_ = std::min(least_radius_, b.radius);
    classes_.clear();
    for (std::size_t i = 0; i < homes_.size(); i++) {
      const double radius = (*bodies_)[i].radius;
      const int size = size_of(radius);
      if (size >= static_cast<int>(classes_.size())) classes_.resize(size + 1);
      SizeClass& c = classes_[size];
      c.largest_radius = std::max(c.largest_radius, radius);
      c.members++;
      homes_[i].size = size;
    }
    look_at_box(now);
    number_of_cells_ = 0;
    for (SizeClass& c : classes_) {
      c.home_radius = margin * c.largest_radius;
      set_cells(c);
      c.first_cell = number_of_cells_;
      number_of_cells_ += c.cells[0] * c.cells[1] * c.cells[2];
    }
  }

  int size_of(double radius) const {
    return radius > least_radius_ ? static_cast<int>(std::log2(radius / least_radius_)) : 0;
  }

  /// Notes how far a reach goes in the box from now on for the lifetimes of two homes.
  void look_at_box(double now) {
    const double later = flow_ ? now + 2.0 * flow_.lifetime() : now;
    const auto first = PeriodicBox::steepness(flow_.box().at(now));
    const auto last = PeriodicBox::steepness(flow_.box().at(later));
    for (int k = 0; k < 3; k++) steepness_[k] = std::max(first[k], last[k]);
    steep_until_ = flow_ ? now + flow_.lifetime() : never;
  }

  /// Cells as wide as two of the class can be apart and be neighbours, but not more than the
  /// bodies are.
  void set_cells(SizeClass& c) {
    const double reach = 2.0 * (largest_ratio_ * c.largest_radius + c.home_radius);
    double number[3], all = 1.0;
    for (int k = 0; k < 3; k++) {
      number[k] = reach > 0.0 ? std::max(1.0, std::floor(1.0 / (reach * steepness_[k]))) : 1.0;
      all *= number[k];
    }
    const double most = 8.0 + 2.0 * bodies_of_box;
    const double shrink = all > most ? std::cbrt(all / most) : 1.0;
    for (int k = 0; k < 3; k++)
      c.cells[k] = static_cast<int>(std::max(1.0, std::floor(number[k] / shrink)));
  }

  /// Puts a home ahead of a body on its flight, by a part of the radius: so it is in there for
  /// longer.
  void set_home(int body, const Flight& flight, double now) {
    Home& home = homes_[body];
    home.radius = classes_[home.size].home_radius;
    home.made = now;
    const Vector3 place = flight.at(now);
    constexpr double ahead = 0.7;
    const Vector3 w = flight.velocity - flow_.velocity(flow_.fraction(place, now));
    const double speed = norm(w);
    put_at(home, speed > 0.0 ? place + (ahead * home.radius / speed) * w : place, now);
  }

  /// Puts a home at a place [length] at a time. Outside the box in a direction that is not periodic
  /// it is in the cell at the end.
  void put_at(Home& home, const Vector3& place, double now) {
    const PeriodicBox& box = flow_.box();
    const Vector3 fraction = flow_.fraction(place, now);
    home.place = flow_ ? flow_.place(fraction) : place;
    home.velocity = flow_.velocity(fraction);
    const double f[] = {fraction.x, fraction.y, fraction.z};
    const SizeClass& c = classes_[home.size];
    double folds[3];
    int cells[3];
    for (int k = 0; k < 3; k++) {
      folds[k] = box.periodic[k] ? std::floor(f[k]) : 0.0;
      home.folds[k] = static_cast<int>(folds[k]);
      cells[k] = static_cast<int>(
          std::clamp(std::floor((f[k] - folds[k]) * c.cells[k]), 0.0, c.cells[k] - 1.0));
    }
    home.folded = home.place - box.edges * Vector3{folds[0], folds[1], folds[2]};
    home.cell = c.first_cell + cells[0] + c.cells[0] * (cells[1] + c.cells[1] * cells[2]);
  }

  void put_in(int body) {
    const Home& home = homes_[body];
    cells_.add(home.cell, home.folded, body, home.folds);
  }

  void fill_cells() {
    std::vector<int> sizes(number_of_cells_, 0);
    int most = 0;
    for (const Home& home : homes_) most = std::max(most, ++sizes[home.cell]);
    cells_.reset(number_of_cells_, most + 1);
    for (int i = 0; i < static_cast<int>(homes_.size()); i++) put_in(i);
  }

  /// Those of a class. Cells behind an end of the box are those of the next box.
  template <class Near>
  void find_in(const SizeClass& c, int i, double now, const Near& near) {
    const Home& home = homes_[i];
    const double reach =
        largest_ratio_ * (body(i).radius + c.largest_radius) + home.radius + c.home_radius;
    const Vector3 fraction = flow_.fraction(home.folded, 0.0);
    const Range zs = range(c, 2, fraction.z, reach * steepness_[2]);
    const Range ys = range(c, 1, fraction.y, reach * steepness_[1]);
    const Range xs = range(c, 0, fraction.x, reach * steepness_[0]);
    for (int z = zs.first; z <= zs.last; z++) {
      const int fold_z = boxes_off(z, c.cells[2]);
      for (int y = ys.first; y <= ys.last; y++) {
        const int fold_y = boxes_off(y, c.cells[1]);
        const int row = c.first_cell + c.cells[0] * (y - fold_y * c.cells[1] +
                                                     c.cells[1] * (z - fold_z * c.cells[2]));
        for (int x = xs.first; x <= xs.last;) {
          const int fold_x = boxes_off(x, c.cells[0]);
          const int last = std::min(xs.last, (fold_x + 1) * c.cells[0] - 1);
          look_through(row + x - fold_x * c.cells[0], last - x + 1, i, {fold_x, fold_y, fold_z},
                       now, reach * reach, near);
          x = last + 1;
        }
      }
    }
  }

  /// The cells along an axis that are at most `way` of the box away from a place in it.
  Range range(const SizeClass& c, int axis, double place, double way) const {
    const int first = static_cast<int>(std::floor((place - way) * c.cells[axis]));
    const int last = static_cast<int>(std::floor((place + way) * c.cells[axis]));
    if (flow_.box().periodic[axis]) return {first, last};
    return {std::clamp(first, 0, c.cells[axis] - 1), std::clamp(last, 0, c.cells[axis] - 1)};
  }

  static int boxes_off(int cell, int cells) {
    return cell >= 0 && cell < cells ? 0 : static_cast<int>(std::floor(double(cell) / cells));
  }

  /// Those in cells that follow each other, all of the box that `folds` says, with a square below
  /// `most`.
  template <class Near>
  void look_through(int first_cell, int cells, int i, const Folds& folds, double now, double most,
                    const Near& near) {
    Vector3 from = homes_[i].folded;
    if (folds[0] != 0 || folds[1] != 0 || folds[2] != 0)
      from -= flow_.box().edges * Vector3{double(folds[0]), double(folds[1]), double(folds[2])};
    const Folds& of_i = homes_[i].folds;
    const auto found = [&](int j, const Folds& of_j, double square) {
      if (j == i) return;
      near(j,
           Folds{folds[0] + of_i[0] - of_j[0], folds[1] + of_i[1] - of_j[1],
                 folds[2] + of_i[2] - of_j[2]},
           square);
    };
    flow_.with_least_square(now, [&](const auto& square) {
      cells_.look_through(first_cell, cells, from, most, square, found);
    });
  }

  BoxFlow flow_;
  const std::vector<Body>* bodies_ = nullptr;
  double largest_ratio_ = 1.0;
  double least_radius_ = never;
  std::array<double, 3> steepness_{};
  double steep_until_ = -never;  // until when steepness_ is right
  std::vector<SizeClass> classes_;
  std::vector<Home> homes_;
  int number_of_cells_ = 0;
  Cells cells_;
};

}  // namespace cohesion::hard_sphere
