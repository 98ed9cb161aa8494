// SPDX-License-Identifier: GPL-2.0-only
#include "hard_event_agreement.h"

#include <algorithm>

#include "atom.h"
#include "error.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;

// Events of a stretch per particle. How often a stretch is repeated goes with the length of the
// chains of events that cross from one process to another and back: two to three times here.
static constexpr double EVENTS_OF_A_STRETCH = 0.25;

HardEventAgreement::HardEventAgreement(LAMMPS* lammps, EventSimulation& simulation)
    : Pointers(lammps), simulation_(simulation), border_(world), own_(0) {}

void HardEventAgreement::plan(const std::vector<BorderExchange::Request>& followed) {
  own_ = atom->nlocal;
  owners_.clear();
  for (const BorderExchange::Request& request : followed) owners_.push_back(request.owner);
  border_.plan(followed, own_);
}

void HardEventAgreement::load_borders() {
  std::vector<std::vector<Flight> > out(border_.peers().size());
  std::vector<std::vector<Flight> > in;
  for (int p = 0; p < static_cast<int>(out.size()); p++)
    for (const int i : border_.told(p)) out[p].push_back(simulation_.bodies[i].flight);
  border_.swap(out, in);
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (int slot = 0; slot < static_cast<int>(in[p].size()); slot++)
      simulation_.bodies[border_.local(p, slot)].flight = in[p][slot];
}

void HardEventAgreement::follow(long expected_events) {
  const double dt = update->dt;
  for (int n = 0; n < static_cast<int>(simulation_.candidates.size()); n++)
    if (shared(simulation_.candidates[n])) simulation_.predict(n);
  simulation_.sort();
  const double of_a_stretch = EVENTS_OF_A_STRETCH * static_cast<double>(atom->natoms);
  const int stretches = 1 + static_cast<int>(static_cast<double>(expected_events) / of_a_stretch);
  for (int n = 1; n <= stretches && simulation_.overrun() < 0; n++)
    follow_stretch(n == stretches ? dt : n * dt / stretches);
}

/// Until all agree on what each has told the others.
void HardEventAgreement::follow_stretch(double until) {
  simulation_.begin_stretch();
  simulation_.run(until);
  double from = 0.0;
  for (int round = 0;; round++) {
    const std::vector<News> told = exchange_news(from);
    const double differs = simulation_.first_difference(from, told);
    MPI_Allreduce(&differs, &from, 1, MPI_DOUBLE, MPI_MIN, world);
    if (from == never) break;
    if (round > simulation_.rules.limit)
      error->all(FLERR,
                 "pair_style hard/square_well: in step {} the processes do not agree on the events "
                 "after {} exchanges: particles are pressed together. Use a smaller time step or "
                 "keyword contact_time",
                 update->ntimestep, round);
    if (differs < never) simulation_.run_again(differs, told, until);
  }
}

/// What happened to this process's particles without those that a peer owns, to all who follow
/// them.
std::vector<News> HardEventAgreement::exchange_news(double from) {
  std::vector<std::vector<News> > out(border_.peers().size()), in;
  for (const News& news : simulation_.news) {
    if (news.body >= own_ || news.key.time < from) continue;
    const int owner = news.partner >= own_ ? owners_[news.partner - own_] : -1;
    for (const BorderExchange::Follower& follower : border_.followers(news.body)) {
      if (border_.peers()[follower.peer] == owner) continue;
      out[follower.peer].push_back(news);
      out[follower.peer].back().body = follower.slot;
    }
  }
  border_.swap(out, in);
  std::vector<News> all;
  for (int p = 0; p < static_cast<int>(in.size()); p++)
    for (News news : in[p]) {
      news.body = border_.local(p, news.body);
      all.push_back(news);
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const News& a, const News& b) { return a.key < b.key; });
  return all;
}
