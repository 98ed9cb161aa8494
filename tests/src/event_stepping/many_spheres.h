// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "event_stepping/pair_run.h"
#include "event_stepping/two_pass_contact.h"

namespace cohesion::event_stepping {

/// Equal spheres in a periodic box, or free where its side is 0, stepped as an engine would: kicks
/// and flights by leapfrog. Velocities are those of the half step before.
class ManySpheres {
 public:
  struct Sums {
    double energy, kinetic;
    Vector3 momentum, angular_momentum;
  };

  ManySpheres(const contact::ContactParameters& parameters, const contact::Adhesion& adhesion,
              double dt, double side)
      : ManySpheres(parameters, adhesion, dt, {side, side, side}, ClosestPacking::in_space()) {}
  ManySpheres(const contact::ContactParameters& parameters, const contact::Adhesion& adhesion,
              double dt, const Vector3& sides, const ClosestPacking& packing)
      : contact_(parameters, adhesion, body(), body(), dt, packing),
        dt_(dt),
        sides_(sides),
        friction_(parameters.friction > 0.0 || parameters.rolling_friction > 0.0) {}

  static Body body() { return {thesis::radius, 1.0 / thesis::mass}; }

  void add(const Vector3& x, const Vector3& v, const Vector3& spin = {}) {
    x_.push_back(x);
    v_.push_back(v);
    w_.push_back(spin);
  }
  int size() const { return static_cast<int>(x_.size()); }

  void step() {
    look();
    friction_ ? compute<ContactMemory::with_rolling>() : compute<ContactMemory::normal_only>();
    for (int i = 0; i < size(); i++) x_[i] += dt_ * v_[i];
    first_ = false;
  }

  /// Of the true motion at the grid point that the last step has led to.
  Sums sums() const {
    std::vector<Vector3> u = v_, w = w_;
    Sums s{};
    for (const Near& p : near_) {
      const PairMotion grid = motion(p, v_, w_);
      give(p, contact_.owed<ContactMemory::with_rolling>(grid.relative, p.memory), u, w);
      const StoredEnergies now = contact_.stored(grid, p.memory);
      s.energy += now.spring + now.adhesion + now.tangential_spring + now.rolling_spring;
    }
    for (int i = 0; i < size(); i++) {
      const double inertia = 1.0 / inverse_inertia(body());
      s.kinetic += 0.5 * thesis::mass * dot(u[i], u[i]) + 0.5 * inertia * dot(w[i], w[i]);
      s.momentum += thesis::mass * u[i];
      s.angular_momentum += thesis::mass * cross(x_[i], u[i]) + inertia * w[i];
    }
    s.energy += s.kinetic;
    return s;
  }
  /// Pairs in range of each other.
  long contacts() const {
    return std::count_if(near_.begin(), near_.end(),
                         [](const Near& p) { return p.memory.in_range(); });
  }
  const Vector3& v(int i) const { return v_[i]; }
  long lasting = 0, followed = 0, collisions = 0;  ///< of contacts in all steps

 private:
  using Contact = TwoPassContact<SpherePair>;
  struct Near {
    int i, j;
    ContactMemory memory;
  };
  template <int SIZE>
  struct Followed {
    int pair;
    FollowedStart start;
    FollowedStep<SIZE> step;
  };

  Vector3 apart(Vector3 s) const {
    for (double Vector3::* const k : {&Vector3::x, &Vector3::y, &Vector3::z})
      if (sides_.*k > 0.0) s.*k -= sides_.*k * std::round(s.*k / sides_.*k);
    return s;
  }

  void look() {
    double moved = 0.0;
    fastest_ = 0.0;
    for (int i = 0; i < size(); i++) {
      fastest_ = std::max(fastest_, norm(v_[i]));
      if (!listed_.empty()) moved = std::max(moved, norm(x_[i] - listed_[i]));
    }
    if (!listed_.empty() && 2.0 * moved + 4.0 * dt_ * fastest_ < skin) return;
    listed_ = x_;
    std::vector<Near> old;
    for (const Near& p : near_)
      if (p.memory.phase != ContactMemory::beyond) old.push_back(p);
    near_.clear();
    std::size_t k = 0;
    for (int i = 0; i < size(); i++)
      for (int j = i + 1; j < size(); j++) {
        const Vector3 s = apart(x_[j] - x_[i]);
        const double reach = 2.0 * thesis::radius + skin;
        if (dot(s, s) > reach * reach) continue;
        while (k < old.size() && (old[k].i < i || (old[k].i == i && old[k].j < j))) k++;
        const bool known = k < old.size() && old[k].i == i && old[k].j == j;
        near_.push_back({i, j, known ? old[k].memory : ContactMemory{}});
      }
  }

  PairMotion motion(const Near& p, const std::vector<Vector3>& v,
                    const std::vector<Vector3>& w) const {
    return {{apart(x_[p.j] - x_[p.i]), v[p.j] - v[p.i]}, w[p.i], w[p.j]};
  }
  void give(const Near& p, const Action& a, std::vector<Vector3>& v,
            std::vector<Vector3>& w) const {
    v[p.i] -= (1.0 / thesis::mass) * a.impulse;
    v[p.j] += (1.0 / thesis::mass) * a.impulse;
    w[p.i] += inverse_inertia(body()) * a.torque_i;
    w[p.j] += inverse_inertia(body()) * a.torque_j;
  }

