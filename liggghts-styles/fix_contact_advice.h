// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FIX_CONTACT_ADVICE_H
#define COHESION_FIX_CONTACT_ADVICE_H

#include <memory>
#include <vector>

#include "fix.h"

namespace LIGGGHTS {
namespace Cohesion {

class ContactAdvice;

/// Lets the contact models of pairs and walls say what to expect of a run, before its first step.
/// Hidden (hidden_fix.h). Costs no step anything.
class FixContactAdvice : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* STYLE = "cohesion_advice";

  FixContactAdvice(LAMMPS_NS::LAMMPS* engine, int count, char** words)
      : Fix(engine, count, words) {}

  int setmask() override { return 0; }
  void setup(int) override;

  /// One that is gone is asked no more.
  void ask(const std::shared_ptr<const ContactAdvice>&);

 private:
  std::vector<std::weak_ptr<const ContactAdvice>> asked_;
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
