// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FIX_CONTACT_BOOK_H
#define COHESION_FIX_CONTACT_BOOK_H

#include <memory>

#include "fix.h"
#include "sampled_energy_tally.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Closes the book of the contacts after each step. Hidden (hidden_fix.h); there is one as long as
/// there is a compute gran/energy.
class FixContactBook : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* STYLE = "cohesion_book";

  FixContactBook(LAMMPS_NS::LAMMPS* engine, int count, char** words);

  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override { book_->close_step(false); }
  void post_run() override;

  const std::shared_ptr<ContactBook>& book() const { return book_; }
  /// The book that is kept, null when there is none.
  static std::shared_ptr<ContactBook> book_of(LAMMPS_NS::LAMMPS* lmp);
  /// Set-up goes through the fixes in their order: behind the walls, which make their forces there.
  static void to_the_end(LAMMPS_NS::LAMMPS* lmp);

 private:
  std::shared_ptr<ContactBook> book_;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
