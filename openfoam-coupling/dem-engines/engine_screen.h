// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "dem_engine.h"

namespace cohesion::coupling {

/// What an engine prints on its screen. Of that its errors and warnings are handed on when they are
/// printed, also those of an engine that ends the process with them, and each text once. The rest
/// is in the engine's log.
class EngineScreen {
 public:
  using Tell = std::function<void(Said, const std::string&)>;

  explicit EngineScreen(Tell tell);

  /// The screen, for the engine to print on and to close.
  FILE* stream() { return stream_; }

  bool has_shown_error() const { return has_shown_error_; }

  /// While this lives the screen is the standard output, which an engine takes for its screen on
  /// all ranks; of a file that it is given the name of it would do so on the first rank alone.
  class AsStandardOutput {
   public:
    explicit AsStandardOutput(EngineScreen& screen) { stdout = screen.stream(); }
    ~AsStandardOutput() { stdout = kept_; }
    AsStandardOutput(const AsStandardOutput&) = delete;
    AsStandardOutput& operator=(const AsStandardOutput&) = delete;

   private:
    FILE* const kept_ = stdout;
  };

 private:
  void take(std::string_view printed);
  void warn(const std::string& text);

  const Tell tell_;
  FILE* stream_;
  std::set<std::string> warnings_;
  bool has_shown_error_ = false;
};

}  // namespace cohesion::coupling
