// SPDX-License-Identifier: GPL-2.0-only
#include "attraction/pair_hamaker.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "common/distinct_places.h"
#include "common/engine_api.h"
#include "contact/adhesion.h"
#include "engine/largest_radii.h"
#include "engine/mobile_particles.h"
#include "engine/special_pairs.h"
#include "error.h"
#include "force.h"
#include "input/hamaker_keywords.h"
#include "input/law_from_script.h"
#include "input/restart_format.h"
#include "input/words_of_law.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "sphere.h"
#include "update.h"
#include "vector3.h"

using namespace LAMMPS_NS;
namespace hamaker = cohesion::hamaker;
using cohesion::vector;
using cohesion::Vector3;

static constexpr int LAYOUT = 3;  // of settings and Parameters in restart files

PairHamaker::PairHamaker(LAMMPS* lammps)
    : Pair(lammps), form(hamaker::forms.data()), parameters(lammps), watch(lammps) {
  single_enable = 1;
  restartinfo = 1;
  writedata = 1;
}

PairHamaker::~PairHamaker() {
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
  memory->destroy(hamaker_constant);
}

void PairHamaker::allocate() {
  allocated = 1;
  const int types = atom->ntypes;
  memory->create(setflag, types + 1, types + 1, "pair:setflag");
  memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
  memory->create(hamaker_constant, types + 1, types + 1, "pair:hamaker_constant");
  parameters.make_room(types, setflag);
}

/* ---------------------------------------------------------------------- */

void PairHamaker::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (needs_list && neighbor->ago == 0)
    check_radii(lmp, "pair_style hamaker: the outer cut-off is beyond the neighbour range",
                largest_radius);
  const bool attract = attracts();
  if (attract && !needs_list)
    error->all(FLERR,
               "pair_style hamaker: an A was raised within a run that began with all A = 0 and "
               "without fix adapt, in which pairs have no list of neighbours: raise it before "
               "the run");
  parameters.require_committed("pair_style hamaker");
  if (attract) {
    if (update->setupflag)
      require_distinct_places(lmp, "pair_style hamaker", list, [](int, int) { return true; });
    if (update->whichflag == 1 && watch.due(update->setupflag)) give_advice();
    std::visit(
        [this](const auto& chosen) {
          if (evflag) {
            force->newton_pair ? compute_pairs<true, true>(chosen)
                               : compute_pairs<true, false>(chosen);
          } else {
            force->newton_pair ? compute_pairs<false, true>(chosen)
                               : compute_pairs<false, false>(chosen);
          }
        },
        laws);
  }
  if (vflag_fdotr) virial_fdotr_compute();
}

void PairHamaker::give_advice() {
  const std::string where = "pair_style hamaker";
  const auto contacts = from_script(lmp, where, [this] { return advised_contacts(); });
  AdviceOfStyles advice;
  advice.add(
      where, "",
      advice_of_attraction(lmp, where, "use pair_style gran/hamaker, which sees it at any step",
                           contacts, watch.now(), advice_filter));
  advice.print(lmp);
}

std::vector<AdvisedContact> PairHamaker::advised_contacts() const {
  std::vector<AdvisedContact> contacts;
  const std::vector<LightestParticle>& lightest = watch.now().lightest;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      const LightestParticle &a = lightest[i], &b = lightest[j];
      const int types = parameters.number(i, j);
      if (!prepared[types]) continue;
      if (!std::isfinite(a.radius) || !std::isfinite(b.radius)) continue;  // no particles yet
      const auto adhesion = std::visit(
          [&](const auto& law_of) {
            return cohesion::contact::adhesion_of(law_of[types],
                                                  cohesion::two_spheres(a.radius, b.radius));
          },
          laws);
      if (adhesion.force == 0.0) continue;
      contacts.push_back({fmt::format("{} - {}", i, j), a, b, {}, adhesion});
    }
  return contacts;
}

