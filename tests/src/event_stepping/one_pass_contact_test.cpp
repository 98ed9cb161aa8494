// SPDX-License-Identifier: BSD-3-Clause
#include "event_stepping/one_pass_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/adhesive_contact.h"
#include "event_stepping/pair_run.h"

namespace cohesion::event_stepping {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double core = 2.0 * thesis::radius;

contact::LinearSpringDashpot spring(double damping) {
  return {thesis::contact().stiffness, damping, thesis::reduced_mass};
}

/// A head-on pair on an engine's grid, from outside until it is outside again; its final speed.
double rebound(const OnePassContact& contact, double speed, double phase) {
  const double dt = contact.step();
  double distance = core + contact.range() + speed * dt * (2.0 + phase), radial = -speed;
  GridMemory memory;
  bool touched = false;
  for (int n = 0; n < 3000; n++) {
    distance += dt * radial;
    const GridPoint at{distance, radial, 0.0};
    GridStep step;
    if (!contact.follow_lasting(at, 0.0, memory, step)) step = contact.follow(at, 0.0, dt, memory);
    radial += dt * step.force / thesis::reduced_mass;
    if (!std::isfinite(radial)) return radial;
    touched = touched || memory.inside();
    if (touched && memory.phase == GridMemory::beyond) return radial;
  }
  return 0.0;
}

}  // namespace

TEST(OnePassContact, RestitutionIsExactForAnyStepAndPhase) {
  for (const double damping : {0.0, 0.79e-3}) {
    const auto law = spring(damping);
    for (const double part : {2.0, 4.0, 10.0, 50.0})
      for (int phase = 0; phase < 8; phase++) {
        const double speed = 0.02, dt = thesis::contact_time / part;
        const OnePassContact contact(law, {}, core, dt);
        const double back = rebound(contact, speed, (phase + 0.37) / 8.0);
        // The distance is rounded by eps core / 2 at each of some part + 5 points, each felt in
        // the velocity over dt at the most.
        EXPECT_NEAR(back, law.restitution() * speed, (part + 5.0) * eps * core / dt)
            << damping << " " << part << " " << phase;
      }
  }
}

TEST(OnePassContact, APairThatIsNewInTheRangeStandsThere) {
  // In the gap at rest within a run: it falls by what is left of the gap, and has fallen in by the
  // whole range where it was outside a step before.
  const contact::Adhesion adhesion{2e-6, 1e-6, 3e-12};
  const double dt = thesis::contact_time / 10.0, gap = 0.25e-6;
  const OnePassContact contact(spring(0.0), adhesion, core, dt);
  const auto is_inside_after = [&](double radial, bool is_new) {
    GridMemory memory;
    memory.is_new = is_new;
    contact.follow({core + gap, radial, 0.0}, 0.0, dt, memory);
    return memory.inside();
  };
  EXPECT_TRUE(is_inside_after(0.0, true));
  EXPECT_FALSE(is_inside_after(0.0, false));

  GridPoint at{core + gap, 0.0, 0.0};
  GridMemory memory;
  memory.is_new = true;
  double fastest = 0.0;
  for (int n = 0; n < 300; n++) {
    GridStep step;
    if (!contact.follow_lasting(at, 0.0, memory, step)) step = contact.follow(at, 0.0, dt, memory);
    memory.is_new = false;
    at.radial += dt * step.force / thesis::reduced_mass;
    at.distance += dt * at.radial;
    fastest = std::max(fastest, std::abs(at.radial));
    EXPECT_LT(at.distance, core + adhesion.cutoff) << n;
  }
  // At the equilibrium, F/K within the contact: from the gap and into the spring.
  const double stiffness = thesis::contact().stiffness;
  const double energy = adhesion.force * gap + 0.5 * adhesion.force * adhesion.force / stiffness;
  // Grid velocities are means over a step, in which the pull adds F dt/mu to the speed: the fastest
  // of them may be of a step that ends one and a half steps before the touch.
  const double speed = std::sqrt(2.0 * energy / thesis::reduced_mass);
  EXPECT_NEAR(fastest, speed, 1.5 * dt * adhesion.force / thesis::reduced_mass);
}

