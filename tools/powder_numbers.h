// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "advice/advised_step.h"
#include "advice/elastic_pair.h"
#include "drag/drag_closure.h"
#include "hamaker/range_of_validity.h"
#include "named_table.h"
#include "powder/elastic_contacts.h"
#include "powder/fluidisation.h"
#include "powder/grain_contact.h"
#include "powder/parcels.h"
#include "powder/plan.h"
#include "powder/sizes.h"
#include "powder/springs.h"
#include "powder_case.h"
#include "powder_contacts.h"
#include "powder_request.h"

namespace cohesion::tools {

using namespace cohesion::powder;

inline PowderSizes sizes_of(const PowderRequest& r) {
  if (!r.percentiles.empty())
    return PowderSizes::of_percentiles(r.percentiles[0], r.percentiles[1], r.percentiles[2]);
  require(r.shares.empty() || r.shares.size() == r.diameters.size(), "number of mass shares",
          static_cast<double>(r.shares.size()), "give one for each diameter, or none");
  std::vector<PowderSize> sizes;
  for (std::size_t k = 0; k < r.diameters.size(); k++)
    sizes.push_back({r.diameters[k], r.shares.empty() ? 1.0 : r.shares[k]});
  return PowderSizes(sizes);
}

inline contact::Keep keep_of(const PowderRequest& r) {
  const auto named = [&](const contact::KeepName& k) { return r.keep == k.name; };
  return std::find_if(contact::keeps.begin(), contact::keeps.end(), named)->keep;
}

/// The numbers of a powder that the lines are made of.
class Powder {
 public:
  explicit Powder(const PowderRequest& r)
      : sizes(sizes_of(r)),
        mean{sizes.sauter(), r.density},
        parcels(r.coarse_graining),
        request_(r) {
    require_lifted(mean, r.gas, r.gravity);
    require_positive("cut-off H_cut", r.cutoffs.at(0));
    for (const drag::Closure& closure : drag::closures)
      fastest_fluidisation = std::max(fastest_fluidisation, fluidisation(closure));
    const double constant = r.surface_energy > 0.0
                                ? hamaker_of_surface_energy(r.surface_energy, r.cutoffs[0])
                                : r.hamaker;
    const hamaker::Asperity asperity = asperity_of(r);
    hamaker = {constant, r.cutoffs[0], r.cutoffs.at(1), asperity.radius, asperity.height};
    adhesion = adhesion_at(sizes.smallest());
    const double fall = std::sqrt(2.0 * r.gravity * parcels.length(sizes.largest()));
    const double usual = r.is_packing() ? fall : std::max(2.0 * fastest_fluidisation, fall);
    speed = r.speed > 0.0 ? r.speed : usual;
    const Load load{speed, pressure_of(r.height, r.void_fraction, r.density * r.gravity)};
    if (r.is_elastic())
      elastic = elastic_of(load);
    else
      springs = springs_under(load);
    cell = r.cell * parcels.length(sizes.largest());
    steps = steps_within(
        PowderCase::output_interval, parcels.time(step_of_contact()),
        longest_gas_step(cell, 2.0 * fastest_fluidisation / r.void_fraction, r.gravity));
    velocity = 2.0 * fluidisation(find_by_name(drag::closures, "drag", r.drag));
  }

  double fluidisation(const drag::Closure& closure) const {
    return minimum_fluidisation(closure, request_.void_fraction, mean, request_.gas,
                                request_.gravity);
  }

  double mass(double diameter) const { return request_.density * sphere_volume(0.5 * diameter); }
  double weight(double diameter) const { return mass(diameter) * request_.gravity; }

