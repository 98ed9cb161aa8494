// SPDX-License-Identifier: GPL-2.0-only
#ifndef LMP_PAIR_GRAN_COHESIVE_H
#define LMP_PAIR_GRAN_COHESIVE_H

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "common/bound_pairs.h"
#include "contact_solver/exact_contact.h"
#include "contact_step/soft_contact_style.h"
#include "input/cohesive_coefficients.h"
#include "pair.h"
#include "sampled_contact/sampled_contact.h"
#include "soft_contacts/pair_contacts.h"
#include "soft_contacts/pair_history.h"

namespace cohesion::advice {
struct AdvisedContact;
struct LightestParticle;
class WarningFilter;
}  // namespace cohesion::advice

namespace LAMMPS_NS {

/// Spheres with a linear, Hertzian or JKR contact, friction and a cohesion, in the exact or the
/// sampled scheme. `Cohesion` (cohesion_law.h) defines name, keywords, law, range and solvers of
/// the style.
template <class Cohesion>
class PairGranCohesive : public Pair, public BoundPairs, public SoftContactStyle {
 public:
  explicit PairGranCohesive(class LAMMPS*);
  ~PairGranCohesive() override;

  void compute(int, int) override;
  void settings(int narg, char** arg) override { coefficients.read_settings(narg, arg); }
  void coeff(int, char**) override;
  void init_style() override;
  double init_one(int, int) override;
  /// For compute pair/local: energy of spring and adhesion; `force` over distance, and SINGLE_EXTRA
  /// numbers in svector (docs/lammps-package/soft_contact_runs.md).
  double single(int i, int j, int, int, double, double, double, double& force) override;
  void write_restart(FILE*) override;
  void read_restart(FILE*) override;
  /// Stale histories are written as none.
  void write_restart_settings(FILE* fp) override {
    coefficients.write_settings(fp, history_stale ? 0 : per_pair);
  }
  /// Histories keep the size that they have in the file, with rolling friction or without.
  void read_restart_settings(FILE* fp) override {
    per_pair = coefficients.read_settings(fp);
    history_stale = per_pair == 0;
  }
  void append_bound(std::vector<std::array<int, 2>>&) const override;
  bool may_have_contacts() const override { return needs_list; }
  bool is_exact_scheme() const override {
    return is_active && coefficients.scheme() == Scheme::exact;
  }
  cohesion::advice::StickingRules sticking_rules() const override;
  bool has_contacts() const override { return is_active && Cohesion::HAS_CONTACT; }
  void continue_run() override;
  void renumber(const Renumbering& renumbering) override { history.renumber(renumbering); }
  void give_advice(const cohesion::advice::RunConditions&, AdviceOfStyles&) override;
  bool has_friction(int type) const override {
    return coefficients.has_friction(type, atom->ntypes);
  }

 private:
  static constexpr int SINGLE_EXTRA = 10;

  using ExactContact = cohesion::contact_solver::ExactContact<typename Cohesion::Solver>;
  using SampledContact = cohesion::sampled_contact::SampledContact<typename Cohesion::Sampled>;

  void allocate();
  double flight_allowance() const;
  void stop_at_flight(double flight, double allowed);
  void warn_of_flight(double flight, double allowed);
  int values_per_pair() const;
  bool bound_pairs_are_read() const;
  template <class Contact>
  PairContacts<Contact> contacts_of_run();
  /// Throws where no run has begun.
  auto& contacts_by_scheme() { return pair_contacts.value(); }
  cohesion::Vector3 separation(int i, int j) const;
  double distance(int i, int j) const;
  bool moves(int i, int j) const;
  void require_distinct_places() const;
  template <class What>
  void for_each_listed(const What&) const;
  bool is_altered(int i, int j) const;
  void find_in_range();
  void forget_all();
  void forget_springs();
  const double* stored_history(int i, int j) const;
  void begin_step();
  void find_close();
  void tally(int i, int j, const cohesion::Vector3& separation, double energy,
             const cohesion::Vector3& impulse);
  void repeat_forces();
  template <class What>
  void for_each_with_history(const What&);
  std::vector<cohesion::advice::AdvisedContact> advised_contacts(
      const std::vector<cohesion::advice::LightestParticle>&) const;

  CohesiveCoefficients<Cohesion> coefficients;
  std::unique_ptr<cohesion::advice::WarningFilter> advice_filter;
  /// By scheme; none before the first run.
  std::optional<std::variant<PairContacts<ExactContact>, PairContacts<SampledContact>>>
      pair_contacts;
  std::vector<double> largest_radius, smallest_radius;  // by type, at init
  ClosePairs close_pairs;                               // pairs that may touch in a step
  double largest_range;                                 // largest gap at which a contact acts
  bool friction;                                        // whether any contact has friction
  bool is_active;                                       // whether anything can happen in this run
  bool needs_list;                                      // whether any pair is visited in this run
  bool history_stale;  // no contact was computed since, so histories are out of date
  int per_pair;        // values per history (ContactHistory); 0: not allocated yet
  class FixContactStep* contact_step;
  PairHistory history;
  bool warned_of_flight = false;  // in this run
};

/// Of j from i, [length].
template <class Cohesion>
cohesion::Vector3 PairGranCohesive<Cohesion>::separation(int i, int j) const {
  return vector(atom->x[j]) - vector(atom->x[i]);
}

template <class Cohesion>
double PairGranCohesive<Cohesion>::distance(int i, int j) const {
  return norm(separation(i, j));
}

/// Pairs of two particles that no fix moves have no contact.
template <class Cohesion>
bool PairGranCohesive<Cohesion>::moves(int i, int j) const {
  return contact_step->body(i).inverse_mass != 0.0 || contact_step->body(j).inverse_mass != 0.0;
}

}  // namespace LAMMPS_NS

#endif
