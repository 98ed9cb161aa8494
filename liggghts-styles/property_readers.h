// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_PROPERTY_READERS_H
#define COHESION_PROPERTY_READERS_H

#include <mpi.h>
// The engine's header of properties wants mpi.h before it.
#include "global_properties.h"
#include "property_registry.h"

namespace LIGGGHTS {
namespace Cohesion {

/// These read a fix property/global of the script. `property` is its name; the engine's registry
/// accepts a function pointer only, hence the template argument. `model`: named in the error that
/// stops the engine where the property is missing.

/// By pair of types, both counted from 1.
template <const char* const& property>
double** type_pair_property(PropertyRegistry& registry, const char* model) {
  registry.registerProperty(property, [](PropertyRegistry& from, const char* caller, bool) {
    return MODEL_PARAMS::createPerTypePairProperty(from, property, caller);
  });
  return registry.getMatrixProperty(property, model)->data;
}

/// By type, counted from 1.
template <const char* const& property>
const double* type_property(PropertyRegistry& registry, const char* model) {
  registry.registerProperty(property, [](PropertyRegistry& from, const char* caller, bool) {
    return MODEL_PARAMS::createPerTypeProperty(from, property, caller);
  });
  return registry.getVectorProperty(property, model)->data;
}

template <const char* const& property>
double scalar_property(PropertyRegistry& registry, const char* model) {
  registry.registerProperty(property, [](PropertyRegistry& from, const char* caller, bool) {
    return MODEL_PARAMS::createScalarProperty(from, property, caller);
  });
  return registry.getScalarProperty(property, model)->data;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
