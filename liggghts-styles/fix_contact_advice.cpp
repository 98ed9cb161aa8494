// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_contact_advice.h"

#include <mpi.h>

#include "contact_advice.h"

namespace LIGGGHTS {
namespace Cohesion {

void FixContactAdvice::ask(const std::shared_ptr<const ContactAdvice>& advice) {
  for (const auto& asked : asked_)
    if (asked.lock() == advice) return;
  asked_.push_back(advice);
}

void FixContactAdvice::setup(int) {
  for (const auto& asked : asked_)
    if (const auto advice = asked.lock()) advice->give();
}

}  // namespace Cohesion
}  // namespace LIGGGHTS
