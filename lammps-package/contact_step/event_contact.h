// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_EVENT_CONTACT_H
#define COHESION_EVENT_CONTACT_H

#include <algorithm>
#include <vector>

#include "contact_scatter.h"
#include "prefetch.h"

// What pairs and walls of the event scheme share: which of their contacts last and which are
// followed, and predictor and corrector of those.

namespace LAMMPS_NS {

/// Changes the relative motion of i and j, and their spins, by `of_i` and `of_j`: three numbers of
/// velocity and three of spin; of_j nullptr: a wall.
inline void change(cohesion::event_stepping::PairMotion& motion, const double* of_i,
                   const double* of_j) {
  motion.relative.velocity -= vector(of_i);
  motion.spin_i += vector(of_i + 3);
  if (!of_j) return;
  motion.relative.velocity += vector(of_j);
  motion.spin_j += vector(of_j + 3);
}

/// What all contacts but one do to its particles: `all_i` and `all_j` less its `own` change. all_j
/// nullptr: a wall.
inline cohesion::event_stepping::PairMotion change_by_others(
    const double* all_i, const double* all_j, const cohesion::event_stepping::PairMotion& own) {
  const auto of_j = [&](int k) { return all_j ? vector(all_j + k) : cohesion::Vector3{}; };
  cohesion::event_stepping::PairMotion others;
  others.relative = {of_j(0) - vector(all_i) - own.relative.separation,
                     of_j(3) - vector(all_i + 3) - own.relative.velocity};
  others.spin_i = vector(all_i + 6) - own.spin_i;
  others.spin_j = of_j(6) - own.spin_j;
  return others;
}

/// A list of things that is made anew in each step and keeps its memory.
template <class Thing>
class OfStep {
 public:
  OfStep() = default;
  OfStep(const OfStep&) = delete;
  OfStep& operator=(const OfStep&) = delete;

  void clear() { end_ = things_.data(); }
  /// Room for one more, which still holds what another step put there.
  [[gnu::always_inline]] Thing& add() {
    if (end_ == full_) grow();
    return *end_++;
  }
  const Thing& operator[](std::size_t k) const { return things_[k]; }
  const Thing* begin() const { return things_.data(); }
  const Thing* end() const { return end_; }
  Thing* begin() { return things_.data(); }
  Thing* end() { return end_; }

 private:
  [[gnu::noinline]] void grow() {
    const std::size_t count = things_.size();
    things_.resize(2 * count + 64);
    end_ = things_.data() + count;
    full_ = things_.data() + things_.size();
  }

  std::vector<Thing> things_;
  Thing* end_ = nullptr;
  Thing* full_ = nullptr;
};

/// A contact that acts by one force.
struct LastingContact {
  int i, j;  // j < 0: a wall
  int contact;
  double* history;
};

/// A contact that begins to act by one force: in that step its springs in the plane of contact have
/// another impulse than lasting_action() gives, and what it owes is what the followed step left.
struct BegunContact {
  LastingContact contact;
  cohesion::event_stepping::ContactMemory before;
  cohesion::event_stepping::Action action;
};

/// A contact that is followed.
struct FollowedContact {
  int i, j;  // j < 0: a wall
  int contact;
  double* history;
  bool in_range;
  cohesion::event_stepping::FollowedStart start;
  cohesion::event_stepping::PairMotion change;  // by itself, as predicted
  cohesion::event_stepping::PairSpins rolled;   // the same
};

/// Contacts of one style in one step. `on_impulse(j, grid, impulse, by_contact, factor)` is called
/// with what each of them does, with factor -1 where it is undone; by_contact() is the part of
/// spring, dashpot and friction. `grid_of(contact)`: the motion of a LastingContact on the grid.
struct StepContacts {
  std::vector<LastingContact> candidates;  // can last from now on
  std::vector<LastingContact> young;       // the same, if they are alone
  OfStep<LastingContact> lasting;          // act, but those that are undone
  std::vector<BegunContact> begun;
  std::vector<LastingContact> idle;  // in their wells, where nothing acts
  OfStep<LastingContact> far;        // out of range, unless others bring them together
  OfStep<FollowedContact> followed;

  void clear() {
    candidates.clear();
    young.clear();
    lasting.clear();
    begun.clear();
    idle.clear();
    far.clear();
    followed.clear();
  }

