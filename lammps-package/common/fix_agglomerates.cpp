// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/fix_agglomerates.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "common/box_shear.h"
#include "common/engine_api.h"
#include "common/fragment_exchange.h"
#include "common/message.h"
#include "common/specified_keywords.h"
#include "domain.h"
#include "force.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::agglomerates;
using cohesion::Vector3;

FixAgglomerates::FixAgglomerates(LAMMPS* lammps, int narg, char** arg)
    : engine_api::StyleFix(lammps, narg, arg), distribution(20) {
  const std::string where = std::string("fix ") + id + " agglomerates";
  if (narg < 4) stop(lmp, FLERR, where, " takes 'N', every so many steps");
  nevery = engine_api::inumeric(FLERR, arg[3], lmp);
  if (nevery < 1) stop(lmp, FLERR, where, ": N is ", nevery, "; it must be 1 or more");
  read_keywords(narg, arg);
  if (!atom->tag_enable) stop(lmp, FLERR, where, " needs particles with IDs");
  scalar_flag = vector_flag = array_flag = peratom_flag = 1;
  size_vector = 8;
  size_array_rows = static_cast<int>(distribution.current().size());
  size_array_cols = 2;
  size_peratom_cols = 3;
  global_freq = peratom_freq = nevery;
  extscalar = extvector = extarray = 0;
  restart_global = restart_peratom = 1;
  create_attribute = 1;
  time_depend = 1;
  comm_forward = 4;
  FixAgglomerates::grow_arrays(atom->nmax);
  atom->add_callback(engine_api::GROW);
  atom->add_callback(engine_api::RESTART);
  for (int i = 0; i < atom->nlocal; i++) FixAgglomerates::set_arrays(i);
}

void FixAgglomerates::read_keywords(int narg, char** arg) {
  const std::string where = std::string("fix ") + id + " agglomerates";
  SpecifiedKeywords given(lmp, where);
  for (int i = 4; i < narg; i += 2) {
    const std::string word = arg[i], value = i + 1 < narg ? arg[i + 1] : "";
    if (word == "sizes" && !value.empty()) {
      const int sizes = engine_api::inumeric(FLERR, arg[i + 1], lmp);
      if (sizes < 2) stop(lmp, FLERR, where, ": sizes ", sizes, "; it must be 2 or more");
      distribution = SizeDistribution(sizes);
    } else if (word == "partners" && (value == "bound" || value == "held")) {
      held_only = value == "held";
    } else {
      stop(lmp, FLERR, where, ": '", word, " ", value,
           "'; after 'N' it takes 'sizes M' and 'partners bound' or 'partners held'");
    }
    given.note(1, arg + i);
  }
}

FixAgglomerates::~FixAgglomerates() {
  atom->delete_callback(id, engine_api::GROW);
  atom->delete_callback(id, engine_api::RESTART);
  memory->destroy(label);
  memory->destroy(position);
  memory->destroy(of_each);
  memory->destroy(since);
}

int FixAgglomerates::setmask() { return engine_api::POST_NEIGHBOR | FixConst::END_OF_STEP; }

void FixAgglomerates::init() {
  const std::string where = std::string("fix ") + id + " agglomerates";
  if (force->newton_pair)
    stop(lmp, FLERR, where,
         " needs pairs on both ranks they belong to; put 'newton off' before the box is made");
  sources = bound_pairs(lmp, where);
}

void FixAgglomerates::post_neighbor() {
  list_images.assign(atom->image, atom->image + atom->nlocal);
}

void FixAgglomerates::setup(int) {
  find_agglomerates(0.0);
  if (last_step >= 0) return;
  for (int i = 0; i < atom->nlocal; i++) since[i] = Membership::at_first(of_each[i][1] > 1.0);
  last_step = update->ntimestep;
}

void FixAgglomerates::end_of_step() {
  const double elapsed = static_cast<double>(update->ntimestep - last_step) * update->dt;
  last_step = update->ntimestep;
  totals.time += elapsed;
  find_agglomerates(elapsed);
  add_durations();
}

/* ---------------------------------------------------------------------- */

void FixAgglomerates::find_agglomerates(double elapsed) {
  const ScopedUnwrap unwrapped(atom, domain, list_images);
  join_bound_pairs();
  int changed = 1;
  while (changed) {
    engine_api::forward_comm(comm, this);
    const int mine = propagate_labels();
    MPI_Allreduce(&mine, &changed, 1, MPI_INT, MPI_MAX, world);
  }
  std::vector<Extent> extents;
  const std::vector<Fragment> whole = merge_across_ranks(world, own_fragments(), extents);
  store_extents(extents);
  compute_statistics(whole, elapsed);
  last_look = update->ntimestep;
}

