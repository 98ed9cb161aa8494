// SPDX-License-Identifier: GPL-2.0-only
#ifndef LMP_FIX_WALL_GRAN_COHESIVE_H
#define LMP_FIX_WALL_GRAN_COHESIVE_H

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "atom.h"
#include "common/guarded.h"
#include "contact_solver/exact_contact.h"
#include "contact_solver/wall.h"
#include "contact_step/contact_forces.h"
#include "contact_step/fix_contact_step.h"
#include "contact_step/soft_contact_style.h"
#include "engine/region_faces.h"
#include "fix.h"
#include "input/cohesive_contact_from_script.h"
#include "sampled_contact/sampled_contact.h"
#include "soft_contacts/wall_forces.h"
#include "soft_contacts/wall_history.h"
#include "update.h"

namespace cohesion::advice {
struct AdvisedContact;
struct LightestParticle;
class WarningFilter;
}  // namespace cohesion::advice

namespace LAMMPS_NS {

/// Walls with the contact law of PairGranCohesive; a wall is a partner of infinite mass and radius.
/// `Cohesion`: as there.
template <class Cohesion>
class FixWallGranCohesive : public FixWithWallHistory, public SoftContactStyle {
 public:
  FixWallGranCohesive(class LAMMPS*, int, char**);
  ~FixWallGranCohesive() override;

  void post_constructor() override;
  int setmask() override;
  void init() override;
  void initial_integrate(int) override;
  void setup(int) override;
  void post_force(int) override;
  bool is_exact_scheme() const override { return scheme == Scheme::exact; }
  cohesion::advice::StickingRules sticking_rules() const override;
  void continue_run() override;
  void give_advice(const cohesion::advice::RunConditions&, AdviceOfStyles&) override;
  bool has_friction(int) const override { return per_wall > ContactHistory::normal_only; }

  double compute_vector(int) override;
  double compute_array(int, int) override;

  void write_restart(FILE*) override;
  void restart(char*) override;

 private:
  using ExactContact = cohesion::contact_solver::ExactContact<typename Cohesion::Solver>;
  using SampledContact = cohesion::sampled_contact::SampledContact<typename Cohesion::Sampled>;
  /// The contacts of the particles near a wall; consecutive equal particles share one. One
  /// alternative per scheme, in the order of Scheme.
  using AnyContacts = std::variant<std::vector<ExactContact>, std::vector<SampledContact> >;
  using Wall = cohesion::contact_solver::Wall;
  using WallState = cohesion::contact_solver::WallState;
  using WallPoint = cohesion::contact_solver::WallPoint;

  /// A particle that may touch a wall in this step.
  struct Near {
    int i;
    int wall;
    cohesion::Vector3 wall_velocity;
    cohesion::contact_solver::RelativeWallMotion motion;
    double* history;
  };

  void read(int, char**);
  template <class Contact>
  const Contact& contact(std::vector<Contact>&, int i);
  template <class Contact>
  void find_in_range(std::vector<Contact>&, const WallState&);
  void repeat_forces();
  template <int SIZE, class What>
  void for_each_with_history(const WallState&, const What&);
  void check_flight(int i, int wall, const WallPoint&, const WallState&);
  WallState state() const;
  double wall_travel(const WallState&) const;
  void update_sizes();
  void find_beside(const WallState&);
  void start_faces(const std::vector<std::string>& region_ids);
  int faces() const { return static_cast<int>(wall_of_face.size()); }
  void find_points(const cohesion::Vector3& centre, const WallState&, double reach,
                   std::vector<WallPoint>&);
  std::string name_of(int wall, const WallState&) const;
  void continue_around_open_edges(int i, const WallState&);
  void check_curvature(int i, double range);
  void warn_of_particles();
  void select_particles(const WallState&, double flight, bool new_list);
  bool may_touch(int i, int face, const WallState&, double flight, double range);
  Near near_face(int i, int face, const WallState&) const;
  template <class What>
  void for_each_near(const What&);
  template <int SIZE, class Contact>
  void compute_contacts(std::vector<Contact>&);
  template <int SIZE, class Contact>
  void compute_contact(const ContactForces<Contact, SIZE>&, const Contact&, const Near&);
  std::vector<cohesion::advice::AdvisedContact> advised_contacts(
      const std::vector<cohesion::advice::LightestParticle>&) const;
  template <class What>
  void with_contacts(const What& what) {
    guarded(lmp, where, [&] {
      std::visit(
          [&](auto& shared) {
            if (per_wall == ContactHistory::with_rolling)
              what(shared, std::integral_constant<int, ContactHistory::with_rolling>());
            else if (per_wall == ContactHistory::with_friction)
              what(shared, std::integral_constant<int, ContactHistory::with_friction>());
            else
              what(shared, std::integral_constant<int, ContactHistory::normal_only>());
          },
          contacts);
    });
  }

  std::string where;  // in front of messages
  std::unique_ptr<cohesion::advice::WarningFilter> advice_filter;
  Scheme scheme;
  bool has_adhesion_word = false;
  Cohesion attraction;
  typename Cohesion::Parameters unscaled_parameters;
  typename Cohesion::Parameters parameters;  // with scaled adhesion, if the script requests it
  typename Cohesion::Law law;
  std::vector<Wall> walls;
  std::vector<RegionFaces> regions;  // further walls, behind the others
  std::vector<int> wall_of_face;     // a plane or cylinder has one face
  std::vector<WallPoint> points;     // of the faces, for one particle
  /// Of each region, near the particle of the last find_points().
  std::vector<RegionFaces::Curvature> curvatures;
  bool has_warned_of_curvature = false;
  cohesion::contact_solver::WallMotion motion;
  cohesion::contact_solver::WallCourse course;

  int per_wall;  // values per history (ContactHistory)
  AnyContacts contacts;
  /// Of the particles at the last rebuild of the neighbour list.
  struct Sizes {
    double smallest_radius, largest_radius, largest_range;
  } sizes;
  std::vector<int> beside;  // particles that may touch a wall
  long radii_version = -1;  // at the time of this search
  double travelled;         // upper bound of a displacement since then, [length]
  FixContactStep* contact_step;

  WallForces forces;
};

/// The contact of particle i; consecutive equal particles share one.
template <class Cohesion>
template <class Contact>
inline const Contact& FixWallGranCohesive<Cohesion>::contact(std::vector<Contact>& shared, int i) {
  const cohesion::contact_solver::Body particle = contact_step->body(i), wall{0.0, 0.0};
  if (shared.empty() || !shared.back().is_between(particle, wall))
    shared.push_back(contact_step->contact<Contact>(
        parameters.contact,
        Cohesion::template of_wall<typename Contact::Attraction>(law, particle.radius), particle,
        wall));
  return shared.back();
}

/// The points of all faces; those of regions that are `reach` [length] away or farther are at an
/// infinite distance.
template <class Cohesion>
inline void FixWallGranCohesive<Cohesion>::find_points(const cohesion::Vector3& centre,
                                                       const WallState& now, double reach,
                                                       std::vector<WallPoint>& found) {
  WallPoint* point = found.data();
  for (const Wall& wall : walls) *point++ = wall.nearest(centre, now, motion.rim_speed);
  for (std::size_t r = 0; r < regions.size(); r++) {
    curvatures[r] = regions[r].find(centre, now, reach, point);
    point += regions[r].count();
  }
}

template <class Cohesion>
cohesion::contact_solver::WallState FixWallGranCohesive<Cohesion>::state() const {
  const double half = 0.5 * update->dt;
  return course.over({contact_step->starts() ? 0.0 : half, half});
}

}  // namespace LAMMPS_NS

#endif
