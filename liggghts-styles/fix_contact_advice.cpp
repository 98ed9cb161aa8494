// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_contact_advice.h"

#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <algorithm>
#include <cstring>

#include "advice/contact_report.h"
#include "atom.h"
#include "comm.h"
#include "common/distinct_places.h"
#include "common/message.h"
#include "common/unmoved_spheres.h"
#include "common/unturned_spheres.h"
#include "error.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "integrated_particles.h"
#include "liggghts_api.h"
#include "pair_gran.h"
#include "unknown_models.h"

namespace LIGGGHTS {
namespace Cohesion {

using cohesion::advice::Report;

namespace {

/// Lets the engine's models count these groups as infinitely heavy, as those of fix freeze.
void freeze(LAMMPS_NS::PairGran& pair, int groups) {
  struct Frozen : LAMMPS_NS::PairGran {
    static int& groups_of(LAMMPS_NS::PairGran& pair) { return pair.*(&Frozen::freeze_group_bit_); }
  };
  Frozen::groups_of(pair) |= groups;
}

std::string named(std::string text, const std::string& walls) {
  const std::string place = ContactAdvice::WALLS;
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at))
    text.replace(at, place.size(), walls);
  return text;
}

bool is_same(const Report& a, const Report& b) {
  return a.table == b.table && a.stop == b.stop &&
         std::equal(a.warnings.begin(), a.warnings.end(), b.warnings.begin(), b.warnings.end(),
                    [](const auto& x, const auto& y) { return x.text == y.text; });
}

}  // namespace

void FixContactAdvice::ask(const std::shared_ptr<ContactAdvice>& advice) {
  advice->continue_from(printed_[advice->name()]);
  for (const auto& asked : asked_)
    if (asked.lock() == advice) return;
  asked_.push_back(advice);
}

/// Walls of which there is the same to say are named together.
void FixContactAdvice::advise_if_due(bool setup) {
  if (asked_.empty() || !changes_.due(setup)) return;
  struct Said {
    Report report;
    std::string walls;
  };
  std::vector<Said> all;
  for (const auto& asked : asked_) {
    const auto advice = asked.lock();
    if (!advice) continue;
    Report report = advice->report(changes_.now());
    const auto same = std::find_if(all.begin(), all.end(), [&](const Said& said) {
      return !said.walls.empty() && !advice->wall().empty() && is_same(said.report, report);
    });
    if (same != all.end())
      same->walls += " and " + advice->wall();
    else
      all.push_back({std::move(report), advice->wall()});
  }
  for (const Said& said : all) {
    if (comm->me == 0) {
      LAMMPS_NS::engine_api::tell(lmp, named(said.report.table, said.walls));
      for (const cohesion::advice::Warning& warning : said.report.warnings)
        error->warning(FLERR, named(warning.text, said.walls).c_str());
    }
    if (!said.report.stop.empty()) LAMMPS_NS::stop(lmp, FLERR, named(said.report.stop, said.walls));
  }
}

void FixContactAdvice::setup_pre_force(int) {
  held_ = IntegratedParticles(lmp);
  const auto is_exact = [](const std::weak_ptr<ContactAdvice>& asked) {
    const auto advice = asked.lock();
    return advice && advice->is_exact();
  };
  const bool exact = std::any_of(asked_.begin(), asked_.end(), is_exact);
  if (exact || !warned_of_partly_held_)
    warned_of_partly_held_ = LAMMPS_NS::require_whole_holds(lmp, "cohesion", exact);
  warn_of_unmoved();
  auto* const pair = dynamic_cast<LAMMPS_NS::PairGran*>(force->pair_match("gran", 1));
  if (!pair) return;
  freeze(*pair, held_->held().held_by_one_fix());
  LAMMPS_NS::require_distinct_places(lmp, "pair_style gran", pair->list, [this](int i, int j) {
    return held_->moves(atom->mask[i]) || held_->moves(atom->mask[j]);
  });
}

