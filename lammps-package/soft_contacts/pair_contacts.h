// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_PAIR_CONTACTS_H
#define COHESION_PAIR_CONTACTS_H

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "atom.h"
#include "contact/contact_parameters.h"
#include "contact_solver/pair_motion.h"
#include "contact_step/close_pairs.h"
#include "contact_step/contact_forces.h"
#include "contact_step/fix_contact_step.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Particles and ghosts of the engine: positions at n, velocities at n-1/2.
struct StaggeredParticles {
  const double *x, *v, *spin;  // three numbers per particle
  const int* type;
  const double *radius, *inverse_mass;

  [[gnu::always_inline]] Vector3 separation(int i, int j) const { return of(x, j) - of(x, i); }
  [[gnu::always_inline]] Vector3 velocity(int i, int j) const { return of(v, j) - of(v, i); }
  [[gnu::always_inline]] PairMotion motion(int i, int j) const {
    return {separation(i, j), velocity(i, j), of(spin, i), of(spin, j)};
  }
  [[gnu::always_inline]] static Vector3 of(const double* numbers, std::ptrdiff_t i) {
    return vector(numbers + 3 * i);
  }
  cohesion::contact_solver::Body body(int i) const { return {radius[i], inverse_mass[i]}; }
};

/// Motion of the particles i and j, read from the arrays where it is used.
struct StaggeredPair {
  const StaggeredParticles& all;
  int i, j;

  [[gnu::always_inline]] Vector3 separation() const { return all.separation(i, j); }
  [[gnu::always_inline]] Vector3 velocity() const { return all.velocity(i, j); }
  [[gnu::always_inline]] Vector3 spin_i() const { return all.of(all.spin, i); }
  [[gnu::always_inline]] Vector3 spin_j() const { return all.of(all.spin, j); }
};

/// The contacts of a pair style and their part of a step. `Contact`: ExactContact or
/// SampledContact, with a solver. The keywords are read in the pair style (pair_gran_cohesive.h):
/// this class needs neither them nor the law. A unit of its own instantiates it for each solver, as
/// hamaker_step.cpp does, with pair_contacts_step.h.
template <class Contact>
class PairContacts : protected Pointers {
 public:
  /// Returns the contact of two bodies with the types of particles i and j.
  using Create = std::function<Contact(int i, int j, const cohesion::contact_solver::Body& a,
                                       const cohesion::contact_solver::Body& b)>;
  /// Adds energy and virial of a pair; the impulse acts on j.
  using Tally = std::function<void(int i, int j, const Vector3& separation, double energy,
                                   const Vector3& impulse)>;

  PairContacts(LAMMPS* lammps, FixContactStep* contact_step, Create create, Tally tally)
      : Pointers(lammps),
        step_(contact_step),
        create_(std::move(create)),
        tally_(std::move(tally)),
        types_(atom->ntypes) {
    clear();
  }

  /// Forgets the contacts of the last step.
  void clear() {
    all_.clear();
    last_.assign((types_ + 1) * (types_ + 1), NONE);
  }
  /// The contact of two particles of which at least one moves.
  const Contact& between(int i, int j) { return all_[index_of(particles(), i, j)]; }

  /// Computes the contacts of `pairs` in this step. `size`: values per history, with which they
  /// are computed; `only_law`: of all contacts, if they have the same; `tallies`: whether outputs
  /// need energy and virial.
  void compute(const ClosePairs& pairs, int size,
               std::optional<cohesion::contact::LawKind> only_law, bool tallies);

 private:
  static constexpr int NONE = -1;

  StaggeredParticles particles() const {
    return {atom->x[0], atom->v[0],   atom->omega[0],
            atom->type, atom->radius, step_->inverse_masses()};
  }
  /// The index of the contact of a pair; consecutive pairs of equal particles share one. NONE: no
  /// fix moves either particle.
  [[gnu::always_inline]] int index_of(const StaggeredParticles& particles, int i, int j) {
    const int types = particles.type[i] * (types_ + 1) + particles.type[j];
    const int last = last_[types];
    if (last != NONE && all_[last].is_between(particles.body(i), particles.body(j))) return last;
    return add(types, i, j);
  }
  [[gnu::noinline]] int add(int types, int i, int j) {
    const cohesion::contact_solver::Body a = step_->body(i), b = step_->body(j);
    if (a.inverse_mass == 0.0 && b.inverse_mass == 0.0) return NONE;
    all_.push_back(create_(i, j, a, b));
    return last_[types] = static_cast<int>(all_.size()) - 1;
  }
  template <int SIZE>
  void compute_sized(const ClosePairs&, std::optional<cohesion::contact::LawKind> only_law);
  template <int SIZE, class By>
  void compute_by(const ClosePairs&);
  template <int SIZE>
  bool read_persistent(const ContactForces<Contact, SIZE>&, const Contact&, int i, int j,
                       double* values);
  template <int SIZE>
  void compute_contact(const ContactForces<Contact, SIZE>&, const Contact&, int i, int j,
                       int& has_history, double* values);
  void hold(int i, int j, int& has_history, double* values) const;
  void add_flux(double fraction, const PairMotion&, const Contact&, const FrictionalStep&);

  FixContactStep* step_;
  Create create_;
  Tally tally_;
  int types_;
  bool tallies_ = false;      // whether tally_ is to be called in this step
  int per_pair_ = 0;          // values per history
  std::vector<Contact> all_;  // of this step
  std::vector<int> last_;     // index of the last contact used, by pair of types
};

}  // namespace LAMMPS_NS

#endif