TEST(OnePassContact, RecursionOnTheGridIsTheClosedForm) {
  const double critical = 2.0 * std::sqrt(thesis::contact().stiffness * thesis::reduced_mass);
  for (const double share : {0.0, 0.1, 1.0, 3.0})
    for (const double part : {2.0, 10.0, 100.0, 1000.0}) {
      const double dt = thesis::contact_time / part, mu = thesis::reduced_mass;
      const DampedOscillator oscillator(thesis::contact().stiffness / mu,
                                        0.5 * share * critical / mu);
      const GridSpring grid = oscillator.on_grid(dt, mu);
      const double w0 = std::sqrt(oscillator.w0_squared());
      const Overlap start{0.0, w0};  // amplitudes of order 1
      double x = oscillator.after(dt, start, 0.0).x, v = x / dt;
      for (int n = 2; n <= 2.0 * part; n++) {
        v -= dt * (grid.stiffness * x + grid.damping * v) / mu;
        x += dt * v;
        // x is rounded by eps and v by eps w0 in each step, and an error of v grows with time at
        // the most; the closed form rounds its argument of 2 pi.
        const double rounding = 10.0 * n * eps * (1.0 + w0 * n * dt);
        EXPECT_NEAR(x, oscillator.after(n * dt, start, 0.0).x, rounding)
            << share << " " << part << " " << n;
      }
    }
}

TEST(OnePassContact, EscapesHeadOnAtTheVelocityOfTheClosedFormForAnyStepAndPhase) {
  const auto law = spring(thesis::contact().damping);
  for (const double hamaker : {1e-19, 7.49e-19, 2e-18}) {
    const contact::Adhesion adhesion = thesis::adhesion(hamaker);
    const double escape = contact::AdhesiveContact(law, adhesion).escape_velocity();
    for (const double part : {4.0, 8.0, 16.0, 50.0})
      for (int phase = 0; phase < 8; phase++)
        for (const double off : {-1e-3, 1e-3}) {
          const OnePassContact contact(law, adhesion, core, thesis::contact_time / part);
          const double back = rebound(contact, escape * (1.0 + off), (phase + 0.37) / 8.0);
          EXPECT_EQ(back > 0.0, off > 0.0) << hamaker << " " << part << " " << phase;
        }
  }
}

TEST(OnePassContact, ExtremesStayFinite) {
  for (const double damping : {0.0, 0.79e-3, 1.0, 1e3})
    for (const double part : {1.0 / 0.9, 4.0, 50.0})
      for (const double cutoff : {0.0, thesis::range})
        for (const double tail : {0.0, 1e-15, 1.0})
          for (const double speed : {0.0, 1e-9, 0.02, 1.0}) {
            const OnePassContact contact(spring(damping), {1e-6, cutoff, tail}, core,
                                         thesis::contact_time / part);
            EXPECT_TRUE(std::isfinite(rebound(contact, speed, 0.3)))
                << damping << " " << part << " " << cutoff << " " << tail << " " << speed;
          }
}

namespace {

/// What a step does to a sphere beside a plane, under an acceleration `others` away from it.
struct BesidePlane {
  OnePassContact contact;
  double mass;
  double others;
  double distance, radial;
  GridMemory memory{};
  GridStep last{};

