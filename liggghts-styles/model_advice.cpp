// SPDX-License-Identifier: GPL-2.0-or-later
#include "model_advice.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "common/guarded.h"
#include "common/several_neighbours.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "fix_template_sphere.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "gravity_of_fixes.h"
#include "integrated_particles.h"
#include "liggghts_api.h"
#include "neighbor.h"
#include "pair_gran.h"
#include "sphere.h"
#include "update.h"

namespace LIGGGHTS {
namespace Cohesion {

using namespace LAMMPS_NS;
namespace advice = cohesion::advice;
using advice::LightestParticle;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

void take_lighter(LightestParticle& lightest, double radius, double mass) {
  lightest.radius = std::min(lightest.radius, radius);
  lightest.mass = std::min(lightest.mass, mass);
}

/// Particles that are still to come; they are of the mean density of their template.
void count_templates(Modify* modify, std::vector<LightestParticle>& lightest) {
  for (int k = 0; k < modify->nfix; k++) {
    auto* const spheres = dynamic_cast<FixTemplateSphere*>(modify->fix[k]);
    if (!spheres || spheres->number_spheres() != 1 || spheres->is_relative()) continue;
    const double radius = spheres->min_rad();
    const double density = spheres->massexpect() / spheres->volexpect();
    for (int type = spheres->mintype(); type <= spheres->maxtype(); type++)
      take_lighter(lightest[type], radius, density * cohesion::sphere_volume(radius));
  }
}

bool inserts(const Modify* modify) {
  for (int k = 0; k < modify->nfix; k++)
    if (std::strncmp(modify->fix[k]->style, "insert/", 7) == 0) return true;
  return false;
}

std::set<int> types_of(const FixWallGran& wall) {
  if (!wall.is_mesh_wall()) return {wall.atom_type_wall()};
  std::set<int> types;
  for (int k = 0; k < wall.n_meshes(); k++) types.insert(wall.mesh_list()[k]->atomTypeWall());
  return types;
}

}  // namespace

std::string name_of_wall(const FixWallGran& wall) {
  return std::string("fix ") + wall.id + " wall/gran";
}

void LiggghtsRun::scan_particles(LAMMPS* lmp, advice::RunConditions& now) {
  const Atom* const atom = lmp->atom;
  const IntegratedParticles mobile(lmp);
  std::vector<LightestParticle> mine(atom->ntypes + 1, {infinite, infinite});
  count_templates(lmp->modify, mine);
  for (int i = 0; i < atom->nlocal; i++)
    take_lighter(mine[atom->type[i]], atom->radius[i],
                 mobile.moves(atom->mask[i]) ? atom->rmass[i] : infinite);
  reduce_particles(lmp, mine, fastest_of(atom, lmp->domain, atom->nlocal), now);
}

bool LiggghtsRun::may_crowd(LAMMPS* lmp) {
  const Pair* const pair = lmp->force->pair;
  return inserts(lmp->modify) || has_several_neighbours(lmp, pair ? pair->list : nullptr);
}

double LiggghtsRun::gravity(LAMMPS* lmp) { return GravityOfFixes(lmp->modify).largest(); }

ContactAdvice::ContactAdvice(LAMMPS* lmp, FixWallGran* wall, const std::string& model,
                             const NormalModelProbe& normal, Adhesion adhesion,
                             ContactLaw contact_law)
    : lmp_(lmp),
      wall_(wall),
      model_(model),
      normal_(normal),
      adhesion_(std::move(adhesion)),
      contact_law_(std::move(contact_law)) {}

std::string ContactAdvice::wall() const { return wall_ ? wall_->id : ""; }

advice::Report ContactAdvice::report(const advice::RunConditions& now) {
  const std::string kind =
      normal_.exponent() != 1.0
          ? " (" + normal_.name() + ": linear springs that an impact presses as far)"
          : "";
  const auto who = [&](const std::string& walls) {
    return model_ + (wall_ ? ", fix wall/gran " + walls : "") + kind;
  };
  return guarded(lmp_, who(wall()), [&] {
    const std::vector<advice::AdvisedContact> all = contacts(now);
    const advice::SchemeLimits& limits =
        exact_ ? advice::exact_scheme_one_pass : advice::sampled_scheme;
    return warning_filter_->only_new(advice::report(who(WALLS), limits, all, now.run), all, now);
  });
}

std::vector<advice::AdvisedContact> ContactAdvice::contacts(
    const advice::RunConditions& now) const {
  const std::vector<LightestParticle>& lightest = now.lightest;
  std::vector<advice::AdvisedContact> contacts;
  const auto add = [&](const std::string& name, int i, int j, const LightestParticle& partner) {
    advice::AdvisedContact c{name, lightest[i], partner, {}, {}};
    if (!c.moves()) return;
    adhesion_(c, i, j);
    set_springs(c, i, j, now.run);
    contacts.push_back(c);
  };
  for (int i = 1; i <= lmp_->atom->ntypes; i++) {
    if (!std::isfinite(lightest[i].radius)) continue;  // no particles
    if (wall_) {
      const std::set<int> types = types_of(*wall_);
      for (const int j : types)
        add(std::to_string(i) + " - wall" + (types.size() > 1 ? " of " + std::to_string(j) : ""), i,
            j, {infinite, infinite});
      continue;
    }
    for (int j = i; j <= lmp_->atom->ntypes; j++)
      if (std::isfinite(lightest[j].radius))
        add(std::to_string(i) + " - " + std::to_string(j), i, j, lightest[j]);
  }
  return contacts;
}

advice::StickingRules ContactAdvice::sticking_rules(const advice::RunConditions& now) const {
  advice::StickingRules rules;
  rules.name = wall_ ? name_of_wall(*wall_) : "pair_style gran";
  rules.is_exact = exact_;
  rules.meant_without = true;  // the script gives the strength, 0
  rules.wall_words =
      "'" + model_.substr(0, model_.find(' ') + 1) + model_.substr(model_.rfind(' ') + 1) + "'";
  for (const advice::AdvisedContact& c : contacts(now)) {
    if (!c.adhesion.attracts()) continue;
    rules.adhesion = model_;
    rules.material_words = std::string(c.material_words);
    rules.softenings.push_back({c.material, advice::stiffness_of(c.springs)});
  }
  return rules;
}

void ContactAdvice::set_springs(advice::AdvisedContact& c, int itype, int jtype,
                                const advice::RunNumbers& run) const {
  const NormalModelProbe::ProbedContact pair{itype,
                                             jtype,
                                             c.i.radius,
                                             c.j.radius,
                                             c.reduced_mass(),
                                             advice::approach_speed(run, c),
                                             wall_ != nullptr};
  c.springs = normal_.springs(pair);
  // Told where the impact goes: not every dashpot of the engine changes with the overlap as
  // power_law_spring.h has it.
  if (c.springs.exponent != 1.0) {
    c.springs =
        normal_.springs(pair, advice::largest_overlap(c.springs, c.reduced_mass(), c.adhesion.force,
                                                      advice::touching_speed(run, c)));
    c.springs.modulus = normal_.stiffness(itype, jtype, wall_ != nullptr);
    const cohesion::contact::NormalLaw law =
        contact_law_(c.springs.hertz(c.reduced_mass()), itype, jtype, c.i.radius, c.j.radius);
    if (const auto* const jkr = std::get_if<cohesion::contact::JkrSpringDashpot>(&law))
      c.springs.jkr = *jkr;
  }
  const bool slides = has("tangential", "history") || has("tangential", "no_history");
  if (!slides || coefficient("coeffFrict", itype, jtype) == 0.0)
    c.springs.tangential_stiffness = c.springs.tangential_damping = 0.0;
  if (!has("tangential", "history")) c.springs.tangential_stiffness = 0.0;
  // The spring of rolling model epsd2 is the tangential one, with the reduced radius as lever.
  if (!has("rolling_friction", "epsd2") || coefficient("coeffRollFrict", itype, jtype) == 0.0)
    c.springs.rolling_stiffness = 0.0;
}

bool ContactAdvice::has_friction(int type) const {
  const bool slides = has("tangential", "history") || has("tangential", "no_history");
  const bool rolls = has("rolling_friction", "epsd2") || has("rolling_friction", "cdt");
  // The properties end at the last type that there is.
  const int types = lmp_->force->registry.max_type();
  for (int other = 1; type <= types && other <= types; other++)
    if ((slides && coefficient("coeffFrict", type, other) > 0.0) ||
        (rolls && coefficient("coeffRollFrict", type, other) > 0.0))
      return true;
  return false;
}

bool ContactAdvice::has(const char* kind, const char* model) const {
  return wall_ ? wall_->contact_match(kind, model)
               : static_cast<PairGran*>(lmp_->force->pair)->contact_match(kind, model);
}

/// Of a model that the contact has.
double ContactAdvice::coefficient(const char* name, int itype, int jtype) const {
  return lmp_->force->registry.getMatrixProperty(name, model_.c_str())->data[itype][jtype];
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
