// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(HARD_EVENTS,FixHardEvents);
// clang-format on
#else

#ifndef LMP_FIX_HARD_EVENTS_H
#define LMP_FIX_HARD_EVENTS_H

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "atom.h"
#include "engine/mobile_particles.h"
#include "fix.h"
#include "hard_sphere/time_warp.h"
#include "hard_spheres/hard_event_record.h"
#include "hard_spheres/hard_event_time_warp.h"
#include "hard_spheres/hard_event_totals.h"
#include "shear/nonaffine_displacements.h"

namespace LAMMPS_NS {

/// Interface of a fix whose walls the event-driven simulation includes.
class HardWallSource {
 public:
  virtual int number_of_walls() const = 0;
  /// Wall w with its motion during the current step, which ends at the time `when` of the
  /// simulation.
  virtual cohesion::hard_sphere::HardWall wall(int w, double when) const = 0;

 protected:
  ~HardWallSource() = default;
};

/// Internal fix that executes the events of a step for pair_style hard/squarewell and its walls.
/// The first of these styles creates it.
///
/// Before pre_force the engine has moved every particle in a straight line to the end of the step.
/// Flights of the simulation (src/hard_sphere/event_simulation.h) last for many steps. A particle
/// at the end of its flight, with the velocity of the flight, continues it. A particle with another
/// velocity or position starts a new flight. Then the simulation executes the events, and the fix
/// writes positions and velocities to the arrays of the engine.
///
/// The simulation does not wrap particles that leave a periodic box: its positions are unwrapped
/// relative to the image flags at the last reset of the simulation time. Remote bodies have the
/// flights of their owners, never data of ghosts, so that all processes compute the same bits.
class FixHardEvents : public Fix {
 public:
  FixHardEvents(class LAMMPS*, int, char**);
  ~FixHardEvents() override;

  /// Returns the fix of this run, and creates it if there is none.
  static FixHardEvents* find_or_create(class LAMMPS*);

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
  void write_restart(FILE*) override;
  void restart(char*) override;
  double memory_usage() override;

  const cohesion::hard_sphere::EventSimulation& simulation() const { return simulation_; }
  const HardEventTotals& totals() const { return totals_; }
  /// Enables the sum totals().flux from here on.
  void enable_flux() { totals_.flux_enabled = true; }
  /// Collective: the pairs in their wells, of an own particle and an own one or a ghost; position
  /// and velocity are relative to the first.
  struct PairInWell {
    int i, j;
    cohesion::Vector3 separation, relative_velocity;
  };
  std::vector<PairInWell> pairs_in_wells();

 private:
  /// Data per particle, stored between steps and sent when particles migrate: the flight
  /// (EventSimulation::flights), the image flags at the last reset of the simulation time, the
  /// distance that clamp_to_boundary() has moved the particle, HardSphere::speed_increment, and the
  /// ID.
  enum DataColumn {
    POSITION = 0,
    VELOCITY = 3,
    START_TIME = 6,
    CAUSAL_DEPTH = 7,
    IMAGE = 8,
    CLAMPED = 9,
    SPEED_INCREMENT = 12,
    TAG = 13
  };
  static constexpr int DATA_COLUMNS = 14;

  void predict_changed_bodies();
  void prepare_restart_step();
  bool time_reset_is_due();
  void round_positions();
  void stop_at_limit() const;
  void run_events();

  using PairsByTag = std::vector<cohesion::hard_sphere::TagPair>;

  // In fix_hard_events_setup.cpp
  void set_rules();
  PairsByTag excluded_bonded_pairs() const;
  void require_distinct_positions() const;
  void warn_of_overlaps() const;

  // In fix_hard_events_results.cpp
  void store_events();
  void store_flights();
  void prefetch_displacements(const cohesion::hard_sphere::Event&) const;
  void check_neighbour_list();
  void track_displacement(int i, const cohesion::Vector3& position, double left);

  // In fix_hard_events_flights.cpp
  struct EngineMotion {
    cohesion::Vector3 position, velocity;
    double velocity_tolerance;  // round-off of velocities that have been remapped at the boundary
                                // of a sheared box
  };
  void require_flights_within_box() const;
  void clamp_to_boundary();
  void wrap_far_particles();
  void restore_clamped_positions();
  cohesion::Vector3 boxes_crossed(int i) const;
  void store_image_flags(int i);
  bool box_has_changed(double dt) const;
  void reset_simulation_time(double dt);
  void set_time_origin_lifetime();
  EngineMotion engine_motion(int i, double end) const;
  bool continues_flight(int i, const EngineMotion&, double end) const;
  void load_body(int i, double dt);
  void load_changes(double dt);
  void load_walls(double when);

  // In fix_hard_events_bodies.cpp
  using RemoteParticles =
      std::vector<std::pair<int, BorderExchange::ParticleRequest> >;  // with the index of one of
                                                                      // its ghosts
  using NumbersByTag = std::unordered_map<std::int64_t, int>;
  cohesion::hard_sphere::HardSphere body_properties(int i) const;
  bool has_same_bodies() const;
  void load_all(double dt);
  void load_bodies(const RemoteParticles&, double dt);
  bool update_bodies(double dt);
  NumbersByTag displaced_bodies() const;
  int find_body(const cohesion::hard_sphere::HardSphere&, int number, const NumbersByTag&) const;
  void preserve_numbers(RemoteParticles&, const NumbersByTag& displaced) const;
  RemoteParticles find_remote_particles();
  void request_remote_particles(const RemoteParticles&);
  void send_owners();
  void set_up_events();
  PairsByTag gather_bound_pairs_at_edge() const;
  void update_bound_at_edge(const NumbersByTag& displaced, const std::vector<int>& old);
  void add_own_bound_at_edge();
  void store_tags();
  void apply_new_tags(PairsByTag&);
  PairsByTag gather_pairs(const PairsByTag& mine) const;

  class PairHardSquareWell* pair_ = nullptr;
  std::vector<HardWallSource*> walls_;
  MobileParticles mobile_;

  // Bodies: the own particles, then the remote ones.
  cohesion::hard_sphere::TimeWarp simulation_;
  HardEventTimeWarp time_warp_;
  double** particle_data_ = nullptr;            // per particle, see DataColumn
  double** owners_ = nullptr;                   // per particle and ghost: process, and index on it
  std::vector<std::uint32_t> stored_versions_;  // versions of the flights in particle_data_
  std::vector<char>
      crossed_boundary_;  // whether own particles have a boxes_crossed() that is not zero
  // Bodies whose flights, spins or speed increments the engine has changed in this step
  std::vector<HardEventTimeWarp::ChangedBody> changed_bodies_;
  PairsByTag bound_at_edge_;           // argument of set_up()
  bool reset_in_next_step_ = true;     // whether to reset the simulation time
  double position_tolerance_ = 0.0;    // round-off of positions, [length]
  double time_origin_lifetime_ = 0.0;  // until the next shift of the time origin, [time]
  int steps_since_reset_ = 0;          // steps since the last reset of the simulation time
  // Of own particles since the last neighbour list
  cohesion::shear::NonaffineDisplacements displacements_;
  double farthest_squared_ = 0.0;  // square of the largest of displacements_
  bool needs_ghosts_ = false;      // whether partners have to be among the ghosts of the last list
  bool warned_ = false;
  HardEventTotals totals_;
  std::unique_ptr<HardEventRecord> record_;
};

}  // namespace LAMMPS_NS

#endif
#endif
