// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_FIX_CONTACT_ADVICE_H
#define COHESION_FIX_CONTACT_ADVICE_H

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fix.h"
#include "integrated_particles.h"
#include "model_advice.h"

namespace LIGGGHTS {
namespace Cohesion {

/// What a step may find wrong, on any rank and in any of the models that share it.
struct LateWarning {
  std::string text;
  std::string first;   ///< where it was found first on this rank, behind the text
  bool due = false;    ///< on this rank
  bool given = false;  ///< on all

  void found(const std::string& where) {
    if (!due) first = where;
    due = true;
  }
};

/// Lets the contact models of pairs and walls say what to expect of a run before its first step and
/// where that becomes worse, and once what went wrong in a step: when lists are made next, or when
/// the run ends. Hidden (hidden_fix.h).
class FixContactAdvice : public LAMMPS_NS::Fix {
 public:
  static constexpr const char* STYLE = "cohesion_advice";

  FixContactAdvice(LAMMPS_NS::LAMMPS* engine, int count, char** words)
      : Fix(engine, count, words), changes_(engine) {}

  int setmask() override;
  void setup_pre_force(int) override;
  void setup(int) override {
    advise_if_due(true);
    warn_of_unlike_walls();
    warn_of_spins();
    post_force(0);
  }
  void pre_force(int) override { advise_if_due(false); }
  void post_force(int) override;
  void pre_exchange() override;
  void post_run() override { pre_exchange(); }

  /// One that is gone is asked no more.
  void ask(const std::shared_ptr<ContactAdvice>&);

  /// The one of this text. To be asked for on all ranks.
  std::shared_ptr<LateWarning> late_warning(const std::string& text);

 private:
  void advise_if_due(bool setup);
  void warn_of_spins();
  void warn_of_unmoved();
  void warn_of_unlike_walls();

  LiggghtsWatch changes_;
  std::vector<std::weak_ptr<ContactAdvice>> asked_;
  std::map<std::string, std::shared_ptr<cohesion::advice::WarningFilter>> printed_;  // by its name
  std::vector<std::shared_ptr<LateWarning>> late_;
  std::optional<IntegratedParticles> held_;  // as the run began
  bool warned_of_unturned_ = false, warned_of_held_ = false, warned_of_partly_held_ = false;
  bool warned_of_unmoved_ = false;
  std::set<std::string> warned_of_walls_;  // the last warning of each
};

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
