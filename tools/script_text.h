// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace cohesion::tools {

/// As printf writes it.
template <class... Values>
std::string text(const char* format, const Values&... values) {
  const int length = std::snprintf(nullptr, 0, format, values...);
  std::string line(static_cast<std::size_t>(length), '\0');
  std::snprintf(line.data(), line.size() + 1, format, values...);
  return line;
}

inline std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string all;
  for (std::size_t k = 0; k < parts.size(); k++) all += (k ? separator : "") + parts[k];
  return all;
}

}  // namespace cohesion::tools