  /// Decides from its motion on the grid whether a contact lasts, and acts, or is followed, which
  /// disturbs both particles. `alone`: whether a young one can be.
  template <int SIZE, class Contact, class OnImpulse>
  [[gnu::noinline]] void classify(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
                                  const Contact& c, int contact, int i, int j,
                                  const cohesion::event_stepping::PairMotion& grid, double* history,
                                  bool alone, const OnImpulse& on_impulse) {
    using namespace cohesion::event_stepping;
    ContactMemory memory = ContactMemory::from(history, SIZE);
    const bool lasted = memory.phase == ContactMemory::lasting;
    if (c.is_idle(grid.relative, memory, step->flight())) {
      idle.push_back({i, j, contact, history});
    } else if (!lasted && c.can_last(grid.relative, memory, alone)) {
      const bool may_be_alone = alone && c.is_young(memory);
      if (may_be_alone) step->add_young(i, j, c.minds_others());
      (may_be_alone ? young : candidates).push_back({i, j, contact, history});
    } else if (memory.phase == ContactMemory::beyond && !c.within_reach(grid.relative, 0.0)) {
      far.add() = {i, j, contact, history};
    } else if (!lasted || !advance_lasting<SIZE>(scatter, step, c, {i, j, contact, history}, grid,
                                                 memory, on_impulse)) {
      // What only the fastest particle of this rank could bring to an edge disturbs nothing.
      if (!c.is_idle(grid.relative, memory, 0.0)) step->disturb(i, j);
      add_followed<SIZE>(scatter, step, c, {i, j, contact, history}, grid, memory);
    }
    if (step->energy_tally.is_active()) {
      step->energy_tally.store(scatter.owned_fraction(j), c.stored(grid, memory));
      const ContactMemory now = c.one_force().template at_grid_point<SIZE>(grid, memory);
      scatter.add_owed_of_tally(i, j, c, c.template owed<SIZE>(grid.relative, now));
    }
  }

  /// A young contact that is not alone crowds, or disturbs, the particle that it shares.
  void find_beside_young(FixEventStep* step) const {
    for (const LastingContact& p : lasting) step->add_beside_young(p.i, p.j);
    for (const LastingContact& p : candidates) step->add_beside_young(p.i, p.j);
  }

  /// Contacts of disturbed particles are followed, too, if they mind others: one force among such
  /// drains energy. Other candidates last from now on.
  template <int SIZE, class Contact, class GridOf, class OnImpulse>
  void follow_disturbed(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
                        const std::vector<Contact>& all, const GridOf& grid_of,
                        const OnImpulse& on_impulse) {
    using namespace cohesion::event_stepping;
    const auto is_disturbed = [&](const LastingContact& p) {
      return step->is_disturbed(p.i, p.j) && all[p.contact].minds_others();
    };
    const auto minds = [](const Contact& c) { return c.minds_others(); };
    if (step->any_disturbed() && std::any_of(all.begin(), all.end(), minds))
      for (const LastingContact& p : lasting)
        if (is_disturbed(p))
          undo_lasting<SIZE>(scatter, step, all[p.contact], p, grid_of(p), on_impulse);
    for (const auto* some : {&candidates, &young})
      for (const LastingContact& p : *some) {
        const Contact& c = all[p.contact];
        ContactMemory memory = ContactMemory::from(p.history, SIZE);
        const PairMotion grid = grid_of(p);
        const bool alone = some == &young && !step->is_crowded(p.i, p.j);
        if (is_disturbed(p))
          add_followed<SIZE>(scatter, step, c, p, grid, memory);
        else
          advance_lasting<SIZE>(scatter, step, c, p, grid, memory, on_impulse, alone);
      }
  }

  /// Pairs out of range are followed where others may bring them together; else they go on as they
  /// do by themselves. What others do to a ghost only its own rank knows.
  template <int SIZE, class Contact, class GridOf>
  void follow_far(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
                  const std::vector<Contact>& all, const GridOf& grid_of) {
    LastingContact* const end =
        std::remove_if(far.begin(), far.end(), [&](const LastingContact& p) {
          if (scatter.is_ghost(p.j)) return false;
          const double stray = step->strays(p.i) + (p.j < 0 ? 0.0 : step->strays(p.j));
          return !all[p.contact].within_reach(grid_of(p).relative, stray);
        });
    for (const LastingContact* p = far.begin(); p != end; p++)
      add_followed<SIZE>(scatter, step, all[p->contact], *p, grid_of(*p),
                         ContactMemory::as_stored(p->history, SIZE));
  }

