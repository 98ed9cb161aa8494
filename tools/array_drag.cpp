// SPDX-License-Identifier: BSD-3-Clause
// array-drag: the drag on fixed spheres in a periodic box, measured by a lattice-Boltzmann flow.
// Manual: docs/tools/array-drag.md

#ifdef COHESION_WITH_THREADS
#include <omp.h>
#endif

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "array_drag_report.h"
#include "array_drag_request.h"
#include "cohesion_version.h"
#include "command_line.h"
#include "lattice_boltzmann/arrays.h"
#include "lattice_boltzmann/random_array.h"
#include "lattice_boltzmann/steady_drag.h"
#include "named_table.h"
#include "sphere_file.h"

namespace {

using namespace cohesion;
using namespace cohesion::lattice_boltzmann;
using tools::ArrayDragRequest;

Array array_of_file(const ArrayDragRequest& r) {
  const tools::SphereFile file = tools::SphereReader(r.file).read(r.box);
  // The edges decide, for the box to be a whole number of nodes; cubes alone fit exactly.
  Array array{{}, {}};
  for (const auto& row : file.rows)
    array.spheres.push_back({{row[0], row[1], row[2]}, 0.5 * row[3]});
  const double scale =
      static_cast<double>(std::lround(r.diameter / sauter_mean(array) * file.box[0])) / file.box[0];
  for (int k = 0; k < 3; k++) {
    array.nodes[k] = static_cast<int>(std::lround(scale * file.box[k]));
    require(std::abs(array.nodes[k] / (scale * file.box[k]) - 1.0) < 1e-9, "edge of the box",
            file.box[k],
            "edges must be as whole numbers of nodes are; take another --diameter, or a cube");
  }
  for (FixedSphere& sphere : array.spheres) {
    sphere.radius *= scale;
    for (double& x : sphere.centre) x *= scale;
  }
  return array;
}

/// The array with the number `n` of those asked for.
Array array_of(const ArrayDragRequest& r, int n) {
  if (!r.file.empty()) return array_of_file(r);
  if (!r.random())
    return cubic_array(find_by_name(cubic_arrays, "array", r.kind), r.phi, r.diameter);
  RandomKind kind{r.phi, {}, r.seed + static_cast<std::uint64_t>(n)};
  for (std::size_t size = 0; size < r.sizes.size(); size++)
    kind.diameters.insert(kind.diameters.end(), r.counts[size], r.sizes[size]);
  return random_array(kind, r.diameter);
}

/// With inertia a force is looked for that gives the speed, and in dilute arrays: what a given
/// force drives there takes long to have its speed. Slow flow may have any viscosity: a large one
/// is steady sooner, but for dense arrays, in whose gaps populations that are no flow fade slowly
/// then.
FlowSettings settings_of(const ArrayDragRequest& r, const Array& array, const Vector& direction) {
  const bool inertia = r.reynolds > 0.0, dense = solid_fraction(array) > 0.15;
  FlowSettings settings{inertia ? r.speed * sauter_mean(array) / r.reynolds
                        : dense ? 0.3
                                : 1.0,
                        {},
                        inertia ? r.speed
                        : dense ? 0.0
                                : 1e-7,
                        r.tolerance,
                        r.most_steps,
                        r.average};
  for (int k = 0; k < 3; k++) settings.body_force[k] = 1e-9 * direction[k] / size_of(direction);
  return settings;
}

#ifdef COHESION_WITH_THREADS
void share_among(int threads) {
  if (threads > 0) omp_set_num_threads(threads);
}

void on_threads(int count, const std::function<void(int)>& part) {
#pragma omp parallel for schedule(static)
  for (int i = 0; i < count; i++) part(i);
}
#else
void share_among(int threads) {
  require(threads <= 1, "number of threads", threads, "this program was built without OpenMP: 1");
}

void on_threads(int count, const std::function<void(int)>& part) { one_by_one(count, part); }
#endif

/// Tells how far a run is, every five seconds.
class Progress {
 public:
  Progress(int flows, double tolerance) : flows_(flows), tolerance_(tolerance) {}

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  ProgressReport of(int flow) {
    return [this, flow](long steps, double left) {
      if (seconds() < shown_ + 5.0) return;
      shown_ = seconds();
      std::fprintf(stderr, "array-drag: %.0f s, flow %d of %d, %ld steps, yet to come %.1e of %.0e",
                   shown_, flow + 1, flows_, steps, left, tolerance_);
      // Flows take about as long as each other.
      if (flow > 0) std::fprintf(stderr, ", some %.0f s left", shown_ / flow * (flows_ - flow));
      std::fputc('\n', stderr);
    };
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  int flows_;
  double tolerance_, shown_ = 0.0;
};

void run(const ArrayDragRequest& r) {
  require(size_of(r.direction) > 0.0, "direction", 0.0, "must not be the null vector");
  require(r.sizes.size() == r.counts.size(), "number of --counts", r.counts.size(),
          "must be that of --sizes");
  require(r.random() || r.arrays == 1, "--arrays", r.arrays, "is of random arrays alone");
  share_among(r.threads);
  const std::vector<Vector> directions =
      r.tensor ? std::vector<Vector>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}} : std::vector{r.direction};
  const int each = static_cast<int>(directions.size());
  Progress progress(r.arrays * each, r.tolerance);
  tools::ArrayDragReport report(r);
  for (int n = 0; n < r.arrays; n++) {
    const Array array = array_of(r, n);
    for (int d = 0; d < each; d++) {
      const FlowSettings settings = settings_of(r, array, directions[d]);
      DrivenFlow flow(array, settings, on_threads);
      report.add(n, array, settings, steady_drag(flow, settings, progress.of(n * each + d)));
      if (!r.slice.empty() && n == r.arrays - 1 && d == 0) report.write_slice(flow, array);
    }
  }
  report.print(progress.seconds());
}

}  // namespace

int main(int argc, char** argv) {
  ArrayDragRequest request;
  CLI::App app{
      "Drag on fixed spheres in a periodic box, by a lattice-Boltzmann flow.\n"
      "Manual: docs/tools/array-drag.md"};
  app.set_version_flag("--version", "array-drag, Cohesion " COHESION_VERSION);
  tools::add_array_options(app, request);
  tools::add_flow_options(app, request);
  tools::add_output_options(app, request);
  try {
    app.parse(argc, argv);
    tools::reject_repeated_options(app, argc, argv);
    if (request.kind.empty() && request.file.empty())
      throw CLI::RequiredError("--array with --phi, or --spheres");
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  return tools::exit_code_of("array-drag", [&] { run(request); });
}
