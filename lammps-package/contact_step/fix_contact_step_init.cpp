// SPDX-License-Identifier: GPL-2.0-only
// The part of FixContactStep that finds the styles and the other fixes of a run at set-up, and
// stops runs that it cannot integrate.
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "advice/unlike_walls.h"
#include "atom.h"
#include "comm.h"
#include "common/message.h"
#include "common/other_forces.h"
#include "common/unmoved_spheres.h"
#include "common/unturned_spheres.h"
#include "contact_step/fix_contact_step.h"
#include "contact_step/soft_contact_style.h"
#include "engine/announced_particles.h"
#include "engine/mobile_particles.h"
#include "engine/pair_members.h"
#include "engine/rerun.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

void FixContactStep::init() {
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "scheme exact follows contacts over the whole step; use 'run_style verlet'");
  if (force->newton_pair)
    error->all(FLERR,
               "scheme exact works out every contact on both sides; put 'newton off' before the "
               "box is made");
  if (comm->ghost_velocity == 0)
    error->all(FLERR,
               "scheme exact needs the velocities of ghost particles; add 'comm_modify vel yes'");

  find_styles();
  mobile->look_up(lmp);
  bool before_me = true;
  any_dynamic_group = false;
  for (int i = 0; i < modify->nfix; i++) {
    const Fix* const fix = modify->fix[i];
    if (fix == this) before_me = false;
    if (group->dynamic[fix->igroup] && (fix->time_integrate || strcmp(fix->style, "freeze") == 0))
      any_dynamic_group = true;
    if (before_me && MobileParticles::integrates(fix))
      error->all(FLERR, std::string("fix ") + fix->id +
                            " integrates the motion: put it behind the pair_style and wall "
                            "commands of scheme exact");
  }
  may_have_contacts = std::any_of(styles.begin(), styles.end(),
                                  [](const SoftContactStyle* s) { return s->may_have_contacts(); });
  any_exact_scheme = std::any_of(styles.begin(), styles.end(), [](const SoftContactStyle* some) {
    return some->is_exact_scheme();
  });
  others_act = other_styles_act();
  refuse_rerun(lmp, any_exact_scheme ? "scheme exact" : "scheme sampled");
  refuse_rigid_bodies();
  if (may_have_contacts && (any_exact_scheme || !warned_of_partly_held))
    warned_of_partly_held = require_whole_holds(
        lmp, any_exact_scheme ? "scheme exact" : "scheme sampled", any_exact_scheme);
  require_spheres();
  warn_of_spins();
  warn_of_unmoved();
  warn_of_unlike_walls();
  warn_of_added_contacts();
  follow_renumbering();
}

void FixContactStep::find_styles() {
  styles.clear();
  for (int i = 0; i < modify->nfix; i++)
    if (auto* wall = dynamic_cast<SoftContactStyle*>(modify->fix[i])) styles.push_back(wall);
  for (const PairMember& member : pair_members(force))
    if (auto* pairs = dynamic_cast<SoftContactStyle*>(member.pair)) styles.push_back(pairs);
}

/// Whether anything but contacts and gravity exerts forces.
bool FixContactStep::other_styles_act() const {
  for (const PairMember& member : pair_members(force))
    if (!dynamic_cast<SoftContactStyle*>(member.pair)) return true;
  return other_forces_act(lmp, [this](const Fix& fix) {
    return &fix == this || dynamic_cast<const SoftContactStyle*>(&fix) ||
           utils::strmatch(fix.style, "^gravity");
  });
}

/// Contacts use the masses of single spheres, not those of rigid bodies.
void FixContactStep::refuse_rigid_bodies() const {
  if (!may_have_contacts) return;
  for (int i = 0; i < modify->nfix; i++) {
    const Fix* const fix = modify->fix[i];
    if (fix->rigid_flag)
      stop(lmp, FLERR, any_exact_scheme ? "scheme exact" : "scheme sampled",
           ": contacts move each sphere by itself, and fix ", fix->id, " ", fix->style,
           " moves bodies of several: use a granular pair_style and fix wall/gran of LAMMPS for "
           "their contacts, with 'pair_style hybrid/overlay' and 'pair_style hamaker', and 'fix "
           "wall/hamaker', laid over them for the attraction");
  }
}

