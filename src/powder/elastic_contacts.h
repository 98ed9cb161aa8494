// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "advice/elastic_pair.h"
#include "advice/softness.h"
#include "powder/grain_contact.h"
#include "powder/springs.h"

/// Hertz's and JKR's contacts of a run, beside those of the material. Any consistent set of units.
namespace cohesion::powder {

/// A contact that the run has to bear, as it is of the material.
struct ElasticBorne {
  double diameter;  ///< of the smaller one, [length]
  advice::ElasticPair pair;
};

/// The two contacts of the smallest grains.
struct ElasticContacts {
  advice::ElasticPair material, used;
  advice::OverMaterial over;
  double young;  ///< E of the run, [force/length^2]
};

/// What a run with them is to do.
struct ElasticDemand {
  double young;        ///< E of the material, [force/length^2]
  double given;        ///< E that is used whatever it does; 0: none
  Load load;           ///< that presses grains together
  double overlap;      ///< that it may press them by at most, over the diameter, [1]
  contact::Keep keep;  ///< what a softer modulus keeps of the material
  /// E over which the attraction can be scaled, [force/length^2]: least_scaled_stiffness().
  double least = 0.0;
};

/// The softest modulus, over the material's, that keeps overlaps below `demand.overlap` over the
/// diameter: of an impact at the speed of the load, to which the adhesion adds, without loss, and
/// under the pressure of the bed, which puts the force p d^2 on a contact. 1 where the material
/// does not, either. Halved on a logarithmic scale to 1e-6.
inline double softest_ratio(const ElasticBorne& borne, const ElasticDemand& demand) {
  const double most = demand.overlap * borne.diameter;
  const double weight = demand.load.pressure * borne.diameter * borne.diameter;
  const auto bears = [&](double ratio) {
    const advice::ElasticPair soft =
        borne.pair.softened(ratio * borne.pair.contact().modulus, demand.keep);
    return std::max(soft.largest_overlap(demand.load.speed), soft.overlap_under(weight)) <= most;
  };
  double high = 1.0, low = 1.0;
  while (low > 1e-12 && bears(low)) {
    high = low;
    low *= 0.1;
  }
  while (high > low * (1.0 + 1e-6)) {
    const double middle = std::sqrt(low * high);
    (bears(middle) ? high : low) = middle;
  }
  return high;
}

/// The contacts at the modulus given, or at the softest that will do for all, in two digits; no
/// stiffer than the material. `all`: the first is that of two of the smallest grains.
inline ElasticContacts elastic_contacts(const std::vector<ElasticBorne>& all,
                                        const ElasticDemand& demand) {
  double young = demand.given;
  if (young == 0.0) {
    double ratio = 0.0;
    for (const ElasticBorne& borne : all) ratio = std::max(ratio, softest_ratio(borne, demand));
    young = rounded_stiffness(std::max(ratio * demand.young, demand.least), demand.young);
  }
  const advice::ElasticPair& material = all.front().pair;
  const advice::ElasticPair used =
      material.softened(young / demand.young * material.contact().modulus, demand.keep);
  const double force = material.pull_off_force(), escape = material.escape_velocity();
  const bool both_part = escape > 0.0 && std::isfinite(escape);
  return {material,
          used,
          {both_part ? used.escape_velocity() / escape : 1.0,
           force > 0.0 ? used.pull_off_force() / force : 1.0},
          young};
}

}  // namespace cohesion::powder
