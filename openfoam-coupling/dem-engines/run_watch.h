// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace cohesion::coupling {

/// Says how far an engine is while it works for long, by a thread of its own.
class RunWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// Of the run that is under way; without one, first = last.
  struct Steps {
    long first, at, last;
  };

  struct Times {
    Clock::duration look;   ///< between two looks at the steps
    Clock::duration first;  ///< after which it is first said
    Clock::duration every;  ///< between one time and the next
  };

  /// `look` and `say` are called by the thread.
  RunWatch(std::function<Steps()> look, std::function<void(const std::string&)> say,
           const Times& times = {std::chrono::milliseconds(250), std::chrono::seconds(3),
                                 std::chrono::seconds(10)});
  ~RunWatch();
  RunWatch(const RunWatch&) = delete;
  RunWatch& operator=(const RunWatch&) = delete;

 private:
  void watch(const Times& times);

  const std::function<Steps()> look_;
  const std::function<void(const std::string&)> say_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread thread_;
};

}  // namespace cohesion::coupling
