// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_UNKNOWN_MODELS_H
#define COHESION_UNKNOWN_MODELS_H

#include <string>

namespace LIGGGHTS {
namespace Cohesion {

/// Lets pair_style gran and fix wall/gran name the model that is unknown, or that a cohesion model
/// of this package is not combined with: the engine's own errors name none, or the cohesion model.
void name_unknown_models();

/// The cohesion model that a script names in the line of a pair style or fix of a wall, "off" too;
/// empty: none, or the style is from a restart file.
std::string cohesion_word_of(const void* style);

/// Where the words of the line end from which a pair style or wall is made, of which the engine
/// passes no count to keywords; null: unknown.
char* const* end_of_words();

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