/// Whether any types attract each other; fix adapt may change it in a run.
bool PairHamaker::attracts() const {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const Parameters& p) { return p.hamaker_constant > 0.0; });
}

/// Whether any do, or may in the run that begins. Of the given ones: mixing adds none.
bool PairHamaker::may_attract() const {
  for (int i = 0; i < modify->nfix; i++)
    if (utils::strmatch(modify->fix[i]->style, "^adapt")) return true;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      if (setflag[i][j] && hamaker_constant[i][j] > 0.0) return true;
  return false;
}

template <bool TALLY, bool NEWTON, class Law>
void PairHamaker::compute_pairs(const std::vector<Law>& law_of) {
  double** const x = atom->x;
  double** const f = atom->f;
  const double* const radius = atom->radius;
  const int* const type = atom->type;
  const int nlocal = atom->nlocal;

  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int* const neighbors = list->firstneigh[i];
    const int number = list->numneigh[i];
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2], ri = radius[i];
    const Law* const laws_of_i = &law_of[parameters.number(type[i], 0)];
    for (int jj = 0; jj < number; jj++) {
      const int j = neighbors[jj] & NEIGHMASK;
      const double dx = xi - x[j][0];
      const double dy = yi - x[j][1];
      const double dz = zi - x[j][2];
      const double rsq = dx * dx + dy * dy + dz * dz;
      const Law& law = laws_of_i[type[j]];
      const double contact = ri + radius[j];
      const double reach = contact + law.outer_cutoff();
      if (rsq >= reach * reach) continue;

      const double r = std::sqrt(rsq);
      const cohesion::PairGeometry geometry = cohesion::two_spheres(ri, radius[j]);
      const double fpair = -law.force(r - contact, geometry) / r;
      f[i][0] += dx * fpair;
      f[i][1] += dy * fpair;
      f[i][2] += dz * fpair;
      if (NEWTON || j < nlocal) {
        f[j][0] -= dx * fpair;
        f[j][1] -= dy * fpair;
        f[j][2] -= dz * fpair;
      }
      if (TALLY) {
        const double energy = eflag_either ? law.energy(r - contact, geometry) : 0.0;
        ev_tally(i, j, nlocal, NEWTON, energy, 0.0, fpair, dx, dy, dz);
      }
    }
  }
}

double PairHamaker::single(int i, int j, int itype, int jtype, double rsq, double, double,
                           double& fforce) {
  const double r = std::sqrt(rsq);
  const double gap = r - atom->radius[i] - atom->radius[j];
  const cohesion::PairGeometry geometry = cohesion::two_spheres(atom->radius[i], atom->radius[j]);
  return std::visit(
      [&](const auto& law_of) {
        const auto& law = law_of[parameters.number(itype, jtype)];
        fforce = -law.force(gap, geometry) / r;
        return law.energy(gap, geometry);
      },
      laws);
}

/* ---------------------------------------------------------------------- */

void PairHamaker::settings(int narg, char** arg) {
  struct Settings {
    double surface_cutoff = 0.0, outer_cutoff = 0.0;
    const hamaker::Form* form = hamaker::forms.data();
  };
  static const std::vector<ContactKeyword<Settings>> keywords{
      {"cutoff", "H_cut H_out",
       [](Settings& s, const double* v) {
         s.surface_cutoff = v[0];
         s.outer_cutoff = v[1];
       }},
      {"form", "name", nullptr, [](Settings& s, const char* name, const double*) {
         s.form = &cohesion::find_by_name(hamaker::forms, "form", name);
       }}};
  const std::string where = "pair_style hamaker";
  WordsOfLaw words(lmp, where, 0, narg, arg, {{"cutoff", 2}});
  warned = words.by_place();
  SpecifiedKeywords given(lmp, where);
  Settings s;
  read_keywords(lmp, where, keywords, 0, words.count(), words.get(), s, given);
  surface_cutoff = s.surface_cutoff;
  outer_cutoff = s.outer_cutoff;
  form = s.form;
  if (given.has("cutoff")) check_parameters(where, {0.0, surface_cutoff, outer_cutoff});
}