  /// Of two grains of a diameter, with the asperities of the request.
  contact::Adhesion adhesion_at(double diameter) const {
    return adhesion_of(two_spheres(0.5 * diameter, 0.5 * diameter));
  }
  contact::Adhesion adhesion_of(const PairGeometry& geometry) const {
    if (request_.is_jkr()) {
      contact::Adhesion own{};
      own.force = contact::JkrSpringDashpot::pull_off_force(geometry.reduced_radius,
                                                            2.0 * request_.surface_energy);
      own.forms_at_touch = true;
      return own;
    }
    const hamaker::AnyLaw law = hamaker::forms.front().law(hamaker, hamaker.asperity_radius > 0.0);
    hamaker::require_weakened_by_asperities(hamaker::forms.front(), hamaker, geometry);
    return std::visit([&](const auto& l) { return contact::adhesion_of(l, geometry); }, law);
  }

  /// A grain of a diameter at a wall, which presses a spring more than two of them.
  Borne at_wall(double diameter) const {
    return {{diameter, mass(diameter)}, adhesion_of(sphere_and_plane(0.5 * diameter))};
  }

  /// Of the spheres that are computed, each size a type.
  PowderSizes computed() const {
    std::vector<PowderSize> all = sizes.all();
    for (PowderSize& size : all) size.diameter = parcels.length(size.diameter);
    return PowderSizes(all);
  }
  PowderContacts contacts() const {
    std::vector<double> diameters;
    for (const PowderSize& size : sizes.all()) diameters.push_back(parcels.length(size.diameter));
    return {diameters,
            request_.density,
            parcels.stiffness(springs.used.stiffness),
            request_.restitution,
            request_.friction,
            parcels.attraction(hamaker),
            {parcels.stiffness(stiffness_stood_for(springs.material.stiffness)), keep_of(request_)},
            material_of_pairs(),
            well_ratio_of(request_),
            elastic
                ? ElasticWords{elastic->young, request_.elastic.poisson, request_.elastic.young,
                               request_.is_jkr() ? parcels.surface_energy(request_.surface_energy)
                                                 : 0.0}
                : ElasticWords{}};
  }

  /// Tabor's parameter of two of the smallest; 0 without adhesion.
  double tabor() const {
    if (!elastic || adhesion.force == 0.0) return 0.0;
    const double radius = 0.25 * sizes.smallest();
    const double work =
        request_.is_jkr() ? 2.0 * request_.surface_energy : adhesion.force / (2.0 * pi * radius);
    return advice::tabor_parameter(elastic->material.contact().modulus, radius, work,
                                   atomic_distance);
  }

  /// Largest overlap of an impact of two of the smallest on linear springs, without loss and
  /// adhesion, over the diameter.
  double impact_overlap() const {
    const double small = sizes.smallest();
    return speed * std::sqrt(0.5 * mass(small) / springs.used.stiffness) / small;
  }

  /// Depth of the well of two grains, and of one at a wall, where the run has wells.
  double well_depth(double diameter) const {
    return powder::well_depth(springs.material.stiffness, request_.restitution,
                              0.5 * mass(diameter), adhesion_at(diameter));
  }
  double well_depth_at_wall(double diameter) const {
    return powder::well_depth(springs.material.stiffness, request_.restitution, mass(diameter),
                              adhesion_of(sphere_and_plane(0.5 * diameter)));
  }

  PowderSizes sizes;
  Grain mean;
  Parcels parcels;
  double fastest_fluidisation = 0.0;  // by the closures
  double speed;                       // of impacts
  hamaker::HamakerParameters hamaker;
  contact::Adhesion adhesion;              // of two of the smallest
  Springs springs{};                       // of the grains, where they are linear
  std::optional<ElasticContacts> elastic;  // of the grains, where they are not
  TimeSteps steps;                         // of the run
  double cell, velocity;                   // of the run

 private:
  /// z0 of Tabor's parameter, [m].
  static constexpr double atomic_distance = 2e-10;
  /// Of a load on contacts: docs/theory/contact_strength.md.
  static constexpr double steps_per_contact_of_packing = 10.0;

  Springs springs_under(const Load& load) const {
    const PowderRequest& r = request_;
    const double stiffest_material =
        r.elastic.young > 0.0 ? material_stiffness(sizes.largest(), sizes.largest()) : 0.0;
    return springs_of({sizes.smallest(), mass(sizes.smallest()), hamaker, adhesion},
                      {r.restitution,
                       load,
                       r.overlap,
                       keep_of(r),
                       r.stiffness,
                       r.elastic,
                       well_ratio_of(r),
                       {at_wall(sizes.smallest()), at_wall(sizes.largest())},
                       stiffest_material});
  }

