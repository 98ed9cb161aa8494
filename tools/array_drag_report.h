// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "array_drag_request.h"
#include "drag/drag_closure.h"
#include "drag/drag_law.h"
#include "drag/size_mixture.h"
#include "lattice_boltzmann/steady_drag.h"
#include "named_table.h"

namespace cohesion::tools {

/// Numbers of independent arrays, or of the spheres of one.
class Sample {
 public:
  void add(double value) { values_.push_back(value); }
  std::size_t count() const { return values_.size(); }
  double mean() const {
    double sum = 0.0;
    for (const double v : values_) sum += v;
    return sum / static_cast<double>(count());
  }
  /// Standard deviation; of two or more.
  double scatter() const {
    const double middle = mean();
    double squares = 0.0;
    for (const double v : values_) squares += (v - middle) * (v - middle);
    return std::sqrt(squares / static_cast<double>(count() - 1));
  }
  double error() const { return scatter() / std::sqrt(static_cast<double>(count())); }

 private:
  std::vector<double> values_;
};

/// F* of a closure at a superficial Reynolds number: with d, the density and the speed 1.
inline double drag_of(const drag::Closure& closure, double solid, double reynolds) {
  const double eps = 1.0 - solid, viscosity = 1.0 / reynolds;
  return drag::DragLaw(closure).per_solid_volume(eps, 1.0 / eps, 1.0, 1.0, viscosity) /
         (18.0 * viscosity * eps);
}

/// Gathers what flows through arrays have given, and prints it.
class ArrayDragReport {
 public:
  explicit ArrayDragReport(const ArrayDragRequest& request) : r_(request) {
    if (!r_.each.empty()) {
      each_ = opened("--each", r_.each);
      each_ << "array,x,y,z,diameter,Fx,Fy,Fz\n";
    }
    if (!r_.slice.empty()) opened("--slice", r_.slice);
  }

  /// A flow through the array with the number `n`.
  void add(int n, const lattice_boltzmann::Array& array,
           const lattice_boltzmann::FlowSettings& settings,
           const lattice_boltzmann::SteadyDrag& found) {
    using namespace lattice_boltzmann;
    solid_ = solid_fraction(array);
    sauter_ = sauter_mean(array);
    nodes_ = volume(array);
    updates_ += nodes_ * static_cast<double>(found.steps);
    steps_ += found.steps;
    balance_ = std::max(balance_, found.balance);
    if (found.swing > 0.0) swings_.add(found.swing);
    reynolds_.add(reynolds(found, array, settings));
    mean_.add(mean_drag(found, array, settings));
    std::map<double, Sample> sizes;
    for (std::size_t s = 0; s < array.spheres.size(); s++) {
      sizes[2.0 * array.spheres[s].radius].add(drag_on(found, array, settings, s));
      write_sphere(
          n, array.spheres[s], found.forces[s],
          6.0 * pi * settings.viscosity * array.spheres[s].radius * size_of(found.superficial));
    }
    spheres_ = static_cast<double>(array.spheres.size());
    for (const auto& [diameter, drags] : sizes) {
      sizes_[diameter].add(drags.mean());
      if (drags.count() > 1) scatter_[diameter].add(drags.scatter());
    }
    add_moments(array);
    // Resistance by the force that drives and the velocity it leads to, for --tensor.
    rows_.push_back({found.body_force, found.superficial});
    drag_unit_ = (1.0 - solid_) * nodes_ / spheres_ / (3.0 * pi * settings.viscosity * sauter_);
  }

  /// Rows x y speed/U in the plane z = half the box; spheres have 0.
  void write_slice(const lattice_boltzmann::DrivenFlow& flow,
                   const lattice_boltzmann::Array& array) const {
    using namespace lattice_boltzmann;
    std::ofstream out = opened("--slice", r_.slice);
    const int z = array.nodes[2] / 2;
    const double speed = size_of(rows_.back().superficial);
    out << "x,y,speed\n";
    for (int y = 0; y < array.nodes[1]; y++)
      for (int x = 0; x < array.nodes[0]; x++) {
        const std::size_t node = flow.grid().index(x, y, z);
        const bool fluid = flow.walls().is_fluid(node);
        out << x << ',' << y << ','
            << (fluid ? size_of(flow.flow().velocity_at(node)) / speed : 0.0) << '\n';
      }
  }

