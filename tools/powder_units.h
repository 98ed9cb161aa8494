// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "powder_request.h"
#include "validation.h"

namespace cohesion::tools {

/// Another unit in which a quantity is often given, and its value in the SI unit.
struct OtherUnit {
  const char* name;
  double value;
};

/// Values that an option may have in its SI unit. Bounds lie well beyond any powder and short of
/// what the same powder has in the other units, as far as both is possible.
struct SiRange {
  const char* option;
  std::vector<double> values;
  double least, most;
  const char* unit;
  std::vector<OtherUnit> others;
};

/// Throws InvalidParameter for a value that is not 0 and out of the range, with what it would be in
/// SI units were it meant in others.
inline void require_within(const SiRange& range) {
  for (const double value : range.values) {
    if (value == 0.0 || (value >= range.least && value <= range.most)) continue;
    std::ostringstream remedy;
    remedy << "the option is in " << range.unit << ", and takes " << range.least << " to "
           << range.most;
    for (const OtherUnit& other : range.others) {
      const double meant = value * other.value;
      if (meant >= range.least && meant <= range.most)
        remedy << "; if " << value << ' ' << other.name << " is meant: " << range.option << ' '
               << meant;
    }
    require(false, range.option, value, remedy.str());
  }
}

/// Throws InvalidParameter for what can only be meant in other units than the SI's.
inline void require_si(const PowderRequest& r) {
  const std::vector<OtherUnit> lengths{{"um", 1e-6}, {"mm", 1e-3}}, small{{"nm", 1e-9}};
  const std::vector<SiRange> ranges{
      {"--diameter", r.diameters, 1e-8, 0.1, "m", lengths},
      {"--percentiles", r.percentiles, 1e-8, 0.1, "m", lengths},
      // The lightest solids are foams and aerogels; osmium has 22.6 g/cm3.
      {"--density", {r.density}, 23.0, 23000.0, "kg/m3", {{"g/cm3", 1e3}}},
      {"--young", {r.elastic.young}, 1e3, 2e12, "Pa", {{"GPa", 1e9}, {"MPa", 1e6}}},
      {"--soft-young", {r.soft_young}, 1e3, 2e12, "Pa", {{"GPa", 1e9}, {"MPa", 1e6}}},
      {"--hamaker", {r.hamaker}, 1e-23, 1e-17, "J", {{"zJ", 1e-21}, {"e-20 J", 1e-20}}},
      {"--surface-energy", {r.surface_energy}, 1e-6, 10.0, "J/m2", {{"mJ/m2", 1e-3}}},
      {"--cutoff", r.cutoffs, 1e-11, 1e-4, "m", small},
      {"--asperity", {r.asperity}, 1e-11, 1e-3, "m", small},
      {"--roughness", r.roughness, 1e-12, 1e-3, "m", small},
      {"--gas-density", {r.gas.density}, 1e-4, 2e4, "kg/m3", {{"g/cm3", 1e3}}},
      {"--gas-viscosity", {r.gas.viscosity}, 1e-7, 1.0, "Pa s", {{"uPa s", 1e-6}}},
      {"--pressure", {r.pressure}, 100.0, 1e9, "Pa", {{"bar", 1e5}}},
      {"--width", {r.width}, 1e-5, 45.0, "m", {{"mm", 1e-3}}},
      {"--depth", {r.depth}, 1e-5, 45.0, "m", {{"mm", 1e-3}}},
      {"--column", {r.column}, 1e-5, 45.0, "m", {{"mm", 1e-3}}},
      {"--height", {r.height}, 1e-5, 99.0, "m", {{"mm", 1e-3}}},
  };
  for (const SiRange& range : ranges) require_within(range);
}

}  // namespace cohesion::tools
