// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "contact/contact_parameters.h"
#include "contact_solver/contact_history.h"
#include "contact_solver/discrete_spring.h"

namespace cohesion::contact_solver {

/// The spring of friction, or of rolling friction, of a contact. With a linear normal spring its
/// stiffness is constant. With Hertz's it grows with the overlap, as Mindlin's: while it grows, the
/// force is kept and the stretch decreases; while it falls, the stretch is kept and the force
/// decreases. So no change of the overlap adds energy to it.
///
/// Source: C. Thornton, S. J. Cummins, P. W. Cleary, Powder Technol. 233 (2013) 30.
class ContactSpring {
 public:
  enum class Kind { sliding, rolling };

  /// inverse_mass [1/mass]: DiscreteSpring.
  ContactSpring(Kind kind, const contact::ContactParameters& contact, const contact::NormalLaw& law,
                double step, double inverse_mass)
      : kind_(kind),
        contact_(contact),
        law_(law),
        step_(step),
        inverse_mass_(inverse_mass),
        stiffens_(!contact::is_linear(law)),
        constant_(stiffens_
                      ? at(0.0)
                      : DiscreteSpring(parameters(std::get<contact::LinearSpringDashpot>(law)),
                                       step, inverse_mass)) {}

  /// Whether there is any friction.
  bool is_present() const { return constant_.is_present(); }
  bool stiffens() const { return stiffens_; }
  /// The spring if its stiffness is constant; step, mass and friction are right in any case.
  const DiscreteSpring& constant() const { return constant_; }
  /// The spring at this overlap [length].
  DiscreteSpring at(double overlap) const {
    if (!stiffens_) return constant_;
    return DiscreteSpring::at_time_level(parameters(contact::point_of(law_, overlap)), step_,
                                         inverse_mass_);
  }
  /// The constants of a persistent contact at this overlap [length].
  DiscreteConstants constants_at(double overlap) const {
    return stiffens_ ? constants_at(contact::point_of(law_, overlap)) : constant_.constants();
  }
  /// The same of a spring that stiffens, at this point of the law.
  DiscreteConstants constants_at(const contact::LawPoint& here) const {
    const contact::TangentialParameters p = parameters(here);
    return constant_.constants_at_time_level(p.stiffness, p.damping);
  }
  /// Of a persistent contact, [energy].
  double stored_energy(double overlap, const Vector3& stretch) const {
    return DiscreteSpring::stored_energy(constants_at(overlap), stretch);
  }
  /// The fraction of a stretch that is left after a change of the overlap [length].
  double left_of_stretch(double before, double now) const {
    if (!stiffens_ || !(now > before)) return 1.0;
    return contact::stretch_left(contact::point_of(law_, before).radius_stiffness,
                                 contact::point_of(law_, now).radius_stiffness);
  }

  /// The impulse of a persistent contact whose normal motion does `normal`, that was persistent in
  /// the last step, too. `values`: the stored spring; `linear`: whether the normal law is;
  /// overlap_before [length]: at the last time level; `losses` may be null.
  template <bool linear>
  [[gnu::always_inline]] Vector3 persistent_impulse(const contact::Plane& plane,
                                                    const Vector3& rate,
                                                    const PersistentStep& normal,
                                                    double overlap_before, double* values,
                                                    DiscreteSpring::Losses* losses) const {
    DiscreteSpring::State last{vector(values), vector(values + 3)}, state{last.stretch};
    Vector3 impulse;
    bool slips;
    if constexpr (linear) {
      impulse = constant_.advance_persistent(plane, rate, normal.repulsion, true, state, slips);
      if (losses)
        *losses = constant_.losses(plane, rate, {constant_.constants(), last}, 1.0,
                                   {constant_.constants(), state}, slips);
    } else {
      const double left =
          contact::stretch_left(normal.radius_stiffness_before, normal.at.radius_stiffness);
      state.stretch = left * state.stretch;
      const DiscreteConstants here = constants_at(normal.at);
      impulse = constant_.advance_persistent(plane, rate, normal.repulsion, here, state, slips);
      if (losses)
        *losses = constant_.losses(plane, rate, {constants_at(overlap_before), last}, left,
                                   {here, state}, slips);
    }
    ContactHistory::store(state, values);
    return impulse;
  }

 private:
  template <class Normal>
  contact::TangentialParameters parameters(const Normal& normal) const {
    return kind_ == Kind::sliding ? contact::tangential_contact(contact_, normal)
                                  : contact::rolling_contact(contact_, normal);
  }

  Kind kind_;
  contact::ContactParameters contact_;
  contact::NormalLaw law_;
  double step_;
  double inverse_mass_;
  bool stiffens_;
  DiscreteSpring constant_;
};

}  // namespace cohesion::contact_solver
