// SPDX-License-Identifier: BSD-3-Clause
// cohesion-mapping: square wells and Hamaker attractions of equal head-on escape velocity, and the
// numbers of Hertz's and JKR's contact.
// Manual: docs/tools/cohesion-mapping.md

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "advice/law_mapping.h"
#include "cohesion_version.h"
#include "command_line.h"
#include "contact/contact_parameters.h"
#include "elastic_numbers.h"
#include "former_names.h"
#include "hamaker/roughness.h"
#include "named_table.h"
#include "square_well/parameters.h"

namespace {

using namespace cohesion;

/// What the command line says.
struct MappingRequest {
  std::vector<double> radii, densities, masses;
  bool wall = false;
  double stiffness = 0.0, restitution = 0.0, damping = 0.0;
  std::vector<double> cutoffs, roughness;
  double asperity = 0.0, ratio = 1.01;
  std::string form = "small_gap", hamaker_scheme = "exact", well_scheme = "exact";
  double step = 0.0;
  std::vector<double> hamaker_constants, depths;
  bool has_damping = false, csv = false;
};

struct MappingRow {
  double hamaker_constant, depth;
  double force;  ///< F_ad of the Hamaker attraction
  advice::SampledEscape hamaker, well;
};

/// Of two particles the second value, or the only one.
double second(const std::vector<double>& values) { return values.back(); }

double mass(const MappingRequest& r, double radius, bool of_second) {
  const auto& given = r.masses.empty() ? r.densities : r.masses;
  const double value = of_second ? second(given) : given.front();
  require_positive(r.masses.empty() ? "density" : "mass", value);
  return r.masses.empty() ? value * sphere_volume(radius) : value;
}

/// Throws InvalidParameter for a second particle where there is none.
void require_one_at_wall(const MappingRequest& r) {
  for (const auto* values : {&r.radii, &r.densities, &r.masses})
    require(!r.wall || values->size() < 2, "second particle",
            values->empty() ? 0.0 : values->back(),
            "there is none beside a --wall: give one radius and one density or mass");
}

/// Throws InvalidParameter for what would have no effect.
void require_used(const MappingRequest& r) {
  require_one_at_wall(r);
  require(r.step == 0.0 || r.hamaker_scheme == "sampled" || r.well_scheme == "sampled",
          "time step (--step)", r.step,
          "scheme exact is the same at any step: leave it out, or choose sampled for a law");
}

PairGeometry geometry_of(const MappingRequest& r) {
  const double ri = r.radii.front(), rj = second(r.radii);
  require_positive("radius", ri);
  require_positive("radius", rj);
  return r.wall ? sphere_and_plane(ri) : two_spheres(ri, rj);
}

double reduced_mass_of(const MappingRequest& r) {
  const double mi = mass(r, r.radii.front(), false);
  return r.wall ? mi : reduced_mass(mi, mass(r, second(r.radii), true));
}

advice::HeadOnPair pair_of(const MappingRequest& r) {
  const double ri = r.radii.front(), rj = second(r.radii);
  const PairGeometry geometry = geometry_of(r);
  const double mu = reduced_mass_of(r);
  contact::ContactParameters parameters;
  parameters.stiffness = r.stiffness;
  parameters.restitution = r.restitution;
  if (r.has_damping) {
    require_non_negative("damping", r.damping);
    parameters.damping = r.damping;
  }
  contact::require_valid(parameters);
  return {contact::normal_contact(parameters, mu), geometry, r.wall ? ri : ri + rj};
}

advice::HamakerKind kind_of(const MappingRequest& r) {
  const hamaker::Asperity asperity = hamaker::asperity_of(r.asperity, r.roughness);
  return {&find_by_name(hamaker::forms, "form", r.form), r.cutoffs.at(0), r.cutoffs.at(1),
          asperity.radius, asperity.height};
}

class Mapping {
 public:
  explicit Mapping(const MappingRequest& r)
      : pair_(pair_of(r)),
        kind_(kind_of(r)),
        hamaker_step_(step(r.hamaker_scheme, r)),
        well_step_(step(r.well_scheme, r)) {
    const square_well::SquareWellParameters well = square_well::well(0.0, r.ratio);
    square_well::require_valid(well);
    width_ = square_well::width(well, r.radii.front(), r.wall ? 0.0 : second(r.radii));
  }

  const advice::HeadOnPair& pair() const { return pair_; }

  MappingRow to_well(double hamaker_constant) const {
    require_positive("Hamaker constant A", hamaker_constant);
    const auto hamaker = advice::hamaker_escape(pair_, kind_.law(hamaker_constant), hamaker_step_);
    const double depth = advice::depth_of(pair_, hamaker.mean, width_, well_step_);
    return row(hamaker_constant, depth, hamaker,
               advice::well_escape(pair_, depth, width_, well_step_));
  }

