// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "hamaker/asperity.h"
#include "hamaker/exact.h"
#include "hamaker/law.h"
#include "hamaker/small_gap.h"

/// The table of forms of the attraction: the one place that knows them all.
/// To add one: its header beside this file, its two laws in LawVariant, and its row in `forms`.
namespace cohesion::hamaker {

/// A Wrapper of the law that was chosen: one std::visit leads to a loop that knows its type.
template <template <class...> class Wrapper>
using LawVariant =
    std::variant<Wrapper<HamakerLaw<SmallGap>>, Wrapper<HamakerLaw<Exact>>,
                 Wrapper<HamakerLaw<Rough<SmallGap>>>, Wrapper<HamakerLaw<Rough<Exact>>>>;

template <class T>
using Identity = T;

using AnyLaw = LawVariant<Identity>;      ///< one law
using AnyLaws = LawVariant<std::vector>;  ///< laws of many pairs of types, all of one kind

struct Form {
  std::string_view name;
  /// The law of this form; throws InvalidParameter. rough: one that knows asperities.
  AnyLaw (*law)(const HamakerParameters&, bool rough);
  /// Up to which H_cut and H_out are let pass, over the reduced radius R*, [1]: see `forms`.
  double largest_surface_cutoff;
  double largest_outer_cutoff;
};

template <class Smooth>
AnyLaw law_of(const HamakerParameters& p, bool rough) {
  if (rough) return HamakerLaw<Rough<Smooth>>(p);
  return HamakerLaw<Smooth>(p);
}

/// The form of small gaps is too strong by H/R* of itself, to first order: a tenth in the force of
/// contact, and at H_out as much again as there is. The exact form is right at any gap; from H_cut
/// on inwards the force is that of contact, which is one at a gap far below the radius, and beyond
/// ten radii there is none.
inline constexpr std::array forms{
    Form{"small_gap", &law_of<SmallGap>, 0.1, 1.0},
    Form{"exact", &law_of<Exact>, 1.0, 10.0},
};

}  // namespace cohesion::hamaker
