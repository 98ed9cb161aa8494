// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "lattice_boltzmann/arrays.h"

namespace cohesion::tools {

/// What the user of array-drag asks for. Lengths in spacings, where nothing else is said.
struct ArrayDragRequest {
  std::string kind, file, each, slice;
  double phi = 0.0, diameter = 16.0, speed = 0.02, reynolds = 0.0, tolerance = 1e-5;
  std::vector<double> box, sizes{1.0};
  std::vector<int> counts{54};
  std::uint64_t seed = 1;
  int arrays = 1, threads = 0;
  long most_steps = 200000, average = 0;
  std::array<double, 3> direction{1.0, 0.0, 0.0};
  bool csv = false, tensor = false;

  bool random() const { return kind == "random"; }
};

inline void add_array_options(CLI::App& app, ArrayDragRequest& r) {
  std::vector<std::string> kinds{"random"};
  for (const auto& kind : lattice_boltzmann::cubic_arrays) kinds.push_back(kind.name);
  auto* kind = app.add_option("--array", r.kind, "sc, bcc, fcc, or random, which hard spheres make")
                   ->check(CLI::IsMember(kinds));
  auto* phi = app.add_option("--phi", r.phi, "fraction of solid of the array");
  kind->needs(phi);
  phi->needs(kind);
  app.add_option("--counts", r.counts, "random: spheres of each size; default 54")
      ->check(CLI::Range(1, 1000000))
      ->needs(kind);
  app.add_option("--sizes", r.sizes, "random: diameters, of any unit; default 1")
      ->check(CLI::PositiveNumber)
      ->needs(kind);
  app.add_option("--seed", r.seed, "random: of the first array; default 1")->needs(kind);
  app.add_option("--arrays", r.arrays, "random: so many, one after the other; default 1")
      ->check(CLI::Range(1, 10000))
      ->needs(kind);
  auto* file = app.add_option("--spheres", r.file,
                              "file of rows x y z diameter, or a dump, in place of --array")
                   ->excludes(kind);
  app.add_option("--box", r.box, "edges of the box of rows, from 0")->expected(3)->needs(file);
  app.add_option("--diameter", r.diameter, "Sauter mean in lattice spacings, nearly")
      ->check(CLI::Range(4.0, 1000.0))
      ->capture_default_str();
}

inline void add_flow_options(CLI::App& app, ArrayDragRequest& r) {
  auto* re = app.add_option("--re", r.reynolds, "U d/nu, superficial; 0: without inertia")
                 ->check(CLI::Range(0.0, 1000.0))
                 ->capture_default_str();
  app.add_option("--speed", r.speed, "superficial, in spacings per step, with --re")
      ->check(CLI::Range(1e-4, 0.1))
      ->capture_default_str()
      ->needs(re);
  auto* direction =
      app.add_option("--direction", r.direction, "of the flow")->capture_default_str();
  app.add_flag("--tensor", r.tensor, "along the three axes, one after the other; without inertia")
      ->excludes(re)
      ->excludes(direction);
  app.add_option("--tolerance", r.tolerance, "of what is yet to come, when the flow is steady")
      ->check(CLI::Range(1e-12, 1e-2))
      ->capture_default_str();
  app.add_option("--average", r.average,
                 "steps: a flow that is not steady by then is measured in the mean of as many more")
      ->check(CLI::Range(1000l, 100000000l))
      ->needs(re);
  app.add_option("--most-steps", r.most_steps, "after which a flow that is not steady is given up")
      ->check(CLI::Range(1000l, 100000000l))
      ->capture_default_str();
}

inline void add_output_options(CLI::App& app, ArrayDragRequest& r) {
  app.add_option("--threads", r.threads, "default: one for each core")->check(CLI::Range(1, 1024));
  app.add_option("--each", r.each, "file for the drag on each sphere");
  app.add_option("--slice", r.slice,
                 "file for the speed in the middle of the last array, z = const.");
  app.add_flag("--csv", r.csv, "name,value with all digits");
}

}  // namespace cohesion::tools
