// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_TYPE_PAIR_TABLE_H
#define COHESION_TYPE_PAIR_TABLE_H

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "comm.h"
#include "error.h"
#include "pointers.h"
#include "utils.h"

namespace LAMMPS_NS {

/// The coefficients of each pair of types: from pair_coeff, by mixing, or by a restart
/// file. Entry (i, j) is seen from i; a style that has two sides writes (j, i) too.
template <class Value>
class TypePairTable : protected Pointers {
 public:
  explicit TypePairTable(LAMMPS* lammps)
      : Pointers(lammps), types_(0), set_(nullptr), uncommitted_(false) {}

  /// Room for pairs of `types` types. `set` is the engine's table of those that were given.
  void make_room(int types, int** set) {
    types_ = types;
    set_ = set;
    for (int i = 1; i <= types; i++) std::fill_n(set[i], types + 1, 0);
    values_.assign((types + 1) * (types + 1), {});
  }

  /// The number of a pair of types.
  int number(int i, int j) const { return i * (types_ + 1) + j; }
  int size() const { return static_cast<int>(values_.size()); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }
  const Value& operator[](int number) const { return values_[number]; }
  Value& operator()(int i, int j) { return values_[number(i, j)]; }
  const Value& operator()(int i, int j) const { return values_[number(i, j)]; }

  /// Calls give(i, j) for each pair i <= j that the first two words of a pair_coeff name.
  template <class Give>
  void assign(const std::string& here, char** arg, Give give) {
    int ilo, ihi, jlo, jhi;
    utils::bounds(FLERR, arg[0], 1, types_, ilo, ihi, error);
    utils::bounds(FLERR, arg[1], 1, types_, jlo, jhi, error);
    bool any = false;
    for (int i = ilo; i <= ihi; i++)
      for (int j = std::max(jlo, i); j <= jhi; j++) {
        give(i, j);
        set_[i][j] = 1;
        any = true;
      }
    if (!any) error->all(FLERR, here + " names no pair with i <= j");
    uncommitted_ = true;
  }

  /// What was given is what the run that is set up has.
  void commit() { uncommitted_ = false; }
  /// Stops LAMMPS where a pair_coeff came after that: laws, ranges and lists are made in the
  /// set-up.
  void require_committed(const std::string& style) const {
    if (uncommitted_)
      error->all(FLERR, style +
                            ": pair_coeff was given after the run had been set up, which takes no "
                            "notice of it any more; leave out 'pre no', so that the next part of "
                            "the run is set up again");
  }

  /// Whether types i and j have to be mixed, for no pair_coeff named them. Stops LAMMPS where one
  /// of them was not given either; `style` stands in front of the message.
  bool to_mix(const std::string& style, int i, int j) const {
    if (set_[i][j]) return false;
    if (!set_[i][i] || !set_[j][j])
      error->all(FLERR, style + ": no pair_coeff for types " + std::to_string(i) + " and " +
                            std::to_string(j) + " nor for both of them to mix");
    return true;
  }

  void write(FILE* fp) const {
    for (int i = 1; i <= types_; i++)
      for (int j = i; j <= types_; j++) {
        fwrite(&set_[i][j], sizeof(int), 1, fp);
        fwrite(&(*this)(i, j), sizeof(Value), 1, fp);
      }
  }
  /// Calls give(i, j, value) for each pair of a restart file.
  template <class Give>
  void read(FILE* fp, Give give) {
    for (int i = 1; i <= types_; i++)
      for (int j = i; j <= types_; j++) {
        Value value{};
        if (comm->me == 0) {
          utils::sfread(FLERR, &set_[i][j], sizeof(int), 1, fp, nullptr, error);
          utils::sfread(FLERR, &value, sizeof(Value), 1, fp, nullptr, error);
        }
        MPI_Bcast(&set_[i][j], 1, MPI_INT, 0, world);
        MPI_Bcast(&value, sizeof(Value), MPI_BYTE, 0, world);
        give(i, j, value);
      }
  }

 private:
  int types_;
  int** set_;
  bool uncommitted_;  // whether something was given that no run has been set up with
  std::vector<Value> values_;
};

}  // namespace LAMMPS_NS

#endif
