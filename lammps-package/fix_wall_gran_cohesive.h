// SPDX-License-Identifier: GPL-2.0-only
#ifndef LMP_FIX_WALL_GRAN_COHESIVE_H
#define LMP_FIX_WALL_GRAN_COHESIVE_H

#include <string>
#include <variant>
#include <vector>

#include "atom.h"
#include "cohesive_contact_from_script.h"
#include "contact_advice.h"
#include "event_contact.h"
#include "event_stepping/cohesive_contact.h"
#include "event_stepping/wall.h"
#include "fix.h"
#include "fix_event_step.h"
#include "guarded.h"
#include "wall_history.h"

namespace LAMMPS_NS {

/// Walls that act on spheres as PairGranCohesive lets spheres act on each other; a wall is a
/// partner of infinite mass and radius. `Cohesion`: as there.
template <class Cohesion>
class FixWallGranCohesive : public Fix, public EventContacts, public AdvisedStyle {
 public:
  FixWallGranCohesive(class LAMMPS*, int, char**);
  ~FixWallGranCohesive() override;

  void post_constructor() override;
  int setmask() override;
  void init() override;
  void post_force(int) override;
  void follow_alone() override;
  void follow_together() override;
  void book_standing() override;
  void give_advice(const Circumstances&) override;
  void take_where_they_are() override;
  bool rubs(int) const override { return per_wall > IN_RANGE; }

  double compute_vector(int) override;
  double compute_array(int, int) override;

  void grow_arrays(int nmax) override { history.grow(nmax); }
  void copy_arrays(int i, int j, int) override { history.copy(i, j); }
  void set_arrays(int i) override { history.begin(i); }
  int pack_exchange(int i, double* buf) override { return history.pack(i, buf); }
  int unpack_exchange(int i, double* buf) override { return history.unpack(i, buf); }
  void write_restart(FILE*) override;
  void restart(char*) override;
  int pack_restart(int i, double* buf) override { return history.pack_restart(i, buf); }
  void unpack_restart(int i, int nth) override { history.unpack_restart(i, atom->extra[i], nth); }
  int maxsize_restart() override { return history.size_restart(); }
  int size_restart(int) override { return history.size_restart(); }
  double memory_usage() override { return history.bytes(atom->nmax); }

 private:
  template <class Pair>
  using ContactsOf = std::vector<cohesion::event_stepping::CohesiveContact<Pair> >;
  /// Those of the particles near a wall, equal neighbours shared. One alternative per scheme, in
  /// the order of Scheme.
  using AnyContacts = std::variant<ContactsOf<typename Cohesion::EventWall>,
                                   ContactsOf<typename Cohesion::Sampled> >;
  using Wall = cohesion::event_stepping::Wall;

  /// A particle that may touch a wall in this step.
  struct Active {
    int i;
    int wall;
    std::size_t contact;
    cohesion::event_stepping::WallPoint point;
    cohesion::event_stepping::PairMotion alone;  // what it does without the others
  };

  void read(int, char**);
  template <class Contact>
  std::size_t contact(std::vector<Contact>&, int i);
  void check_flight(int i, const cohesion::event_stepping::WallPoint&, bool inside);
  cohesion::event_stepping::WallState state() const;
  double way_of_walls(const cohesion::event_stepping::WallState&) const;
  void look_at_sizes();
  template <bool FRICTION, bool ROLLING, class Contact>
  void follow_alone(std::vector<Contact>&);
  template <bool FRICTION, bool ROLLING, class Contact>
  void follow_together(const std::vector<Contact>&);
  std::vector<AdvisedContact> advised_contacts(const std::vector<LightestParticle>&) const;
  template <class Work>
  void with_contacts(const Work& work) {
    guarded(lmp, where, [&] { std::visit(work, contacts); });
  }
  void sum();

  std::string where;  // in front of messages
  cohesion::advice::Said said;
  Scheme scheme;
  Cohesion attraction;
  typename Cohesion::Parameters given_parameters;
  typename Cohesion::Parameters parameters;  // with adhesion scaled, if wished
  typename Cohesion::Law law;
  std::vector<Wall> walls;
  cohesion::event_stepping::WallMotion motion;
  bigint time_origin;

  int per_wall;  // values of history (HistorySize)
  WallHistory history;
  AnyContacts contacts;
  std::vector<Active> active;
  /// Of the particles, when the list of neighbours was new.
  struct Sizes {
    double smallest_radius, largest_radius, largest_range;
  } sizes;
  std::vector<cohesion::Vector3> rolled;  // with rolling friction, of each: from roll_alone()
  FixEventStep* step;

  std::vector<double> mine;   // forces on each wall
  std::vector<double> total;  // of all processes
  bool summed;
};

}  // namespace LAMMPS_NS

#endif
