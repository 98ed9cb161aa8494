// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(stationary,FixStationary);
// clang-format on
#else

#ifndef LMP_FIX_STATIONARY_H
#define LMP_FIX_STATIONARY_H

#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "statistics/block_rule.h"

namespace LAMMPS_NS {

/// fix ID group stationary N ...: ends a run when blocks of it are alike.
/// Doc: docs/lammps-package/fix_stationary.md
class FixStationary : public Fix {
 public:
  FixStationary(class LAMMPS*, int, char**);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void post_run() override;
  double compute_scalar() override { return progress; }
  double compute_vector(int) override;
  void write_restart(FILE*) override;
  void restart(char*) override;

 private:
  enum class TermKind { mean, weighted, rate, ratio };
  struct Term {
    TermKind kind;
    std::string value,
        other;  // as in the script: c_ID, f_ID, v_name; the weight, of a ratio the total below
    double last, last_other;  // of totals
  };
  struct Value {
    std::string words;  // as in the script
    double tolerance;
    std::vector<Term> terms;
  };

  void read_keywords(int, char**);
  int read_watched(int, int, char**);
  void require_exists(const std::string&) const;
  bigint next_sample() const;
  double evaluate(const std::string&) const;
  bool sample();
  void count_time();
  std::vector<cohesion::statistics::Ratio> gains(double elapsed);
  void finish();

  std::string where;
  std::string progress_value;
  bool per_particle = false;
  double start = 0.0, block = 0.0;
  int most = 0;  // blocks; 0: any number
  std::vector<Value> watched;
  std::unique_ptr<cohesion::statistics::BlockRule> rule;

  // Whether there was a sample, so that progress and totals have a last value
  bool has_sample = false;
  double progress = 0.0;           // since the fix was defined
  double last_progress = 0.0;      // the value of `progress_value` at the last sample
  double time_since_sample = 0.0;  // time since the last sample, up to counted_step
  bigint counted_step = 0;
  enum { watching, met, given_up };
  int state = watching;
  bool ended_run = false;  // whether this fix has, not the user's own `timer timeout`
};

}  // namespace LAMMPS_NS

#endif
#endif
