// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_EVENT_CONTACTS_H
#define COHESION_EVENT_CONTACTS_H

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "atom.h"
#include "contact/adhesion.h"
#include "contact_interface.h"
#include "contact_range.h"
#include "event_stepping/grid_point.h"
#include "event_stepping/one_pass_contact.h"
#include "fix_others.h"
#include "integrated_particles.h"
#include "normal_model_probe.h"

namespace LAMMPS_NS {
class FixWallGran;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

struct LateWarning;

/// The contacts of one pair style or wall under scheme event: brings what the engine knows of a
/// contact to the law that follows it (event_stepping/one_pass_contact.h), and keeps its memory in
/// the engine's contact history, with which it goes through exchange and restart. Others act as in
/// the step before.
class EventContacts {
 public:
  using Adhesion =
      std::function<cohesion::contact::Adhesion(int itype, int jtype, double ri, double rj)>;
  using OnePassContact = cohesion::event_stepping::OnePassContact;
  using MakeLaw = std::unique_ptr<OnePassContact> (*)(const cohesion::contact::LinearSpringDashpot&,
                                                      const cohesion::contact::Adhesion&,
                                                      double contact_distance, double step);

  /// who: in messages; wall: null for pairs. Adds to the history of contacts.
  EventContacts(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* owner, LAMMPS_NS::FixWallGran* wall,
                const std::string& who);
  ~EventContacts();

  /// `adhesion`: of two types and radii; rj infinite: beside a wall; maker: of what follows it;
  /// range: beyond which nothing acts.
  /// Stops where the normal model is none that the scheme can follow.
  void connect(const NormalModelProbe& normal, Adhesion adhesion, MakeLaw maker,
               const ContactRange& range, int types);

  /// r: distance of the centres, or from the wall; normal: from j, or the wall, to i. False, and
  /// `step` of no meaning: the contact does nothing.
  bool follow(const ContactModels::SurfacesCloseData& d, double r, const double* normal,
              cohesion::event_stepping::GridStep& step);

  /// Whether a pair at this distance of the centres has no memory and nothing can happen to it in
  /// this step, as most that the engine shows: follow() would find out by looking at far more.
  bool is_far(const ContactModels::SurfacesCloseData& d, double r) const;

  /// Whether the grid has a contact with this history in the range of its attraction.
  bool in_range(const double* history) const;

  /// Lets the engine's friction act in `step` with the repulsion of the contact, and with the K_t
  /// and eta_t that make the grid follow its spring exactly (one_pass_contact.h). `spring`: its
  /// displacement, which the engine will let grow through all of the step before, also where there
  /// was no contact; null: it has none.
  void set_friction(ContactModels::SurfacesIntersectData& contact,
                    const cohesion::event_stepping::GridStep& step, double* spring) const;

 private:
  // What is remembered of a contact. TOUCH: how long it was in contact in the last step; STEP: the
  // one in which this was written, and 1.
  enum { PHASE, AHEAD, FORCE, REPULSION, TOUCH, STEP };

  using GridMemory = cohesion::event_stepping::GridMemory;

  /// The bodies of a contact, and its law.
  struct KnownContact;

  static bool is_impulse(const KnownContact&, double contact_time);
  void exclude_impulse(const KnownContact&, const ContactModels::SurfacesCloseData& d,
                       const double* normal, const cohesion::event_stepping::GridStep&);
  /// The law of a contact; null: nothing that a force could move.
  KnownContact* known_contact(const ContactModels::SurfacesCloseData& d);
  /// The mass of a particle; 0: no force moves it.
  double mass(int particle) const {
    return mobile_.moves(atom_->mask[particle]) ? atom_->rmass[particle] : 0.0;
  }
  double others(const ContactModels::SurfacesCloseData& d, const cohesion::Vector3& normal) const;
  bool repeat(const ContactModels::SurfacesCloseData& d,
              cohesion::event_stepping::GridStep& step) const;
  const double* last_record(const ContactModels::SurfacesCloseData& d) const;
  void write(const ContactModels::SurfacesCloseData& d, const GridMemory& memory,
             const cohesion::event_stepping::GridStep& step) const;
  void make_law(KnownContact& k, const ContactModels::SurfacesCloseData& d) const;

  LAMMPS_NS::LAMMPS* lmp_;
  LAMMPS_NS::Atom* atom_;
  LAMMPS_NS::FixWallGran* wall_;
  std::string who_;
  int offset_;
  const NormalModelProbe* normal_ = nullptr;
  Adhesion adhesion_;
  MakeLaw make_law_ = nullptr;
  ContactRange range_;
  FixOthers* others_ = nullptr;
  MobileParticles mobile_;
  std::vector<KnownContact> known_;  // the last of each two types
  const KnownContact* followed_ = nullptr;
  double time_apart_ = 0.0;  // how much of the step before the contact just followed was none
  int types_ = 0;
  std::shared_ptr<LateWarning> late_;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
