// SPDX-License-Identifier: GPL-2.0-only
#include "outputs/fix_stationary.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>

#include "arg_info.h"
#include "comm.h"
#include "common/specified_keywords.h"
#include "error.h"
#include "group.h"
#include "input.h"
#include "input/law_from_script.h"
#include "modify.h"
#include "named_table.h"
#include "timer.h"
#include "update.h"
#include "variable.h"

using namespace LAMMPS_NS;
using cohesion::statistics::BlockRule;
using cohesion::statistics::Ratio;
using cohesion::statistics::Watched;

static constexpr int HEAD = 2;  // blocks, state; then three numbers of each watched value

namespace {

struct TermRow {
  const char* word;
  int operands;
};

/// In the order of FixStationary::TermKind.
constexpr TermRow TERMS[] = {{"mean", 1}, {"weighted", 2}, {"rate", 1}, {"ratio", 2}};

}  // namespace

FixStationary::FixStationary(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg), where(std::string("fix ") + id + " stationary") {
  if (narg < 4) error->all(FLERR, where + ": give N, every so many steps, and keywords");
  nevery = utils::inumeric(FLERR, arg[3], false, lmp);
  if (nevery < 1) error->all(FLERR, where + ": N is {}; it must be 1 or more", nevery);
  read_keywords(narg, arg);
  if (progress_value.empty())
    error->all(FLERR, where + ": give 'progress VALUE', what start and block are counted in");
  if (watched.empty()) error->all(FLERR, where + ": give at least one 'watch TOLERANCE TERM'");
  std::vector<Watched> rows;
  for (const Value& value : watched) rows.push_back({value.terms.size(), value.tolerance});
  rule = from_script(lmp, where, [&] { return std::make_unique<BlockRule>(start, block, rows); });
  scalar_flag = vector_flag = 1;
  extscalar = extvector = 0;
  size_vector = HEAD + 3 * static_cast<int>(watched.size());
  global_freq = nevery;
  restart_global = 1;
  time_depend = 1;
}

void FixStationary::read_keywords(int narg, char** arg) {
  struct Keyword {
    const char* name;
    bool takes_a_value;
    std::function<int(int)> read;  // from arg[i] on; returns the place of the first word behind
  };
  const auto number = [&](double& value) {
    return [this, arg, &value](int i) {
      value = utils::numeric(FLERR, arg[i], false, lmp);
      return i + 1;
    };
  };
  const std::vector<Keyword> keywords{
      {"progress", true,
       [&](int i) {
         progress_value = arg[i];
         require_exists(progress_value);
         return i + 1;
       }},
      {"per_particle", false,
       [&](int i) {
         per_particle = true;
         return i;
       }},
      {"start", true, number(start)},
      {"block", true, number(block)},
      {"most", true,
       [&](int i) {
         most = utils::inumeric(FLERR, arg[i], false, lmp);
         if (most < 2)
           error->all(FLERR, where + ": most {}; two blocks are compared at least", most);
         return i + 1;
       }},
      {"watch", true, [&](int i) { return read_watched(i, narg, arg); }},
  };
  SpecifiedKeywords given(lmp, where);
  for (int i = 4; i < narg;) {
    const Keyword& keyword = *from_script(
        lmp, where, [&] { return &cohesion::find_by_name(keywords, "keyword", arg[i]); });
    i++;
    if (keyword.takes_a_value && i == narg)
      error->all(FLERR, where + ": " + keyword.name + " takes a value");
    const bool may_come_again = strcmp(keyword.name, "watch") == 0;
    if (!may_come_again) given.note(keyword.takes_a_value, arg + i - 1);
    i = keyword.read(i);
  }
}

/// Reads from the tolerance at `i` on; returns the place of the first word behind.
int FixStationary::read_watched(int i, int narg, char** arg) {
  const bool any = strcmp(arg[i], "any") == 0;
  Value value{std::string(), any ? BlockRule::any : utils::numeric(FLERR, arg[i], false, lmp), {}};
  for (i++; i < narg; i++) {
    const std::string word = arg[i];
    const auto row = std::find_if(std::begin(TERMS), std::end(TERMS),
                                  [&](const TermRow& r) { return word == r.word; });
    if (row == std::end(TERMS)) break;
    if (i + row->operands >= narg)
      error->all(FLERR, where + ": watch: " + word + " takes " +
                            (row->operands == 2 ? "two values" : "one value"));
    Term term{static_cast<TermKind>(row - std::begin(TERMS)), {}, {}, 0.0, 0.0};
    term.value = arg[++i];
    value.words += (value.words.empty() ? "" : " + ") + word + " " + term.value;
    require_exists(term.value);
    if (row->operands == 2) {
      term.other = arg[++i];
      value.words += " " + term.other;
      require_exists(term.other);
    }
    value.terms.push_back(term);
  }
  if (value.terms.empty())
    error->all(FLERR,
               where +
                   ": watch takes a tolerance and then at least one of: mean VALUE, weighted "
                   "VALUE WEIGHT, rate TOTAL, ratio TOTAL TOTAL");
  watched.push_back(value);
  return i;
}

/// Stops when `word` refers to nothing that exists. The engine itself says what is wrong with an
/// index, but what is missing only in a run.
void FixStationary::require_exists(const std::string& word) const {
  ArgInfo reference(word);
  const std::string name = reference.get_name();
  const bool there =
      (reference.get_type() == ArgInfo::COMPUTE && modify->find_compute(name) >= 0) ||
      (reference.get_type() == ArgInfo::FIX && modify->find_fix(name) >= 0);
  const int variable = reference.get_type() == ArgInfo::VARIABLE
                           ? input->variable->find(const_cast<char*>(name.c_str()))
                           : -1;
  if (!there && (variable < 0 || !input->variable->equalstyle(variable)))
    error->all(FLERR, where + ": '" + word +
                          "' must be c_ID, f_ID (with indices) or v_name of a compute, a fix or an "
                          "equal-style variable that has been defined");
}