  /// Adds what lasting contacts owe, and do, to particles that have a followed one.
  template <int SIZE, class Contact, class GridOf>
  void couple_lasting(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
                      const std::vector<Contact>& all, const GridOf& grid_of) const {
    using namespace cohesion::event_stepping;
    if (!step->any_followed()) return;
    const auto beside = [step](const LastingContact& p) {
      return step->is_followed(p.i) || (p.j >= 0 && step->is_followed(p.j));
    };
    for_each_lasting<SIZE>(
        all, grid_of, beside,
        [&](const LastingContact& p, const ContactMemory& before, const ContactMemory& memory,
            const PairMotion& grid, const auto& action) {
          const bool i = step->is_followed(p.i), j = p.j >= 0 && step->is_followed(p.j);
          const Contact& c = all[p.contact];
          const Action owed = c.template owed<SIZE>(grid.relative, before);
          const PairMotion does = c.template lasting_change<SIZE>(grid, action(), owed, memory);
          if (i) {
            step->count_contact(p.i);
            scatter.change_i(step->owed(p.i), c, owed);
            scatter.add_predicted_i(p.i, c, does);
          }
          if (j) {
            step->count_contact(p.j);
            scatter.change_j(step->owed(p.j), c, owed);
            scatter.add_predicted_j(p.j, c, does);
          }
        });
  }

  /// Calls what(contact, before, memory, grid, action) for the contacts that act by one force and
  /// are `wanted`; before: what tells what they owe; action(): what they do.
  template <int SIZE, class Contact, class GridOf, class Wanted, class What>
  void for_each_lasting(const std::vector<Contact>& all, const GridOf& grid_of,
                        const Wanted& wanted, const What& what) const {
    using namespace cohesion::event_stepping;
    for (const LastingContact& p : lasting) {
      if (!wanted(p)) continue;
      const ContactMemory memory = ContactMemory::as_stored(p.history, SIZE);
      if (memory.phase != ContactMemory::lasting) continue;
      const PairMotion grid = grid_of(p);
      what(p, memory, memory, grid,
           [&] { return all[p.contact].one_force().template lasting_action<SIZE>(grid, memory); });
    }
    for (const BegunContact& b : begun)
      if (wanted(b.contact))
        what(b.contact, b.before, ContactMemory::as_stored(b.contact.history, SIZE),
             grid_of(b.contact), [&] { return b.action; });
  }

  /// The predictor: every followed contact by itself.
  template <int SIZE, class Contact>
  void predict(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
               const std::vector<Contact>& all) {
    for (FollowedContact& p : followed) {
      LAMMPS_NS::change(p.start.truth, step->owed(p.i), p.j >= 0 ? step->owed(p.j) : nullptr);
      const bool only = SIZE < HistorySize::with_rolling && step->has_one_contact(p.i) &&
                        (p.j < 0 || step->has_one_contact(p.j));
      if (only) continue;
      const Contact& c = all[p.contact];
      if (p.in_range && c.template predict_lasting<SIZE>(p.start, p.change)) {
        scatter.add_predicted(p.i, p.j, c, p.change);
        continue;
      }
      const auto f = c.template follow<SIZE>(p.start, {}, {}, p.in_range);
      if (!f.normal.interacts) continue;
      p.change = f.change;
      if constexpr (SIZE >= HistorySize::with_rolling) p.rolled = f.rolled();
      scatter.add_predicted(p.i, p.j, c, f.change);
    }
  }

  /// The corrector: every followed contact with half of what the others do before it and half
  /// after.
  template <int SIZE, class Contact, class OnImpulse>
  void correct(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
               const std::vector<Contact>& all, const OnImpulse& on_impulse) {
    using namespace cohesion::event_stepping;
    const auto fetch = [&](const FollowedContact& p) {
      cohesion::prefetch_numbers(p.history, SIZE);
      scatter.fetch(p.i, p.j);
    };
    for_each_followed(fetch, [&](FollowedContact& p) {
      const Contact& c = all[p.contact];
      const PairMotion others = change_by_others(
          step->predicted(p.i), p.j >= 0 ? step->predicted(p.j) : nullptr, p.change);
      ContactMemory memory = ContactMemory::as_stored(p.history, SIZE);
      const FollowedStep<SIZE> f = c.template follow<SIZE>(p.start, others, p.rolled, p.in_range);
      const Action action = c.template finish<SIZE>(p.start, others, f, memory);
      memory.to(p.history, SIZE);
      scatter.apply(p.i, p.j, action);
      if (memory.had_event())
        scatter.note_sudden(p.i, p.j, c, p.start.truth.relative.separation, action.impulse);
      const double fraction = scatter.owned_fraction(p.j);
      if (f.normal.normal.unresolved) step->count_unresolved(fraction);
      step->energy_tally.add_losses(fraction, Contact::template losses<SIZE>(f), 1.0);
      on_impulse(
          p.j, p.start.truth, action.impulse,
          [&] { return c.by_contact(p.start, f.normal, action); }, 1.0);
    });
  }

