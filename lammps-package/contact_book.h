// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_CONTACT_BOOK_H
#define COHESION_CONTACT_BOOK_H

#include <array>
#include <memory>
#include <vector>

#include "event_stepping/pair_motion.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// What contacts store at the grid point, what was lost before it, and the true motion there: of
/// one process. Kept while somebody reads it, who takes off what was there before, and in steps
/// that a run may be gone on from.
class ContactBook : protected Pointers {
 public:
  using Reader = std::shared_ptr<const void>;
  /// All [energy].
  struct Sums {
    cohesion::event_stepping::StoredEnergies stored{};
    cohesion::event_stepping::ContactLosses lost{};  ///< so far
    double external_work = 0.0;  ///< of other forces but gravity, and moving walls; so far
  };

  explicit ContactBook(LAMMPS*);
  ~ContactBook() override;
  ContactBook(const ContactBook&) = delete;
  ContactBook& operator=(const ContactBook&) = delete;

  /// To be held as long as the book is to be kept.
  [[nodiscard]] Reader keep() const { return readers_; }
  bool is_read() const { return readers_.use_count() > 1; }
  bool is_kept() const { return kept_; }
  const Sums& sums() const { return now_; }

  /// Whether it is kept in this step.
  void update_readers();
  /// A new grid point: what was lost after the last one was lost before this one.
  void begin_step();
  /// What `fraction` of a contact stores.
  void store(double fraction, const cohesion::event_stepping::StoredEnergies&);
  /// Where a run goes on from the forces of the last one, what springs in the plane of contact
  /// store is known: all else is stored again.
  void begin_again();
  void store_again(double fraction, const cohesion::event_stepping::StoredEnergies&);
  /// What `fraction` of a contact loses, of which `later` is after the grid point.
  void lose(double fraction, const cohesion::event_stepping::ContactLosses&, double later);
  /// Work of others around the grid point.
  void work(double done);

  /// Per atom and ghost: six numbers that lead from velocity and spin on the grid to the true ones,
  /// of all contacts.
  double** owed() const { return owed_; }
  /// The end of the step, of a particle: the impulse and angular impulse of contacts that are in
  /// the engine's velocities by then.
  void end_step(int i, const cohesion::event_stepping::Body&, const cohesion::Vector3& pushed,
                const cohesion::Vector3& turned);
  /// Then, of a particle.
  cohesion::Vector3 true_velocity(int i) const;
  cohesion::Vector3 true_spin(int i) const;

  /// What a later run needs to go on: of a particle, six numbers; of all particles, seven.
  static constexpr int OF_PARTICLE = 6;
  using OfAll = std::array<double, 7>;
  void note_motion(int i, double* values) const;
  void take_motion(int i, const double* values);
  OfAll of_all() const;
  void take_of_all(const OfAll&);

  double bytes() const;

 private:
  bool kept_ = false;
  Sums now_, later_;  // later_: after the grid point
  int room_ = 0;      // of both arrays, in particles
  double** owed_ = nullptr;
  double** to_truth_ = nullptr;  // from the engine's velocity and spin at the end of the step
  Reader readers_;
};

}  // namespace LAMMPS_NS

#endif