  MappingRow to_hamaker(double depth) const {
    require_positive("depth D", depth);
    const auto well = advice::well_escape(pair_, depth, width_, well_step_);
    const double a = advice::hamaker_constant_of(pair_, well.mean, kind_, hamaker_step_);
    return row(a, depth, advice::hamaker_escape(pair_, kind_.law(a), hamaker_step_), well);
  }

 private:
  static std::optional<double> step(const std::string& scheme, const MappingRequest& r) {
    if (scheme == "exact") return std::nullopt;
    require_positive("time step of scheme sampled (--step)", r.step);
    return r.step;
  }

  MappingRow row(double hamaker_constant, double depth, const advice::SampledEscape& hamaker,
                 const advice::SampledEscape& well) const {
    const double force = advice::adhesion_of(pair_, kind_.law(hamaker_constant)).force;
    return {hamaker_constant, depth, force, hamaker, well};
  }

  advice::HeadOnPair pair_;
  advice::HamakerKind kind_;
  std::optional<double> hamaker_step_, well_step_;
  double width_;
};

void print_csv(const std::vector<MappingRow>& rows) {
  std::puts(
      "hamaker_constant,depth,adhesion_force,hamaker_mean,hamaker_slowest_parted,"
      "hamaker_fastest_stuck,well_mean,well_slowest_parted,well_fastest_stuck");
  for (const MappingRow& r : rows)
    std::printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", r.hamaker_constant,
                r.depth, r.force, r.hamaker.mean, r.hamaker.slowest_parted, r.hamaker.fastest_stuck,
                r.well.mean, r.well.slowest_parted, r.well.fastest_stuck);
}

/// What a LAMMPS script says for both laws of a row.
void print_coefficients(const MappingRequest& request, const advice::HeadOnPair& pair,
                        const MappingRow& r) {
  char contact[80], hamaker[160], rough[80], well[80];
  std::snprintf(contact, sizeof contact, "stiffness %.9g damping %.9g", pair.spring.stiffness(),
                pair.spring.damping());
  if (request.roughness.empty())
    std::snprintf(rough, sizeof rough, "asperity %.9g", request.asperity);
  else
    std::snprintf(rough, sizeof rough, "roughness %.9g %.9g", request.roughness[0],
                  request.roughness[1]);
  std::snprintf(hamaker, sizeof hamaker, "hamaker %.9g cutoff %.9g %.9g %s", r.hamaker_constant,
                request.cutoffs[0], request.cutoffs[1], rough);
  std::snprintf(well, sizeof well, "well %.9g %.9g", r.depth, request.ratio);
  const auto print = [&](const char* law, const char* cohesion, const std::string& settings) {
    if (request.wall)
      std::printf("fix         wall all wall/gran/%s %s %s zplane 0 NULL %s\n", law, contact,
                  cohesion, settings.c_str());
    else
      std::printf("pair_style  gran/%s %s\npair_coeff  * * %s %s\n", law, settings.c_str(), contact,
                  cohesion);
  };
  print("hamaker", hamaker, "scheme " + request.hamaker_scheme + " form " + request.form);
  print("square_well", well, "scheme " + request.well_scheme);
}

void print_text(const MappingRequest& request, const advice::HeadOnPair& pair,
                const std::vector<MappingRow>& rows) {
  const auto& spring = pair.spring;
  std::printf("restitution %.9g, contact time %.9g, reduced mass %.9g\n", spring.restitution(),
              spring.contact_time(), spring.reduced_mass());
  std::puts("head-on escape velocity: mean (slowest that parted to fastest that stuck)\n");
  std::printf("%-13s%-13s%-13s%-40s%s\n", "A", "D", "F_ad",
              ("Hamaker, " + request.hamaker_scheme).c_str(),
              ("square well, " + request.well_scheme).c_str());
  const auto escape = [](const advice::SampledEscape& e, const std::string& scheme) {
    char text[80];
    if (scheme == "exact")
      std::snprintf(text, sizeof text, "%.6g", e.mean);
    else
      std::snprintf(text, sizeof text, "%.4g (%.4g to %.4g)", e.mean, e.slowest_parted,
                    e.fastest_stuck);
    return std::string(text);
  };
  for (const MappingRow& r : rows)
    std::printf("%-12.6g %-12.6g %-12.6g %-39s %s\n", r.hamaker_constant, r.depth, r.force,
                escape(r.hamaker, request.hamaker_scheme).c_str(),
                escape(r.well, request.well_scheme).c_str());
  for (const MappingRow& r : rows) {
    std::puts("");
    print_coefficients(request, pair, r);
  }
}

