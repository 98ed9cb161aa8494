// SPDX-License-Identifier: GPL-2.0-only
#ifndef LMP_FIX_WALL_GRAN_COHESIVE_H
#define LMP_FIX_WALL_GRAN_COHESIVE_H

#include <string>
#include <variant>
#include <vector>

#include "cohesive_contact_from_script.h"
#include "event_contact.h"
#include "event_stepping/cohesive_contact.h"
#include "event_stepping/wall.h"
#include "fix.h"
#include "fix_event_step.h"

namespace LAMMPS_NS {

/// Walls that act on spheres as PairGranCohesive lets spheres act on each other; a wall is a
/// partner of infinite mass and radius. `Cohesion`: as there.
template <class Cohesion>
class FixWallGranCohesive : public Fix, public EventContacts {
 public:
  FixWallGranCohesive(class LAMMPS*, int, char**);
  ~FixWallGranCohesive() override;

  void post_constructor() override;
  int setmask() override;
  void init() override;
  void post_force(int) override;
  void follow_alone() override;
  void follow_together() override;

  double compute_vector(int) override;
  double compute_array(int, int) override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  void write_restart(FILE*) override;
  void restart(char*) override;
  int pack_restart(int, double*) override;
  void unpack_restart(int, int) override;
  int maxsize_restart() override;
  int size_restart(int) override;
  double memory_usage() override;

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
  int history_size() const { return per_wall * static_cast<int>(walls.size()); }
  double* history_of(int i, int wall) { return history[i] + wall * per_wall; }
  void check_flight(int i, const cohesion::event_stepping::WallPoint&, bool inside);
  double way_of_walls(const cohesion::event_stepping::WallState&) const;
  void look_at_sizes();
  template <bool FRICTION, bool ROLLING, class Contact>
  void follow_alone(std::vector<Contact>&);
  template <bool FRICTION, bool ROLLING, class Contact>
  void follow_together(const std::vector<Contact>&);
  void give_advice();
  void sum();

  std::string where;  // in front of messages
  Scheme scheme;
  Cohesion attraction;
  typename Cohesion::Parameters parameters;  // with adhesion scaled, if wished
  typename Cohesion::Law law;
  std::vector<Wall> walls;
  cohesion::event_stepping::WallMotion motion;
  bigint time_origin;

  int per_wall;      // values of history (HistorySize); an in-range flag of -1: not known yet
  double** history;  // per atom
  AnyContacts contacts;
  std::vector<Active> active;
  /// Of the particles, when the list of neighbours was new.
  struct Sizes {
    double smallest_radius, largest_radius, largest_range;
  } sizes;
  std::vector<cohesion::Vector3> rolled;  // with rolling friction, of each: from roll_alone()
  FixEventStep* step;

  std::vector<double> mine;   // force on each wall
  std::vector<double> total;  // of all processes
  bool summed;
};

}  // namespace LAMMPS_NS

#endif