void PairHamaker::check_parameters(const std::string& where, const Parameters& p) {
  from_script(lmp, where, [&] { require_valid(p); });
}

void PairHamaker::coeff(int narg, char** arg) {
  if (narg < 3)
    error->all(FLERR,
               "pair_coeff of hamaker takes 'i j hamaker A', and if wanted 'cutoff H_cut H_out', "
               "both distances, and 'asperity' with a radius or 'roughness' with rms and "
               "wavelength");
  if (!allocated) allocate();
  const std::string here = std::string("pair_coeff ") + arg[0] + " " + arg[1] + " of hamaker";
  WordsOfLaw words(lmp, here, 2, narg, arg, {{"hamaker", 1}, {"cutoff", 2}}, !warned);
  warned = warned || words.by_place();
  SpecifiedKeywords given(lmp, here);
  Parameters p{0.0, surface_cutoff, outer_cutoff};
  read_keywords(lmp, here, hamaker_keywords(), 0, words.count(), words.get(), p, given);
  if (!given.has("hamaker")) error->all(FLERR, here + " needs 'hamaker A'");
  if (!given.has("cutoff") && outer_cutoff == 0.0)
    error->all(FLERR, here + ": needs 'cutoff H_cut H_out', both distances, here or in pair_style");
  require_one_roughness(lmp, here, given);
  check_parameters(here, p);
  parameters.assign(here, arg, [&](int i, int j) { give(i, j, p); });
}

void PairHamaker::init_style() {
  if (!atom->radius_flag)
    error->all(FLERR,
               "pair_style hamaker acts between spheres and needs an atom style with radii, "
               "for instance 'atom_style sphere'");
  parameters.commit();
  require_plausible_spheres(lmp, "pair_style hamaker");
  require_whole_special_factors(lmp, this, "pair_style hamaker", true);
  largest_radius = largest_radii(lmp);
  smallest_radius = smallest_radii(lmp, largest_radius);
  const bool rough = std::any_of(parameters.begin(), parameters.end(),
                                 [](const Parameters& p) { return p.asperity_radius > 0.0; });
  std::visit([this](const auto& law) { laws = std::vector(parameters.size(), law); },
             form->law(hamaker::none, rough));
  prepared.assign(parameters.size(), false);
  needs_list = may_attract();
  if (needs_list)
    engine_api::request_neighbor_list(neighbor, this, instance_me);
  else
    list = nullptr;
}

/// Of a material, with the constant that fix adapt may have changed.
PairHamaker::Parameters PairHamaker::of_type(int i) {
  Parameters p = parameters(i, i);
  p.hamaker_constant = hamaker_constant[i][i];
  return p;
}

double PairHamaker::init_one(int i, int j) {
  if (parameters.to_mix("pair_style hamaker", i, j))
    give(i, j, hamaker::mixed(of_type(i), of_type(j)));
  prepared[parameters.number(i, j)] = true;
  watch.forget();
  // fix adapt may have changed it.
  parameters(i, j).hamaker_constant = hamaker_constant[i][j];
  const Parameters& p = parameters(i, j);
  const std::string here =
      "pair_style hamaker, types " + std::to_string(i) + " and " + std::to_string(j);
  check_parameters(here, p);
  require_far_below_radius(lmp, here, *form, p, smallest_radius[i], smallest_radius[j]);
  require_plausible_range(lmp, here, largest_radius[i] + largest_radius[j] + p.outer_cutoff);
  std::visit(
      [&](auto& law_of) {
        using Law = typename std::decay_t<decltype(law_of)>::value_type;
        law_of[parameters.number(i, j)] = law_of[parameters.number(j, i)] = Law(p);
      },
      laws);
  return largest_radius[i] + largest_radius[j] + (needs_list ? p.outer_cutoff : 0.0);
}

/* ---------------------------------------------------------------------- */