 private:
  using ContactMemory = cohesion::event_stepping::ContactMemory;
  using PairMotion = cohesion::event_stepping::PairMotion;

  /// Calls what(contact) for all that are followed, and fetch(contact) some contacts before.
  template <class Fetch, class What>
  [[gnu::always_inline]] void for_each_followed(const Fetch& fetch, const What& what) {
    constexpr int before = 6;
    FollowedContact* const end = followed.end();
    for (FollowedContact* p = followed.begin(); p != end; p++) {
      if (end - p > before) fetch(p[before]);
      what(*p);
    }
  }
  template <int SIZE, class Contact, class OnImpulse>
  bool advance_lasting(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
                       const Contact& c, const LastingContact& p, const PairMotion& grid,
                       ContactMemory& memory, const OnImpulse& on_impulse, bool alone = true) {
    using namespace cohesion::event_stepping;
    const bool lasted = memory.phase == ContactMemory::lasting;
    const ContactMemory before = memory;
    Action action;
    ContactLosses lost;
    ContactLosses* const losses = step->energy_tally.is_active() ? &lost : nullptr;
    const bool lasts =
        c.one_force().template advance_lasting<SIZE>(grid, memory, action, losses, alone);
    if (!lasts) c.one_force().template end_lasting<SIZE>(grid, memory, losses);
    memory.to(p.history, SIZE);
    step->energy_tally.add_losses(scatter.owned_fraction(p.j), lost, 0.0);
    if (!lasts) return false;
    if (lasted)
      lasting.add() = p;
    else
      begun.push_back({p, before, action});
    scatter.apply(p.i, p.j, action);
    on_impulse(p.j, grid, action.impulse, [&] { return c.by_contact(grid, action); }, 1.0);
    return true;
  }

  template <int SIZE, class Contact, class OnImpulse>
  void undo_lasting(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
                    const Contact& c, const LastingContact& p, const PairMotion& grid,
                    const OnImpulse& on_impulse) {
    using namespace cohesion::event_stepping;
    ContactMemory memory = ContactMemory::as_stored(p.history, SIZE);
    const Action action = c.one_force().template lasting_action<SIZE>(grid, memory);
    scatter.apply_reversed(p.i, p.j, action);
    on_impulse(p.j, grid, action.impulse, [&] { return c.by_contact(grid, action); }, -1.0);
    ContactLosses lost;
    c.one_force().template end_lasting<SIZE>(grid, memory,
                                             step->energy_tally.is_active() ? &lost : nullptr);
    step->energy_tally.add_losses(scatter.owned_fraction(p.j), lost, 0.0);
    add_followed<SIZE>(scatter, step, c, p, grid, memory);
  }

  template <int SIZE, class Contact>
  void add_followed(const ContactsOfStep<Contact, SIZE>& scatter, FixEventStep* step,
                    const Contact& c, const LastingContact& p, const PairMotion& grid,
                    const ContactMemory& memory) {
    FollowedContact& now = followed.add();
    now.i = p.i;
    now.j = p.j;
    now.contact = p.contact;
    now.history = p.history;
    now.in_range = memory.in_range();
    now.start = c.template start<SIZE>(grid, grid, memory);
    now.change = {};
    if constexpr (SIZE >= HistorySize::with_rolling) now.rolled = {};
    memory.to(p.history, SIZE);
    step->add_followed(p.i);
    if (p.j >= 0) step->add_followed(p.j);
    scatter.add_kick(p.i, p.j, c, c.most_kick(now.start));
    scatter.add_owed(
        p.i, p.j, c,
        c.template owed<SIZE>(now.start.truth.relative.separation, now.start.ahead, memory));
  }
};

}  // namespace LAMMPS_NS

#endif
