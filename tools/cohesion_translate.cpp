// SPDX-License-Identifier: BSD-3-Clause
// cohesion-translate: what the cohesion of a script of LIGGGHTS amounts to.
// Manual: docs/tools/cohesion-translate.md
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "advice/advised_step.h"
#include "cohesion_version.h"
#include "command_line.h"
#include "script_case.h"
#include "script_contact.h"
#include "script_reader.h"
#include "script_report.h"
#include "script_run.h"
#include "script_text.h"
#include "script_translation.h"
#include "script_warnings.h"

namespace {

using namespace cohesion;
using namespace cohesion::tools;

struct TranslateRequest {
  std::string script;
  std::vector<std::string> variables;  // name, value, name, value
  double speed = 0.0, diameter = 0.0, density = 0.0;
  std::vector<std::string> write;  // what is kept, and a file
  Translation translation;
  bool csv = false;
};

void add_options_of_writing(CLI::App& app, TranslateRequest& r) {
  auto* write = app.add_option("--write", r.write,
                               "script with a law of this package in place of sjkr and sjkr2: "
                               "equal-force or equal-velocity, and a file")
                    ->type_name("RULE FILE")
                    ->expected(2);
  app.add_option("--law", r.translation.law, "of this script")
      ->check(CLI::IsMember({"hamaker", "jkr"}))
      ->capture_default_str()
      ->needs(write);
  app.add_option("--cutoff", r.translation.cutoffs,
                 "H_cut and H_out of hamaker, in the units of the script; default: 4e-10 1e-7 m; "
                 "none for units lj")
      ->check(CLI::PositiveNumber)
      ->expected(2)
      ->needs(write);
}

void add_options(CLI::App& app, TranslateRequest& r) {
  app.add_option("SCRIPT", r.script, "of LIGGGHTS")->required();
  app.add_option("--var", r.variables, "name and value of a variable, as often as needed")
      ->type_name("NAME VALUE")
      ->expected(2, 1000);
  app.add_option("--speed", r.speed,
                 "of impacts; default: of the fastest insertion, or 1 m/s; none for units lj")
      ->check(CLI::PositiveNumber);
  auto* diameter = app.add_option("--diameter", r.diameter, "of grains whose size the script lacks")
                       ->check(CLI::PositiveNumber);
  auto* density =
      app.add_option("--density", r.density, "of these grains")->check(CLI::PositiveNumber);
  diameter->needs(density);
  density->needs(diameter);
  add_options_of_writing(app, r);
  app.add_flag("--csv", r.csv, "comma-separated values with all digits");
}

std::map<std::string, std::string> variables_of(const TranslateRequest& r) {
  if (r.variables.size() % 2 != 0)
    throw std::runtime_error("--var has a name without a value: write --var NAME VALUE");
  std::map<std::string, std::string> values;
  for (std::size_t k = 0; k < r.variables.size(); k += 2)
    values[r.variables[k]] = r.variables[k + 1];
  return values;
}

/// Throws std::runtime_error: units without a length in metres have no defaults.
[[noreturn]] void require_in_units(const ScriptCase& script, const std::string& what_and_cure) {
  throw std::runtime_error("units " + script.unit_name() + " have no " + what_and_cure);
}

/// assumed [length/time]: of impacts, where neither script nor command line has a speed.
FastestSphere fastest_of(const TranslateRequest& r, const ScriptRun& run, double assumed) {
  if (r.speed > 0.0) return {advice::fastest_over_impact * r.speed, "three times --speed"};
  const double insertion = run.insertion_speed().value_or(0.0), fall = run.fall_speed();
  std::vector<std::string> origins;
  if (insertion > 0.0) origins.push_back("insertion");
  if (fall > 0.0) origins.push_back("fall through the box");
  if (origins.empty())
    return {advice::fastest_over_impact * assumed,
            "three times the assumed speed: specify --speed"};
  return {std::hypot(insertion, fall), joined(origins, " and ")};
}

ContactConditions conditions_of(const TranslateRequest& r, const ScriptCase& script) {
  ContactConditions conditions{};
  const advice::SiUnits* units = script.units();
  const ScriptRun& run = script.run();
  conditions.is_speed_assumed = !(r.speed > 0.0) && !run.insertion_speed();
  conditions.is_gravity_assumed = !run.gravity();
  if (!units && conditions.is_speed_assumed)
    require_in_units(script, "speed in metres per second: specify --speed");
  if (!units && conditions.is_gravity_assumed)
    require_in_units(script,
                     "acceleration in metres per second squared: add 'fix ID all gravity ...'");
  const double metre = units ? 1.0 / units->length : 1.0, second = units ? 1.0 / units->time : 1.0;
  conditions.speed = r.speed > 0.0 ? r.speed : run.insertion_speed().value_or(metre / second);
  conditions.gravity = run.gravity().value_or(9.81 * metre / (second * second));
  conditions.step = run.step().value_or(0.0);
  if (!(conditions.gravity > 0.0))
    throw std::runtime_error(
        "fix gravity has no acceleration above 0, so that there is no Bond number: specify one");
  conditions.gravity_of_run = run.gravity().value_or(0.0);
  conditions.fastest = fastest_of(r, run, conditions.speed);
  return conditions;
}

/// Throws std::runtime_error with the line of the model where a value is outside its range.
ScriptContact contact_of(const ScriptCase& script, const GranularModel& model,
                         const PairOfScript& pair) {
  try {
    return {script, model, pair};
  } catch (const InvalidParameter& error) {
    model.where.fail("types " + std::to_string(pair.i) + " and " + std::to_string(pair.j) + ": " +
                     error.what());
  }
}

std::vector<ContactPairOfTypes> contacts_of(const ScriptCase& script) {
  std::vector<ContactPairOfTypes> contacts;
  const auto& grains = script.grains();
  for (auto a = grains.begin(); script.pairs() && a != grains.end(); ++a)
    for (auto b = a; b != grains.end(); ++b) {
      const int i = a->first, j = b->first;
      const auto of = [&](const ScriptGrain& one, const ScriptGrain& other) {
        return contact_of(script, *script.pairs(), {i, j, one, other});
      };
      contacts.push_back({"types " + std::to_string(i) + " and " + std::to_string(j),
                          std::to_string(i) + '-' + std::to_string(j), &*script.pairs(), i, j,
                          of(a->second.smallest, b->second.smallest),
                          of(a->second.median, b->second.median)});
    }
  for (const WallOfScript& wall : script.walls())
    for (const auto& [i, g] : grains) {
      const auto of = [&, type = i](const ScriptGrain& one) {
        return contact_of(script, wall.model, {type, wall.type, one, {}});
      };
      contacts.push_back({"type " + std::to_string(i) + " and wall '" + wall.id + "' of type " +
                              std::to_string(wall.type),
                          std::to_string(i) + "-" + wall.id, &wall.model, i, wall.type,
                          of(g.smallest), of(g.median)});
    }
  return contacts;
}

/// Throws std::runtime_error if the target is one of the files, also by another path or a link.
void refuse_to_replace(const std::vector<std::string>& files, const std::string& target) {
  for (const std::string& file : files) {
    std::error_code is_missing;
    if (std::filesystem::equivalent(file, target, is_missing))
      throw std::runtime_error(
          "--write would replace " +
          (file == files.front() ? "the script" : "the included file '" + file + "'") +
          ": specify another file");
  }
}

/// Throws std::runtime_error unless the rule is known and cutoffs are specified or in metres.
Translation translation_of(const TranslateRequest& r, const ScriptCase& script, double gravity) {
  Translation t = r.translation;
  t.gravity = gravity;
  const advice::SiUnits* units = script.units();
  if (t.law == "hamaker" && t.cutoffs.empty()) {
    if (!units) require_in_units(script, "length in metres: specify --cutoff");
    t.cutoffs = {4e-10 / units->length, 1e-7 / units->length};
  }
  t.keeps_velocity = r.write[0] == "equal-velocity";
  if (!t.keeps_velocity && r.write[0] != "equal-force")
    throw std::runtime_error("--write " + r.write[0] +
                             ": write equal-force or equal-velocity, then the name of a file");
  return t;
}

void warn(const std::vector<std::string>& texts) {
  for (const std::string& text : texts)
    std::cerr << "cohesion-translate: WARNING: " << text << '\n';
}

/// Adds the grains of the command line. Throws std::runtime_error where contacts or sizes lack.
void require_contacts(const TranslateRequest& r, ScriptCase& script) {
  if (!script.pairs() && script.walls().empty())
    throw std::runtime_error(r.script +
                             ": has neither 'pair_style gran' nor 'fix wall/gran': name the script "
                             "that sets the contacts");
  if (r.diameter > 0.0) script.add_grains({0.5 * r.diameter, r.density});
  if (script.grains().empty())
    throw std::runtime_error(r.script +
                             ": has no particle template and no 'set' of diameter and density: "
                             "specify --diameter and --density");
}

void run(const TranslateRequest& r) {
  ScriptReader reader(variables_of(r));
  const std::vector<ScriptCommand>& commands = reader.read(r.script);
  ScriptCase script(commands);
  require_contacts(r, script);
  const ContactConditions conditions = conditions_of(r, script);
  ScriptReport report(conditions, r.csv);
  ScriptWarnings warnings(script, conditions);
  warnings.check_script();
  const std::vector<ContactPairOfTypes> contacts = contacts_of(script);
  std::set<std::string> evaluated;  // a wall may be defined again
  for (const ContactPairOfTypes& contact : contacts) {
    if (!evaluated.insert(contact.title + contact.model->words()).second) continue;
    report.add(contact);
    warnings.check_contact(contact);
  }
  report.print();
  warn(warnings.texts());
  if (r.write.empty()) return;
  refuse_to_replace(reader.files(), r.write[1]);
  TranslatedScript translated(r.script, script, translation_of(r, script, conditions.gravity),
                              conditions);
  for (const ContactPairOfTypes& contact : contacts) translated.add(contact);
  translated.write(r.write[1], commands);
  warn(translated.warnings());
  std::cerr << "cohesion-translate: wrote " << r.write[1]
            << "; run it with liggghts-cohesion, and check its strength with cohesion-translate\n";
}

}  // namespace

int main(int argc, char** argv) {
  TranslateRequest request;
  CLI::App app{
      "Strength of the cohesion that a script of LIGGGHTS specifies, in its units.\n"
      "Manual: docs/tools/cohesion-translate.md"};
  app.set_version_flag("--version", "cohesion-translate, Cohesion " COHESION_VERSION);
  add_options(app, request);
  CLI11_PARSE(app, argc, argv);
  return cohesion::tools::exit_code_of("cohesion-translate", [&] { run(request); });
}
