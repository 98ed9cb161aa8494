// SPDX-License-Identifier: GPL-2.0-or-later
#include "load_dem_engine.h"

#include <dlfcn.h>
#include <unistd.h>

#include "named_table.h"

namespace cohesion::coupling {

namespace {

std::string own_folder() {
  Dl_info info;
  if (!dladdr(reinterpret_cast<void*>(&load_dem_engine), &info)) return "";
  const std::string file = info.dli_fname;
  return file.substr(0, file.rfind('/') + 1);
}

void* symbol(void* handle, const char* name, const std::string& library) {
  if (void* found = dlsym(handle, name)) return found;
  throw DemEngineError("'" + library + "' is not a particle engine adapter: it has no symbol '" +
                       name + "'");
}

}  // namespace

const DemEngineRow& dem_engine(const std::string& name) {
  return find_by_name(dem_engines, "particle engine", name);
}

std::string dem_engine_library(const DemEngineRow& engine) {
  const std::string library = own_folder() + std::string(engine.library);
  if (access(library.c_str(), F_OK) == 0) return library;
  const std::string name(engine.name);
  throw DemEngineError("this build has no particle engine '" + name + "': there is no '" + library +
                       "'. Install its Debian package, cohesion-" + name +
                       ", or the engine (scripts/setup does), configure the package with -D" +
                       std::string(engine.option) +
                       "=ON and build it again, or name the file of "
                       "an adapter in the entry 'library' of " +
                       name + "Coeffs");
}

MakeDemEngine load_dem_engine(const std::string& library) {
  // Local scope: the symbols of an engine must not meet those of another library.
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle)
    throw DemEngineError("cannot load the particle engine adapter '" + library + "': " + dlerror() +
                         "; build the package with this engine, or name the adapter's file in the "
                         "entry 'library'");
  const auto interface =
      reinterpret_cast<DemEngineInterface>(symbol(handle, dem_engine_interface_symbol, library));
  if (interface() != dem_engine_interface)
    throw DemEngineError("'" + library + "' was built for version " + std::to_string(interface()) +
                         " of the engine interface, this program for version " +
                         std::to_string(dem_engine_interface) + "; build both from one source");
  return reinterpret_cast<MakeDemEngine>(symbol(handle, make_dem_engine_symbol, library));
}

}  // namespace cohesion::coupling
