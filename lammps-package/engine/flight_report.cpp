// SPDX-License-Identifier: GPL-2.0-only
#include "flight_report.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "atom.h"
#include "box_shear.h"
#include "domain.h"
#include "message.h"
#include "vector3.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;

namespace {

// Overlap over the smaller diameter: what the law of a spring is meant for stays below.
constexpr double DEEP = 0.01;

struct DeepestContact {
  int i = -1, partner = -1;
  double overlap = -std::numeric_limits<double>::infinity();  // over the smaller diameter

  void consider(const Atom* atom, int a, int b) {
    const double distance = norm(vector(atom->x[b]) - vector(atom->x[a]));
    const double ra = atom->radius[a], rb = atom->radius[b];
    const double found = (ra + rb - distance) / (2.0 * std::min(ra, rb));
    if (found > overlap) *this = {a, b, found};
  }
};

DeepestContact deepest_contact_of(const Atom* atom, int i) {
  DeepestContact deepest;
  for (int j = 0; j < atom->nlocal + atom->nghost; j++)
    if (j != i) deepest.consider(atom, i, j);
  return deepest;
}

/// The deepest contact of all particles. They are sorted along x: those farther apart there than
/// two radii do not touch.
DeepestContact deepest_contact(const Atom* atom) {
  std::vector<int> sorted(atom->nlocal + atom->nghost);
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(),
            [atom](int a, int b) { return atom->x[a][0] < atom->x[b][0]; });
  double largest = 0.0;
  for (int i : sorted) largest = std::max(largest, atom->radius[i]);
  DeepestContact deepest;
  for (std::size_t a = 0; a < sorted.size(); a++)
    for (std::size_t b = a + 1; b < sorted.size(); b++) {
      const int i = sorted[a], j = sorted[b];
      if (atom->x[j][0] - atom->x[i][0] > atom->radius[i] + largest) break;
      deepest.consider(atom, i, j);
    }
  return deepest;
}

}  // namespace

std::string LAMMPS_NS::report_flight(const LAMMPS* lmp, int i) {
  const Atom* const atom = lmp->atom;
  const double* const x = atom->x[i];
  const std::string flight = message("particle ", atom->tag[i], " at (", x[0], " ", x[1], " ", x[2],
                                     ") has the speed ", norm(vector(atom->v[i])));
  const char* const why =
      " of the smaller diameter: spheres that are made or put within each other fly apart; if they "
      "were, place them apart from each other";
  const DeepestContact own = deepest_contact_of(atom, i);
  if (own.overlap > DEEP)
    return message(flight, " and overlaps particle ", atom->tag[own.partner], " by ", own.overlap,
                   why);
  const DeepestContact other = deepest_contact(atom);
  if (other.overlap <= DEEP) return flight;
  return message(flight, "; particles ", std::min(atom->tag[other.i], atom->tag[other.partner]),
                 " and ", std::max(atom->tag[other.i], atom->tag[other.partner]), " overlap by ",
                 other.overlap, why);
}

std::string LAMMPS_NS::report_fastest(const LAMMPS* lmp) {
  const Atom* const atom = lmp->atom;
  const cohesion::shear::BoxShear flow = rate_of_shear(lmp->domain);
  int fastest = -1;
  double most = -1.0;
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    Vector3 v = vector(atom->v[i]);
    v.x = flow.nonaffine(v.x, atom->x[i][1]);
    if (dot(v, v) <= most) continue;
    most = dot(v, v);
    fastest = i;
  }
  return fastest < 0 ? "there is no particle" : report_flight(lmp, fastest);
}
