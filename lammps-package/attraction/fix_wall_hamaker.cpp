// SPDX-License-Identifier: GPL-2.0-only
#include "attraction/fix_wall_hamaker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "atom.h"
#include "common/plausible_sizes.h"
#include "common/specified_keywords.h"
#include "contact/adhesion.h"
#include "engine/largest_radii.h"
#include "engine/particles_at_walls.h"
#include "error.h"
#include "input/hamaker_keywords.h"
#include "input/law_from_script.h"
#include "input/walls_from_script.h"
#include "input/words_of_law.h"
#include "modify.h"
#include "sphere.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

namespace hamaker = cohesion::hamaker;
using cohesion::contact_solver::Wall;

static const char* const usage =
    "fix wall/hamaker takes 'hamaker A cutoff H_cut H_out' and at least one plane, 'xplane lo hi', "
    "'yplane lo hi' or 'zplane lo hi', NULL for no wall on a side; and if wanted 'form' with a "
    "name and 'asperity' with a radius or 'roughness' with rms and wavelength";

FixWallHamaker::FixWallHamaker(LAMMPS* lammps, int narg, char** arg)
    : FixWithWallHistory(lammps, narg, arg),
      given(hamaker::none),
      form(hamaker::forms.data()),
      law(form->law(given, false)),
      watch(lammps) {
  read(narg, arg);
  std::fill_n(mine, 4, 0.0);
  scalar_flag = vector_flag = 1;
  size_vector = 3;
  extscalar = extvector = 1;
  global_freq = 1;
  energy_global_flag = 1;
  virial_global_flag = virial_peratom_flag = 1;
  restart_peratom = 1;
  create_attribute = 1;
  history.start(static_cast<int>(planes.size()), 1);
  FixWallHamaker::grow_arrays(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) FixWallHamaker::set_arrays(i);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixWallHamaker::~FixWallHamaker() {
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

void FixWallHamaker::read(int narg, char** arg) {
  const std::string where = std::string("fix ") + arg[0] + " wall/hamaker";
  WordsOfLaw all(lmp, where, 3, narg, arg, {{"hamaker", 1}, {"cutoff", 2}});
  const std::vector<ContactKeyword<hamaker::HamakerParameters>> keywords = hamaker_keywords();
  SpecifiedKeywords specified(lmp, where);
  WallsFromScript from_words(lmp, "fix wall/hamaker");
  hamaker::HamakerParameters p = hamaker::none;
  char** const words = all.get();
  const int count = all.count();
  for (int i = 0; i < count;) {
    const std::string word = words[i];
    const int left = count - i - 1;
    const auto row = std::find_if(keywords.begin(), keywords.end(),
                                  [&](const auto& k) { return word == k.name; });
    if (row != keywords.end()) {
      const int stop = std::min(i + 1 + row->values(), count);
      read_keywords(lmp, where, keywords, i, stop, words, p, specified);
      i = stop;
    } else if (word == "form") {
      if (left < 1) error->all(FLERR, "fix wall/hamaker: form takes a name");
      specified.note(1, words + i);
      form = hamaker_form_from_script(lmp, where, words[i + 1]);
      i += 2;
    } else if (const int taken = from_words.read_planes(count - i, words + i)) {
      i += taken;
    } else {
      error->all(FLERR, "fix wall/hamaker: unknown keyword '" + word +
                            "'; valid ones: hamaker, cutoff, xplane, yplane, zplane, form, "
                            "asperity, roughness");
    }
  }
  planes = from_words.walls;
  if (planes.empty() || !specified.has("hamaker") || !specified.has("cutoff"))
    error->all(FLERR, usage);
  require_one_roughness(lmp, where, specified);
  given = p;
  law = from_script(lmp, where, [&] { return form->law(p, p.asperity_radius != 0.0); });
}

int FixWallHamaker::setmask() { return POST_FORCE | MIN_POST_FORCE; }

void FixWallHamaker::init() {
  if (!atom->radius_flag)
    error->all(FLERR,
               "fix wall/hamaker acts on spheres and needs an atom style with radii, for "
               "instance 'atom_style sphere'");
  require_plausible_spheres(lmp, std::string("fix ") + id + " wall/hamaker");
  const std::vector<double> smallest = smallest_radii(lmp, largest_radii(lmp, groupbit), groupbit);
  for (int type = 1; type <= atom->ntypes; type++)
    require_far_below_radius(lmp, std::string("fix ") + id + " wall/hamaker", *form, given,
                             smallest[type], std::numeric_limits<double>::infinity());
  gives_advice = this == all_of_style().front();
  warn_of_particles_at_walls(
      lmp, std::string("fix ") + id + " wall/hamaker",
      {planes,
       {},
       groupbit,
       cohesion::advice::overlap_for_warning,
       "the spring of its contact throws it out"},
      [this](int i, int w) { return *history.of(i, w) == WallHistory::NOT_KNOWN; });
  // Between two runs a script may put particles behind a wall.
  for (int i = 0; i < atom->nlocal; i++)
    for (int w = 0; w < static_cast<int>(planes.size()); w++)
      *history.of(i, w) = std::min(*history.of(i, w), 0.0);
}

void FixWallHamaker::setup(int vflag) { post_force(vflag); }
void FixWallHamaker::min_setup(int vflag) { post_force(vflag); }
void FixWallHamaker::min_post_force(int vflag) { post_force(vflag); }

void FixWallHamaker::post_force(int vflag) {
  v_init(vflag);
  if (gives_advice && update->whichflag == 1 && watch.due(update->setupflag)) give_advice();
  std::fill_n(mine, 4, 0.0);
  summed = false;
  std::visit([this](const auto& chosen) { attract(chosen); }, law);
}

/// All fixes of this style, in the order of the script.
std::vector<FixWallHamaker*> FixWallHamaker::all_of_style() const {
  std::vector<FixWallHamaker*> all;
  for (int i = 0; i < modify->nfix; i++)
    if (auto* one = dynamic_cast<FixWallHamaker*>(modify->fix[i])) all.push_back(one);
  return all;
}

/// The first of these fixes prints what all of them report.
void FixWallHamaker::give_advice() {
  AdviceOfStyles advice;
  for (FixWallHamaker* one : all_of_style()) one->add_advice(watch.now(), advice);
  advice.print(lmp);
}

void FixWallHamaker::add_advice(const RunConditions& of_all, AdviceOfStyles& advice) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::string where = std::string("fix ") + id + " wall/hamaker";
  const RunConditions now = of_group(lmp, of_all, groupbit);
  const std::vector<LightestParticle>& lightest = now.lightest;
  std::vector<AdvisedContact> contacts;
  for (int type = 1; type <= atom->ntypes; type++) {
    if (!std::isfinite(lightest[type].radius)) continue;  // no particles yet
    const auto adhesion = std::visit(
        [&](const auto& chosen) {
          return cohesion::contact::adhesion_of(chosen,
                                                cohesion::sphere_and_plane(lightest[type].radius));
        },
        law);
    if (adhesion.force == 0.0) continue;
    contacts.push_back(
        {fmt::format("{} - wall", type), lightest[type], {infinite, infinite}, {}, adhesion});
  }
  advice.add(
      style, id,
      advice_of_attraction(lmp, where, "use fix wall/gran/hamaker, which sees it at any step",
                           contacts, now, advice_filter));
}

template <class Law>
void FixWallHamaker::attract(const Law& chosen) {
  for (std::size_t w = 0; w < planes.size(); w++) {
    const Wall& plane = planes[w];
    const int d = plane.shape;
    for (int i = 0; i < atom->nlocal; i++) {
      if (!(atom->mask[i] & groupbit)) continue;
      const double distance = plane.side * (atom->x[i][d] - plane.position);
      const double gap = distance - atom->radius[i], reach = chosen.outer_cutoff();
      double& flag = *history.of(i, static_cast<int>(w));
      if (WallHistory::keep_behind(flag, distance, atom->radius[i] + reach)) continue;
      if (distance <= 0.0) stop_at_passage(i);
      flag = gap < reach;
      if (gap >= reach) continue;
      const cohesion::PairGeometry geometry = cohesion::sphere_and_plane(atom->radius[i]);
      const double pull = plane.side * chosen.force(gap, geometry);
      atom->f[i][d] -= pull;
      mine[0] += chosen.energy(gap, geometry);
      mine[1 + d] += pull;
      if (evflag) v_tally(d, i, -pull * atom->x[i][d]);
    }
  }
}

/// The attraction has done work on the way to the wall, which behind it nothing takes back.
void FixWallHamaker::stop_at_passage(int i) const {
  const double* const x = atom->x[i];
  error->one(FLERR,
             "fix {} wall/hamaker: the centre of particle {} at ({} {} {}) went through a wall, "
             "which only attracts: give the wall a contact, for instance by fix wall/gran with the "
             "same planes",
             id, atom->tag[i], x[0], x[1], x[2]);
}

void FixWallHamaker::sum() {
  if (!summed) MPI_Allreduce(mine, total, 4, MPI_DOUBLE, MPI_SUM, world);
  summed = true;
}

/// Energy of all particles with the walls.
double FixWallHamaker::compute_scalar() {
  sum();
  return total[0];
}

/// Force on the walls.
double FixWallHamaker::compute_vector(int n) {
  sum();
  return total[1 + n];
}
