// SPDX-License-Identifier: GPL-2.0-only
#ifdef PAIR_CLASS
// clang-format off
PairStyle(hamaker,PairHamaker);
// clang-format on
#else

#ifndef LMP_PAIR_HAMAKER_H
#define LMP_PAIR_HAMAKER_H

#include <array>
#include <string>
#include <vector>

#include "common/bound_pairs.h"
#include "hamaker/forms.h"
#include "input/type_pair_table.h"
#include "pair.h"
#include "soft_contacts/contact_advice.h"

namespace LAMMPS_NS {

/// pair_style hamaker [cutoff H_cut H_out] [form name]: Hamaker attraction between spheres, laid
/// over any contact style with hybrid/overlay. The law is src/hamaker/law.h; doc:
/// docs/lammps-package/pair_hamaker.md
class PairHamaker : public Pair, public BoundPairs {
 public:
  explicit PairHamaker(class LAMMPS*);
  ~PairHamaker() override;

  void compute(int, int) override;
  void settings(int, char**) override;
  void coeff(int, char**) override;
  void init_style() override;
  double init_one(int, int) override;
  double single(int, int, int, int, double, double, double, double&) override;

  void* extract(const char*, int&) override;
  void append_bound(std::vector<std::array<int, 2> >&) const override;

  void write_restart(FILE*) override;
  void read_restart(FILE*) override;
  void write_restart_settings(FILE*) override;
  void read_restart_settings(FILE*) override;
  void write_data(FILE*) override;
  void write_data_all(FILE*) override;

 private:
  using Parameters = cohesion::hamaker::HamakerParameters;

  template <bool TALLY, bool NEWTON, class Law>
  void compute_pairs(const std::vector<Law>&);

  void give_advice();
  std::vector<AdvisedContact> advised_contacts() const;
  bool attracts() const;
  bool may_attract() const;
  void allocate();
  Parameters of_type(int);
  void give(int, int, const Parameters&);
  void check_parameters(const std::string& where, const Parameters&);
  static void write_coefficients(FILE*, const Parameters&);

  double surface_cutoff = 0.0;  // default of pair_coeff
  double outer_cutoff = 0.0;    // default of pair_coeff
  const cohesion::hamaker::Form* form;
  double** hamaker_constant = nullptr;  // by type pair; fix adapt writes it
  TypePairTable<Parameters> parameters;
  cohesion::hamaker::AnyLaws laws;  // by type pair, built at init
  std::vector<bool> prepared;       // by type pair: whether it is this style's in this run
  std::vector<double> largest_radius, smallest_radius;  // by type, at init
  bool needs_list = true;                               // whether any pair is looked at in this run
  bool warned = false;                                  // of numbers without keywords
  LammpsWatch watch;
  cohesion::advice::WarningFilter advice_filter;
};

}  // namespace LAMMPS_NS

#endif
#endif
