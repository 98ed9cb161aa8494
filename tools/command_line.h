// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>

namespace cohesion::tools {

/// Throws CLI::ArgumentMismatch for an option of `app`, or of its groups, that the command line
/// names twice: a list given twice would be taken for the sum of both.
inline void reject_repeated_options(const CLI::App& app, int argc, char** argv) {
  for (const CLI::Option* option : app.get_options()) {
    int named = 0;
    for (int i = 1; i < argc; i++) {
      const std::string word(argv[i]);
      named += option->check_name(word.substr(0, word.find('=')));
    }
    if (named > 1) throw CLI::ArgumentMismatch(option->get_name() + ": given twice");
  }
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; }))
    if (group->get_name().empty()) reject_repeated_options(*group, argc, argv);
}

/// Calls run(). An exception is printed after the name of the program; returns the exit code.
template <class Run>
int exit_code_of(const char* program, Run run) {
  try {
    run();
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace cohesion::tools