  ElasticContacts elastic_of(const Load& load) const {
    const PowderRequest& r = request_;
    contact::ContactParameters contact;
    contact::set_hertz(contact, r.elastic.young, r.elastic.poisson);
    contact.restitution = r.restitution;
    contact.friction = r.friction;
    if (r.is_jkr()) contact::set_surface_energy(contact, r.surface_energy);
    const auto borne = [&](double diameter, double reduced_mass, const PairGeometry& geometry) {
      return ElasticBorne{diameter,
                          {contact, geometry.reduced_radius, reduced_mass,
                           r.is_jkr() ? contact::Adhesion{} : adhesion_of(geometry)}};
    };
    const double small = sizes.smallest(), large = sizes.largest();
    ElasticDemand demand{r.elastic.young, r.soft_young, load, r.overlap, keep_of(r)};
    if (adhesion.cutoff > 0.0 && demand.keep == contact::Keep::escape_velocity) {
      demand.least = least_scaled_stiffness(r.elastic.young, hamaker, contact::hertz_power);
      // As the engine will: throws where the outer cut-off leaves no room.
      if (r.soft_young > 0.0)
        contact::for_stiffness(r.soft_young, {r.elastic.young, demand.keep, contact::hertz_power},
                               hamaker);
    }
    return elastic_contacts({borne(small, 0.5 * mass(small), two_spheres(0.5 * small, 0.5 * small)),
                             borne(small, mass(small), sphere_and_plane(0.5 * small)),
                             borne(large, mass(large), sphere_and_plane(0.5 * large))},
                            demand);
  }

  /// Springs stiffer than the material has for slow impacts stand for none but themselves. A well
  /// has its depth from the material in any case.
  double stiffness_stood_for(double material) const {
    return well_ratio_of(request_) > 0.0 ? material : std::max(material, springs.used.stiffness);
  }

  /// Hertz's contact of two sizes is that of two equal grains of the same R* and mu.
  double material_stiffness(double diameter_i, double diameter_j) const {
    const PairGeometry pair = two_spheres(0.5 * diameter_i, 0.5 * diameter_j);
    return sticking_stiffness(request_.elastic, 4.0 * pair.reduced_radius,
                              2.0 * reduced_mass(mass(diameter_i), mass(diameter_j)),
                              request_.restitution, adhesion_of(pair), speed);
  }
  std::vector<double> material_of_pairs() const {
    if (elastic || request_.elastic.young == 0.0 || sizes.all().size() == 1) return {};
    std::vector<double> all;
    for (const PowderSize& i : sizes.all())
      for (const PowderSize& j : sizes.all())
        all.push_back(
            parcels.stiffness(stiffness_stood_for(material_stiffness(i.diameter, j.diameter))));
    return all;
  }

  /// Time step for a contact of two of the smallest grains, [time].
  double step_of_contact() const {
    // At the speeds of the run, parcels fall through their diameter as grains do at this gravity.
    const double gravity = parcels.length(request_.gravity);
    if (elastic) return elastic->used.advised_step(speed, gravity);
    contact::ContactParameters contact;
    contact.stiffness = springs.used.stiffness;
    contact.restitution = request_.restitution;
    contact.friction = request_.friction;
    const double small = sizes.smallest();
    contact::Adhesion in_run{};
    in_run.force = springs.used.pull_off;
    return std::min(
        springs.used.contact_time / steps_of_spring(),
        advice::planned_steady_step(
            advice::contact_of_equals(contact, 0.5 * small, mass(small), in_run), speed, gravity));
  }
  double steps_of_spring() const {
    if (request_.is_packing()) return steps_per_contact_of_packing;
    return request_.engine == "liggghts" ? steps_per_contact_liggghts : steps_per_contact;
  }

  const PowderRequest& request_;
};

}  // namespace cohesion::tools
