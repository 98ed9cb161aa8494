// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_COHESIVE_PAIRS_H
#define COHESION_COHESIVE_PAIRS_H

#include <string>

#include "common/bound_pairs.h"
#include "contact_interface.h"

namespace LAMMPS_NS {
class LAMMPS;
class PairGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace Cohesion {

/// Notes a cohesion model of this package that is registered.
void note_cohesion_model(const std::string& name);
/// The names of those, with commas.
std::string cohesion_models();
bool is_cohesion_model(const std::string& name);

/// Whether pair_style gran has a cohesion model of this package with scheme exact.
bool pairs_are_exact(LAMMPS_NS::LAMMPS* lmp);

/// Pairs of pair_style gran, of which a cohesion says which it binds. The engine keeps its models
/// out of reach; so each makes itself known by the pair style, or the fix of a wall, that it is a
/// part of.
class CohesivePairs : public LAMMPS_NS::BoundPairs {
 public:
  /// owner: what the engine gives a model of contacts; of a wall's this is an empty set.
  CohesivePairs(LAMMPS_NS::LAMMPS* lmp, IContactHistorySetup* owner, bool wall);
  CohesivePairs(const CohesivePairs&) = delete;
  CohesivePairs& operator=(const CohesivePairs&) = delete;

  /// Of a pair style or a fix wall/gran; null: it has no cohesion of this package.
  static const CohesivePairs* of(const IContactHistorySetup* owner);

  /// Whether their scheme is exact.
  virtual bool is_exact() const = 0;

  void append_bound(std::vector<std::array<int, 2> >& pairs) const override;

 protected:
  ~CohesivePairs();

  /// Whether two particles of these types and radii with this gap [length] are bound; rj 0: beside
  /// a wall; history: what the engine remembers of their contact, null where no model asks it to.
  virtual bool binds(int itype, int jtype, double ri, double rj, double gap,
                     const double* history) const = 0;

 private:
  LAMMPS_NS::LAMMPS* lmp_;
  const IContactHistorySetup* owner_;
  LAMMPS_NS::PairGran* pair_;  // null for walls
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
