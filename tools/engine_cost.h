// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>

namespace cohesion::tools {

/// What LAMMPS with this package takes for a packing, measured in a run of its own.
class EngineCost {
 public:
  /// `program`: LAMMPS that knows `plugin`, by its path or by its name on the PATH; `plugin`: file
  /// of this package's plugin, as a script names it.
  EngineCost(std::string program, std::string plugin)
      : program_(from_anywhere(program)), plugin_(from_anywhere(plugin)) {}

  /// Seconds per grain and step of a simple cubic packing in which each grain presses on six, of
  /// spheres of this diameter [m] and density [kg/m3] with these lines of pair style and
  /// coefficients; nothing: the program could not be started or failed, and what it said is in
  /// said().
  std::optional<double> seconds(double diameter, double density, const std::string& pair_lines,
                                double step) {
    namespace fs = std::filesystem;
    std::string folder = fs::temp_directory_path() / "cohesion-powder-XXXXXX";
    if (!mkdtemp(folder.data())) return std::nullopt;
    std::ofstream(folder + "/in.cost") << script(diameter, density, pair_lines, step);
    const std::string command = "cd '" + folder + "' && '" + program_ +
                                "' -in in.cost -log none > out.cost 2>&1 < /dev/null";
    const bool ran = std::system(command.c_str()) == 0;
    std::stringstream output;
    output << std::ifstream(folder + "/out.cost").rdbuf();
    said_ = output.str();
    fs::remove_all(folder);
    std::smatch found;
    if (!ran || !std::regex_search(said_, found, std::regex("Loop time of ([0-9.e+-]+)")))
      return std::nullopt;
    return std::stod(found[1]) / (grains * steps);
  }

  const std::string& said() const { return said_; }

 private:
  /// A path that is one from another folder, too; a name without a folder stays as it is.
  static std::string from_anywhere(const std::string& file) {
    return file.find('/') == std::string::npos ? file : std::filesystem::absolute(file).string();
  }

  static constexpr int edge = 16, grains = edge * edge * edge, steps = 200;

  std::string script(double diameter, double density, const std::string& pair_lines,
                     double step) const {
    std::ostringstream text;
    text.precision(9);
    text << "plugin load " << plugin_
         << "\nunits si\natom_style sphere\nboundary p p p\nnewton off\ncomm_modify vel yes\n"
         << "lattice sc " << 0.999 * diameter << "\nregion box block 0 " << edge << " 0 " << edge
         << " 0 " << edge << "\ncreate_box 1 box\ncreate_atoms 1 box\nset group all diameter "
         << diameter << " density " << density << "\n"
         << pair_lines << "neighbor " << 0.1 * diameter << " bin\ntimestep " << step
         << "\nfix move all nve/sphere\nrun " << steps << "\n";
    return text.str();
  }

  std::string program_, plugin_, said_;
};

}  // namespace cohesion::tools