  void step() {
    const double dt = contact.step();
    distance += dt * radial;
    const GridPoint at{distance, radial, 0.0};
    if (!contact.follow_lasting(at, others, memory, last))
      last = contact.follow(at, others, dt, memory);
    radial += dt * (last.force / mass + others);
  }
  /// Height over touch at which what moves it now would turn, where it flies freely.
  double height() const {
    const double now = radial - 0.5 * contact.step() * (last.force / mass + others);
    return distance - thesis::radius + now * now / (-2.0 * others);
  }
};

/// Two spheres in a plane that meet with a normal and a sideways speed; whether they part again.
/// `turned`: largest change of the angular momentum over r times speed.
bool parts(const OnePassContact& contact, double speed, double sideways, double phase,
           double& turned) {
  const double dt = contact.step(), flight = dt * (2.0 + phase);
  double x = core + contact.range() + speed * flight, y = -sideways * flight;
  double vx = -speed, vy = sideways;
  const double momentum = x * vy - y * vx;
  GridMemory memory;
  bool touched = false;
  for (int n = 0; n < 40.0 * thesis::contact_time / dt; n++) {
    x += dt * vx;
    y += dt * vy;
    const double r = std::hypot(x, y), nx = x / r, ny = y / r;
    const GridPoint at{r, vx * nx + vy * ny, std::abs(vy * nx - vx * ny)};
    GridStep step;
    if (!contact.follow_lasting(at, 0.0, memory, step)) step = contact.follow(at, 0.0, dt, memory);
    vx += dt * step.force / thesis::reduced_mass * nx;
    vy += dt * step.force / thesis::reduced_mass * ny;
    turned = std::max(turned,
                      std::abs(x * vy - y * vx - momentum) / (core * std::hypot(speed, sideways)));
    touched = touched || memory.inside();
    if (touched && memory.phase == GridMemory::beyond) return true;
  }
  return false;
}

double escape_speed(const OnePassContact& contact, double slope, double phase, double& turned) {
  double low = 1e-3, high = 0.1;
  for (int k = 0; k < 30; k++) {
    const double middle = std::sqrt(low * high);
    (parts(contact, middle, slope * middle, phase, turned) ? high : low) = middle;
  }
  return high;
}

}  // namespace

TEST(OnePassContact, ElasticBouncesUnderWeightKeepTheirHeight) {
  const double mass = thesis::mass, stiffness = 2.0 * thesis::contact().stiffness;
  const contact::LinearSpringDashpot law(stiffness, 0.0, mass);
  const double gravity = 9.81, height = 2e-5;
  for (const double part : {2.0, 4.0, 10.0, 50.0}) {
    const double dt = law.contact_time() / part;
    BesidePlane sphere{{law, {}, thesis::radius, dt},
                       mass,
                       -gravity,
                       thesis::radius + height,
                       -0.5 * gravity * dt};
    int bounces = 0;
    double reached = 0.0;
    for (bool was = false; bounces < 500;) {
      sphere.step();
      if (was && !sphere.memory.inside()) bounces++;
      was = sphere.memory.inside();
      if (bounces == 499 && sphere.memory.phase == GridMemory::beyond) reached = sphere.height();
    }
    // Each bounce rounds place and speed, two to each of some steps, by eps of distance over dt.
    const double steps = 500.0 * (part + 2.0 * std::sqrt(2.0 * height / gravity) / dt);
    const double speed = std::sqrt(2.0 * gravity * height);
    EXPECT_NEAR(reached / height, 1.0, std::sqrt(steps) * 8.0 * eps * thesis::radius / dt / speed)
        << part;
  }
}

TEST(OnePassContact, ALoadAtRestPressesItsSpringOnTheGrid) {
  const contact::LinearSpringDashpot law(1600.0, 1.6e-3, thesis::mass);
  for (const double part : {4.0, 10.0, 50.0}) {
    BesidePlane sphere{{law, {}, thesis::radius, law.contact_time() / part},
                       thesis::mass,
                       -9.81,
                       thesis::radius * (1.0 - 1e-9),
                       0.0};
    for (int n = 0; n < 800.0 * part; n++) sphere.step();
    const double overlap = thesis::radius - sphere.distance;
    // Of the distance, eps is rounded off.
    EXPECT_NEAR(overlap, thesis::mass * 9.81 / sphere.contact.spring().stiffness,
                4.0 * eps * thesis::radius + 1e-9 * overlap)
        << part;
    EXPECT_EQ(sphere.memory.phase, GridMemory::lasting);
  }
}

