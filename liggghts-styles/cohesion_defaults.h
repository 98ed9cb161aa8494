// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_COHESION_DEFAULTS_H
#define COHESION_COHESION_DEFAULTS_H

#include <string>
#include <string_view>

#include "contact/normal_law.h"
#include "contact/stiffness_scaling.h"
#include "contact_interface.h"
#include "normal_model_probe.h"
#include "settings.h"

namespace LIGGGHTS {
namespace Cohesion {

/// What most cohesion models have in common (cohesion_overlay.h): no keywords, and no part in the
/// spring.
struct CohesionDefaults {
  static constexpr bool HAS_SAMPLED = true;

  static void registerSettings(Settings&) {}

  static constexpr bool is_idle(const ContactModels::SurfacesCloseData&) { return false; }
  static constexpr bool is_idle_in_contact(const ContactModels::SurfacesCloseData&) {
    return false;
  }

  static cohesion::contact::NormalLaw contact_law(const cohesion::contact::NormalLaw& normal, int,
                                                  int, double, double) {
    return normal;
  }
  static cohesion::contact::Material material(int, int) { return {}; }
  static std::string_view material_words(const NormalModelProbe&) { return ""; }
  static std::string doubt(int, int) { return ""; }
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
