// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "advice/elastic_pair.h"
#include "hamaker/forms.h"
#include "hamaker/roughness.h"
#include "named_table.h"
#include "printed_lines.h"
#include "sphere.h"

namespace cohesion::tools {

/// What `cohesion-mapping contact` is given, besides the two particles: Hertz's contact with a
/// Hamaker attraction, or JKR's. Any consistent set of units.
struct ElasticRequest {
  double young = 0.0, poisson = 0.3, soft_young = 0.0, restitution = 0.9;
  double surface_energy = 0.0, hamaker = 0.0, asperity = 0.0;
  std::vector<double> cutoffs, roughness;
  std::string form = "small_gap", keep = "velocity";
  double speed = 0.0;
};

inline void add_options(CLI::App& app, ElasticRequest& r) {
  std::vector<std::string> forms, keeps;
  for (const auto& form : hamaker::forms) forms.emplace_back(form.name);
  for (const auto& keep : contact::keeps) keeps.emplace_back(keep.name);
  app.add_option("--young", r.young, "Young's modulus [force/length^2]")->required();
  app.add_option("--poisson", r.poisson, "Poisson's ratio")->capture_default_str();
  app.add_option("--restitution", r.restitution, "e of a contact without cohesion")
      ->capture_default_str();
  auto* energy = app.add_option("--surface-energy", r.surface_energy,
                                "of each surface: JKR's contact [energy/length^2]")
                     ->check(CLI::PositiveNumber);
  auto* cutoffs = app.add_option("--cutoff", r.cutoffs,
                                 "surface and outer cut-off H_cut H_out of the attraction [length]")
                      ->expected(2);
  auto* constant =
      app.add_option("--hamaker", r.hamaker, "Hamaker constant A: Hertz's contact [energy]")
          ->check(CLI::PositiveNumber)
          ->needs(cutoffs)
          ->excludes(energy);
  cutoffs->needs(constant);
  app.add_option("--form", r.form, "of the attraction")
      ->check(CLI::IsMember(forms))
      ->needs(constant);
  auto* asperity =
      app.add_option("--asperity", r.asperity, "radius of asperities [length]")->needs(constant);
  app.add_option("--roughness", r.roughness,
                 "rms and wavelength of the surface, in place of it [length]")
      ->expected(2)
      ->needs(constant)
      ->excludes(asperity);
  app.add_option("--speed", r.speed, "of impacts; not given: the escape velocity [length/time]")
      ->check(CLI::PositiveNumber);
  auto* soft = app.add_option("--soft-young", r.soft_young,
                              "modulus of the run, softer than the material [force/length^2]")
                   ->check(CLI::PositiveNumber);
  app.add_option("--keep", r.keep, "what that keeps of the material")
      ->check(CLI::IsMember(keeps))
      ->needs(soft)
      ->capture_default_str();
}

/// The numbers of the two, of the material and of a run with a softer modulus.
class ElasticNumbers {
 public:
  ElasticNumbers(const ElasticRequest& r, const PairGeometry& geometry, double reduced_mass)
      : request_(r),
        hamaker_(hamaker_of(r)),
        real_(contact_of(r), geometry.reduced_radius, reduced_mass, adhesion_of(r, geometry)),
        geometry_(geometry),
        mass_(reduced_mass) {
    const double force = real_.pull_off_force();
    keep_ = find_by_name(contact::keeps, "quantity to keep", r.keep).keep;
    escape_ = real_.escape_velocity();
    speed_ = r.speed > 0.0 ? r.speed : escape_;
    require(speed_ > 0.0 && std::isfinite(speed_), "speed of impacts", speed_,
            "a pair that never sticks, or always, has no escape velocity: give --speed");
    require(!softens() || force == 0.0 || keep_ == contact::Keep::force || is_plain(),
            "asperity radius", hamaker::asperity_of(r.asperity, r.roughness).radius,
            "only the form small_gap without asperities is scaled: add --keep force");
    if (!softens()) return;
    soft_ = real_.softened(r.soft_young / r.young * real_.contact().modulus, keep_);
    soft_hamaker_ = contact::for_stiffness(
        soft_->contact().modulus, {real_.contact().modulus, keep_, contact::hertz_power}, hamaker_);
  }

