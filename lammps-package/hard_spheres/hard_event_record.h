// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_HARD_EVENT_RECORD_H
#define COHESION_HARD_EVENT_RECORD_H

#include <cstdio>
#include <string>

#include "hard_sphere/event_simulation.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// The file of keyword `record FILE` with one line per event. Process 0 writes it.
class HardEventRecord : protected Pointers {
 public:
  /// An empty name disables the file.
  HardEventRecord(LAMMPS*, const std::string& file);
  ~HardEventRecord();
  HardEventRecord(const HardEventRecord&) = delete;
  HardEventRecord& operator=(const HardEventRecord&) = delete;

  /// Collective: writes the events of a step of all processes, sorted.
  void write(const cohesion::hard_sphere::EventSimulation&);

 private:
  bool enabled_;
  FILE* file_;
};

}  // namespace LAMMPS_NS

#endif
