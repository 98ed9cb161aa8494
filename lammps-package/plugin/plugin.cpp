// SPDX-License-Identifier: GPL-2.0-only
// What `plugin load` opens: compares the engine's version with the one the styles were built for,
// then loads the styles from the file beside this one.
//
// An engine of another version lacks C++ symbols that the styles need, so that a file with the
// styles could not even be opened there and nobody would learn why. This one therefore needs
// nothing of the engine but its C functions.

#include <dlfcn.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "lammpsplugin.h"
#include "library.h"
#include "version.h"

namespace {

constexpr const char* styles_file = "cohesion-styles.so";
constexpr const char* styles_function = "cohesion_register_styles";

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

/// The engine's Error::all, in the spelling that this engine has. The C functions have no
/// counterpart that ends the run in every version.
[[noreturn]] void stop(void* lmp, const std::string& message) {
  // Memory and Error have been the first two members of class LAMMPS in all versions.
  void* const error = static_cast<void**>(lmp)[1];
  const std::string file = "cohesionplugin";
  constexpr int no_pointer_into_the_input_line = -2;

  using AllSince2024 = void (*)(void*, const std::string&, int, int, const std::string&);
  using All = void (*)(void*, const std::string&, int, const std::string&);
  if (void* all = dlsym(
          RTLD_DEFAULT,
          "_ZN9LAMMPS_NS5Error3allERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEiiS8_"))
    reinterpret_cast<AllSince2024>(all)(error, file, 0, no_pointer_into_the_input_line, message);
  if (void* all = dlsym(
          RTLD_DEFAULT,
          "_ZN9LAMMPS_NS5Error3allERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEiS8_"))
    reinterpret_cast<All>(all)(error, file, 0, message);

  std::fprintf(stderr, "ERROR: %s\n", message.c_str());
  lammps_command(lmp, "quit 1");
  std::abort();
}

void refuse_other_version(void* lmp) {
  const int engine = lammps_version(lmp);
  if (engine == version_number(LAMMPS_VERSION)) return;
  stop(lmp, "the COHESION plugin was built for LAMMPS " LAMMPS_VERSION
            " and cannot run in LAMMPS " +
                version_name(engine) + "; build it against the engine that loads it");
}

std::string file_beside_this_one(const char* name) {
  Dl_info info;
  if (!dladdr(reinterpret_cast<void*>(&file_beside_this_one), &info)) return name;
  const std::string self = info.dli_fname;
  return self.substr(0, self.rfind('/') + 1) + name;
}

}  // namespace

extern "C" void lammpsplugin_init(void* lmp, void* handle, void* register_style) {
  refuse_other_version(lmp);

  const std::string file = file_beside_this_one(styles_file);
  void* const styles = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!styles)
    stop(lmp, "the COHESION plugin cannot open the file with its styles: " +
                  std::string(dlerror()) + "; it must stand beside the plugin");
  void* const register_all = dlsym(styles, styles_function);
  if (!register_all)
    stop(lmp, "'" + file + "' is not of the COHESION package: it has no function " +
                  styles_function + "; put the one that was built with the plugin there");
  reinterpret_cast<lammpsplugin_initfunc>(register_all)(lmp, handle, register_style);
}
