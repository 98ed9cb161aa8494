// SPDX-License-Identifier: BSD-3-Clause
// array-drag: the drag on fixed spheres in a periodic box, measured by a lattice-Boltzmann flow.
// Manual: docs/tools/array-drag.md

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "cohesion_version.h"
#include "drag/drag_closure.h"
#include "drag/drag_law.h"
#include "given_once.h"
#include "lattice_boltzmann/arrays.h"
#include "lattice_boltzmann/steady_drag.h"

namespace {

using namespace cohesion;
using namespace cohesion::lattice_boltzmann;

struct Request {
  std::string kind = "sc", file;
  double phi = 0.0, diameter = 16.0, speed = 0.02, reynolds = 0.0, tolerance = 1e-6;
  std::vector<double> box;
  std::array<double, 3> direction{1.0, 0.0, 0.0};
  bool csv = false;
};

/// Rows of x y z d in the units of --box, made `diameter` spacings of the Sauter mean.
Array array_of_file(const Request& r) {
  std::ifstream in(r.file);
  if (!in) throw std::runtime_error("--spheres " + r.file + ": cannot be read");
  std::vector<std::array<double, 4>> rows;
  for (std::array<double, 4> row; in >> row[0] >> row[1] >> row[2] >> row[3];) rows.push_back(row);
  if (!in.eof() || rows.empty())
    throw std::runtime_error("--spheres " + r.file + ": row " + std::to_string(rows.size() + 1) +
                             " is not x y z diameter");
  double squares = 0.0, cubes = 0.0;
  for (const auto& row : rows) {
    squares += row[3] * row[3];
    cubes += row[3] * row[3] * row[3];
  }
  // The edges decide, for the box to be a whole number of nodes; cubes alone fit exactly.
  const double scale = std::lround(r.diameter * squares / cubes * r.box[0]) / r.box[0];
  Array array;
  for (int k = 0; k < 3; k++) {
    array.nodes[k] = static_cast<int>(std::lround(scale * r.box[k]));
    require(std::abs(array.nodes[k] / (scale * r.box[k]) - 1.0) < 1e-9, "edge of the box", r.box[k],
            "edges must be as whole numbers of nodes are; take another --diameter, or a cube");
  }
  for (const auto& row : rows)
    array.spheres.push_back(
        {{scale * row[0], scale * row[1], scale * row[2]}, 0.5 * scale * row[3]});
  return array;
}

Array array_of(const Request& r) {
  if (!r.file.empty()) return array_of_file(r);
  return cubic_array(find_by_name(cubic_arrays, "array", r.kind), r.phi, r.diameter);
}

/// F* of a closure at a superficial Reynolds number: with d, the density and the speed 1.
double drag_of(const drag::Closure& closure, double solid, double reynolds) {
  const double eps = 1.0 - solid, viscosity = 1.0 / reynolds;
  return drag::DragLaw(closure).per_solid_volume(eps, 1.0 / eps, 1.0, 1.0, viscosity) /
         (18.0 * viscosity * eps);
}

/// The flow without inertia takes any force; with inertia the force is set anew until Re is as
/// asked.
std::pair<SteadyDrag, Course> measured(const Request& r, const Array& array, const Told& told) {
  const double size = size_of(r.direction);
  double squares = 0.0, cubes = 0.0;
  for (const FixedSphere& s : array.spheres) {
    squares += s.radius * s.radius;
    cubes += s.radius * s.radius * s.radius;
  }
  const double d = 2.0 * cubes / squares;
  const double solid = 4.0 / 3.0 * pi * cubes / Grid(array.nodes).volume();
  const bool inertia = r.reynolds > 0.0;
  Course course{inertia ? r.speed * d / r.reynolds : 0.1, {}, r.tolerance};
  // From F_total/V = 18 mu phi F* U/((1 - phi) d^2), by the first closure.
  const double target = inertia ? r.speed : 1e-6;
  double force = 18.0 * course.viscosity * solid * target / ((1.0 - solid) * d * d) *
                 drag_of(drag::closures.front(), solid, inertia ? r.reynolds : 1e-3);
  for (int round = 0;; round++) {
    for (int k = 0; k < 3; k++) course.body_force[k] = force * r.direction[k] / size;
    SteadyDrag found = steady_drag(array, course, told);
    const double off = size_of(found.superficial) / target;
    if (!inertia || std::abs(off - 1.0) < 0.01 || round == 5) return {found, course};
    force /= off;
  }
}

}  // namespace

