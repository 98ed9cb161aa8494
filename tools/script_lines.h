// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "script_reader.h"
#include "script_text.h"

namespace cohesion::tools {

/// The lines of a script, in which commands are replaced.
class ScriptLines {
 public:
  explicit ScriptLines(const std::string& file) : file_(file) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) lines_.emplace_back(line);
  }

  void replace(const ScriptCommand& c, const std::string& text) {
    text_of(c);
    for (int k = c.line; k <= c.last_line; k++) lines_[static_cast<std::size_t>(k) - 1].reset();
    lines_[static_cast<std::size_t>(c.line) - 1] = text;
  }
  /// law: in place of sjkr and sjkr2.
  void replace_model(const ScriptCommand& c, const std::string& law) {
    replace(c, with_law(c, text_of(c), law));
  }

  void write(const std::string& target) const {
    std::ofstream stream(target);
    for (const std::optional<std::string>& line : lines_)
      if (line) stream << *line << '\n';
    if (!stream.flush())
      throw std::runtime_error("'" + target + "' cannot be written: check its folder");
  }

 private:
  /// The lines of a command, as they are written.
  std::string text_of(const ScriptCommand& c) const {
    if (c.file != file_)
      c.fail("this line is in an included file, which is not translated: move it into '" + file_ +
             "'");
    std::string all;
    for (int k = c.line; k <= c.last_line; k++)
      all += (k > c.line ? "\n" : "") + lines_[static_cast<std::size_t>(k) - 1].value_or("");
    return all;
  }

  /// Word k names the cohesion model, or the switch that this package lacks.
  static bool is_replaced(const ScriptCommand& c, std::size_t k) {
    const std::string &word = c.words[k], &before = k > 0 ? c.words[k - 1] : word;
    return word == "cohesion" || before == "cohesion" || word == "tangential_reduce" ||
           before == "tangential_reduce";
  }
  /// The lines of a command, with values in place of the variables that hold such words.
  static std::string expanded(const ScriptCommand& c, std::string line) {
    std::size_t at = 0, k = 0;
    for (std::size_t origin = 0; origin < c.written.size(); origin++) {
      std::vector<std::string> values;
      bool is_changed = false;
      for (; k < c.words.size() && c.origins[k] == origin; k++) {
        values.push_back(c.words[k]);
        is_changed = is_changed || is_replaced(c, k);
      }
      const std::string& written = c.written[origin];
      const std::string value = is_changed ? joined(values, " ") : written;
      const std::size_t found = line.find(written, at);
      if (found == std::string::npos) continue;  // a word in quotes, on several lines
      line.replace(found, written.size(), value);
      at = found + value.size();
    }
    return line;
  }

  static std::string with_law(const ScriptCommand& c, std::string line, const std::string& law) {
    static const std::regex model(R"((cohesion(?:\s|&)+)sjkr2?(?!\S))"),
        reduce(R"(\s+tangential_reduce\s+(?:on|off)(?!\S))");
    line = expanded(c, line);
    if (!std::regex_search(line, model))
      c.fail("its cohesion model is in quotes: remove the quotes for a translation");
    return std::regex_replace(std::regex_replace(line, model, "$1" + law), reduce, "");
  }

  std::string file_;
  std::vector<std::optional<std::string>> lines_;  // empty: removed
};

}  // namespace cohesion::tools
