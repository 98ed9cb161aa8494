// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cohesion::tools {

/// Throws CLI::ArgumentMismatch for an option of `app`, or of its groups, that the command line
/// names twice: a list given twice would be taken for the sum of both.
inline void require_given_once(const CLI::App& app, int argc, char** argv) {
  for (const CLI::Option* option : app.get_options()) {
    int named = 0;
    for (int i = 1; i < argc; i++) {
      const std::string word(argv[i]);
      named += option->check_name(word.substr(0, word.find('=')));
    }
    if (named > 1) throw CLI::ArgumentMismatch(option->get_name() + ": given twice");
  }
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; }))
    if (group->get_name().empty()) require_given_once(*group, argc, argv);
}

}  // namespace cohesion::tools
