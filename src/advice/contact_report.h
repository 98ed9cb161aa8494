// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "advice/contact_advice.h"
#include "advice/integrated_escape.h"
#include "advice/power_law_spring.h"
#include "advice/softness.h"

/// What a style prints before the first step of a run.
namespace cohesion::advice {

/// The smallest particle of a type, and the lightest that moves: its contacts are the shortest.
struct LightestParticle {
  double radius;  ///< [length]; infinite for a wall and for a type without particles
  double mass;    ///< [mass]; infinite for a wall and for a type that does not move
};

/// One contact that a run may see.
struct AdvisedContact {
  std::string name;
  LightestParticle i, j;
  ContactSprings springs;
  contact::Adhesion adhesion;
  contact::Material material = {};       ///< whose contact it stands for
  std::string_view material_words = {};  ///< by which a user tells it; empty: there are none
  std::string doubt = {};  ///< of the adhesion's numbers, before what would bear it; empty: none

  bool moves() const { return inverse_mass() > 0.0; }
  double reduced_mass() const { return 1.0 / inverse_mass(); }
  double diameter() const { return 2.0 * std::min(i.radius, j.radius); }
  /// R*, [length]; beside a wall the radius.
  double reduced_radius() const { return 1.0 / (1.0 / i.radius + 1.0 / j.radius); }
  /// Between the centres; beside a wall the diameter.
  double distance() const {
    const double sum = i.radius + j.radius;
    return std::isfinite(sum) ? sum : diameter();
  }

 private:
  double inverse_mass() const { return 1.0 / i.mass + 1.0 / j.mass; }
};

/// K of a linear spring, or E*.
inline double stiffness_of(const ContactSprings& s) {
  return s.exponent == contact::linear_power ? s.stiffness : s.modulus;
}

/// How many contacts a particle of a run may have at a time.
enum class Crowd {
  pair,      ///< there are at most two particles
  separate,  ///< no particle has more than one neighbour now
  several,   ///< some particle has several neighbours, or particles are still to come
};

/// What all contacts of a run share.
struct RunNumbers {
  double fastest;      ///< speed of the fastest particle, beyond a mean shear, [length/time]
  double gravity;      ///< largest acceleration, [length/time^2]
  double dt;           ///< [time]
  double shear = 0.0;  ///< rate of a mean shear, [1/time]
  Crowd crowd = Crowd::pair;
  bool plane = false;  ///< two dimensions
};

struct Warning {
  std::vector<std::string> contacts;  ///< their names
  Subject subject;
  std::string text;
};

struct Report {
  std::string table;
  std::vector<Warning> warnings;
  std::string stop;  ///< why the run must not begin; empty: it may
};

/// Approach speed to judge a contact by, [length/time]: of the fastest particle, or of one that
/// falls through the smaller diameter of the two; and what a mean shear adds between the centres.
inline double approach_speed(const RunNumbers& run, const AdvisedContact& c) {
  return std::max(run.fastest, std::sqrt(2.0 * run.gravity * c.diameter())) +
         std::abs(run.shear) * c.distance();
}

/// Speed at first touch, what the attraction adds on the way included, [length/time].
inline double touching_speed(const RunNumbers& run, const AdvisedContact& c) {
  const double speed = approach_speed(run, c);
  return std::sqrt(speed * speed + 2.0 * c.adhesion.well_energy() / c.reduced_mass());
}

/// Numbers of one contact; one partner must move. A spring that is not linear is that of an impact
/// at the approach speed.
inline ContactNumbers numbers(const AdvisedContact& c, const RunNumbers& run) {
  const double speed = approach_speed(run, c);
  const ContactSprings s =
      linear_springs(c.springs, c.reduced_mass(), c.adhesion.force, touching_speed(run, c));
  return ContactNumbers({c.i.radius, c.j.radius, c.i.mass, c.j.mass, s.stiffness, s.damping,
                         c.adhesion, speed, run.dt, run.gravity, s.tangential_stiffness,
                         s.rolling_stiffness, s.tangential_damping, s.rolling_damping,
                         c.springs.exponent == 1.0});
}

/// Approach speed below which a pair sticks, [length/time].
inline double escape_velocity(const AdvisedContact& c, const RunNumbers& run) {
  if (c.springs.exponent == 1.0) return numbers(c, run).escape_velocity();
  if (c.springs.jkr) return escape_velocity(*c.springs.jkr, c.springs.hertz(c.reduced_mass()));
  return escape_velocity(c.springs.hertz(c.reduced_mass()), c.adhesion);
}

namespace detail {

inline std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// What a row begins with.
inline std::string name(const AdvisedContact& c) {
  return "  " + c.name + std::string(c.name.size() < 10 ? 10 - c.name.size() : 0, ' ');
}

inline std::string row(const AdvisedContact& c, const ContactNumbers& n, const SchemeLimits& limits,
                       double escape) {
  // JKR's spring and adhesion are one.
  const bool attracts = n.parameters().adhesion.force > 0.0 && !c.springs.jkr;
  const std::string ratio =
      attracts ? number("%.3g", n.well_energy() / n.spring_adhesion_energy()) : "none";
  return name(c) + number("%9.3g", n.parameters().speed) +
         number("%11.4g", contact_steps_of(n, limits)) + number("%14.3g", n.steps_in_cutoff()) +
         number("%10.2g", n.static_overlap_over_diameter()) +
         number("%10.2g", n.impact_overlap_over_diameter()) + number("%10.3g", n.bond_number()) +
         number("%10.3g", escape) + std::string(14 - std::min<std::size_t>(14, ratio.size()), ' ') +
         ratio + "\n";
}

/// A sentence about several contacts, with their names.
struct SharedNote {
  std::string sentence;
  std::vector<std::string> contacts;