/// What a scheme is called now; a former name is warned of once.
std::string current_scheme(const std::string& name) {
  return current_name("scheme", name, [](const std::string& sentence) {
    static std::set<std::string> given;
    if (given.insert(sentence).second) std::cerr << "cohesion-mapping: " << sentence << '\n';
  });
}

void add_particles(CLI::App& app, MappingRequest& r) {
  auto* radius = app.add_option("--radius", r.radii, "radius, of two unlike spheres both [length]");
  radius->required()->expected(1, 2);
  app.add_flag("--wall", r.wall, "the partner is a plane wall");
  auto* material = app.add_option_group("material");
  material->add_option("--density", r.densities, "density, or both [mass/length^3]")
      ->expected(1, 2);
  material->add_option("--mass", r.masses, "mass in place of it, or both [mass]")->expected(1, 2);
  material->require_option(1);
  app.add_flag("--csv", r.csv, "comma-separated values with all digits");
}

void add_options(CLI::App& app, MappingRequest& r) {
  const auto schemes = CLI::IsMember({"exact", "sampled"});
  std::vector<std::string> forms;
  for (const auto& form : hamaker::forms) forms.emplace_back(form.name);

  add_particles(app, r);
  app.add_option("--stiffness", r.stiffness, "K of the contact [force/length]")->required();
  auto* loss = app.add_option_group("loss");
  loss->add_option("--restitution", r.restitution, "e of a contact without cohesion");
  loss->add_option("--damping", r.damping, "dashpot eta in place of it [mass/time]")
      ->each([&r](const std::string&) { r.has_damping = true; });
  loss->require_option(1);
  app.add_option("--cutoff", r.cutoffs, "surface and outer cut-off H_cut H_out [length]")
      ->required()
      ->expected(2);
  app.add_option("--form", r.form, "of the attraction")
      ->check(CLI::IsMember(forms))
      ->capture_default_str();
  auto* asperity =
      app.add_option("--asperity", r.asperity, "radius of asperities, 0: smooth [length]")
          ->capture_default_str();
  app.add_option("--roughness", r.roughness,
                 "rms and wavelength of the surface, in place of it [length]")
      ->expected(2)
      ->excludes(asperity);
  app.add_option("--ratio", r.ratio, "r_out/r of the well")->capture_default_str();
  app.add_option("--hamaker-scheme", r.hamaker_scheme, "scheme of the Hamaker law")
      ->check(schemes)
      ->transform(current_scheme)
      ->capture_default_str();
  app.add_option("--well-scheme", r.well_scheme, "scheme of the well")
      ->check(schemes)
      ->transform(current_scheme)
      ->capture_default_str();
  app.add_option("--step", r.step, "time step of scheme sampled [time]");
}

void print_mapping(const MappingRequest& request) {
  require_used(request);
  const Mapping mapping(request);
  std::vector<MappingRow> rows;
  for (const double a : request.hamaker_constants) rows.push_back(mapping.to_well(a));
  for (const double d : request.depths) rows.push_back(mapping.to_hamaker(d));
  if (request.csv)
    print_csv(rows);
  else
    print_text(request, mapping.pair(), rows);
}

}  // namespace

int main(int argc, char** argv) {
  MappingRequest request;
  CLI::App app{
      "Square wells and Hamaker attractions of equal head-on escape velocity, and the numbers of\n"
      "Hertz's and JKR's contact.\n"
      "Any consistent set of units. Manual: docs/tools/cohesion-mapping.md"};
  app.set_version_flag("--version", "cohesion-mapping, Cohesion " COHESION_VERSION);
  app.require_subcommand(1);
  CLI::App* to_well = app.add_subcommand("to-well", "depth D of the well for Hamaker constants");
  add_options(*to_well, request);
  to_well->add_option("--hamaker", request.hamaker_constants, "Hamaker constants A [energy]")
      ->required();
  CLI::App* to_hamaker = app.add_subcommand("to-hamaker", "Hamaker constant A for depths");
  add_options(*to_hamaker, request);
  to_hamaker->add_option("--depth", request.depths, "depths D of wells [energy]")->required();
  tools::ElasticRequest elastic;
  CLI::App* of_contact =
      app.add_subcommand("contact", "numbers of Hertz's and JKR's contact, and of a softer one");
  add_particles(*of_contact, request);
  tools::add_options(*of_contact, elastic);
  try {
    app.parse(argc, argv);
    for (const CLI::App* way : app.get_subcommands())
      tools::reject_repeated_options(*way, argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }

  return tools::exit_code_of("cohesion-mapping", [&] {
    if (of_contact->parsed()) {
      require_one_at_wall(request);
      tools::ElasticNumbers(elastic, geometry_of(request), reduced_mass_of(request))
          .print(request.csv);
    } else {
      print_mapping(request);
    }
  });
}
