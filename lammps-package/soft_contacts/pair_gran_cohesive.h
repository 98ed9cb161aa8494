// SPDX-License-Identifier: GPL-2.0-only
#ifndef LMP_PAIR_GRAN_COHESIVE_H
#define LMP_PAIR_GRAN_COHESIVE_H

#include <algorithm>
#include <array>
#include <memory>
#include <variant>
#include <vector>

#include "common/bound_pairs.h"
#include "contact_solver/exact_contact.h"
#include "contact_step/advised_style.h"
#include "contact_step/close_pairs.h"
#include "contact_step/contact_forces.h"
#include "input/cohesive_coefficients.h"
#include "pair.h"
#include "sampled_contact/sampled_contact.h"
#include "soft_contacts/pair_history.h"
#include "update.h"

namespace LAMMPS_NS {

/// Particles and ghosts of the engine: positions at n, velocities at n-1/2.
struct StaggeredParticles {
  const double *x, *v, *spin;  // three numbers per particle
  const int* type;
  Bodies bodies;

  [[gnu::always_inline]] cohesion::contact_solver::RelativeState relative_state(int i,
                                                                                int j) const {
    return {of(x, j) - of(x, i), of(v, j) - of(v, i)};
  }
  [[gnu::always_inline]] cohesion::contact_solver::PairMotion motion(int i, int j) const {
    return {relative_state(i, j), of(spin, i), of(spin, j)};
  }
  [[gnu::always_inline]] static cohesion::Vector3 of(const double* numbers, std::ptrdiff_t i) {
    return vector(numbers + 3 * i);
  }
};

/// Motion of the particles i and j, read from the arrays where it is used.
struct StaggeredPair {
  const StaggeredParticles& all;
  int i, j;

  [[gnu::always_inline]] cohesion::contact_solver::RelativeState relative() const {
    return all.relative_state(i, j);
  }
  [[gnu::always_inline]] cohesion::Vector3 spin_i() const { return all.of(all.spin, i); }
  [[gnu::always_inline]] cohesion::Vector3 spin_j() const { return all.of(all.spin, j); }
};

/// Spheres with a linear, Hertzian or JKR contact, friction and a cohesion, in the exact or the
/// sampled scheme. `Cohesion` (cohesion_law.h) defines name, keywords, law, range and solvers of
/// the style.
template <class Cohesion>
class PairGranCohesive : public Pair,
                         public BoundPairs,
                         public SoftContactStyle,
                         public AdvisedStyle {
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

  /// The contacts of a step, and the index of the last one used per pair of types.
  template <class Contact>
  struct Contacts {
    std::vector<Contact> all;
    std::vector<int> last;

    static constexpr int NONE = -1;
    void clear() {
      all.clear();
      std::fill(last.begin(), last.end(), NONE);
    }
  };
  /// One alternative per scheme, in the order of Scheme.
  using ExactContact = cohesion::contact_solver::ExactContact<typename Cohesion::Solver>;
  using SampledContact = cohesion::sampled_contact::SampledContact<typename Cohesion::Sampled>;
  using AnyContacts = std::variant<Contacts<ExactContact>, Contacts<SampledContact>>;

  void allocate();
  double flight_allowance() const;
  void stop_at_flight(double flight, double allowed);
  void warn_of_flight(double flight, double allowed);
  int values_per_pair() const;
  bool bound_pairs_are_read() const;
  template <class Contact>
  int contact_index(Contacts<Contact>&, const StaggeredParticles&, int i, int j);
  template <class Contact>
  int new_contact(Contacts<Contact>&, int pair_index, int i, int j);
  StaggeredParticles particles() const;
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
  void hold(int i, int j, int& has_history, double* values) const;
  void begin_step();
  void find_close();
  template <int SIZE, class Contact>
  void compute_contacts(Contacts<Contact>&);
  template <int SIZE, class By, class Contact>
  void compute_by(Contacts<Contact>&);
  template <int SIZE, class Contact>
  bool read_persistent(const ContactForces<Contact, SIZE>&, const Contact&, int i, int j,
                       double* values);
  template <int SIZE, class Contact>
  void compute_contact(const ContactForces<Contact, SIZE>&, const Contact&, int i, int j,
                       int& has_history, double* values);
  template <class Contact>
  void add_flux(double fraction, const cohesion::contact_solver::PairMotion&, const Contact&,
                const cohesion::contact_solver::FrictionalStep&);
  void tally(int i, int j, const cohesion::Vector3& separation, double energy,
             const cohesion::Vector3& impulse);
  template <class What>
  void with_contacts(const What&);
  void repeat_forces();
  template <class What>
  void for_each_with_history(const What&);
  std::vector<cohesion::advice::AdvisedContact> advised_contacts(
      const std::vector<cohesion::advice::LightestParticle>&) const;

  CohesiveCoefficients<Cohesion> coefficients;
  std::unique_ptr<cohesion::advice::WarningFilter> advice_filter;
  AnyContacts any_contacts;
  std::vector<double> largest_radius, smallest_radius;  // by type, at init
  ClosePairs close_pairs;                               // pairs that may touch in a step
  double largest_range;                                 // largest gap at which a contact acts
  bool friction;                                        // whether any contact has friction
  bool is_active;                                       // whether anything can happen in this run
  bool needs_list;                                      // whether any pair is visited in this run
  bool history_stale;  // no contact was computed since, so histories are out of date
  int per_pair;        // values per history (HistorySize); 0: not allocated yet
  class FixContactStep* contact_step;
  PairHistory history;
  bool warned_of_flight = false;  // in this run
};

template <class Cohesion>
inline StaggeredParticles PairGranCohesive<Cohesion>::particles() const {
  return {atom->x[0], atom->v[0], atom->omega[0], atom->type, contact_step->bodies()};
}

/// The index of the contact of a pair; consecutive pairs of equal particles share one. NONE: no fix
/// moves either particle.
template <class Cohesion>
template <class Contact>
[[gnu::always_inline]] inline int PairGranCohesive<Cohesion>::contact_index(
    Contacts<Contact>& contacts, const StaggeredParticles& particles, int i, int j) {
  const int types = coefficients.pair_index(particles.type[i], particles.type[j]);
  const int last = contacts.last[types];
  if (last != Contacts<Contact>::NONE &&
      contacts.all[last].is_between(particles.bodies[i], particles.bodies[j]))
    return last;
  return new_contact(contacts, types, i, j);
}

template <class Cohesion>
template <class Contact>
[[gnu::noinline]] int PairGranCohesive<Cohesion>::new_contact(Contacts<Contact>& contacts,
                                                              int pair_index, int i, int j) {
  if (!moves(i, j)) return Contacts<Contact>::NONE;
  const cohesion::contact_solver::Body a = contact_step->body(i), b = contact_step->body(j);
  contacts.all.push_back(
      contact_step->contact<Contact>(coefficients.contact(pair_index),
                                     coefficients.template attraction<typename Contact::Attraction>(
                                         pair_index, a.radius, b.radius),
                                     a, b));
  return contacts.last[pair_index] = static_cast<int>(contacts.all.size()) - 1;
}

template <class Cohesion>
double PairGranCohesive<Cohesion>::distance(int i, int j) const {
  return norm(particles().relative_state(i, j).separation);
}

/// Pairs of two particles that no fix moves have no contact.
template <class Cohesion>
bool PairGranCohesive<Cohesion>::moves(int i, int j) const {
  return contact_step->body(i).inverse_mass != 0.0 || contact_step->body(j).inverse_mass != 0.0;
}

}  // namespace LAMMPS_NS

#endif
