// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FIX_PARTNER_IDS_H
#define COHESION_FIX_PARTNER_IDS_H

#include <vector>

#include "fix.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Keeps the contacts of particles that `delete_atoms` renumbers. The engine stores the partners of
/// a contact by their IDs and leaves these as they were. Hidden (hidden_fix.h).
class FixPartnerIds : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* STYLE = "cohesion_partner_ids";

  FixPartnerIds(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  ~FixPartnerIds() override;

  int setmask() override;
  void init() override;
  void setup(int) override;
  void pre_neighbor() override;

  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  double memory_usage() override;

 private:
  bool has_run_ = false;
  std::vector<int> ids_;  // of the particles in the last run; 0: it is new
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
