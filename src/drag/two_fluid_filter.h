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
namespace cohesion::drag {

/// What falls in the gas of a cell, and the cell. Igci's law holds gas and grains to Stokes'
/// terminal speed, Radl and Sundaresan's to that with Schiller and Naumann's drag.
struct CellOfGrains {
  double size;  ///< Delta [length]
  powder::Grain grain;
  powder::Gas gas;
  double gravity;  ///< [length/time^2]
};

struct TwoFluidFilter {
  std::string_view name;
  /// Drag over the closure's [1] at the solid fraction phi >= 0 [1]. Null: the closure as it is.
  double (*factor)(double phi, const CellOfGrains& cell);
};

namespace detail {

inline double igci_in(double phi, const CellOfGrains& cell) {
  const double speed = stokes_terminal_speed(cell.grain.diameter, cell.grain.density,
                                             cell.gas.density, cell.gas.viscosity, cell.gravity);
  return Igci::factor(phi, filter_over_fall(cell.size, speed, cell.gravity));
}

/// Throws InvalidParameter as powder::terminal_speed().
inline double radl_sundaresan_in(double phi, const CellOfGrains& cell) {
  const double speed = powder::terminal_speed(cell.grain, cell.gas, cell.gravity);
  return RadlSundaresan::factor(
      phi, cell.size / filter_length(speed, cell.grain.diameter, cell.gravity));
}

}  // namespace detail

/// Filters of two fluids; those of particles in cells are drag_filters (filtered_drag.h).
inline constexpr std::array two_fluid_filters{
    TwoFluidFilter{"none", nullptr},
    TwoFluidFilter{"igci", &detail::igci_in},
    TwoFluidFilter{"radlSundaresan", &detail::radl_sundaresan_in},
};

}  // namespace cohesion::drag
