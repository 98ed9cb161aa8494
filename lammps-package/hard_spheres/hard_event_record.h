// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_EVENT_RECORD_H
#define COHESION_HARD_EVENT_RECORD_H

#include <cstdio>
#include <string>

#include "hard_sphere/event_simulation.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// The file with a line for every event that `record FILE` asks for; process 0 writes it.
class HardEventRecord : protected Pointers {
 public:
  /// Empty name: no file.
  HardEventRecord(LAMMPS*, const std::string& file);
  ~HardEventRecord();
  HardEventRecord(const HardEventRecord&) = delete;
  HardEventRecord& operator=(const HardEventRecord&) = delete;

  /// Collective: the events of a step of all processes, in order.
  void write(const cohesion::hard_sphere::EventSimulation&);

 private:
  bool enabled_;
  FILE* file_;
};

}  // namespace LAMMPS_NS

#endif