  template <int SIZE>
  void compute() {
    const int n = size();
    std::vector<Vector3> dv(n), dw(n), v = v_, w = w_;
    std::vector<char> disturbed(n, 0), crowded(n, 0), marked(n, 0), has_young(n, 0);
    std::vector<Followed<SIZE>> follow;
    const auto is_disturbed = [&](const Near& p) {
      return contact_.minds_others() && (disturbed[p.i] || disturbed[p.j]);
    };
    const auto add_followed = [&](std::size_t k, const PairMotion& grid) {
      const Near& p = near_[k];
      follow.push_back({static_cast<int>(k), contact_.start<SIZE>(grid, {}, p.memory), {}});
      marked[p.i] = marked[p.j] = 1;
      give(p, contact_.owed<SIZE>(grid.relative, p.memory), v, w);
      followed++;
    };
    std::vector<std::size_t> candidates, old;
    for (std::size_t k = 0; k < near_.size(); k++) {
      Near& p = near_[k];
      const PairMotion grid = motion(p, v_, w_);
      const bool beyond = p.memory.phase == ContactMemory::beyond;
      if (beyond && !contact_.within_reach(grid.relative, dt_ * fastest_)) continue;
      if (first_ && norm(grid.relative.separation) < 2.0 * thesis::radius)
        p.memory = ContactMemory::seen_inside();
      const bool lasted = p.memory.phase == ContactMemory::lasting;
      Action action;
      if (!lasted && contact_.can_last(grid.relative, p.memory, true)) {
        candidates.push_back(k);
        for (const int m : {p.i, p.j})
          if (contact_.is_young(p.memory)) {
            crowded[m] |= has_young[m];
            has_young[m] = 1;
          }
        if (!contact_.is_young(p.memory)) old.push_back(k);
      } else if (lasted &&
                 contact_.one_force().advance_lasting<SIZE>(grid, p.memory, action, nullptr)) {
        give(p, action, dv, dw);
        old.push_back(k);
        lasting++;
      } else {
        if (lasted) contact_.one_force().end_lasting<SIZE>(grid, p.memory, nullptr);
        if (!beyond || contact_.within_reach(grid.relative, 0.0))
          disturbed[p.i] = disturbed[p.j] = 1;
        add_followed(k, grid);
      }
    }
    for (const std::size_t k : old)
      for (const int m : {near_[k].i, near_[k].j}) crowded[m] |= has_young[m];
    for (int i = 0; i < n; i++) disturbed[i] |= crowded[i];
    for (std::size_t k = 0; k < near_.size(); k++) {
      Near& p = near_[k];
      if (p.memory.phase != ContactMemory::lasting || !is_disturbed(p)) continue;
      const PairMotion grid = motion(p, v_, w_);
      const Action a = contact_.one_force().lasting_action<SIZE>(grid, p.memory);
      give(p, {-a.impulse, -a.torque_i, -a.torque_j}, dv, dw);
      lasting--;
      contact_.one_force().end_lasting<SIZE>(grid, p.memory, nullptr);
      add_followed(k, grid);
    }
    for (const std::size_t k : candidates) {
      Near& p = near_[k];
      const PairMotion grid = motion(p, v_, w_);
      Action action;
      if (is_disturbed(p)) {
        add_followed(k, grid);
      } else {
        const bool alone = !crowded[p.i] && !crowded[p.j];
        contact_.one_force().advance_lasting<SIZE>(grid, p.memory, action, nullptr, alone);
        give(p, action, dv, dw);
        lasting++;
      }
    }
    std::vector<Vector3> moved(n), changed(n), spun(n);
    const auto add = [&](const Near& p, const PairMotion& c) {
      moved[p.i] -= 0.5 * c.relative.separation;
      moved[p.j] += 0.5 * c.relative.separation;
      changed[p.i] -= 0.5 * c.relative.velocity;
      changed[p.j] += 0.5 * c.relative.velocity;
      spun[p.i] += c.spin_i;
      spun[p.j] += c.spin_j;
    };
    for (const Near& p : near_) {
      if (p.memory.phase != ContactMemory::lasting || !(marked[p.i] || marked[p.j])) continue;
      const PairMotion grid = motion(p, v_, w_);
      const Action owed = contact_.owed<SIZE>(grid.relative, p.memory);
      give(p, owed, v, w);
      add(p, contact_.lasting_change<SIZE>(
                 grid, contact_.one_force().lasting_action<SIZE>(grid, p.memory), owed, p.memory));
    }
    for (Followed<SIZE>& f : follow) {
      const Near& p = near_[f.pair];
      f.start.truth = motion(p, v, w);
      f.step = contact_.follow<SIZE>(f.start, {}, {}, p.memory.in_range());
    }
    for (const Followed<SIZE>& f : follow) add(near_[f.pair], f.step.change);
    for (Followed<SIZE>& f : follow) {
      Near& p = near_[f.pair];
      const PairMotion& own = f.step.change;
      const PairMotion others{{moved[p.j] - moved[p.i] - own.relative.separation,
                               changed[p.j] - changed[p.i] - own.relative.velocity},
                              spun[p.i] - own.spin_i,
                              spun[p.j] - own.spin_j};
      const bool in = p.memory.in_range();
      f.step = contact_.follow<SIZE>(f.start, others, f.step.rolled(), in);
      give(p, contact_.finish<SIZE>(f.start, others, f.step, p.memory), dv, dw);
      collisions += !in && p.memory.in_range();
    }
    for (int i = 0; i < n; i++) {
      v_[i] += dv[i];
      w_[i] += dw[i];
    }
  }

  static constexpr double skin = 0.1 * 2.0 * thesis::radius;
  Contact contact_;
  double dt_;
  Vector3 sides_;
  bool friction_;
  bool first_ = true;
  double fastest_ = 0.0;
  std::vector<Vector3> x_, v_, w_, listed_;
  std::vector<Near> near_;
};

}  // namespace cohesion::event_stepping
