// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

/// Checks of the parameters of a law, made once when the law is built.
/// Every message says what was given and what would be right; the adapter adds where it stood.
namespace cohesion {

/// What every law throws when a parameter cannot be right.
struct InvalidParameter : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

inline void require(bool right, const char* name, double value, const std::string& remedy) {
  if (right) return;
  std::ostringstream message;
  message << name << " = " << value << ": " << remedy;
  throw InvalidParameter(message.str());
}

inline void require_positive(const char* name, double value) {
  require(std::isfinite(value) && value > 0.0, name, value,
          "must be a finite number greater than zero");
}

inline void require_non_negative(const char* name, double value) {
  require(std::isfinite(value) && value >= 0.0, name, value,
          "must be a finite number not below zero");
}

}  // namespace cohesion
