// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_COHESIVE_COEFFICIENTS_H
#define COHESION_COHESIVE_COEFFICIENTS_H

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "comm.h"
#include "contact/stiffness_scaling.h"
#include "contact_solver/contact_solver.h"
#include "contact_solver/turning.h"
#include "input/cohesive_contact_from_script.h"
#include "input/restart_format.h"
#include "input/type_pair_table.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Settings of a pair style with cohesion and its coefficients by pair of types: read from a script
/// or a restart file, mixed, and made laws for a run.
template <class Cohesion>
class CohesiveCoefficients : protected Pointers {
 public:
  using Parameters = typename Cohesion::Parameters;

  explicit CohesiveCoefficients(LAMMPS* lammps)
      : Pointers(lammps), scheme_(Scheme::exact), parameters_(lammps) {}

  static std::string message_prefix() { return std::string("pair_style ") + Cohesion::STYLE; }

  /// What `pair_style` says.
  void read_settings(int narg, char** arg);
  /// Room for pairs of `types` types. `set` is the engine's table of those that were given.
  void make_room(int types, int** set) { parameters_.make_room(types, set); }
  /// What `pair_coeff` says.
  void read(int narg, char** arg);
  /// The laws are made anew, by prepare().
  void start() {
    parameters_.commit();
    laws_.assign(parameters_.size(), cohesion_.no_law());
    contacts_.assign(parameters_.size(), {});
    prepared_.assign(parameters_.size(), false);
    has_other_ranges_ = false;
  }
  void require_committed() const { parameters_.require_committed(message_prefix()); }
  /// Whether types i and j are this style's in the run; those of other styles of a hybrid are not.
  bool has(int i, int j) const { return prepared_[pair_index(i, j)]; }
  /// Whether any law that prepare() has made acts as far as another than that of the run before.
  bool has_other_ranges() const { return has_other_ranges_; }
  /// Whether the laws of two pairs of types, pair_index(), have different ranges.
  bool have_other_ranges(int a, int b) const { return a != b && ranges_[a] != ranges_[b]; }
  /// Makes the law of types i and j, mixed when they were not given. Returns the gap up to which
  /// the scheme has to see particles of these radii, [length].
  double prepare(int i, int j, double radius_i, double radius_j);
  /// Stops LAMMPS where particles of these radii are too small for what prepare() took.
  void require_short(int i, int j, double radius_i, double radius_j) const {
    cohesion_.require_short(lmp, where_types(i, j), parameters_(i, j), radius_i, radius_j);
    if constexpr (std::is_same_v<typename Cohesion::Solver,
                                 cohesion::contact_solver::ContactSolver>) {
      if (scheme_ != Scheme::exact || radius_i == 0.0 || radius_j == 0.0) return;
      LAMMPS_NS::from_script(lmp, where_types(i, j), [&] {
        cohesion::contact_solver::require_turns_as_touching(
            attraction<cohesion::contact::Adhesion>(pair_index(i, j), radius_i, radius_j),
            radius_i + radius_j);
        return true;
      });
    }
  }

  /// With `per_pair`, how many numbers the histories of that file hold for each pair; 0: there are
  /// none.
  void write_settings(FILE*, int per_pair) const;
  /// Returns that number.
  int read_settings(FILE*);
  void write(FILE* fp) const { parameters_.write(fp); }
  void read(FILE* fp) {
    parameters_.read(fp, [this](int i, int j, const Parameters& p) {
      give(i, j, p);
      note_range(i, j);
    });
  }

  Scheme scheme() const { return scheme_; }
  int type_pairs() const { return parameters_.size(); }
  /// The number of a pair of types.
  int pair_index(int i, int j) const { return parameters_.number(i, j); }
  /// That acts, from prepare() on.
  const cohesion::contact::ContactParameters& contact(int pair_index) const {
    return contacts_[pair_index];
  }
  cohesion::contact::Material material(int pair_index) const {
    return Cohesion::material(parameters_[pair_index]);
  }
  std::string doubt(int pair_index) const { return Cohesion::doubt(lmp, parameters_[pair_index]); }
  /// Gap up to which particles of these types attract each other, whatever the scheme makes of it,
  /// [length]; 0: they do not.
  double range_of_attraction(int pair_index) const {
    return Cohesion::range(Scheme::sampled, parameters_[pair_index], 1.0, 1.0);
  }
  /// The normal law of all contacts of the run, if they have the same.
  std::optional<cohesion::contact::LawKind> only_law() const {
    std::optional<cohesion::contact::LawKind> only;
    for (int k = 0; k < type_pairs(); k++) {
      if (!prepared_[k]) continue;
      const auto kind = kind_of_law(contacts_[k]);
      if (only && *only != kind) return std::nullopt;
      only = kind;
    }
    return only;
  }
  /// Whether any contact resists rolling. Of the given ones: mixing adds none.
  bool any_rolls() const {
    return std::any_of(parameters_.begin(), parameters_.end(),
                       [](const Parameters& p) { return p.contact.rolling_friction > 0.0; });
  }
  /// Whether any contact of this type has friction.
  bool has_friction(int type, int types) const {
    const auto any_between = [&](int other) {
      const auto& contact = parameters_(type, other).contact;
      return contact.friction > 0.0 || contact.rolling_friction > 0.0;
    };
    for (int other = 1; other <= types; other++)
      if (any_between(other)) return true;
    return false;
  }
  /// Whether anything can happen between particles of any types.
  bool any_active() const {
    if constexpr (Cohesion::HAS_CONTACT)
      return true;
    else
      return std::any_of(parameters_.begin(), parameters_.end(), &Cohesion::attracts);
  }
  /// As a pair of src/contact_solver takes it.
  template <class Attraction>
  Attraction attraction(int pair_index, double radius_i, double radius_j) const {
    return Cohesion::template of_pair<Attraction>(laws_[pair_index], radius_i, radius_j);
  }