TEST(OnePassContact, ASlowLoadPartsAContactAtTheAdhesionForceAtAnyStep) {
  // A sphere on a plane, from its rest without a load; this grows by F_ad in 2000 contact times.
  const contact::Adhesion adhesion = thesis::adhesion(7.49e-19);
  const double mass = thesis::mass, rate = 1.0 / 2000.0;
  for (const double stiffness : {800.0, 8e4})
    for (const double restitution : {0.99, 0.9, 0.5, 0.3})
      for (const double part : {4.0, 10.0, 20.0, 50.0}) {
        const auto law =
            contact::LinearSpringDashpot::from_restitution(stiffness, restitution, mass);
        const double dt = law.contact_time() / part;
        BesidePlane sphere{{law, adhesion, thesis::radius, dt},
                           mass,
                           0.0,
                           thesis::radius - adhesion.force / stiffness,
                           0.0};
        sphere.memory.phase = GridMemory::begun;
        double load = 0.0;
        for (int n = 0; load < 1.1 && sphere.memory.inside(); n++) {
          load = rate * n / part;
          sphere.others = load * adhesion.force / mass;
          sphere.step();
        }
        // Half of the hundredth is for what it swings by, the rest for the lag of the load and of
        // its knowledge: (6 H_cut mass k^2/F_ad)^(1/3) < 0.003, k = rate/t_c.
        EXPECT_NEAR(load, 1.0, 0.01) << stiffness << " " << restitution << " " << part;
      }
}

TEST(OnePassContact, ObliquePairsEscapeAtTheSameSpeedForAnyStepAndPhase) {
  const auto law = spring(thesis::contact().damping);
  for (const double hamaker : {1e-19, 7.49e-19, 2e-18}) {
    const contact::Adhesion adhesion = thesis::adhesion(hamaker);
    for (const double angle : {30.0, 60.0, 80.0}) {
      const double slope = std::tan(angle * 3.14159265358979 / 180.0);
      double turned = 0.0;
      const double fine =
          escape_speed({law, adhesion, core, thesis::contact_time / 200.0}, slope, 0.4, turned);
      for (const double part : {4.0, 8.0, 16.0, 50.0})
        for (int phase = 0; phase < 8; phase++) {
          const OnePassContact contact(law, adhesion, core, thesis::contact_time / part);
          const double found = escape_speed(contact, slope, phase / 8.0, turned);
          EXPECT_NEAR(found / fine, 1.0, 1e-3) << hamaker << " " << angle << " " << part;
        }
      // A force along the line of the centres turns nothing: rounding of some 40 contact times.
      EXPECT_LT(turned, 8000.0 * eps) << hamaker << " " << angle;
    }
  }
}

TEST(OnePassContact, FollowsALastingContactAsItsOneForceDoes) {
  const auto law = spring(thesis::contact().damping);
  const double dt = thesis::contact_time / 10.0;
  const OnePassContact contact(law, thesis::adhesion(7.49e-19), core, dt);
  GridMemory memory;
  memory.phase = GridMemory::lasting;
  const double overlap = contact.range() * 1000.0;
  for (const double radial : {-1e-3, 0.0, 1e-3}) {
    const GridPoint at{core - overlap, radial, 0.0};
    GridStep simple;
    ASSERT_TRUE(contact.follow_lasting(at, 0.0, memory, simple)) << radial;
    GridMemory after = memory;
    const GridStep followed = contact.follow(at, 0.0, dt, after);
    // Distances are rounded by eps core, and a force is a difference of three over dt^2.
    EXPECT_NEAR(followed.force, simple.force, 8.0 * eps * core * thesis::reduced_mass / (dt * dt));
    EXPECT_EQ(after.phase, GridMemory::begun);
  }
}

