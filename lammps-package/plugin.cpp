// SPDX-License-Identifier: GPL-2.0-only
// Entry of the plugin: checks the engine's version, then registers every style of the package.

#include <array>
#include <cstring>
#include <sstream>
#include <string>

#include "error.h"
#include "fix_gas_coupling.h"
#include "fix_wall_hamaker.h"
#include "lammps.h"
#include "lammpsplugin.h"
#include "library.h"
#include "pair_hamaker.h"
#include "version.h"

using namespace LAMMPS_NS;

namespace {

constexpr std::array<const char*, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                             "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

/// 20210929 as "29 Sep 2021"
std::string version_name(int number) {
  const int month = number / 100 % 100;
  const bool known = month >= 1 && month <= 12;
  return std::to_string(number % 100) + " " + (known ? months[month - 1] : "?") + " " +
         std::to_string(number / 10000);
}

/// "29 Sep 2021" as 20210929
int version_number(const std::string& name) {
  std::istringstream words(name);
  int day = 0, year = 0;
  std::string month;
  words >> day >> month >> year;
  int m = 1;
  for (const char* candidate : months) {
    if (month == candidate) break;
    m++;
  }
  return (year * 100 + m) * 100 + day;
}

/// The layout of the engine's classes changes between versions. Only the engine's own C function is
/// safe to ask which one this is.
void refuse_other_version(void* lmp) {
  const int engine = lammps_version(lmp);
  if (engine == version_number(LAMMPS_VERSION)) return;
  static_cast<LAMMPS*>(lmp)->error->all(
      FLERR, "the COHESION plugin was built for LAMMPS " LAMMPS_VERSION
             " and cannot run in LAMMPS " +
                 version_name(engine) + "; build it against the engine that loads it");
}

template <class Style>
void* make_pair_style(void* lmp) {
  return new Style(static_cast<LAMMPS*>(lmp));
}

template <class Style>
void* make_fix_style(void* lmp, int narg, char** arg) {
  return new Style(static_cast<LAMMPS*>(lmp), narg, arg);
}

}  // namespace

extern "C" void lammpsplugin_init(void* lmp, void* handle, void* regfunc) {
  refuse_other_version(lmp);

  const auto register_style = reinterpret_cast<lammpsplugin_regfunc>(regfunc);
  lammpsplugin_t plugin{};
  plugin.version = LAMMPS_VERSION;
  plugin.author = "the COHESION package";
  plugin.handle = handle;

  plugin.style = "pair";
  plugin.name = "hamaker";
  plugin.info = "pair hamaker";
  plugin.creator.v1 = &make_pair_style<PairHamaker>;
  register_style(&plugin, lmp);

  plugin.style = "fix";
  plugin.name = "wall/hamaker";
  plugin.info = "fix wall/hamaker";
  plugin.creator.v2 = &make_fix_style<FixWallHamaker>;
  register_style(&plugin, lmp);

  plugin.name = "gas/coupling";
  plugin.info = "fix gas/coupling";
  plugin.creator.v2 = &make_fix_style<FixGasCoupling>;
  register_style(&plugin, lmp);
}