int FixStationary::setmask() { return FixConst::END_OF_STEP | FixConst::POST_RUN; }

void FixStationary::init() {
  if (per_particle && group->count(igroup) == 0)
    error->all(FLERR, where + ": per_particle, and no particle is in the group");
  // Computes of forces and energies must be asked for before the step.
  if (state == watching) modify->addstep_compute_all(next_sample());
}

/// The first step from the present one on in which a sample is taken.
bigint FixStationary::next_sample() const {
  return (update->ntimestep + nevery - 1) / nevery * nevery;
}

/// Totals are known from the first step of the run on, where the engine has their values.
void FixStationary::setup(int) {
  if (has_sample || update->ntimestep % nevery) return;
  modify->clearstep_compute();
  sample();
  modify->addstep_compute(update->ntimestep + nevery);
}

void FixStationary::end_of_step() {
  if (state != watching) return;
  modify->clearstep_compute();
  const bool block_ended = sample();
  modify->addstep_compute(update->ntimestep + nevery);
  if (!block_ended) return;
  if (rule->met())
    state = met;
  else if (most && rule->blocks() >= most)
    state = given_up;
  if (state != watching) finish();
}

/// Returns the value of a reference, the same on all ranks to the last bit: they must end the run
/// in the same step.
double FixStationary::evaluate(const std::string& word) const {
  double value = input->variable->compute_equal(word);
  MPI_Bcast(&value, 1, MPI_DOUBLE, 0, world);
  if (!std::isfinite(value))
    error->all(FLERR, where + ": {} is {} at step {}", word, value, update->ntimestep);
  return value;
}

bool FixStationary::sample() {
  const double value = evaluate(progress_value);
  count_time();
  const std::vector<Ratio> gained = gains(time_since_sample);
  time_since_sample = 0.0;
  const double gain = value - last_progress;
  last_progress = value;
  if (!has_sample) {  // the first sample sets what totals count from
    has_sample = true;
    return rule->add(progress, std::vector<Ratio>(gained.size()));
  }
  progress += per_particle ? gain / static_cast<double>(group->count(igroup)) : gain;
  return rule->add(progress, gained);
}

/// Adds the time up to this step. The time step may be another in the next run.
void FixStationary::count_time() {
  time_since_sample += static_cast<double>(update->ntimestep - counted_step) * update->dt;
  counted_step = update->ntimestep;
}

std::vector<Ratio> FixStationary::gains(double elapsed) {
  std::vector<Ratio> gained;
  for (Value& value : watched)
    for (Term& term : value.terms) {
      const double here = evaluate(term.value);
      const double other = term.other.empty() ? 0.0 : evaluate(term.other);
      if (term.kind == TermKind::mean)
        gained.push_back({here, 1.0});
      else if (term.kind == TermKind::weighted)
        gained.push_back({here * other, other});
      else if (term.kind == TermKind::rate)
        gained.push_back({here - term.last, elapsed});
      else
        gained.push_back({here - term.last, other - term.last_other});
      term.last = here;
      term.last_other = other;
    }
  return gained;
}

/// Ends the run after this step, as `fix halt ... error continue` does: later runs are carried out.
void FixStationary::finish() {
  ended_run = true;
  timer->force_timeout();
  std::string text = fmt::format("{}: {} after {} blocks, step {}\n", where,
                                 state == met ? "stationary" : "the rule was not met",
                                 rule->blocks(), update->ntimestep);
  for (std::size_t w = 0; w < watched.size(); w++) {
    const auto mean = rule->mean(w);
    text += fmt::format("  {}: mean {:.6g} +- {:.2g}, last change {:.2g} %\n", watched[w].words,
                        mean.value, mean.error, 100.0 * rule->change(w));
  }
  if (comm->me) return;
  utils::logmesg(lmp, text);
  if (state == given_up)
    error->warning(FLERR, where + ": ended after most = {} blocks without being stationary", most);
}

void FixStationary::post_run() {
  if (ended_run) timer->reset_timeout();
  ended_run = false;
  count_time();
  if (comm->me == 0 && state == watching)
    utils::logmesg(lmp, fmt::format("{}: not met yet: {} blocks\n", where, rule->blocks()));
}

double FixStationary::compute_vector(int n) {
  if (n == 0) return rule->blocks();
  if (n == 1) return state == met ? 1.0 : 0.0;
  const std::size_t w = (n - HEAD) / 3;
  if ((n - HEAD) % 3 == 2) return rule->change(w);
  const auto mean = rule->mean(w);
  return (n - HEAD) % 3 == 0 ? mean.value : mean.error;
}

void FixStationary::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  std::vector<double> numbers = rule->state();
  numbers.insert(numbers.begin(), {progress, static_cast<double>(state)});
  const double count = static_cast<double>(numbers.size());
  numbers.insert(numbers.begin(), count);
  const int size = static_cast<int>(numbers.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(numbers.data(), sizeof(double), numbers.size(), fp);
}

void FixStationary::restart(char* buf) {
  double count;
  memcpy(&count, buf, sizeof(double));
  std::vector<double> numbers(static_cast<std::size_t>(count));
  memcpy(numbers.data(), buf + sizeof(double), numbers.size() * sizeof(double));
  progress = numbers[0];
  state = static_cast<int>(numbers[1]);
  numbers.erase(numbers.begin(), numbers.begin() + 2);
  from_script(lmp, where, [&] { return rule->restore(numbers), true; });
  // A tolerance or `most` may be another than in the run that wrote the file.
  if (!rule->met() && (!most || rule->blocks() < most)) state = watching;
}
