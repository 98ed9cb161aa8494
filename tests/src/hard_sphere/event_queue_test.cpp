// SPDX-License-Identifier: BSD-3-Clause
#include "hard_sphere/event_queue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace {

using cohesion::hard_sphere::EventQueue;
using cohesion::hard_sphere::QueuedEvent;

constexpr double never = std::numeric_limits<double>::infinity();

/// A queue and the sorted map that is its reference. Unique ranks resolve ties.
class ComparedQueue {
 public:
  explicit ComparedQueue(int bodies) : entries_(bodies) {
    queue_.reset(static_cast<std::size_t>(bodies));
    for (int n = 0; n < bodies; n++) entries_[n] = reference_.end();
  }

  void set(int body, double time, bool behind_all) {
    const int rank = behind_all ? next_rank_ : -next_rank_;
    next_rank_++;
    if (entries_[body] != reference_.end()) reference_.erase(entries_[body]);
    entries_[body] = reference_.insert({{time, rank}, body});
    QueuedEvent event;
    event.time = time;
    event.body = body;
    event.depth = rank;
    queue_.replace(
        event,
        [](const QueuedEvent& x, const QueuedEvent& y) {
          EXPECT_EQ(x.time, y.time);
          EXPECT_NE(x.body, y.body);
          return x.depth < y.depth;
        },
        [this](int leader, std::size_t subtrees) {
          if (subtrees == 1) leader_ = leader;
        });
  }

  double time_of(int body) const {
    return entries_[body] == reference_.end() ? never : entries_[body]->first.first;
  }

  /// The first body; -1: none.
  int next() const { return is_empty() ? -1 : reference_.begin()->second; }

  void check() {
    const auto event = queue_.next();
    if (is_empty()) {
      ASSERT_EQ(event.time, never);
      return;
    }
    ASSERT_EQ(event.time, reference_.begin()->first.first);
    ASSERT_EQ(event.body, reference_.begin()->second);
    // A queue of one body has no subtrees.
    if (entries_.size() > 1) {
      ASSERT_EQ(leader_, event.body);
    }
  }

 private:
  bool is_empty() const { return reference_.empty() || reference_.begin()->first.first == never; }

  EventQueue queue_;
  int leader_ = -1;  // body that last became the first of all
  int next_rank_ = 1;
  std::multimap<std::pair<double, int>, int> reference_;
  std::vector<std::multimap<std::pair<double, int>, int>::iterator> entries_;
};

TEST(EventQueue, IsEmptyAfterReset) {
  EXPECT_EQ(EventQueue{}.next().time, never);
  for (const int bodies : {0, 1, 2, 3, 1000}) ComparedQueue(bodies).check();
}

// Few different times, so that most events are tied. The rank of a body changes with its time, and
// sometimes without it. A body without an event is never first.
TEST(EventQueue, NextIsTheFirstOfASortedMap) {
  std::mt19937 random(7);
  for (const int bodies : {1, 2, 3, 4, 5, 7, 8, 9, 31, 100})
    for (int again = 0; again < 3; again++) {
      ComparedQueue queue(bodies);
      for (int n = 0; n < 2000; n++) {
        const int body = static_cast<int>(random() % bodies);
        double time = static_cast<double>(random() % 6);
        if (random() % 20 == 0) time = never;
        if (random() % 4 == 0) time = queue.time_of(body);
        queue.set(body, time, random() % 2);
        queue.check();
        if (HasFatalFailure()) return;
      }
    }
}

// As in a simulation: the first body gets a later time, and so do some others. Intervals of all
// magnitudes, with ties.
TEST(EventQueue, OrderIsRightAsTimeAdvances) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const double now : {0.0, 1e3, -7.0})
    for (const bool tied : {false, true}) {
      const int bodies = 200;
      ComparedQueue queue(bodies);
      const auto wait = [&] {
        const double size = std::exp2(std::floor(8.0 * normal(random)));
        return tied ? size * static_cast<double>(random() % 3)
                    : size * std::abs(normal(random)) + 1e-9;
      };
      for (int body = 0; body < bodies; body++) queue.set(body, now + wait(), true);
      for (int n = 0; n < 5000; n++) {
        const int first = queue.next();
        ASSERT_GE(first, 0);
        const double time = queue.time_of(first);
        queue.set(first, time + wait(), random() % 2);
        for (int k = 0; k < 2; k++)
          queue.set(static_cast<int>(random() % bodies), time + wait(), random() % 2);
        queue.check();
        if (HasFatalFailure()) return;
      }
    }
}

// A body that becomes the first of a half, a quarter and so on is reported once for each of these
// subtrees, in the order of their sizes.
TEST(EventQueue, ReportsNewLeadersOfSubtrees) {
  EventQueue queue;
  queue.reset(8);
  std::vector<std::pair<int, std::size_t> > leads;
  const auto set = [&](int body, double time) {
    leads.clear();
    QueuedEvent event;
    event.time = time;
    event.body = body;
    queue.replace(
        event, [](const QueuedEvent&, const QueuedEvent&) { return false; },
        [&](int leader, std::size_t subtrees) { leads.emplace_back(leader, subtrees); });
    return leads;
  };
  using Leads = std::vector<std::pair<int, std::size_t> >;
  EXPECT_EQ(set(0, 3.0), (Leads{{0, 4}, {0, 2}, {0, 1}}));
  EXPECT_EQ(set(2, 4.0), (Leads{{2, 4}}));
  EXPECT_EQ(set(7, 1.0), (Leads{{7, 4}, {7, 2}, {7, 1}}));
  // Still first, and so is no other body of its half: no report. After 0 and 2, the first of all is
  // 0.
  EXPECT_EQ(set(7, 2.0), Leads{});
  EXPECT_EQ(set(7, 5.0), (Leads{{0, 1}}));
  EXPECT_EQ(set(0, 6.0), (Leads{{2, 2}, {2, 1}}));
}

// Repeated predictions do not increase the memory.
TEST(EventQueue, MemoryIsAFewTimesItsEvents) {
  EventQueue queue;
  const int bodies = 1000;
  queue.reset(bodies);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform;
  for (int step = 0; step < 1000; step++)
    for (int body = 0; body < bodies; body++) {
      QueuedEvent event;
      event.time = 0.01 * step + 10.0 * uniform(random);
      event.body = body;
      queue.replace(
          event, [](const QueuedEvent&, const QueuedEvent&) { return false; },
          [](int, std::size_t) {});
    }
  EXPECT_LT(queue.bytes(), 5.0 * sizeof(QueuedEvent) * bodies);
}

}  // namespace