  void print(double seconds) const {
    if (r_.csv) std::puts("name,value");
    const double re = reynolds_.mean();
    print("phi", solid_);
    print("diameter", sauter_);
    print("spheres", spheres_);
    print("arrays", r_.arrays);
    print("Re", re);
    print("F", mean_.mean());
    if (mean_.count() > 1) print("F_error", mean_.error());
    if (swings_.count() > 0) {
      print("unsteady", static_cast<double>(swings_.count()));
      print("F_error_of_time", swings_.mean() * mean_.mean());
    }
    print("K", mean_.mean() / (1.0 - solid_));
    print("error_of_balance", balance_);
    for (const drag::Closure& closure : drag::closures)
      print("F_" + std::string(closure.name), drag_of(closure, solid_, std::max(re, 1e-3)));
    print_sizes(std::max(re, 1e-3));
    if (r_.tensor) print_tensor();
    print("steps", static_cast<double>(steps_));
    print("million_updates_a_second", 1e-6 * updates_ / seconds);
    print("seconds", seconds);
  }

 private:
  struct Driven {
    lattice_boltzmann::Vector force, superficial;
  };

  static std::ofstream opened(const std::string& option, const std::string& path) {
    std::ofstream out(path);
    if (!out) throw std::runtime_error(option + " " + path + ": cannot be written");
    return out;
  }

  void print(const std::string& name, double value) const {
    std::printf(r_.csv ? "%s,%.17g\n" : "%-28s %.5g\n", name.c_str(), value);
  }

  void write_sphere(int n, const lattice_boltzmann::FixedSphere& sphere,
                    const lattice_boltzmann::Vector& force, double unit) {
    if (r_.each.empty()) return;
    each_ << n + 1;
    for (const double x : sphere.centre) each_ << ',' << x;
    each_ << ',' << 2.0 * sphere.radius;
    for (const double f : force) each_ << ',' << f / unit;
    each_ << '\n';
  }

  void add_moments(const lattice_boltzmann::Array& array) {
    double second = 0.0, third = 0.0, fourth = 0.0;
    for (const auto& s : array.spheres) {
      const double d = 2.0 * s.radius;
      second += d * d;
      third += d * d * d;
      fourth += d * d * d * d;
    }
    around_ = drag::SizesAround::from_sums(second, third, fourth);
  }

  /// The drag of each size, and what the laws of mixtures say of it with the closure that goes with
  /// them.
  void print_sizes(double re) const {
    const drag::Closure& beetstra = find_by_name(drag::closures, "drag law", "beetstra");
    int n = 0;
    for (const auto& [diameter, drags] : sizes_) {
      const std::string which = "_" + std::to_string(++n);
      if (sizes_.size() > 1) {
        print("diameter" + which, diameter);
        print("F" + which, drags.mean());
        if (drags.count() > 1) print("F_error" + which, drags.error());
        const double y = diameter / around_.sauter;
        for (const drag::MixtureLaw& law : drag::mixture_laws)
          if (law.mixes)
            print("F_" + std::string(law.name) + which,
                  y * y * drag::mixed_drag(law, 1.0 - solid_, diameter, around_) *
                      drag_of(beetstra, solid_, re));
      }
      if (scatter_.count(diameter) > 0) print("scatter" + which, scatter_.at(diameter).mean());
    }
  }

  /// The mean over arrays of F with F . U in place of F U: the force that drives along each axis is
  /// that of a flow with U along it.
  void print_tensor() const {
    const char axes[] = "xyz";
    const std::size_t arrays = rows_.size() / 3;
    double mean[3][3] = {};
    for (std::size_t n = 0; n < arrays; n++) {
      double mobility[3][3], inverse[3][3];
      for (int d = 0; d < 3; d++)
        for (int k = 0; k < 3; k++)
          mobility[k][d] = rows_[3 * n + d].superficial[k] / rows_[3 * n + d].force[d];
      invert(mobility, inverse);
      for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
          mean[i][j] += drag_unit_ * inverse[i][j] / static_cast<double>(arrays);
    }
    for (int i = 0; i < 3; i++)
      for (int j = i; j < 3; j++)
        print(std::string("F_") + axes[i] + axes[j], 0.5 * (mean[i][j] + mean[j][i]));
  }

  static void invert(const double (&a)[3][3], double (&b)[3][3]) {
    const auto minor = [&](int i, int j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      return a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
    };
    const double determinant =
        a[0][0] * minor(0, 0) + a[0][1] * minor(0, 1) + a[0][2] * minor(0, 2);
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) b[j][i] = minor(i, j) / determinant;
  }

  ArrayDragRequest r_;
  std::ofstream each_;
  double solid_ = 0.0, sauter_ = 0.0, nodes_ = 0.0, spheres_ = 0.0, updates_ = 0.0;
  double balance_ = 0.0, drag_unit_ = 0.0;
  long steps_ = 0;
  drag::SizesAround around_{};
  Sample swings_, reynolds_, mean_;
  std::map<double, Sample> sizes_, scatter_;  // by diameter
  std::vector<Driven> rows_;
};

}  // namespace cohesion::tools
