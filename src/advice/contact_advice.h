// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "advice/contact_numbers.h"
#include "constants.h"

/// What to say about a type pair before the first step.
namespace cohesion::advice {

/// What a stepping scheme asks of the step.
struct SchemeLimits {
  std::string_view scheme;
  double steps_for_warning;  ///< steps per contact below which results suffer
  double steps_for_error;    ///< steps per contact below which they mean nothing; 0: no such number
  bool samples_force;        ///< one force per step: leapfrog's limit holds, and gaps are skipped
  /// How often a contact takes a speed from two places a step apart: where it begins and ends.
  double speeds_of_places;
  /// The same two numbers, of the normal contact alone, of springs without a closed form.
  double integrated_for_warning = 0.0, integrated_for_error = 0.0;
  /// What else than a smaller step helps where gaps are skipped.
  std::string_view remedy = "use the exact scheme";
};

/// Force sampled once per step: 15 to 50 steps per contact are usual; the error is leapfrog's own.
inline constexpr SchemeLimits sampled_scheme{"sampled", 15.0, 0.0, true, 0.0};
/// Closed-form pair motion, exact for one pair while a step is no longer than a contact
/// (contact_solver/damped_oscillator.h, first_zero). Of many, a dense elastic gas keeps its energy
/// to 3e-4 in 100 collisions at 4 steps per contact. Springs without a closed form are integrated:
/// at 10 steps per contact pairs part at the escape velocity within 0.1 % (restitution above 0.7),
/// at 20 within 0.05 %.
inline constexpr SchemeLimits exact_scheme{"exact", 4.0, 1.0, false, 2.0, 10.0, 4.0};
/// The same in LIGGGHTS, whose contacts do not know how a wall accelerates: at 4 steps per contact
/// an elastic one parts from a wall that moves away at half of its strength.
inline constexpr SchemeLimits exact_scheme_one_pass{"exact", 10.0, 1.0, false, 2.0, 10.0, 4.0};

/// Overlap over diameter above which spheres are no longer almost rigid.
inline constexpr double overlap_for_warning = 0.01;
/// Nothing blows up before a centre reaches the plane of a wall, which then pushes it out at the
/// wrong side. Between equal spheres the same happens at twice this overlap.
inline constexpr double overlap_for_error = 0.5;
/// Steps in the surface cut-off below which a sampled force gets the work of the adhesion wrong.
inline constexpr double cutoff_steps_for_warning = 1.0;
/// Fraction of the speed of an impact that rounding may leave open: what 15 steps leave open of the
/// escape velocity where a force is sampled.
inline constexpr double rounding_for_warning = 1.0 / 15.0;

enum class Severity { warning, error };

/// What a finding is about.
enum class Subject {
  contact_steps,    ///< steps per contact against the scheme's limits
  stability,        ///< leapfrog's limit (sampled force only)
  steadiness,       ///< of discrete springs where a particle has several contacts (exact scheme)
  cutoff_steps,     ///< steps in the surface cut-off (sampled force only)
  escape_velocity,  ///< of a square well, as far as the step decides it (sampled force only)
  rounding,         ///< of places, against the way in a step
  static_overlap,   ///< F_ad/K
  impact_overlap,   ///< of an impact at the given speed
  softness,         ///< of the spring, against that of the material (softness.h)
};

struct Finding {
  Subject subject;
  Severity severity;
  std::string sentence;  ///< the number, and what to change; in the user's units
  /// Of an error, the step that the sentence names, [time]; infinity: none.
  double largest_step = std::numeric_limits<double>::infinity();
};

namespace detail {

template <class... Part>
std::string text(const Part&... part) {
  std::ostringstream out;
  out.precision(3);
  (out << ... << part);
  return out.str();
}

}  // namespace detail

/// The largest number with three digits that is not above `limit`: a step that a sentence
/// names is small enough.
inline double named_step(double limit) {
  if (!(limit > 0.0) || !std::isfinite(limit)) return limit;
  const double scale = std::pow(10.0, 2.0 - std::floor(std::log10(limit)));
  // Rounding must not take the last digit from a limit that has no more of them.
  const double named = std::floor(limit * scale * (1.0 + 1e-12)) / scale;
  return named <= limit ? named : named - 1.0 / scale;
}

namespace detail {

/// The steps of a contact, and which number of them the scheme asks for.
inline double contact_steps_of(const ContactNumbers& n, const SchemeLimits& limits) {
  const bool integrated = !n.parameters().is_linear && !limits.samples_force;
  return integrated ? n.steps_per_normal_contact() : n.steps_per_contact();
}

/// The step that it names is at most steady_step [time].
inline std::optional<Finding> contact_steps(const ContactNumbers& n, SchemeLimits limits,
                                            double steady_step) {
  const double steps = contact_steps_of(n, limits);
  if (!n.parameters().is_linear && !limits.samples_force) {
    limits.steps_for_warning = limits.integrated_for_warning;
    limits.steps_for_error = limits.integrated_for_error;
  }
  if (steps >= limits.steps_for_warning) return std::nullopt;
  // Half a contact time to the last digit is still half a contact time.
  const bool fatal = steps < (1.0 - 1e-6) * limits.steps_for_error;
  const std::string least = limits.steps_for_error > 0.0
                                ? text(" and cannot do with fewer than ", limits.steps_for_error)
                                : "";
  const double named =
      named_step(std::min(n.parameters().dt * steps / limits.steps_for_warning, steady_step));
  return Finding{Subject::contact_steps, fatal ? Severity::error : Severity::warning,
                 text("a contact takes ", steps, " time steps, the ", limits.scheme,
                      " scheme should have ", limits.steps_for_warning, least,
                      ": reduce the time step to ", named, " or soften the spring"),
                 named};
}

inline std::optional<Finding> stability(const ContactNumbers& n) {
  const double dt = n.parameters().dt, limit = n.stable_step();
  if (dt < limit) return std::nullopt;
  return Finding{
      Subject::stability, Severity::error,
      text("the time step ", dt, " makes contacts unstable: reduce it below ", named_step(limit)),
      limit};
}

/// The largest step [time] in which a particle with several contacts is steady.
inline double steady_step(const ContactNumbers& n, bool plane) {
  const bool at_wall = !std::isfinite(n.parameters().radius_i + n.parameters().radius_j);
  return n.steady_step(at_wall ? ClosestPacking::at_wall()
                       : plane ? ClosestPacking::in_plane()
                               : ClosestPacking::in_space());
}

/// Where a particle has several contacts, or will have. limit [time]: steady_step().
inline std::optional<Finding> steadiness(const ContactNumbers& n, bool several, double limit) {
  const double dt = n.parameters().dt;
  if (dt <= limit) return std::nullopt;
  return Finding{
      Subject::steadiness, several ? Severity::error : Severity::warning,
      text("the time step ", dt, " makes particles with several contacts ",
           several ? "unstable, so that they gain energy without bound"
                   : "unstable: the run stops where a particle has two neighbours",
           ": reduce it to ", named_step(limit), ", or use less damping or softer springs"),
      limit};
}

/// The finding on a pair that touches at `speed` u [length/time] and crosses `cutoff` H_cut
/// [length] in `steps` time steps.
inline std::optional<Finding> cutoff_steps(double speed, double cutoff, double steps,
                                           const SchemeLimits& limits) {
  if (steps >= cutoff_steps_for_warning) return std::nullopt;
  return Finding{
      Subject::cutoff_steps, Severity::warning,
      text("a pair at ", speed, " crosses the surface cut-off in ", steps,
           " time steps, so that which pairs stick is left to chance: reduce the time step to ",
           named_step(cutoff / speed), " or ", limits.remedy)};
}

/// What 15 steps of a lightly damped contact leave open is allowed to the others, too.
inline std::optional<Finding> escape_velocity(const ContactNumbers& n, const SchemeLimits& limits) {
  const double open = n.sampled_escape_error(), allowed = 1.0 / limits.steps_for_warning;
  const double escape = n.escape_velocity();
  // Two particles meet at up to twice the speed; slower pairs stick at any step.
  const bool reached =
      escape > 0.0 && std::isfinite(escape) && 2.0 * n.parameters().speed >= (1.0 - open) * escape;
  if (open <= allowed || !reached) return std::nullopt;
  return Finding{
      Subject::escape_velocity, Severity::warning,
      text("the step leaves the speed below which pairs stick, ", escape, ", open by ",
           100.0 * open, " %, so that which pairs stick is left to chance: for ", 100.0 * allowed,
           " % reduce the time step to ", named_step(n.parameters().dt * allowed / open))};
}

inline std::optional<Finding> rounding(const ContactNumbers& n, const SchemeLimits& limits) {
  const double error = n.rounding_error(limits.speeds_of_places);
  const double allowed = rounding_for_warning;
  if (error <= allowed) return std::nullopt;
  return Finding{
      Subject::rounding, Severity::warning,
      text("rounded places leave the speed of an impact at ", n.entry_speed(), " open by up to ",
           100.0 * error, " %: for ", 100.0 * allowed, " % raise the time step to ",
           n.parameters().dt * error / allowed, " and soften the spring")};
}

/// The overlap falls as stiffness^(-1/power) of a linear spring, and as E*^(-1/(power + 1/2)) of
/// Hertz's contact. The contact time of an impact falls as stiffness^(-1/2) and as E*^(-2/5).
inline std::optional<Finding> overlap(Subject subject, const char* name, double over_diameter,
                                      const PairParameters& pair, double power) {
  if (over_diameter <= overlap_for_warning) return std::nullopt;
  std::string sentence = text(name, " is ", 100.0 * over_diameter, " % of the diameter");
  const bool fatal = over_diameter >= overlap_for_error;
  if (fatal) sentence += ", so far that particles pass through walls";
  const double excess = over_diameter / overlap_for_warning;
  const std::string aim = text(": for ", 100.0 * overlap_for_warning, " % ");
  const double factor = std::pow(excess, pair.is_linear ? power : power + 0.5);
  const std::string cure =
      pair.is_linear ? text("raise the stiffness to about ", pair.stiffness * factor)
                     : text("raise Young's modulus to up to ", factor, " times its value");
  const double dt = pair.dt * std::pow(factor, pair.is_linear ? -0.5 : -0.4);
  const std::string step = text("; for as many steps per contact, lower the time step to ", dt);
  return Finding{subject, fatal ? Severity::error : Severity::warning,
                 sentence + aim + cure + step};
}

}  // namespace detail

/// What is to be said of a pair in this scheme, in the order of Subject; empty: nothing.
/// steady_step [time]: the largest one of particles with several contacts; infinite: there are
/// none.
inline std::vector<Finding> advise(const ContactNumbers& n, const SchemeLimits& limits,
                                   double steady_step = std::numeric_limits<double>::infinity()) {
  const PairParameters& p = n.parameters();
  const bool attracts = p.adhesion.force > 0.0;
  std::vector<Finding> findings;
  const auto add = [&](const std::optional<Finding>& finding) {
    if (finding) findings.push_back(*finding);
  };
  add(detail::contact_steps(n, limits, steady_step));
  if (limits.samples_force) add(detail::stability(n));
  if (limits.samples_force && attracts && p.adhesion.cutoff > 0.0)
    add(detail::cutoff_steps(n.entry_speed(), p.adhesion.cutoff, n.steps_in_cutoff(), limits));
  // A force in the spring has an escape velocity of another kind.
  if (limits.samples_force && !attracts && n.well_energy() > 0.0)
    add(detail::escape_velocity(n, limits));
  add(detail::rounding(n, limits));
  if (attracts)
    add(detail::overlap(Subject::static_overlap, "the overlap of a resting pair",
                        n.static_overlap_over_diameter(), p, 1.0));
  // Of a fast impact, whose overlap goes as 1/w0; adhesion makes it fall faster.
  add(detail::overlap(Subject::impact_overlap, "the largest overlap of an impact",
                      n.impact_overlap_over_diameter(), p, 2.0));
  return findings;
}

}  // namespace cohesion::advice