  std::string names() const {
    std::string all;
    for (const std::string& name : contacts) all += (all.empty() ? "" : ", ") + name;
    return all;
  }
};

inline void add(std::vector<SharedNote>& notes, const std::string& sentence,
                const std::string& contact) {
  for (SharedNote& note : notes)
    if (note.sentence == sentence) {
      note.contacts.push_back(contact);
      return;
    }
  notes.push_back({sentence, {contact}});
}

inline std::string over_material_sentence(const AdvisedContact& c, const RunNumbers& run) {
  const double stiffness = stiffness_of(c.springs);
  const OverMaterial over =
      over_material(c.material, stiffness, c.adhesion, [&](const contact::Adhesion& adhesion) {
        AdvisedContact other = c;
        other.adhesion = adhesion;
        // Its pull-off force is that of its work of adhesion.
        if (c.springs.jkr)
          other.springs.jkr = c.springs.jkr->with_work_of_adhesion(
              adhesion.force / c.adhesion.force * c.springs.jkr->work_of_adhesion());
        return escape_velocity(other, run);
      });
  return name_of_stiffness(c.material) + number(" %.6g", stiffness) +
         number(" for %.6g of the material", c.material.stiffness) +
         number(": escape velocity %.3g", over.escape_velocity) +
         number(", pull-off force %.3g times the material's", over.force);
}

/// Under the table, what a soft spring changed where the material is given; where it is not, a
/// warning if that matters. Each once for all contacts.
inline void add_softness(Report& report, const std::string& style,
                         const std::vector<AdvisedContact>& contacts, const RunNumbers& run) {
  std::vector<SharedNote> scaled, soft;
  for (const AdvisedContact& c : contacts) {
    if (!c.moves() || c.adhesion.force == 0.0) continue;
    // JKR's spring and adhesion are one, which no numbers of the contact tell apart.
    if (!c.material.is_specified() && !c.springs.jkr && softness_decides(numbers(c, run)))
      add(soft, softness_advice(c.material_words), c.name);
    if (c.material.is_specified() && !is_of_material(c.material, stiffness_of(c.springs)))
      add(scaled, over_material_sentence(c, run), c.name);
  }
  for (const SharedNote& note : scaled)
    report.table += "  " + note.sentence + " (" + note.names() + ")\n";
  for (const SharedNote& note : soft)
    report.warnings.push_back(
        {note.contacts, Subject::softness, style + ", " + note.names() + ": " + note.sentence});
}

/// Removes the warnings of steps in a contact that the step an error names would satisfy, so that
/// the messages do not name several steps. `steps`: what each warning names, [time].
inline void remove_satisfied(std::vector<Warning>& warnings, const std::vector<double>& steps,
                             double step_of_error) {
  std::vector<Warning> left;
  for (std::size_t k = 0; k < warnings.size(); k++)
    if (warnings[k].subject != Subject::contact_steps || steps[k] < step_of_error)
      left.push_back(warnings[k]);
  warnings = std::move(left);
}

}  // namespace detail

/// The table of numbers that decide whether the run can be right, a warning for each that says that
/// it will not be, and the first that says that it must blow up, of those about the step the one
/// with the smallest. Contacts of which neither partner moves are left out. `style`: who speaks.
inline Report report(const std::string& style, const SchemeLimits& limits,
                     const std::vector<AdvisedContact>& contacts, const RunNumbers& run) {
  Report report;
  report.table = style + ", scheme " + std::string(limits.scheme) +
                 ": what to expect (lightest particles; / d: over the diameter)\n"
                 "  contact       speed  steps/t_c  H_cut/(v dt)  F_ad/K/d  impact/d"
                 "      Bond     v_esc   tail/spring\n";
  double largest_step = 0.0;
  std::vector<double> steps;  // that the warnings name
  for (const AdvisedContact& c : contacts) {
    if (!c.moves()) continue;
    const ContactNumbers n = numbers(c, run);
    report.table += detail::row(c, n, limits, escape_velocity(c, run));
    const bool packs = !limits.samples_force && run.crowd != Crowd::pair;
    const double steady_step =
        packs ? detail::steady_step(n, run.plane) : std::numeric_limits<double>::infinity();
    std::vector<Finding> findings = advise(n, limits, steady_step);
    if (packs)
      if (const auto finding = detail::steadiness(n, run.crowd == Crowd::several, steady_step))
        findings.push_back(*finding);
    for (const Finding& finding : findings) {
      const bool of_overlap =
          finding.subject == Subject::static_overlap || finding.subject == Subject::impact_overlap;
      const std::string message =
          style + ", " + c.name + ": " + (of_overlap ? c.doubt : "") + finding.sentence;
      if (finding.severity == Severity::warning) {
        report.warnings.push_back({{c.name}, finding.subject, message});
        steps.push_back(finding.largest_step);
      }
      if (finding.severity == Severity::error &&
          (report.stop.empty() ||
           (std::isfinite(largest_step) && finding.largest_step < largest_step))) {
        report.stop = message;
        largest_step = finding.largest_step;
      }
    }
  }
  if (!report.stop.empty() && std::isfinite(largest_step))
    detail::remove_satisfied(report.warnings, steps, largest_step);
  detail::add_softness(report, style, contacts, run);
  return report;
}

/// Of an attraction alone, whose contact is another style's: all that can be judged is whether its
/// surface cut-off is seen. Of contacts with adhesion alone.
inline Report attraction_report(const std::string& style, const SchemeLimits& limits,
                                const std::vector<AdvisedContact>& contacts,
                                const RunNumbers& run) {
  Report report;
  report.table = style + ", scheme " + std::string(limits.scheme) +
                 ": what to expect (lightest particles)\n"
                 "  contact       speed  H_cut/(v dt)\n";
  for (const AdvisedContact& c : contacts) {
    if (!c.moves()) continue;
    const double speed = touching_speed(run, c);
    const double steps = c.adhesion.cutoff / (speed * run.dt);
    report.table += detail::name(c) + detail::number("%9.3g", approach_speed(run, c)) +
                    detail::number("%14.3g", steps) + "\n";
    if (const auto finding = detail::cutoff_steps(speed, c.adhesion.cutoff, steps, limits))
      report.warnings.push_back(
          {{c.name}, finding->subject, style + ", " + c.name + ": " + finding->sentence});
  }
  return report;
}

}  // namespace cohesion::advice
