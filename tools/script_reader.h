// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "script_expression.h"

namespace cohesion::tools {

/// A command of a script, its variables replaced by their values where these are known.
struct ScriptCommand {
  std::string file;
  int line = 0;  ///< of its first word
  std::vector<std::string> words;
  int last_line = 0;
  std::vector<std::string> written = {};  ///< the words of the script, with their variables
  std::vector<std::size_t> origins = {};  ///< of each word, its place in `written`

  std::string place() const { return file + ':' + std::to_string(line); }

  /// Throws std::runtime_error with the place.
  [[noreturn]] void fail(const std::string& what_and_cure) const {
    throw std::runtime_error(place() + ": " + what_and_cure);
  }
  bool has(std::size_t k) const { return k < words.size(); }
  const std::string& word(std::size_t k, const std::string& what) const {
    if (!has(k)) fail("'" + words.front() + "' ends before " + what + ": complete the line");
    return words[k];
  }
  double number(std::size_t k, const std::string& what) const {
    const std::string& text = word(k, what);
    if (const auto value = number_of(text)) return *value;
    if (const std::size_t at = text.find('$'); at != std::string::npos)
      fail("the value of the variable '" + variable_name(text, at) + "' for " + what +
           " is not known: specify it with --var " + variable_name(text, at) + " VALUE");
    fail("'" + text + "' is no number for " + what + ": write a number");
  }
  int integer(std::size_t k, const std::string& what) const {
    const double value = number(k, what);
    if (value != std::floor(value) || std::abs(value) > 1e9)
      fail("'" + words[k] + "' is no whole number for " + what + ": write a whole number");
    return static_cast<int>(value);
  }
  /// The place of a word from `from` on; the number of words: there is none.
  std::size_t find(const std::string& text, std::size_t from = 0) const {
    while (from < words.size() && words[from] != text) from++;
    return std::min(from, words.size());
  }

  /// What the script has for word k, with variables; empty: it has none.
  std::string word_with_variables(std::size_t k) const {
    if (k >= origins.size()) return "";
    const std::string& text = written[origins[k]];
    return text.find('$') != std::string::npos ? text : "";
  }
  /// Not one of several words of a variable.
  bool is_whole(std::size_t k) const {
    return k >= origins.size() || std::count(origins.begin(), origins.end(), origins[k]) == 1;
  }

  static std::optional<double> number_of(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value)) return {};
    return value;
  }
  /// Of the variable whose $ is at `at`.
  static std::string variable_name(const std::string& text, std::size_t at) {
    if (text[at + 1] != '{') return text.substr(at + 1, 1);
    const std::size_t close = text.find('}', at);
    return text.substr(at + 2, close == std::string::npos ? close : close - at - 2);
  }
};

/// Reads the commands of a script and of the files that it includes: comments, continued lines,
/// quotes, and variables of the styles index, string, loop and equal.
class ScriptReader {
 public:
  /// given: values of variables, which the script does not change unless it deletes them.
  explicit ScriptReader(const std::map<std::string, std::string>& given) {
    for (const auto& [name, text] : given) {
      values_[name] = {false, text};
      fixed_.insert(name);
    }
  }

  /// Throws std::runtime_error when a file cannot be read.
  const std::vector<ScriptCommand>& read(const std::string& file) {
    read_file(file, "the script");
    return commands_;
  }
  /// The script and the files that it includes.
  const std::vector<std::string>& files() const { return files_; }

 private:
  static constexpr int deepest_include = 20, deepest_expression = 20;

  struct Variable {
    bool is_expression;
    std::string text;
  };

  void read_file(const std::string& file, const std::string& what) {
    std::ifstream stream(file);
    if (!stream)
      throw std::runtime_error(what + " '" + file + "' cannot be read: check its name and folder");
    files_.push_back(file);
    std::string text, whole;
    int line = 0, first = 0;
    while (std::getline(stream, text)) {
      line++;
      if (!text.empty() && text.back() == '\r') text.pop_back();
      if (whole.empty()) first = line;
      whole += without_comment(text);
      const std::size_t last = whole.find_last_not_of(" \t");
      if (last != std::string::npos && whole[last] == '&') {
        whole = whole.substr(0, last) + ' ';
        continue;
      }
      add({file, first, {}, line}, whole);
      whole.clear();
    }
    add({file, first, {}, line}, whole);
  }

  static std::string without_comment(const std::string& text) {
    char quote = 0;
    for (std::size_t k = 0; k < text.size(); k++) {
      if (quote ? text[k] == quote : text[k] == '"' || text[k] == '\'') quote = quote ? 0 : text[k];
      if (text[k] == '#' && !quote) return text.substr(0, k);
    }
    return text;
  }