int main(int argc, char** argv) {
  Request request;
  CLI::App app{
      "Drag on fixed spheres in a periodic box, by a lattice-Boltzmann flow.\n"
      "Manual: docs/tools/array-drag.md"};
  app.set_version_flag("--version", "array-drag, Cohesion " COHESION_VERSION);
  std::vector<std::string> kinds;
  for (const CubicArray& kind : cubic_arrays) kinds.push_back(kind.name);
  auto* kind = app.add_option("--array", request.kind, "cubic array")
                   ->check(CLI::IsMember(kinds))
                   ->capture_default_str();
  auto* phi = app.add_option("--phi", request.phi, "fraction of solid of the array");
  auto* file =
      app.add_option("--spheres", request.file, "file of rows x y z diameter, in place of it")
          ->excludes(kind)
          ->excludes(phi);
  auto* box =
      app.add_option("--box", request.box, "edges of the box of --spheres, from 0")->expected(3);
  file->needs(box);
  box->needs(file);
  app.add_option("--diameter", request.diameter, "Sauter mean in lattice spacings, nearly")
      ->check(CLI::Range(4.0, 1000.0))
      ->capture_default_str();
  app.add_option("--re", request.reynolds, "U d/nu, superficial, to 1 %; 0: without inertia")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  app.add_option("--speed", request.speed, "superficial, in spacings per step, with --re")
      ->check(CLI::Range(1e-4, 0.1))
      ->capture_default_str();
  app.add_option("--direction", request.direction, "of the flow")->capture_default_str();
  app.add_option("--tolerance", request.tolerance, "of the velocity, when the flow is steady")
      ->check(CLI::Range(1e-12, 1e-2))
      ->capture_default_str();
  app.add_flag("--csv", request.csv, "name,value with all digits");
  try {
    app.parse(argc, argv);
    tools::require_given_once(app, argc, argv);
    if (request.file.empty() && phi->count() == 0) throw CLI::RequiredError("--phi, or --spheres");
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }

  try {
    require(size_of(request.direction) > 0.0, "direction", 0.0, "must not be the null vector");
    const Array array = array_of(request);
    const auto begin = std::chrono::steady_clock::now();
    const auto seconds = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    double shown = 0.0;
    const auto [found, course] = measured(request, array, [&](long steps, double left) {
      if (seconds() < shown + 5.0) return;
      shown = seconds();
      std::fprintf(stderr, "array-drag: %.0f s, %ld steps, change yet to come %.1e of %.0e\n",
                   shown, steps, left, request.tolerance);
    });
    const double re = reynolds(found, course), drag = mean_drag(found, array, course);
    const auto print = [&](const std::string& name, double value) {
      std::printf(request.csv ? "%s,%.17g\n" : "%-24s %.5g\n", name.c_str(), value);
    };
    if (request.csv) std::puts("name,value");
    print("phi", found.solid);
    print("diameter", found.diameter);
    print("spheres", static_cast<double>(array.spheres.size()));
    print("Re", re);
    print("F", drag);
    print("K", drag / (1.0 - found.solid));
    print("error_of_balance", found.balance);
    for (const drag::Closure& closure : drag::closures)
      print("F_" + std::string(closure.name), drag_of(closure, found.solid, std::max(re, 1e-3)));
    print("steps", static_cast<double>(found.steps));
    print("seconds", seconds());
  } catch (const std::exception& error) {
    std::cerr << "array-drag: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