/// Joins the bound pairs that this rank has; each set has the smallest label of its own particles.
void FixAgglomerates::join_bound_pairs() {
  const int nlocal = atom->nlocal, all = nlocal + atom->nghost;
  pairs.clear();
  for (const BoundPairs* source : sources)
    held_only ? source->append_held(pairs) : source->append_bound(pairs);
  sets.reset(all);
  for (const auto& [i, j] : pairs)
    if ((atom->mask[i] & groupbit) && (atom->mask[j] & groupbit)) sets.join(i, j);
  bound.clear();
  for (int i = 0; i < all; i++)
    if (sets.size(i) > 1) bound.push_back(i);

  set_label.assign(all, static_cast<double>(MAXTAGINT));
  set_shift.assign(all, {});
  set_wraps.assign(all, 0.0);
  for (const int i : bound)
    if (i < nlocal) {
      double& smallest = set_label[sets.root(i)];
      smallest = std::min(smallest, static_cast<double>(atom->tag[i]));
    }
  for (int i = 0; i < nlocal; i++) {
    label[i] = static_cast<double>(atom->tag[i]);
    std::copy_n(atom->x[i], 3, position[i]);
  }
  for (const int i : bound) label[i] = set_label[sets.root(i)];
}

/// Gives each set the smaller label of a ghost's owner, and unfolds the set to where that one is.
/// Returns whether a label has changed.
bool FixAgglomerates::propagate_labels() {
  bool changed = false;
  const double near = 0.25 * std::min(domain->xprd, std::min(domain->yprd, domain->zprd));
  std::fill(set_wraps.begin(), set_wraps.end(), 0.0);
  const auto ghost = std::lower_bound(bound.begin(), bound.end(), atom->nlocal);
  for (auto k = ghost; k != bound.end(); ++k) {
    const int r = sets.root(*k);
    const double* const x = atom->x[*k];
    const Vector3 shift{position[*k][0] - x[0], position[*k][1] - x[1], position[*k][2] - x[2]};
    if (label[*k] < set_label[r]) {
      set_label[r] = label[*k];
      set_shift[r] = shift;
      changed = true;
    } else if (label[*k] == set_label[r] && norm(shift - set_shift[r]) > near) {
      set_wraps[r] = 1.0;
    }
  }
  for (const int i : bound) {
    const int r = sets.root(i);
    const Vector3& shift = set_shift[r];
    label[i] = set_label[r];
    position[i][0] = atom->x[i][0] + shift.x;
    position[i][1] = atom->x[i][1] + shift.y;
    position[i][2] = atom->x[i][2] + shift.z;
  }
  return changed;
}

/// Returns a fragment for each set of this rank; several may have the same label.
std::vector<Fragment> FixAgglomerates::own_fragments() {
  std::vector<Fragment> fragments;
  set_fragment.assign(atom->nlocal + atom->nghost, -1);
  for (const int i : bound) {
    if (i >= atom->nlocal) break;
    const int r = sets.root(i);
    if (set_fragment[r] < 0) {
      set_fragment[r] = static_cast<int>(fragments.size());
      fragments.push_back({set_label[r]});
      fragments.back().wraps = set_wraps[r];
    }
    fragments[set_fragment[r]].add(Vector3{position[i][0], position[i][1], position[i][2]});
  }
  return fragments;
}

void FixAgglomerates::store_extents(const std::vector<Extent>& extents) {
  for (int i = 0; i < atom->nlocal; i++) {
    of_each[i][0] = of_each[i][2] = 0.0;
    of_each[i][1] = atom->mask[i] & groupbit ? 1.0 : 0.0;
  }
  for (const int i : bound) {
    if (i >= atom->nlocal) break;
    of_each[i][0] = label[i];
    const Extent& whole = extents[set_fragment[sets.root(i)]];
    of_each[i][1] = whole.count;
    of_each[i][2] = whole.gyration;
  }
}

/// Sums the numbers of all ranks, and adds them to the means over time.
void FixAgglomerates::compute_statistics(const std::vector<Fragment>& whole, double elapsed) {
  enum { NUMBER, PARTICLES, GROUP, GYRATION, UNFOLDED, WRAPPING, SIZES };
  const std::size_t rows = distribution.current().size();
  std::vector<double> sums(SIZES + rows, 0.0);
  double most = 0.0;
  distribution.clear();
  for (const Fragment& p : whole) {
    sums[NUMBER] += 1.0;
    sums[PARTICLES] += p.count;
    most = std::max(most, p.count);
    distribution.add(p.count);
    if (p.wraps > 0.0) {
      sums[WRAPPING] += 1.0;
    } else {
      sums[GYRATION] += radius_of_gyration(p);
      sums[UNFOLDED] += 1.0;
    }
  }
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    sums[GROUP] += 1.0;
    if (of_each[i][1] == 1.0) distribution.add(1.0);
  }
  std::copy(distribution.current().begin(), distribution.current().end(), sums.begin() + SIZES);
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM,
                world);
  MPI_Allreduce(&most, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  std::copy(sums.begin() + SIZES, sums.end(), distribution.current().begin());
  number = sums[NUMBER];
  particles = sums[PARTICLES];
  group_size = sums[GROUP];
  gyration = sums[GYRATION];
  unfolded = sums[UNFOLDED];
  wrapping = sums[WRAPPING];
  totals.size.add_time(elapsed, number, particles);
  distribution.add_time(elapsed);
}

