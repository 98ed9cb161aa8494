// SPDX-License-Identifier: GPL-2.0-only
#include "engine/announced_particles.h"

#include <algorithm>
#include <cstring>

#if __has_include("GRANULAR/fix_pour.h")
#include "GRANULAR/fix_pour.h"
#else
#include "fix_pour.h"
#endif
#include "fix_deposit.h"
#include "modify.h"
#include "molecule.h"
#include "sphere.h"

using namespace LAMMPS_NS;

// The fixes tell the largest radius only, and no density; so their members are read. Names of
// private members may stand in an explicit instantiation, which here defines a function. The fixes
// are known by their styles: no symbol of theirs need be in the engine.

namespace {

// Of a particle whose radius or density is not given (AtomVecSphere::create_atom).
constexpr double USUAL_RADIUS = 0.5, USUAL_DENSITY = 1.0;

/// What such a fix inserts: atoms of a type, or molecules whose types are counted from there.
struct Insertion {
  bool atoms;
  int type;
  double radius, density;  ///< of atoms
  int count;               ///< of molecules
  Molecule* const* molecules;
};

Insertion insertion(const FixPour&);
Insertion insertion(const FixDeposit&);

// What `mode` and `dstyle` mean there.
enum { ATOM, MOLECULE };
enum { ONE, RANGE, POLY };

template <auto mode, auto type, auto count, auto molecules, auto style, auto radius_one,
          auto radius_low, auto radii, auto of_radii, auto density_low>
struct Pour {
  static double radius(const FixPour& fix) {
    if (fix.*style == RANGE) return fix.*radius_low;
    if (fix.*style == POLY) return *std::min_element(fix.*radii, fix.*radii + fix.*of_radii);
    return fix.*radius_one;
  }
  friend Insertion insertion(const FixPour& fix) {
    return {fix.*mode == ATOM, fix.*type,  radius(fix),
            fix.*density_low,  fix.*count, fix.*molecules};
  }
};
template struct Pour<&FixPour::mode, &FixPour::ntype, &FixPour::nmol, &FixPour::onemols,
                     &FixPour::dstyle, &FixPour::radius_one, &FixPour::radius_lo,
                     &FixPour::radius_poly, &FixPour::npoly, &FixPour::density_lo>;

template <auto mode, auto type, auto count, auto molecules>
struct Deposit {
  friend Insertion insertion(const FixDeposit& fix) {
    return {fix.*mode == ATOM, fix.*type, USUAL_RADIUS, USUAL_DENSITY, fix.*count, fix.*molecules};
  }
};
template struct Deposit<&FixDeposit::mode, &FixDeposit::ntype, &FixDeposit::nmol,
                        &FixDeposit::onemols>;

void add(std::vector<AnnouncedParticle>& all, const Insertion& inserted, int mask) {
  const auto mass = [](double density, double radius) {
    return density * cohesion::sphere_volume(radius);
  };
  if (inserted.atoms) {
    all.push_back({inserted.type, mask, inserted.radius, mass(inserted.density, inserted.radius)});
    return;
  }
  for (int k = 0; k < inserted.count; k++) {
    const Molecule& molecule = *inserted.molecules[k];
    for (int i = 0; i < molecule.natoms; i++) {
      const double radius = molecule.radiusflag ? molecule.radius[i] : USUAL_RADIUS;
      all.push_back({inserted.type + molecule.type[i], mask, radius,
                     molecule.rmassflag ? molecule.rmass[i] : mass(USUAL_DENSITY, radius)});
    }
  }
}

}  // namespace

std::vector<AnnouncedParticle> LAMMPS_NS::announced_particles(LAMMPS* lmp) {
  std::vector<AnnouncedParticle> all;
  for (int k = 0; k < lmp->modify->nfix; k++) {
    const Fix* const fix = lmp->modify->fix[k];
    const int mask = 1 | fix->groupbit;
    if (strcmp(fix->style, "pour") == 0)
      add(all, insertion(static_cast<const FixPour&>(*fix)), mask);
    if (strcmp(fix->style, "deposit") == 0)
      add(all, insertion(static_cast<const FixDeposit&>(*fix)), mask);
  }
  return all;
}
