// SPDX-License-Identifier: GPL-2.0-only
#include "engine/flight_report.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "atom.h"
#include "common/box_shear.h"
#include "common/message.h"
#include "domain.h"
#include "update.h"
#include "vector3.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;

namespace {

// Overlap over the smaller diameter: what the law of a spring is meant for stays below.
constexpr double DEEP = 0.01;

/// Whether two spheres overlap by no more than a collision explains. Its spheres approach for half
/// of the contact, of some ten steps. Those that part may have been put within each other, unless
/// they were apart a step ago.
bool collide(double overlap, double approach_in_a_step) {
  constexpr double steps_of_approach = 10.0;
  return overlap <= (approach_in_a_step > 0.0 ? steps_of_approach : -1.0) * approach_in_a_step;
}

struct DeepestContact {
  int i = -1, partner = -1;
  double overlap = -std::numeric_limits<double>::infinity();  // over the smaller diameter

  void consider(const Atom* atom, int a, int b, double found) {
    found /= 2.0 * std::min(atom->radius[a], atom->radius[b]);
    if (found > overlap) *this = {a, b, found};
  }
};

/// Contacts by what may be the reason of a speed.
struct DeepestContacts {
  DeepestContact put, colliding;

  void consider(const LAMMPS* lmp, int a, int b) {
    const Atom* const atom = lmp->atom;
    const Vector3 apart = vector(atom->x[b]) - vector(atom->x[a]);
    const double distance = norm(apart), overlap = atom->radius[a] + atom->radius[b] - distance;
    if (overlap <= 0.0) return;
    const double parting = dot(apart, vector(atom->v[b]) - vector(atom->v[a]));
    const double approach = distance > 0.0 ? -lmp->update->dt * parting / distance : 0.0;
    (collide(overlap, approach) ? colliding : put).consider(atom, a, b, overlap);
  }
};

DeepestContacts deepest_contacts_of(const LAMMPS* lmp, int i) {
  DeepestContacts deepest;
  for (int j = 0; j < lmp->atom->nlocal + lmp->atom->nghost; j++)
    if (j != i) deepest.consider(lmp, i, j);
  return deepest;
}

/// The deepest contacts of all particles. They are sorted along x: those farther apart there than
/// two radii do not touch.
DeepestContacts deepest_contacts(const LAMMPS* lmp) {
  const Atom* const atom = lmp->atom;
  std::vector<int> sorted(atom->nlocal + atom->nghost);
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(),
            [atom](int a, int b) { return atom->x[a][0] < atom->x[b][0]; });
  double largest = 0.0;
  for (int i : sorted) largest = std::max(largest, atom->radius[i]);
  DeepestContacts deepest;
  for (std::size_t a = 0; a < sorted.size(); a++)
    for (std::size_t b = a + 1; b < sorted.size(); b++) {
      const int i = sorted[a], j = sorted[b];
      if (atom->x[j][0] - atom->x[i][0] > atom->radius[i] + largest) break;
      deepest.consider(lmp, i, j);
    }
  return deepest;
}

}  // namespace

std::string LAMMPS_NS::report_flight(const LAMMPS* lmp, int i) {
  const Atom* const atom = lmp->atom;
  const double* const x = atom->x[i];
  const DeepestContacts own = deepest_contacts_of(lmp, i);
  std::string flight = message("particle ", atom->tag[i], " at (", x[0], " ", x[1], " ", x[2],
                               ") has the speed ", norm(vector(atom->v[i])));
  const char* const why =
      " of the smaller diameter: they were made or put within each other and fly apart, or a "
      "collision is this deep since the spring is soft for its speed; if they were put there, "
      "place them apart from each other";
  if (own.put.overlap > DEEP)
    return message(flight, " and overlaps particle ", atom->tag[own.put.partner], " by ",
                   own.put.overlap, why);
  if (own.colliding.i >= 0)
    flight += message(" in a fast collision with particle ", atom->tag[own.colliding.partner]);
  const DeepestContact other = deepest_contacts(lmp).put;
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
