// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string_view>
#include <vector>

namespace cohesion {

/// How many letters have to be changed, added or left out to make one word of the other, upper and
/// lower case being the same (Levenshtein's distance).
inline int letters_apart(std::string_view one, std::string_view other) {
  const auto lower = [](char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  // Of the first letters of `one` that have been seen, and of the first so many of `other`
  std::vector<int> apart(other.size() + 1);
  std::iota(apart.begin(), apart.end(), 0);
  for (const char letter : one) {
    int without_both = apart[0]++;
    for (std::size_t k = 0; k < other.size(); k++) {
      const int changed = without_both + (lower(letter) != lower(other[k]));
      without_both = apart[k + 1];
      apart[k + 1] = std::min({changed, apart[k] + 1, apart[k + 1] + 1});
    }
  }
  return apart.back();
}

/// The name in a table that is the fewest letters apart from `word`, the first of several; rows
/// have a member `name`.
template <class Table>
std::string_view nearest_name(const Table& table, std::string_view word) {
  const auto nearer = [word](const auto& one, const auto& other) {
    return letters_apart(one.name, word) < letters_apart(other.name, word);
  };
  return std::min_element(std::begin(table), std::end(table), nearer)->name;
}

}  // namespace cohesion
