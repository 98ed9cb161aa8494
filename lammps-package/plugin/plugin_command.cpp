// SPDX-License-Identifier: GPL-2.0-only
// The command `plugin load FILE ...` for a LAMMPS that was built without its PLUGIN package.
//
// LAMMPS calls LAMMPS::post_create() whenever its styles have been created: at the start and after
// `clear`. It does so through the dynamic linker, so the definition here, linked or preloaded in
// front of liblammps, comes first. It does the engine's own work, then adds the command.

#include <dlfcn.h>
#include <unistd.h>

#include <list>
#include <string>

#include "comm.h"
#include "command.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "input.h"
#include "lammps.h"
#include "lammpsplugin.h"
#include "modify.h"

using namespace LAMMPS_NS;

namespace {

std::list<lammpsplugin_t> loaded;  // of all LAMMPS instances: `clear` must not lose them

void add_style(const lammpsplugin_t& plugin, LAMMPS* lmp) {
  const std::string style = plugin.style;
  if (style == "pair")
    (*lmp->force->pair_map)[plugin.name] = reinterpret_cast<Force::PairCreator>(plugin.creator.v1);
  else if (style == "fix")
    (*lmp->modify->fix_map)[plugin.name] = reinterpret_cast<Modify::FixCreator>(plugin.creator.v2);
  else if (style == "compute")
    (*lmp->modify->compute_map)[plugin.name] =
        reinterpret_cast<Modify::ComputeCreator>(plugin.creator.v2);
  else if (style == "command")
    (*lmp->input->command_map)[plugin.name] =
        reinterpret_cast<Input::CommandCreator>(plugin.creator.v1);
  else
    lmp->error->all(FLERR, "plugin load: styles of kind '" + style +
                               "' cannot be added; only pair, fix, compute and command");
}

void register_style(lammpsplugin_t* plugin, void* lmp) {
  for (const auto& known : loaded)
    if (std::string(known.style) == plugin->style && std::string(known.name) == plugin->name)
      return;
  loaded.push_back(*plugin);
  add_style(*plugin, static_cast<LAMMPS*>(lmp));
}

std::string beside_this_library(const std::string& file) {
  Dl_info info;
  if (file.find('/') != std::string::npos ||
      !dladdr(reinterpret_cast<void*>(&register_style), &info))
    return file;
  const std::string self = info.dli_fname;
  return self.substr(0, self.rfind('/') + 1) + file;
}

class PluginCommand : public Command {
 public:
  explicit PluginCommand(LAMMPS* lammps) : Command(lammps) {}

  void command(int narg, char** arg) override {
    if (narg < 2 || std::string(arg[0]) != "load")
      error->all(FLERR, "this LAMMPS knows only 'plugin load FILE ...'");
    for (int i = 1; i < narg; i++) load(arg[i]);
  }

 private:
  void load(const std::string& file) {
    void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
    std::string reason = handle ? "" : dlerror();
    const std::string beside = beside_this_library(file);
    if (!handle && access(beside.c_str(), F_OK) == 0) {
      handle = dlopen(beside.c_str(), RTLD_NOW | RTLD_GLOBAL);
      if (!handle) reason = dlerror();
    }
    if (!handle)
      error->all(FLERR, "plugin load: cannot open '" + file + "': " + reason +
                            "; give the file's path, or its folder in LD_LIBRARY_PATH");
    void* init = dlsym(handle, "lammpsplugin_init");
    if (!init)
      error->all(FLERR, "plugin load: '" + file +
                            "' is not a LAMMPS plugin: it has no function lammpsplugin_init");
    reinterpret_cast<lammpsplugin_initfunc>(init)(lmp, handle,
                                                  reinterpret_cast<void*>(&register_style));
  }
};

Command* make_plugin_command(LAMMPS* lmp) { return new PluginCommand(lmp); }

}  // namespace

void LAMMPS::post_create() {
  using PostCreate = void (*)(LAMMPS*);
  // The mangled name is that of this very function.
  static const auto engine_own =
      reinterpret_cast<PostCreate>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  if (!engine_own)
    error->all(FLERR, "the library that adds 'plugin load' must come before liblammps");
  engine_own(this);

  (*input->command_map)["plugin"] = &make_plugin_command;
  for (const auto& plugin : loaded) add_style(plugin, this);
}
