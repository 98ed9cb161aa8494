// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HAMAKER_KEYWORDS_H
#define COHESION_HAMAKER_KEYWORDS_H

#include <vector>

#include "cohesive_contact_from_script.h"
#include "hamaker/parameters.h"

namespace LAMMPS_NS {

inline cohesion::hamaker::Parameters& itself(cohesion::hamaker::Parameters& p) { return p; }

/// `hamaker A [cutoff H_cut H_out] [asperity r_a]`, of what law() finds among the parameters P.
template <class P = cohesion::hamaker::Parameters,
          cohesion::hamaker::Parameters& (*law)(P&) = &itself>
std::vector<ContactKeyword<P>> hamaker_keywords() {
  return {{"hamaker", 1, [](P& p, const double* v) { law(p).hamaker_constant = v[0]; }},
          {"cutoff", 2,
           [](P& p, const double* v) {
             law(p).surface_cutoff = v[0];
             law(p).outer_cutoff = v[1];
           }},
          {"asperity", 1, [](P& p, const double* v) { law(p).asperity_radius = v[0]; }}};
}

}  // namespace LAMMPS_NS

#endif
