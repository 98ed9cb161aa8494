# SPDX-License-Identifier: BSD-3-Clause
"""Command line of the programs that measure (benchmarks): `LMP_WITH_PLUGIN_COMMAND PLUGIN [options]`, and of
those that know LIGGGHTS too, `LIGGGHTS_COHESION [options]`; of those that run coupled cases, `BUILD WORK [options]`."""
import argparse
import os

from cohesion_tests import csv_table
from cohesion_tests.launcher import given_program
from cohesion_tests.liggghts import SCENES as LIGGGHTS_SCENES


def words(description, *options, liggghts=False):
    """What the command line says. `options`: name and keywords of argparse's add_argument, each; `liggghts`:
    whether a LIGGGHTS is taken as well, which has no plugin. Names the engine to lammps.py."""
    parser = argparse.ArgumentParser(description=description,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lmp", type=given_program,
                        help="program that knows `plugin load`" + (", or liggghts-cohesion" if liggghts else ""))
    parser.add_argument("plugin", type=given_program, help="plugin built for it; of liggghts-cohesion none",
                        **({"nargs": "?"} if liggghts else {}))
    for name, keywords in options:
        parser.add_argument(name, **keywords)
    given = parser.parse_args()
    os.environ["COHESION_LMP"] = given.lmp
    if given.plugin:
        os.environ["COHESION_PLUGIN"] = given.plugin
    else:
        os.environ["COHESION_SCRIPTS"] = str(LIGGGHTS_SCENES)
    return given


def coupling_parser(description, table=False):
    """A parser for the programs that run coupled cases: `BUILD WORK [options]`. `table`: with the option --csv."""
    parser = argparse.ArgumentParser(description=description,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="build folder of the package")
    parser.add_argument("work", help="folder for the cases")
    if table:
        csv_table.add_to(parser)
    return parser
