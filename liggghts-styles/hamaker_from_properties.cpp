// SPDX-License-Identifier: GPL-2.0-or-later
#include "hamaker_from_properties.h"

#include <mpi.h>

#include <sstream>

#include "error.h"
#include "fix_wall_gran.h"
#include "global_properties.h"
#include "neighbor.h"
#include "property_registry.h"

namespace LIGGGHTS {
namespace Cohesion {

namespace {

constexpr const char* caller = "cohesion_model hamaker";
constexpr const char* constant_property = "hamakerConstant";
constexpr const char* surface_property = "hamakerSurfaceCutoff";
constexpr const char* outer_property = "hamakerOuterCutoff";

MatrixProperty* make_constant(PropertyRegistry& registry, const char* asked_by, bool) {
  return MODEL_PARAMS::createPerTypePairProperty(registry, constant_property, asked_by);
}
ScalarProperty* make_surface_cutoff(PropertyRegistry& registry, const char* asked_by, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, surface_property, asked_by);
}
ScalarProperty* make_outer_cutoff(PropertyRegistry& registry, const char* asked_by, bool) {
  return MODEL_PARAMS::createScalarProperty(registry, outer_property, asked_by);
}

void stop(LAMMPS* lmp, const std::ostringstream& message) {
  lmp->error->all(FLERR, message.str().c_str());
}

}  // namespace

HamakerOfTypes::HamakerOfTypes(LAMMPS* lmp, PropertyRegistry& registry)
    : types_(registry.max_type()) {
  registry.registerProperty(constant_property, &make_constant);
  registry.registerProperty(surface_property, &make_surface_cutoff);
  registry.registerProperty(outer_property, &make_outer_cutoff);
  double** constant = registry.getMatrixProperty(constant_property, caller)->data;
  const double surface_cutoff = registry.getScalarProperty(surface_property, caller)->data;
  const double outer_cutoff = registry.getScalarProperty(outer_property, caller)->data;

  for (int i = 1; i <= types_; i++)
    for (int j = 1; j <= types_; j++) try {
        laws_.emplace_back(
            cohesion::hamaker::Parameters{constant[i][j], surface_cutoff, outer_cutoff});
      } catch (const cohesion::InvalidParameter& bad) {
        std::ostringstream message;
        message << "cohesion model hamaker, atom types " << i << " and " << j << ": " << bad.what()
                << " (fix property/global " << constant_property << " = " << constant[i][j] << ", "
                << surface_property << " = " << surface_cutoff << ", " << outer_property << " = "
                << outer_cutoff << ")";
        stop(lmp, message);
      }
}

void require_range(LAMMPS* lmp, PropertyRegistry& registry, FixWallGran* wall, double range) {
  // The engine looks for pairs up to (f - 1)(r_i + r_j) and for walls up to (f - 1) r: the wall
  // seen by the smallest particle asks for most. The last factor keeps rounding from cutting the
  // last bit of the range off.
  lmp->neighbor->register_contact_dist_factor(1.0 + range / registry.min_radius() * (1.0 + 1e-6));
  if (!wall) return;

  if (wall->is_mesh_wall()) {
    std::ostringstream message;
    message << "cohesion model hamaker, fix wall/gran " << wall->id
            << ": mesh walls are not supported, use 'primitive'";
    stop(lmp, message);
  }
  // The list of particles near a primitive wall holds those within the skin when it was made, and
  // serves until a particle has moved half the skin.
  if (range > 0.5 * lmp->neighbor->skin) {
    std::ostringstream message;
    message << "cohesion model hamaker, fix wall/gran " << wall->id << ": " << outer_property
            << " = " << range << " exceeds half the neighbor skin of " << lmp->neighbor->skin
            << ", beyond which a primitive wall may miss particles; use 'neighbor " << 2.0 * range
            << " bin' or more";
    stop(lmp, message);
  }
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
