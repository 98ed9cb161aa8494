// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_WORDS_OF_LAW_H
#define COHESION_WORDS_OF_LAW_H

#include <string>
#include <vector>

#include "comm.h"
#include "input/cohesive_contact_from_script.h"

namespace LAMMPS_NS {

/// A keyword of a law and the numbers behind it.
struct LawKeyword {
  const char* name;
  int values;
};

/// The words of a command from arg[first] on, all numbers of its law behind their keywords. A
/// script may leave out these keywords, and give all numbers first, in the order of `keywords`:
/// then they are put in, and `warns` that it should.
class WordsOfLaw {
 public:
  WordsOfLaw(LAMMPS* lmp, const std::string& where, int first, int narg, char** arg,
             const std::vector<LawKeyword>& keywords, bool warns = true) {
    int next = first;
    std::string instead;
    for (const LawKeyword& keyword : keywords) {
      if (next == narg || !is_number(arg[next])) break;
      words_.push_back(keyword.name);
      for (int k = 0; k < keyword.values && next < narg && is_number(arg[next]); k++)
        words_.push_back(arg[next++]);
    }
    for (const std::string& word : words_) instead += (instead.empty() ? "" : " ") + word;
    if (warns && !instead.empty() && lmp->comm->me == 0)
      lmp->error->warning(FLERR, where + ": numbers without keywords; write '" + instead + "'");
    by_place_ = !words_.empty();
    words_.insert(words_.end(), arg + next, arg + narg);
    for (std::string& word : words_) pointers_.push_back(&word[0]);
  }
  WordsOfLaw(const WordsOfLaw&) = delete;
  WordsOfLaw& operator=(const WordsOfLaw&) = delete;

  /// Whether keywords were left out.
  bool by_place() const { return by_place_; }
  int count() const { return static_cast<int>(pointers_.size()); }
  char** get() { return pointers_.data(); }

 private:
  bool by_place_;
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

}  // namespace LAMMPS_NS

#endif