void PairHamaker::give(int i, int j, const Parameters& p) {
  parameters(i, j) = parameters(j, i) = p;
  hamaker_constant[i][j] = hamaker_constant[j][i] = p.hamaker_constant;
}

/// Bound are the pairs that attract each other where they are, of which something moves one.
void PairHamaker::append_bound(std::vector<std::array<int, 2>>& pairs) const {
  if (!needs_list) return;
  MobileParticles mobile;
  mobile.look_up(lmp);
  const auto led = [&](int i) { return mobile.inverse_mass(atom->mask[i], 1.0) == 0.0; };
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const Parameters& p = parameters(atom->type[i], atom->type[j]);
      if (p.hamaker_constant == 0.0 || (led(i) && led(j))) continue;
      const Vector3 d = vector(atom->x[j]) - vector(atom->x[i]);
      const double reach = atom->radius[i] + atom->radius[j] + p.outer_cutoff;
      if (dot(d, d) < reach * reach) pairs.push_back({i, j});
    }
  }
}

/// "A": double** by type pair, for fix adapt.
void* PairHamaker::extract(const char* name, int& dimension) {
  dimension = 2;
  return strcmp(name, "A") == 0 ? hamaker_constant : nullptr;
}

void PairHamaker::write_restart(FILE* fp) {
  write_restart_settings(fp);
  parameters.write(fp);
}

void PairHamaker::read_restart(FILE* fp) {
  read_restart_settings(fp);
  allocate();
  parameters.read(fp, [this](int i, int j, const Parameters& p) { give(i, j, p); });
}

void PairHamaker::write_restart_settings(FILE* fp) {
  write_layout(fp, LAYOUT);
  fwrite(&surface_cutoff, sizeof(double), 1, fp);
  fwrite(&outer_cutoff, sizeof(double), 1, fp);
  const int row = static_cast<int>(form - hamaker::forms.data());
  fwrite(&row, sizeof(int), 1, fp);
}

void PairHamaker::read_restart_settings(FILE* fp) {
  require_layout(lmp, fp, "pair_style hamaker", LAYOUT);
  int row = 0;
  if (comm->me == 0) {
    utils::sfread(FLERR, &surface_cutoff, sizeof(double), 1, fp, nullptr, error);
    utils::sfread(FLERR, &outer_cutoff, sizeof(double), 1, fp, nullptr, error);
    utils::sfread(FLERR, &row, sizeof(int), 1, fp, nullptr, error);
  }
  MPI_Bcast(&surface_cutoff, 1, MPI_DOUBLE, 0, world);
  MPI_Bcast(&outer_cutoff, 1, MPI_DOUBLE, 0, world);
  MPI_Bcast(&row, 1, MPI_INT, 0, world);
  if (row < 0 || row >= static_cast<int>(hamaker::forms.size()))
    error->all(FLERR,
               "pair_style hamaker: the restart file names a form that this version of the "
               "package does not have");
  form = &hamaker::forms[row];
}

void PairHamaker::write_data(FILE* fp) {
  for (int i = 1; i <= atom->ntypes; i++) {
    fprintf(fp, "%d", i);
    write_coefficients(fp, parameters(i, i));
  }
}

void PairHamaker::write_data_all(FILE* fp) {
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      fprintf(fp, "%d %d", i, j);
      write_coefficients(fp, parameters(i, j));
    }
}

void PairHamaker::write_coefficients(FILE* fp, const Parameters& p) {
  fprintf(fp, " hamaker %.17g cutoff %.17g %.17g", p.hamaker_constant, p.surface_cutoff,
          p.outer_cutoff);
  if (p.asperity_height > 0.0) {
    const hamaker::Roughness r = hamaker::roughness_of(p);
    fprintf(fp, " roughness %.17g %.17g", r.rms, r.wavelength);
  } else if (p.asperity_radius > 0.0) {
    fprintf(fp, " asperity %.17g", p.asperity_radius);
  }
  fprintf(fp, "\n");
}