  void print(bool csv) const {
    const Lines lines(csv);
    lines.heading(std::string(real_.is_jkr() ? "JKR's" : "Hertz's") + " contact, of the material");
    lines({"reduced_modulus", "reduced modulus E*", real_.contact().modulus, "[force/length^2]"});
    lines({"pull_off", "pull-off force", real_.pull_off_force(), "[force]"});
    print_tearing(lines);
    lines({"escape_velocity", "escape velocity", escape_, "[length/time]"});
    const double e = request_.restitution;
    if (e > 0.0 && e < 1.0)
      lines({"well_depth", "square well of the same escape velocity",
             0.5 * mass_ * escape_ * escape_ / std::expm1(-2.0 * std::log(e)), "[energy]"});
    print_step(lines, real_, "");
    if (!soft_) return;
    lines.heading("Of a run with the softer modulus");
    lines({"soft_pull_off", "pull-off force", soft_->pull_off_force(), "[force]"});
    lines({"soft_escape_velocity", "escape velocity", soft_->escape_velocity(), "[length/time]"});
    print_adhesion(lines);
    print_step(lines, *soft_, "soft_");
  }

 private:
  bool softens() const { return request_.soft_young > 0.0; }
  bool is_plain() const {
    return real_.is_jkr() || (request_.form == "small_gap" && hamaker_.asperity_radius == 0.0);
  }

  static hamaker::HamakerParameters hamaker_of(const ElasticRequest& r) {
    if (r.hamaker == 0.0) return hamaker::none;
    const hamaker::Asperity asperity = hamaker::asperity_of(r.asperity, r.roughness);
    return {r.hamaker, r.cutoffs.at(0), r.cutoffs.at(1), asperity.radius, asperity.height};
  }
  static contact::ContactParameters contact_of(const ElasticRequest& r) {
    contact::ContactParameters p;
    contact::set_hertz(p, r.young, r.poisson);
    p.restitution = r.restitution;
    p.friction = 1.0;  // Contacts with friction need the shorter steps.
    if (r.surface_energy > 0.0) contact::set_surface_energy(p, r.surface_energy);
    return p;
  }
  static contact::Adhesion adhesion_of(const ElasticRequest& r, const PairGeometry& geometry) {
    if (r.hamaker == 0.0) return {};
    const hamaker::HamakerParameters p = hamaker_of(r);
    const hamaker::AnyLaw law =
        find_by_name(hamaker::forms, "form", r.form).law(p, p.asperity_radius > 0.0);
    return std::visit([&](const auto& l) { return contact::adhesion_of(l, geometry); }, law);
  }

  void print_tearing(const Lines& lines) const {
    if (!real_.is_jkr()) return;
    const double w = real_.contact().work_of_adhesion, modulus = real_.contact().modulus;
    lines({"work_of_adhesion", "work of adhesion", w, "[energy/length^2]"});
    lines({"tearing_gap", "gap at which the neck tears",
           contact::JkrSpringDashpot::tearing_gap(modulus, geometry_.reduced_radius, w),
           "[length]"});
  }

  /// The adhesion that a script with the softer modulus has where it does not name the material.
  void print_adhesion(const Lines& lines) const {
    if (real_.is_jkr()) {
      lines({"soft_surface_energy", "surface energy", 0.5 * soft_->contact().work_of_adhesion,
             "[energy/length^2]"});
    } else if (hamaker_.hamaker_constant > 0.0) {
      lines({"soft_hamaker", "Hamaker constant A", soft_hamaker_.hamaker_constant, "[energy]"});
      lines({"soft_cutoff", "surface cut-off H_cut", soft_hamaker_.surface_cutoff, "[length]"});
    }
  }

  void print_step(const Lines& lines, const advice::ElasticPair& pair,
                  const std::string& name) const {
    const double time = pair.contact_time(speed_);
    lines({name + "contact_time", "contact time, impact at the speed", time, "[time]"});
    lines({name + "overlap", "largest overlap of this impact", pair.largest_overlap(speed_),
           "[length]"});
    lines({name + "step", "time step, a twentieth of it or less", pair.advised_step(speed_),
           "[time]"});
    lines({name + "largest_step", "largest step without warning, a tenth or less",
           pair.largest_step(speed_), "[time]"});
    // The engines evaluate the larger of the two speeds.
    lines({name + "fastest", "steps valid up to this speed and sqrt(2 g d)",
           advice::fastest_over_impact * speed_, "[length/time]"});
  }

  const ElasticRequest& request_;
  hamaker::HamakerParameters hamaker_, soft_hamaker_{};
  advice::ElasticPair real_;
  std::optional<advice::ElasticPair> soft_;
  PairGeometry geometry_;
  double mass_, escape_, speed_;
  contact::Keep keep_;
};

}  // namespace cohesion::tools
