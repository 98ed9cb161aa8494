// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "drag/filtered_drag.h"
#include "drag/igci.h"
#include "powder/fluidisation.h"

/// The drag of two fluids in cells that are too coarse for the clusters in them, over that of the
/// closure at the mean values there: the laws by name, each with the terminal speed and the length
/// that its source measures cells in.
namespace cohesion::powder {

/// What falls in the gas of a cell, and the cell. Igci's law holds gas and grains to Stokes'
/// terminal speed, Radl and Sundaresan's to that with Schiller and Naumann's drag.
struct CellOfGrains {
  double size;  ///< Delta [length]
  Grain grain;
  Gas gas;
  double gravity;  ///< [length/time^2]
};

struct CellFilter {
  std::string_view name;
  /// Drag over the closure's [1] at the solid fraction phi >= 0 [1]. Null: the closure as it is.
  double (*factor)(double phi, const CellOfGrains& cell);
};

namespace detail {

inline double igci_in(double phi, const CellOfGrains& cell) {
  const double speed = drag::stokes_terminal_speed(
      cell.grain.diameter, cell.grain.density, cell.gas.density, cell.gas.viscosity, cell.gravity);
  return drag::Igci::factor(phi, drag::filter_over_fall(cell.size, speed, cell.gravity));
}

/// Throws InvalidParameter as terminal_speed().
inline double radl_sundaresan_in(double phi, const CellOfGrains& cell) {
  const double speed = terminal_speed(cell.grain, cell.gas, cell.gravity);
  return drag::RadlSundaresan::factor(
      phi, cell.size / drag::filter_length(speed, cell.grain.diameter, cell.gravity));
}

}  // namespace detail

/// Of two fluids; filters of particles in cells are drag_filters (drag/filtered_drag.h).
inline constexpr std::array cell_filters{
    CellFilter{"none", nullptr},
    CellFilter{"igci", &detail::igci_in},
    CellFilter{"radlSundaresan", &detail::radl_sundaresan_in},
};

}  // namespace cohesion::powder
