// SPDX-License-Identifier: GPL-2.0-only
#include "flight_report.h"

#include <algorithm>
#include <limits>

#include "atom.h"
#include "box_shear.h"
#include "domain.h"
#include "message.h"
#include "vector3.h"

using namespace LAMMPS_NS;
using cohesion::vector;
using cohesion::Vector3;

namespace {

// Over the smaller diameter: no contact that a linear spring stands for is so deep.
constexpr double TOO_DEEP = 0.1;

struct DeepestContact {
  int partner = -1;
  double overlap = -std::numeric_limits<double>::infinity();  // over the smaller diameter
};

DeepestContact deepest_contact(const Atom* atom, int i) {
  DeepestContact deepest;
  for (int j = 0; j < atom->nlocal + atom->nghost; j++) {
    if (j == i) continue;
    const double distance = norm(vector(atom->x[j]) - vector(atom->x[i]));
    const double ri = atom->radius[i], rj = atom->radius[j];
    const double overlap = (ri + rj - distance) / (2.0 * std::min(ri, rj));
    if (overlap > deepest.overlap) deepest = {j, overlap};
  }
  return deepest;
}

}  // namespace

std::string LAMMPS_NS::report_flight(const LAMMPS* lmp, int i) {
  const Atom* const atom = lmp->atom;
  const double* const x = atom->x[i];
  const std::string flight = message("particle ", atom->tag[i], " at (", x[0], " ", x[1], " ", x[2],
                                     ") has the speed ", norm(vector(atom->v[i])));
  const DeepestContact deepest = deepest_contact(atom, i);
  if (deepest.overlap < TOO_DEEP) return flight;
  return message(flight, " and overlaps particle ", atom->tag[deepest.partner], " by ",
                 deepest.overlap,
                 " of the smaller diameter: spheres that are made or put within each other fly "
                 "apart; place them apart from each other");
}

std::string LAMMPS_NS::report_fastest(const LAMMPS* lmp) {
  const Atom* const atom = lmp->atom;
  const cohesion::shear::BoxShear flow = rate_of_shear(lmp->domain);
  int fastest = -1;
  double most = -1.0;
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    Vector3 v = vector(atom->v[i]);
    v.x = flow.beyond(v.x, atom->x[i][1]);
    if (dot(v, v) <= most) continue;
    most = dot(v, v);
    fastest = i;
  }
  return fastest < 0 ? "there is no particle" : report_flight(lmp, fastest);
}