/// A sphere that is held in its place is as heavy for friction as for the normal force: it must not
/// turn either.
void FixContactAdvice::post_force(int) {
  if (!held_->held().any()) return;
  for (int i = 0; i < atom->nlocal; i++)
    if (held_->is_held_but_turned(atom->mask[i])) std::fill_n(atom->torque[i], 3, 0.0);
}

/// Of spheres on which friction acts and that do not turn. A warning that was given is not given
/// again.
void FixContactAdvice::warn_of_spins() {
  if (warned_of_unturned_ && warned_of_held_) return;
  std::vector<bool> has_friction(atom->ntypes + 1, false);
  for (const auto& asked : asked_)
    if (const auto advice = asked.lock())
      for (int type = 1; type <= atom->ntypes; type++)
        has_friction[type] = has_friction[type] || advice->has_friction(type);
  const IntegratedParticles mobile(lmp);
  if (!warned_of_unturned_)
    warned_of_unturned_ = LAMMPS_NS::warn_of_unturned(lmp, mobile, has_friction);
  if (!warned_of_held_)
    warned_of_held_ =
        LAMMPS_NS::warn_of_held_turned(lmp, mobile.held(), mobile.turned_groups(), has_friction);
}

/// A warning that was given is not given again.
void FixContactAdvice::warn_of_unmoved() {
  if (warned_of_unmoved_) return;
  std::vector<int> announced;
  for (int k = 0; k < modify->nfix; k++)
    if (std::strncmp(modify->fix[k]->style, "insert/", 7) == 0)
      announced.push_back(1 | modify->fix[k]->groupbit);
  warned_of_unmoved_ = LAMMPS_NS::warn_of_unmoved(lmp, announced);
}

/// Of walls that decide by other rules than the pairs which particles stick, those with a cohesion
/// of the engine or none among them. A warning that was given is not given again.
void FixContactAdvice::warn_of_unlike_walls() {
  std::vector<cohesion::advice::StickingRules> pairs, walls;
  std::set<std::string> known;
  for (const auto& asked : asked_) {
    const auto advice = asked.lock();
    if (!advice) continue;
    (advice->wall().empty() ? pairs : walls).push_back(advice->sticking_rules(changes_.now()));
    known.insert(advice->wall());
  }
  if (pairs.empty()) return;
  for (int k = 0; k < modify->nfix; k++) {
    const auto* const wall = dynamic_cast<const LAMMPS_NS::FixWallGran*>(modify->fix[k]);
    if (!wall || known.count(wall->id)) continue;
    const std::string word = cohesion_word_of(wall);
    cohesion::advice::StickingRules rules;
    rules.name = name_of_wall(*wall);
    rules.is_exact = pairs.front().is_exact;  // it has no scheme
    rules.meant_without = word == "off";
    if (!word.empty() && word != "off") rules.adhesion = "cohesion model " + word;
    rules.without_words = "'cohesion off'";
    walls.push_back(rules);
  }
  for (const std::string& text : cohesion::advice::warnings_of_walls(
           walls, pairs, "a wall without the keyword has that of the pairs"))
    if (warned_of_walls_.insert(text).second && comm->me == 0) error->warning(FLERR, text.c_str());
}

int FixContactAdvice::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_EXCHANGE | PRE_FORCE | POST_FORCE | POST_RUN;
}

void FixContactAdvice::pre_exchange() {
  for (const auto& warning : late_) {
    if (warning->given) continue;
    const int here = warning->due ? comm->me : comm->nprocs;
    int rank = comm->nprocs;
    MPI_Allreduce(&here, &rank, 1, MPI_INT, MPI_MIN, world);
    if (rank == comm->nprocs) continue;
    warning->given = true;
    char where[256] = {};
    warning->first.copy(where, sizeof where - 1);
    MPI_Bcast(where, sizeof where, MPI_CHAR, rank, world);
    if (comm->me == 0) error->warning(FLERR, (warning->text + where).c_str());
  }
}

std::shared_ptr<LateWarning> FixContactAdvice::late_warning(const std::string& text) {
  for (const auto& warning : late_)
    if (warning->text == text) return warning;
  late_.push_back(std::make_shared<LateWarning>(LateWarning{text, {}}));
  return late_.back();
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
