// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HAMAKER_KEYWORDS_H
#define COHESION_HAMAKER_KEYWORDS_H

#include <string>
#include <vector>

#include "hamaker/parameters.h"
#include "hamaker/roughness.h"
#include "input/cohesive_contact_from_script.h"

namespace LAMMPS_NS {

inline cohesion::hamaker::HamakerParameters& itself(cohesion::hamaker::HamakerParameters& p) {
  return p;
}

/// `hamaker A [cutoff H_cut H_out] [asperity r_a | roughness rms lambda]`, of what law() finds
/// among the parameters P.
template <class P = cohesion::hamaker::HamakerParameters,
          cohesion::hamaker::HamakerParameters& (*law)(P&) = &itself>
std::vector<ContactKeyword<P>> hamaker_keywords() {
  return {{"hamaker", "A", [](P& p, const double* v) { law(p).hamaker_constant = v[0]; }},
          {"cutoff", "H_cut H_out",
           [](P& p, const double* v) {
             law(p).surface_cutoff = v[0];
             law(p).outer_cutoff = v[1];
           }},
          {"asperity", "r_a", [](P& p, const double* v) { law(p).asperity_radius = v[0]; }},
          {"roughness", "rms lambda", [](P& p, const double* v) {
             const auto asperity = cohesion::hamaker::asperity_of({v[0], v[1]});
             law(p).asperity_radius = asperity.radius;
             law(p).asperity_height = asperity.height;
           }}};
}

/// Stops LAMMPS where asperities are given in both ways.
inline void require_one_roughness(LAMMPS* lmp, const std::string& where,
                                  const SpecifiedKeywords& given) {
  if (given.has("asperity") && given.has("roughness"))
    lmp->error->all(FLERR, where +
                               ": asperities are given either by their radius ('asperity') or by "
                               "the roughness of the surface ('roughness'), not both");
}

}  // namespace LAMMPS_NS

#endif
