// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdio>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "dem_engine.h"

namespace cohesion::coupling {

/// The screen that an engine prints on. Its errors and warnings are passed on when they are
/// printed, also those of an engine that ends the process with them, and each text once. The rest
/// is in the engine's log.
class EngineScreen {
 public:
  using OnMessage = std::function<void(MessageLevel, const std::string&)>;

  explicit EngineScreen(OnMessage on_message);

  /// The screen, for the engine to print on and to close.
  FILE* stream() { return stream_; }

  bool has_shown_error() const { return has_shown_error_; }

  /// While this lives the screen is the standard output, which an engine takes for its screen on
  /// all ranks; a file that it is given by name it would take on the first rank alone.
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
  void read(std::string_view printed);
  void warn(const std::string& text);

  const OnMessage on_message_;
  FILE* stream_;
  std::set<std::string> warnings_;
  bool has_shown_error_ = false;
};

}  // namespace cohesion::coupling
