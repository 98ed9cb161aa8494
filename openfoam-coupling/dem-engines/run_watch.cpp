// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_watch.h"

#include <sstream>
#include <utility>

namespace cohesion::coupling {

namespace {

using Clock = RunWatch::Clock;

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

/// A run since it was first seen: its speed is that of the steps since then.
struct SeenRun {
  RunWatch::Steps start;
  Clock::time_point since;

  bool is(const RunWatch::Steps& steps) const {
    return steps.first == start.first && steps.last == start.last && steps.at >= start.at;
  }

  std::string progress(const RunWatch::Steps& steps, Clock::time_point time) const {
    if (steps.last <= steps.first) return "no run under way";
    std::ostringstream text;
    text.precision(3);
    text << "step " << steps.at - steps.first << " of " << steps.last - steps.first << " of a run";
    if (const long done = steps.at - start.at; done > 0)
      text << ", about "
           << seconds(time - since) * static_cast<double>(steps.last - steps.at) / done
           << " s left of it";
    return text.str();
  }
};

}  // namespace

RunWatch::RunWatch(std::function<Steps()> steps, std::function<void(const std::string&)> report,
                   const Times& times)
    : steps_(std::move(steps)),
      report_(std::move(report)),
      thread_([this, times] { watch(times); }) {}

RunWatch::~RunWatch() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void RunWatch::watch(const Times& times) {
  const auto begin = Clock::now();
  auto next = begin + times.first;
  SeenRun run{steps_(), begin};
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, times.poll, [this] { return end_; })) {
    const Steps steps = steps_();
    const auto now = Clock::now();
    if (!run.is(steps)) run = {steps, now};
    if (now < next) continue;
    std::ostringstream text;
    text.precision(3);
    text << seconds(now - begin) << " s, " << run.progress(steps, now);
    report_(text.str());
    next = now + times.every;
  }
}

}  // namespace cohesion::coupling
