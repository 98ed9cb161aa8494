// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>

#include "constants.h"

namespace cohesion::tools {

/// The value of an expression of a script: numbers, PI, v_name, + - * / ^ and parentheses.
/// Functions and thermo keywords have no value. As in LIGGGHTS, the unary minus binds before ^, and
/// ^ associates to the left: -2^2 is 4, 2^3^2 is 64.
class ScriptExpression {
 public:
  using Variables = std::function<std::optional<double>(const std::string&)>;

  ScriptExpression(const std::string& text, const Variables& variables)
      : text_(text), variables_(variables) {}

  std::optional<double> value() {
    const std::optional<double> found = sum();
    skip_spaces();
    return at_ == text_.size() ? found : std::nullopt;
  }

 private:
  using Number = std::optional<double>;

  Number sum() {
    Number left = product();
    for (char sign = next_of("+-"); left && sign; sign = next_of("+-")) {
      const Number right = product();
      if (!right) return {};
      left = sign == '+' ? *left + *right : *left - *right;
    }
    return left;
  }
  Number product() {
    Number left = power();
    for (char sign = next_of("*/"); left && sign; sign = next_of("*/")) {
      const Number right = power();
      if (!right) return {};
      left = sign == '*' ? *left * *right : *left / *right;
    }
    return left;
  }
  Number power() {
    Number left = unary();
    while (left && next_of("^")) {
      const Number exponent = unary();
      if (!exponent) return {};
      left = std::pow(*left, *exponent);
    }
    return left;
  }
  Number unary() {
    if (!next_of("-")) return term();
    const Number positive = unary();
    return positive ? Number(-*positive) : Number();
  }
  Number term() {
    if (next_of("(")) {
      const Number inner = sum();
      return next_of(")") ? inner : Number();
    }
    skip_spaces();
    if (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) return named();
    return number();
  }
  Number number() {
    const char* const begin = text_.c_str() + at_;
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    at_ += static_cast<std::size_t>(end - begin);
    return end != begin ? Number(value) : Number();
  }
  Number named() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_'))
      at_++;
    const std::string name = text_.substr(begin, at_ - begin);
    if (name == "PI") return pi;
    return name.rfind("v_", 0) == 0 ? variables_(name.substr(2)) : Number();
  }

  void skip_spaces() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) at_++;
  }
  /// The next character if it is one of these, which is passed; else 0.
  char next_of(const std::string& these) {
    skip_spaces();
    if (at_ == text_.size() || these.find(text_[at_]) == std::string::npos) return 0;
    return text_[at_++];
  }

  std::string text_;
  Variables variables_;
  std::size_t at_ = 0;
};

}  // namespace cohesion::tools
