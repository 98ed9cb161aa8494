# SPDX-License-Identifier: BSD-3-Clause
"""What the programs of all examples share: words of the command line, the table they leave, how they end."""

import argparse
import sys
from pathlib import Path

from cohesion_studies import package_tree
from cohesion_studies.job_pool import cores


def one_or_more(text):
    """A whole number, for argparse."""
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{number}: it must be 1 or more")
    return number


def folder_words(parser, out, of="runs and results"):
    """--out and --build; `out`: what --out is when not given, as the help says it. BUILD, with an installation, is the
    current folder."""
    parser.add_argument("--out", type=Path, metavar="FOLDER", help=f"folder for {of} ({out})")
    parser.add_argument("--build", type=package_tree.tree, default=package_tree.own_tree(), metavar="FOLDER",
                        help="build folder of the package, or prefix of an installation (%(default)s)")


def out_folder(args, name):
    """--out; where it is not given, the folder `name` in the build folder, or beside us with an installation."""
    return args.out or package_tree.results(args.build, name)


def together_words(parser):
    """--together."""
    parser.add_argument("--together", type=one_or_more, default=cores(), metavar="N",
                        help="runs at a time (the cores there are: %(default)s)")


def words(doc, count):
    """Those of a program that takes `count` words and no options but --help, which prints its text `doc`; with others
    that text is the error that it ends with."""
    if {"--help", "-h"} & set(sys.argv[1:]):
        print(doc)
        sys.exit(0)
    if len(sys.argv) != 1 + count:
        sys.exit(doc)
    return sys.argv[1:]


def leave_table(out, text, name="result.txt"):
    """Into the file `name` of the folder `out`, and printed."""
    file = out / name
    file.write_text(text + "\n")
    print(f"{text}\n\ntable:   {file}")


def run(main, *errors):
    """Runs `main`. One of the exceptions `errors` ends the program with its text and no traceback."""
    try:
        main()
    except errors as error:
        sys.exit(f"{Path(sys.argv[0]).name}: {error}")