namespace {

/// The largest work of a pair's forces on an encounter, of eight positions in the step, over its
/// kinetic energy at the start. Others change its speed along the normal by up to `shake` of that
/// at the start in a step, and the pair knows what they did a step before.
double largest_work(const OnePassContact& contact, double sideways, double shake) {
  const double dt = contact.step(), speed = 0.05,
               energy = 0.5 * (speed * speed + sideways * sideways);
  double largest = 0.0;
  for (int phase = 0; phase < 8; phase++) {
    const double flight = dt * (2.0 + phase / 8.0);
    double x = core + contact.range() + speed * flight, y = -sideways * flight;
    double vx = -speed, vy = sideways, ax = 0.0, ay = 0.0, known = 0.0, work = 0.0;
    GridMemory memory;
    bool touched = false, over = false;
    for (int n = 0; !over && n < 40.0 * thesis::contact_time / dt; n++) {
      x += dt * vx;
      y += dt * vy;
      const double r = std::hypot(x, y), nx = x / r, ny = y / r;
      const GridPoint at{r, vx * nx + vy * ny, std::abs(vy * nx - vx * ny)};
      GridStep step;
      if (!contact.follow_lasting(at, known, memory, step))
        step = contact.follow(at, known, dt, memory);
      const double a = step.force / thesis::reduced_mass;
      work += 0.5 * dt * ((ax + a * nx) * vx + (ay + a * ny) * vy);
      ax = a * nx;
      ay = a * ny;
      known = shake * speed / dt * std::sin(1.7 * n);
      vx += dt * (ax + known * nx);
      vy += dt * (ay + known * ny);
      touched = touched || memory.inside();
      over = touched && memory.phase == GridMemory::beyond && a == 0.0;
    }
    EXPECT_TRUE(over);
    largest = std::max(largest, std::abs(work) / energy);
  }
  return largest;
}

}  // namespace

TEST(OnePassContact, ElasticPairsThatOthersShakeGiveBackWhatTheyTook) {
  for (const double hamaker : {0.0, 2e-18}) {
    const auto adhesion = hamaker > 0.0 ? thesis::adhesion(hamaker) : contact::Adhesion{};
    for (const double part : {4.0, 10.0, 20.0, 50.0})
      for (const double sideways : {0.0, 0.05}) {
        const OnePassContact contact(spring(0.0), adhesion, core, thesis::contact_time / part);
        // Alone: rounding of the distance, felt in the velocity over a step; what it turns by in a
        // step, squared.
        const double dt = contact.step(), turns = dt * sideways / core;
        const double alone = 8.0 * (part + 5.0) * eps * core / dt / 0.05 + turns * turns;
        EXPECT_LT(largest_work(contact, sideways, 0.0), alone) << hamaker << " " << part;
        // Settled twice, each time but for what others change in a step, 2 shake at the most. Of
        // what is not settled, a tenth of the shaking leaves a tenth, of this a hundredth.
        const double much = largest_work(contact, sideways, 0.1);
        EXPECT_LT(much, 0.5 * 0.2 * 0.2) << hamaker << " " << part << " " << sideways;
        EXPECT_LT(largest_work(contact, sideways, 0.01), much / std::sqrt(10.0 * 100.0) + alone)
            << hamaker << " " << part << " " << sideways;
      }
  }
}

TEST(OnePassContact, TheFirstStepOfARunTakesAPairWhereItIs) {
  const contact::LinearSpringDashpot law = spring(0.0);
  const double dt = thesis::contact_time / 10.0, mu = thesis::reduced_mass;
  const OnePassContact contact(law, thesis::adhesion(7.49e-19), core, dt);
  const double start = 2e-7, speed = 0.01;
  const DampedOscillator oscillator(law.stiffness() / mu, 0.0);
  const double pull = thesis::adhesion(7.49e-19).force / mu;
  GridMemory memory;
  const GridStep step = contact.follow({core - start, -speed, 0.0}, 0.0, 0.5 * dt, memory);
  const double flown = -speed + 0.5 * dt * step.force / mu;
  EXPECT_NEAR(start - dt * flown, oscillator.after(dt, {start, speed}, pull).x, 4.0 * eps * core);
  EXPECT_EQ(memory.phase, GridMemory::begun);
  GridMemory beyond;
  EXPECT_EQ(contact.follow({core * 1.1, -speed, 0.0}, -9.81, 0.5 * dt, beyond).force, 0.0);
  EXPECT_EQ(beyond.phase, GridMemory::beyond);
}

}  // namespace cohesion::event_stepping
