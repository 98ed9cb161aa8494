// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine_screen.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace cohesion::coupling {

namespace {

constexpr std::string_view error_word = "ERROR", warning_word = "WARNING";
/// The number of different texts, as many as LAMMPS itself shows.
constexpr std::size_t most_warnings = 100;

bool begins(std::string_view text, std::string_view word) {
  return text.substr(0, word.size()) == word;
}

/// The text from the first line that begins with one of the words to the end, without blanks there.
std::string_view message_in(std::string_view printed) {
  while (!begins(printed, error_word) && !begins(printed, warning_word)) {
    const auto end = printed.find('\n');
    if (end == std::string_view::npos) return {};
    printed.remove_prefix(end + 1);
  }
  return printed.substr(0, printed.find_last_not_of(" \t\n") + 1);
}

}  // namespace

EngineScreen::EngineScreen(OnMessage on_message) : on_message_(std::move(on_message)) {
  cookie_io_functions_t functions{};
  functions.write = [](void* screen, const char* text, std::size_t size) {
    static_cast<EngineScreen*>(screen)->read({text, size});
    return static_cast<ssize_t>(size);
  };
  stream_ = fopencookie(this, "w", functions);
  if (!stream_) throw std::system_error(errno, std::generic_category(), "screen of the engine");
  // The engines print a message with one call. Without a buffer it comes in one piece and at once:
  // after an error on one rank nothing is flushed.
  std::setvbuf(stream_, nullptr, _IONBF, 0);
}

void EngineScreen::read(std::string_view printed) {
  const std::string text(message_in(printed));
  if (begins(text, error_word)) {
    has_shown_error_ = true;
    on_message_(MessageLevel::error, text);
  } else if (!text.empty()) {
    warn(text);
  }
}

void EngineScreen::warn(const std::string& text) {
  if (warnings_.size() > most_warnings || !warnings_.insert(text).second) return;
  on_message_(MessageLevel::warning,
              warnings_.size() <= most_warnings
                  ? text
                  : "more than " + std::to_string(most_warnings) +
                        " different warnings; the others are in its log alone");
}

}  // namespace cohesion::coupling
