// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_SOFT_CONTACT_STYLE_H
#define COHESION_SOFT_CONTACT_STYLE_H

#include <string>

namespace LAMMPS_NS {

/// The pair styles and walls with soft contacts, of either scheme: what FixEventStep orders within
/// a step. FixEventStep::run_corrector() calls all of this with the first forces of a step; the
/// corrector is each style's own part of Pair::compute or Fix::post_force. In the sampled scheme
/// classify() finds the close pairs alone, and contacts are computed in that part.
class SoftContactStyle {
 public:
  /// Lets contacts that last act, and adds the others, whose particles are disturbed, to those that
  /// are followed.
  virtual void classify() = 0;
  /// Marks particles that have a young contact and another one as crowded, or disturbed.
  virtual void find_beside_young() = 0;
  /// Adds lasting contacts of disturbed particles to those that are followed, too, and undoes what
  /// they did. Then adds what leads to the true motion of the particles of all that are followed.
  virtual void follow_disturbed() = 0;
  /// Adds pairs out of range to those that are followed, where others may bring them together.
  virtual void follow_far() = 0;
  /// Adds what lasting contacts do to particles that have a followed one, and what leads to the
  /// true motion of these.
  virtual void couple_lasting() = 0;
  /// The predictor: every followed contact by itself, as if its particles had no other.
  virtual void predict() = 0;
  /// Whether friction turns particles of this type.
  virtual bool has_friction(int type) const = 0;
  /// Whether any contact may act in this run.
  virtual bool may_have_contacts() const { return true; }
  /// Whether contacts are those of scheme event, which takes account of what they do to each other
  /// within a step; else they are sampled.
  virtual bool is_event_scheme() const = 0;
  /// What messages call the style: 'pair_style NAME', or 'fix ID NAME'.
  virtual std::string name() const = 0;
  /// Whether it has contacts with a spring, which act in this run.
  virtual bool has_contacts() const { return true; }
  /// Where a run takes over the forces of the last one: finds what has come into range or out of it
  /// between the two, and adds what the contacts store to the energy tally.
  virtual void continue_run() = 0;
  /// Particles have other IDs than those by which contacts are remembered.
  virtual void renumber(const class Renumbering&) {}

 protected:
  ~SoftContactStyle() = default;
};

}  // namespace LAMMPS_NS

#endif
