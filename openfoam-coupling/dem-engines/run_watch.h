// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace cohesion::coupling {

/// Reports how far an engine is while it works for long, by a thread of its own.
class RunWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// The steps of the run that is under way; without one, first = last.
  struct Steps {
    long first, at, last;
  };

  struct Times {
    Clock::duration poll;   ///< between two reads of the steps
    Clock::duration first;  ///< until the first report
    Clock::duration every;  ///< between two reports
  };

  /// `steps` and `report` are called by the thread.
  RunWatch(std::function<Steps()> steps, std::function<void(const std::string&)> report,
           const Times& times = {std::chrono::milliseconds(250), std::chrono::seconds(3),
                                 std::chrono::seconds(10)});
  ~RunWatch();
  RunWatch(const RunWatch&) = delete;
  RunWatch& operator=(const RunWatch&) = delete;

 private:
  void watch(const Times& times);

  const std::function<Steps()> steps_;
  const std::function<void(const std::string&)> report_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread thread_;
};

}  // namespace cohesion::coupling
