// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "validation.h"

namespace cohesion {

/// The row of `table` called `name`; rows have a member `name`.
/// Throws InvalidParameter that lists the valid names when there is none.
template <class Table>
const auto& find_by_name(const Table& table, std::string_view what, std::string_view name) {
  std::string valid;
  for (const auto& row : table) {
    if (row.name == name) return row;
    valid += valid.empty() ? "" : ", ";
    valid += row.name;
  }
  throw InvalidParameter("unknown " + std::string(what) + " '" + std::string(name) +
                         "'; valid names: " + valid);
}

}  // namespace cohesion