void FixAgglomerates::add_durations() {
  double mine[2] = {}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    const double duration = since[i].update(of_each[i][1] > 1.0, totals.time);
    if (duration < 0.0) continue;
    mine[0] += duration;
    mine[1] += 1.0;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  totals.durations += all[0];
  totals.finished += all[1];
}

double FixAgglomerates::compute_vector(int n) {
  const auto ratio = [](double a, double b) { return b > 0.0 ? a / b : 0.0; };
  switch (n) {
    case 0:
      return number;
    case 1:
      return ratio(particles, number);
    case 2:
      return totals.size.mean();
    case 3:
      return ratio(std::max(largest, group_size > 0.0 ? 1.0 : 0.0), group_size);
    case 4:
      return ratio(totals.durations, totals.finished);
    case 5:
      return totals.finished;
    case 6:
      return ratio(gyration, unfolded);
    default:
      return wrapping;
  }
}

double FixAgglomerates::compute_array(int row, int column) {
  if (column == 0) return distribution.current()[row];
  return totals.time > 0.0 ? distribution.sums()[row] / totals.time : distribution.current()[row];
}

/// "agglomerates": double** [atoms], the per-atom array of this step, looked for where it is of
/// another; all ranks ask, between two runs. It adds nothing to what is summed over time.
void* FixAgglomerates::extract(const char* name, int& dimension) {
  dimension = 2;
  if (std::string(name) != "agglomerates") return nullptr;
  if (last_look != update->ntimestep) find_agglomerates(0.0);
  return of_each;
}

/* ---------------------------------------------------------------------- */

int FixAgglomerates::pack_forward_comm(int n, int* list, double* buf, int, int*) {
  for (int i = 0; i < n; i++) {
    buf[4 * i] = label[list[i]];
    std::copy_n(position[list[i]], 3, buf + 4 * i + 1);
  }
  return 4 * n;
}

void FixAgglomerates::unpack_forward_comm(int n, int first, double* buf) {
  for (int i = 0; i < n; i++) {
    label[first + i] = buf[4 * i];
    std::copy_n(buf + 4 * i + 1, 3, position[first + i]);
  }
}

void FixAgglomerates::grow_arrays(int nmax) {
  memory->grow(label, nmax, "agglomerates:label");
  memory->grow(position, nmax, 3, "agglomerates:position");
  memory->grow(of_each, nmax, 3, "agglomerates:of_each");
  memory->grow(since, nmax, "agglomerates:since");
  array_atom = of_each;
}

void FixAgglomerates::copy_arrays(int i, int j, int) {
  since[j] = since[i];
  std::copy_n(of_each[i], 3, of_each[j]);
}

void FixAgglomerates::set_arrays(int i) {
  since[i] = {};
  std::fill_n(of_each[i], 3, 0.0);
}

int FixAgglomerates::pack_exchange(int i, double* buf) {
  buf[0] = since[i].since;
  return 1;
}

int FixAgglomerates::unpack_exchange(int i, double* buf) {
  since[i].since = buf[0];
  return 1;
}

void FixAgglomerates::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  const auto& sums = distribution.sums();
  const double rows = static_cast<double>(sums.size()), step = static_cast<double>(last_step);
  const int size = static_cast<int>(sizeof(double) * (2 + sums.size()) + sizeof(FragmentTotals));
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&step, sizeof(double), 1, fp);
  fwrite(&totals, sizeof(FragmentTotals), 1, fp);
  fwrite(&rows, sizeof(double), 1, fp);
  fwrite(sums.data(), sizeof(double), sums.size(), fp);
}

void FixAgglomerates::restart(char* buf) {
  double step, rows;
  memcpy(&step, buf, sizeof(double));
  memcpy(&totals, buf + sizeof(double), sizeof(FragmentTotals));
  memcpy(&rows, buf + sizeof(double) + sizeof(FragmentTotals), sizeof(double));
  last_step = static_cast<bigint>(step);
  auto& sums = distribution.sums();
  if (static_cast<std::size_t>(rows) != sums.size())
    stop(lmp, FLERR, "fix ", id, " agglomerates: the restart holds a distribution of 'sizes ", rows,
         "', here it is ", sums.size(), "; give the same");
  memcpy(sums.data(), buf + 2 * sizeof(double) + sizeof(FragmentTotals),
         sizeof(double) * sums.size());
}

int FixAgglomerates::pack_restart(int i, double* buf) {
  buf[0] = 2;
  buf[1] = since[i].since;
  return 2;
}

void FixAgglomerates::unpack_restart(int i, int nth) {
  double* const values = atom->extra[i];
  int m = 0;
  for (int n = 0; n < nth; n++) m += static_cast<int>(values[m]);
  since[i].since = values[m + 1];
}

double FixAgglomerates::memory_usage() { return 8.0 * sizeof(double) * atom->nmax; }