  struct WrittenWord {
    std::string text;
    bool is_quoted;
  };

  /// Words; those in quotes are one, without the quotes.
  static std::vector<WrittenWord> words_of(const std::string& text) {
    std::vector<WrittenWord> words;
    std::size_t k = 0;
    while ((k = text.find_first_not_of(" \t", k)) != std::string::npos) {
      const bool quoted = text[k] == '"' || text[k] == '\'';
      const std::size_t begin = quoted ? k + 1 : k;
      const std::size_t end = quoted ? text.find(text[k], begin) : text.find_first_of(" \t", begin);
      words.push_back({text.substr(begin, end == std::string::npos ? end : end - begin), quoted});
      if (end == std::string::npos) break;
      k = quoted ? end + 1 : end;
    }
    return words;
  }

  /// As in LIGGGHTS, a variable may have several words, and quotes keep it from being replaced.
  void add(ScriptCommand command, const std::string& line) {
    for (const WrittenWord& written : words_of(line)) {
      const auto values = written.is_quoted ? std::vector<WrittenWord>{written}
                                            : words_of(substituted(written.text));
      for (const WrittenWord& value : values) {
        command.words.push_back(value.text);
        command.origins.push_back(command.written.size());
      }
      command.written.push_back(written.text);
    }
    if (command.words.empty()) return;
    if (command.words[0] == "variable") set_variable(command);
    if (command.words[0] == "include") {
      include(command);
      return;
    }
    commands_.push_back(std::move(command));
  }

  /// Relative to the folder of the script, or to that of the user.
  void include(const ScriptCommand& command) {
    const std::string& name = command.word(1, "the name of a file");
    if (++depth_ > deepest_include) command.fail("files include each other: remove this line");
    const std::size_t folder = command.file.find_last_of('/');
    const std::string beside =
        folder == std::string::npos ? name : command.file.substr(0, folder + 1) + name;
    read_file(name[0] != '/' && std::ifstream(beside) ? beside : name,
              command.place() + ": the file");
    depth_--;
  }

  void set_variable(const ScriptCommand& command) {
    if (command.words.size() < 3) return;
    const std::string &name = command.words[1], &style = command.words[2];
    if (style == "delete") fixed_.erase(name);
    if (fixed_.count(name)) return;
    if (style == "index" || style == "loop") {
      if (command.has(3)) values_.emplace(name, Variable{false, first_of(command)});
    } else if ((style == "equal" || style == "string") && command.has(3)) {
      std::string text = command.words[3];
      for (std::size_t k = 4; k < command.words.size(); k++) text += ' ' + command.words[k];
      values_[name] = {style == "equal", text};
    } else {
      values_.erase(name);
    }
  }
  /// First value of an index or a loop: N, N pad, N1 N2, N1 N2 pad. pad: leading zeros to the width
  /// of the last value.
  static std::string first_of(const ScriptCommand& command) {
    if (command.words[2] == "index") return command.words[3];
    const bool is_padded = command.words.back() == "pad";
    const std::size_t numbers = command.words.size() - 3 - (is_padded ? 1 : 0);
    const std::string first = numbers > 1 ? command.words[3] : "1";
    const std::string& last = command.words[numbers > 1 ? 4 : 3];
    const std::size_t width = is_padded ? last.size() : 0;
    return std::string(width > first.size() ? width - first.size() : 0, '0') + first;
  }

  /// An expression is evaluated with the values at its use. Empty: not known.
  std::optional<std::string> value_of(const std::string& name, int depth = 0) const {
    const auto found = values_.find(name);
    if (found == values_.end() || depth > deepest_expression) return {};
    if (!found->second.is_expression) return found->second.text;
    const auto value = ScriptExpression(found->second.text, [&](const std::string& other) {
                         const auto text = value_of(other, depth + 1);
                         return text ? ScriptCommand::number_of(*text) : std::nullopt;
                       }).value();
    return value ? std::optional(digits_of(*value)) : std::nullopt;
  }

  static std::string digits_of(double value) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
  }

  /// Unknown variables stay as they are.
  std::string substituted(const std::string& text) const {
    std::string result;
    for (std::size_t k = 0; k < text.size(); k++) {
      if (text[k] != '$' || k + 1 == text.size()) {
        result += text[k];
        continue;
      }
      const std::string name = ScriptCommand::variable_name(text, k);
      const std::size_t length = text[k + 1] == '{' ? name.size() + 3 : 2;
      result += value_of(name).value_or(text.substr(k, length));
      k += length - 1;
    }
    return result;
  }

  std::map<std::string, Variable> values_;
  std::set<std::string> fixed_;
  std::vector<ScriptCommand> commands_;
  std::vector<std::string> files_;
  int depth_ = 0;
};

}  // namespace cohesion::tools
