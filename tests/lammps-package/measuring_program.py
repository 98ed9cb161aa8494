# SPDX-License-Identifier: BSD-3-Clause
"""Command line of the programs here that measure: `LMP_WITH_PLUGIN_COMMAND PLUGIN [options]`."""
import argparse
import os


def words(description, *options):
    """What the command line says. `options`: name and keywords of argparse's add_argument, each.
    Names the engine to lammps_engine, which is to be imported after this."""
    parser = argparse.ArgumentParser(description=description,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lmp", help="program that knows `plugin load`")
    parser.add_argument("plugin", help="plugin built for it")
    for name, keywords in options:
        parser.add_argument(name, **keywords)
    given = parser.parse_args()
    os.environ.update(COHESION_LMP=given.lmp, COHESION_PLUGIN=given.plugin, OMP_NUM_THREADS="1")
    return given