 private:
  Parameters contact_from_script(const std::string& here, int narg, char** arg) {
    if constexpr (Cohesion::HAS_CONTACT)
      return cohesive_contact_from_script<Cohesion>(lmp, here, 2, narg, arg);
    else
      return Cohesion::from_script(lmp, here, 2, narg, arg);
  }
  static std::string where_types(int i, int j) {
    return message_prefix() + ", types " + std::to_string(i) + " and " + std::to_string(j);
  }
  void give(int i, int j, const Parameters& p) {
    parameters_(i, j) = p;
    parameters_(j, i) = Cohesion::reversed(p);
  }
  /// Returns whether it is another than before; the first of all is not.
  bool note_range(int i, int j) {
    ranges_.resize(parameters_.size(), NONE);
    const double before = ranges_[pair_index(i, j)];
    const double now = Cohesion::range(Scheme::exact, parameters_(i, j), 1.0, 1.0);
    ranges_[pair_index(i, j)] = ranges_[pair_index(j, i)] = now;
    return before != NONE && before != now;
  }

  static constexpr double NONE = -1.0;

  Scheme scheme_;
  Cohesion cohesion_;
  TypePairTable<Parameters> parameters_;
  std::vector<typename Cohesion::Law> laws_;  // by pair_index(); of a scaled adhesion, if wished
  std::vector<cohesion::contact::ContactParameters> contacts_;  // the same
  std::vector<bool> prepared_;                                  // the same
  std::vector<double> ranges_;  // the same, of particles of radius 1
  bool has_other_ranges_ = false;
};

template <class Cohesion>
void CohesiveCoefficients<Cohesion>::read_settings(int narg, char** arg) {
  if (!Cohesion::HAS_CONTACT && narg > 0)
    error->all(FLERR, message_prefix() + " takes no keywords, not '" + arg[0] + "'");
  SpecifiedKeywords given(lmp, message_prefix());
  for (int i = 0; i < narg; i += 2) {
    const std::string word = arg[i];
    if (word != "scheme" && !is_setting<Cohesion>(word))
      error->all(FLERR, message_prefix() + ": unknown keyword '" + word +
                            "'; valid ones: " + setting_names<Cohesion>());
    if (i + 1 == narg) error->all(FLERR, message_prefix() + ": " + word + " takes a name");
    given.note(1, arg + i);
    if (word == "scheme")
      scheme_ = scheme_from_script(lmp, message_prefix(), arg[i + 1]);
    else
      cohesion_.set(lmp, message_prefix(), word, arg[i + 1]);
  }
}

template <class Cohesion>
void CohesiveCoefficients<Cohesion>::read(int narg, char** arg) {
  const std::string here =
      std::string("pair_coeff ") + arg[0] + " " + arg[1] + " of " + Cohesion::STYLE;
  const Parameters p = contact_from_script(here, narg, arg);
  parameters_.assign(here, arg, [&](int i, int j) { give(i, j, p); });
}

template <class Cohesion>
double CohesiveCoefficients<Cohesion>::prepare(int i, int j, double radius_i, double radius_j) {
  const std::string here = where_types(i, j);
  if (parameters_.to_mix(message_prefix(), i, j))
    give(i, j, LAMMPS_NS::from_script(lmp, here, [&] {
           return Cohesion::mixed(parameters_(i, i), parameters_(j, j));
         }));
  require_computable(lmp, here, scheme_, parameters_(i, j).contact);
  if (note_range(i, j)) has_other_ranges_ = true;
  const Parameters scaled = cohesion_.scaled(lmp, here, parameters_(i, j));
  laws_[pair_index(j, i)] = cohesion_.law(lmp, here, Cohesion::reversed(scaled));
  laws_[pair_index(i, j)] = cohesion_.law(lmp, here, scaled);
  contacts_[pair_index(i, j)] = contacts_[pair_index(j, i)] = scaled.contact;
  prepared_[pair_index(i, j)] = prepared_[pair_index(j, i)] = true;
  return Cohesion::range(scheme_, scaled, radius_i, radius_j);
}

/* ---------------------------------------------------------------------- */

template <class Cohesion>
void CohesiveCoefficients<Cohesion>::write_settings(FILE* fp, int per_pair) const {
  write_layout(fp, Cohesion::RESTART_LAYOUT);
  const int numbers[3] = {cohesion_.settings(), static_cast<int>(scheme_), per_pair};
  fwrite(numbers, sizeof(int), 3, fp);
}

template <class Cohesion>
int CohesiveCoefficients<Cohesion>::read_settings(FILE* fp) {
  require_layout(lmp, fp, message_prefix(), Cohesion::RESTART_LAYOUT);
  int numbers[3] = {0, 0, 0};
  if (comm->me == 0) utils::sfread(FLERR, numbers, sizeof(int), 3, fp, nullptr, error);
  MPI_Bcast(numbers, 3, MPI_INT, 0, world);
  cohesion_.restore_settings(numbers[0]);
  scheme_ = static_cast<Scheme>(numbers[1]);
  return numbers[2];
}

}  // namespace LAMMPS_NS

#endif
