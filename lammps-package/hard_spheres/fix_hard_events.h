// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(HARD_EVENTS,FixHardEvents);
// clang-format on
#else

#ifndef LMP_FIX_HARD_EVENTS_H
#define LMP_FIX_HARD_EVENTS_H

#include <memory>
#include <unordered_map>
#include <vector>

#include "atom.h"
#include "fix.h"
#include "hard_event_record.h"
#include "hard_event_time_warp.h"
#include "hard_event_totals.h"
#include "hard_sphere/event_simulation.h"
#include "mobile_particles.h"
#include "shear/nonaffine_displacements.h"

namespace LAMMPS_NS {

/// A fix whose walls take part in the event-driven simulation.
class HardWalls {
 public:
  virtual const std::vector<cohesion::event_stepping::Wall>& hard_walls() const = 0;
  /// Whether the walls act on particle i.
  virtual bool acts_on(int i) const = 0;
  /// Wall w and its motion over the step that ends now.
  virtual cohesion::hard_sphere::MovingWall over_step(int w) const = 0;
  virtual bool still() const = 0;
  virtual cohesion::hard_sphere::Law law_of_type(int type) const = 0;
  virtual cohesion::hard_sphere::Surfaces surfaces_of(int i) const = 0;
  /// Whether particle i is in the well of wall w; negative: not known yet.
  virtual double& inside(int i, int w) = 0;

 protected:
  ~HardWalls() = default;
};

/// The fix that executes the events of a step, for pair_style hard/square_well and its walls; the
/// first of them makes it.
///
/// In pre_force the engine has moved every particle straight to the end of the step. The candidate
/// pairs are the pairs of the neighbour list and the particles with the walls; their events are
/// executed in order (src/hard_sphere/event_simulation.h), and positions and velocities corrected.
/// Positions are those of the owner of a particle with a periodic image, never a ghost's own, so
/// that every process works out the same numbers.
class FixHardEvents : public Fix {
 public:
  FixHardEvents(class LAMMPS*, int, char**);
  ~FixHardEvents() override;

  /// Returns the fix of this run, which it makes when there is none.
  static FixHardEvents* of(class LAMMPS*);

  int setmask() override;
  void init() override;
  void initial_integrate(int) override;
  void pre_exchange() override;
  void setup_pre_force(int) override;
  void pre_force(int) override;
  int pack_forward_comm(int, int*, double*, int, int*) override;
  void unpack_forward_comm(int, int, double*) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  double memory_usage() override;

  const cohesion::hard_sphere::EventSimulation& simulation() const { return simulation_; }
  const HardEventTotals& totals() const { return totals_; }
  /// Asks for totals().flux to be summed from here on.
  void sum_flux() { totals_.flux_wanted = true; }

 private:
  struct HistorySlots {  // of a candidate pair; two for a pair through the boundary
    int* flag[2];
    double* value[2];
  };
  struct SecondEntry {  // of such a pair in the list of neighbours
    int i, j, image;
    int* flag;
    double* value;
  };
  struct RemoteParticle {  // a particle that another process owns
    int body, ghost, image, owner;
  };
  struct Shift {  // in boxes
    int x, y, z;
    bool operator==(const Shift& b) const { return x == b.x && y == b.y && z == b.z; }
  };

  void warn_of_overlaps() const;
  void match_restart();
  void round_positions();
  void set_up_candidates();
  void set_body(int body, int i);
  int body_of(int i);
  int image_of(const Shift&);
  Shift shift_of(int ghost) const;
  void update_images();
  void add_pairs();
  void add_second_entries();
  void add_walls();
  void find_wells_of_new_pairs();
  void store_inside(int candidate);
  bool with_remote_body(const cohesion::hard_sphere::CandidatePair& b) const {
    return b.i >= atom->nlocal || b.j >= atom->nlocal;
  }
  void load_flights();
  void run_events(long expected_events);
  void stop_at_limit() const;
  void store_results();
  void track_displacement(int i, const cohesion::Vector3& position, double left);
  void check_list();

  class PairHardSquareWell* pair_;
  std::vector<HardWalls*> walls_;
  std::vector<std::pair<HardWalls*, int> > wall_;  // by number
  MobileParticles mobile_;

  // Bodies: own particles, then those in remote_.
  cohesion::hard_sphere::EventSimulation simulation_;
  std::vector<HistorySlots> slots_;  // by candidate
  std::vector<SecondEntry> second_entries_;
  std::vector<Shift> shifts_;  // by image
  std::vector<RemoteParticle> remote_;
  std::unordered_map<std::uint64_t, int> remote_body_;
  HardEventTimeWarp time_warp_;
  double** origin_;   // per atom and ghost: process, index there, position there
  double** outside_;  // per atom:// how far the free flight led out of the box
  double* kick_;      // per atom: Flight::kick
  // Of own particles since the list was made.
  cohesion::shear::NonaffineDisplacements displacements_;
  double farthest_squared_;  // the largest of displacements_, squared
  bool warned_;
  HardEventTotals totals_;
  std::unique_ptr<HardEventRecord> record_;
};

}  // namespace LAMMPS_NS

#endif
#endif
