// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <system_error>

namespace cohesion::coupling {

/// The folder in which an engine works, which need not be that of the solver. The process is in it
/// during a Visit; where the engine's script changes the folder, the next Visit goes there.
class WorkingFolder {
 public:
  explicit WorkingFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  class Visit {
   public:
    explicit Visit(WorkingFolder& there) : there_(there) {
      std::filesystem::current_path(there.folder_);
    }
    ~Visit() {
      std::error_code ignored;
      there_.folder_ = std::filesystem::current_path(ignored);
      std::filesystem::current_path(home_, ignored);
    }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

   private:
    const std::filesystem::path home_ = std::filesystem::current_path();
    WorkingFolder& there_;
  };

 private:
  std::filesystem::path folder_;
};

}  // namespace cohesion::coupling
