// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_UNKNOWN_MODELS_H
#define COHESION_UNKNOWN_MODELS_H

namespace LIGGGHTS {
namespace Cohesion {

/// Lets pair_style gran and fix wall/gran name the model that is unknown, or that a cohesion model
/// of this package is not combined with: the engine's own errors name none, or the cohesion model.
void name_unknown_models();

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