/// Friction and rotational energy use the moment of inertia of spheres.
void FixContactStep::require_spheres() {
  const bool matters =
      energy_tally.has_readers() ||
      std::any_of(styles.begin(), styles.end(), [this](const SoftContactStyle* some) {
        bool any = false;
        for (int type = 1; type <= atom->ntypes; type++) any = any || some->has_friction(type);
        return any && some->is_exact_scheme();
      });
  if (!matters) return;
  for (int i = 0; i < modify->nfix; i++)
    if (MobileParticles::turns_discs(modify->fix[i]))
      error->all(FLERR, std::string("fix ") + modify->fix[i]->id + " " + modify->fix[i]->style +
                            " disc: friction of scheme exact and compute gran/energy "
                            "take particles for spheres, of moment of inertia 2/5 m R^2; leave out "
                            "'disc'");
}

/// Issued once in the life of the fix.
void FixContactStep::warn_of_unmoved() {
  if (warned_of_unmoved || !may_have_contacts) return;
  std::vector<int> announced;
  for (const AnnouncedParticle& particle : announced_particles(lmp))
    announced.push_back(particle.mask);
  warned_of_unmoved = LAMMPS_NS::warn_of_unmoved(lmp, announced);
}

/// Warns of walls whose adhesion or scheme differs from that of the pairs. Each text is issued
/// once.
void FixContactStep::warn_of_unlike_walls() {
  std::vector<cohesion::advice::StickingRules> pairs, walls;
  for (const SoftContactStyle* some : styles) {
    if (dynamic_cast<const Fix*>(some))
      walls.push_back(some->sticking_rules());
    else if (some->has_contacts())
      pairs.push_back(some->sticking_rules());
  }
  for (const std::string& text :
       cohesion::advice::warnings_of_walls(walls, pairs, "exact where the keyword is missing"))
    if (warned_of_walls.insert(text).second && comm->me == 0) error->warning(FLERR, text);
}

/// Warns of types between which hybrid/overlay adds the springs of several contact styles. Issued
/// once.
void FixContactStep::warn_of_added_contacts() {
  for (int i = 1; i <= atom->ntypes && !warned_of_added_contacts; i++)
    for (int j = i; j <= atom->ntypes && !warned_of_added_contacts; j++) {
      std::string names;
      int count = 0;
      for (const PairMember& member : pair_members_between(force, i, j)) {
        const auto* const ours = dynamic_cast<SoftContactStyle*>(member.pair);
        if (ours ? !ours->has_contacts() : !utils::strmatch(member.style, "^gran")) continue;
        names += (count++ ? " and " : "") + member.style;
      }
      warned_of_added_contacts = count > 1;
      if (warned_of_added_contacts && comm->me == 0)
        error->warning(FLERR, "pair_style hybrid/overlay: between types " + std::to_string(i) +
                                  " and " + std::to_string(j) + " the contact springs of " + names +
                                  " add up; give one contact style to each pair of types, and "
                                  "overlay only attractions without a contact (hamaker, "
                                  "squarewell)");
    }
}

/// Warns of spheres on which friction acts and that do not rotate. Issued once.
void FixContactStep::warn_of_spins() {
  if (warned_of_unturned && warned_of_held) return;
  std::vector<bool> has_friction(atom->ntypes + 1, false);
  for (int type = 1; type <= atom->ntypes; type++)
    for (const SoftContactStyle* some : styles)
      has_friction[type] = has_friction[type] || some->has_friction(type);
  if (!warned_of_unturned) warned_of_unturned = warn_of_unturned(lmp, *mobile, has_friction);
  if (!warned_of_held)
    warned_of_held =
        warn_of_held_turned(lmp, mobile->held(), mobile->turned_groups(), has_friction);
}
