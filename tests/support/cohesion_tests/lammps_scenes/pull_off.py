# SPDX-License-Identifier: BSD-3-Clause
"""Grains that adhere and are pulled off along x by a load that grows slowly, in LAMMPS: at which load they part, over
F_ad. A grain begins at rest at F_ad/K, without a load, at a plane, in a cylinder or beside another grain."""
import math
import re

from cohesion_tests import lammps
from cohesion_tests.theory.slow_ramp import CUT, DENSITY, OUT, TOP, A

PARTNERS = ("plane", "cylinder", "pair")
LOADS = ("addforce", "gravity", "wall")


def script(grain, division, scheme, pulled_by):
    """pulled_by: addforce, gravity, or wall: a second plane, which attracts three times as much and moves away slowly
    with the grain."""
    d, steps, side = grain.diameter, grain.steps(division), 4 * grain.diameter
    at_rest, contact = grain.overlap_at_rest, grain.words
    adhesion = grain.adhesion
    pair = grain.partner == "pair"
    start = side - (d if pair else d / 2) + at_rest
    dt = grain.contact_time / division
    load = f"{grain.force * TOP!r}*step/{steps}"
    wall = {"plane": f"xplane NULL {side!r}", "cylinder": f"zcylinder {side!r}"}.get(grain.partner)
    lines = [
        f"plugin load {lammps.plugin()}", "units si", "atom_style sphere", "atom_modify map array", "boundary f f f",
        "newton off", "comm_modify vel yes",
        "region box block " + 3 * f"{-2 * side!r} {2 * side!r} " + "units box", "create_box 1 box",
        f"neighbor {d / 2!r} bin", f"create_atoms 1 single {start:.17g} 0 0 units box"]
    if pair:
        lines.append(f"create_atoms 1 single {side:.17g} 0 0 units box")
    lines += [f"set group all diameter {d!r}", f"set group all density {DENSITY!r}", "group first id 1",
              "group second id 2", f"pair_style {grain.style} scheme {scheme}",
              f"pair_coeff * * {contact} {adhesion if pair else ''}"]
    if wall:
        lines.append(f"fix wall all wall/{grain.style} {contact} {adhesion} {wall} scheme {scheme}")
    loaded = f"{load}/{grain.force!r}"
    if pulled_by == "gravity":
        lines += [f"variable a equal {load}/{grain.mass!r}", "fix pull all gravity v_a vector -1 0 0"]
    elif pulled_by == "wall":
        strong = f"hamaker {3 * A!r} cutoff {CUT!r} {OUT!r}"
        away = start - d / 2 + 3 * at_rest
        speed = -2 * TOP * at_rest / (steps * dt)  # both springs give way
        # F_ad lasts up to H_cut. A load presses a contact by F/K', somewhat more than F/K; so a fifth longer.
        steps = round(steps * (1.2 + CUT / (TOP * at_rest)))
        lines.append(f"fix puller all wall/gran/hamaker {contact} {strong} xplane {away:.17g} NULL "
                     f"translate x {speed!r} scheme {scheme}")
        loaded = f"f_puller[1]/{grain.force!r}"
    else:
        lines += [f"variable down equal -{load}", "fix pull first addforce v_down 0 0"]
        if pair:
            lines += [f"variable up equal {load}", "fix hold second addforce v_up 0 0"]
    lines += ["fix move all nve/sphere", f"timestep {dt!r}",
              f"variable gap equal {'x[2]' if pair else f'{side:.17g}'}-x[1]-{side - start:.17g}",
              f"variable load equal {loaded}", f"fix stop all halt 1 v_gap > {at_rest + 3 * grain.opens_by!r} error continue",
              "thermo_style custom step v_gap v_load", "thermo_modify format float %.9g", f"thermo {max(steps // 4000, 1)}",
              f"run {steps}", 'print "ENDED $(v_gap)"']
    return "\n".join(lines) + "\n"


def load_at_parting(grain, division, scheme="exact", pulled_by="addforce"):
    """Over F_ad, read to 0.0003 of it; infinite where it does not part."""
    with lammps.temporary_folder() as folder:
        code, output = lammps.run_text(script(grain, division, scheme, pulled_by), folder)
    if code != 0:
        raise AssertionError(output[-3000:])
    opened = grain.overlap_at_rest + grain.opens_by  # since the start
    if float(re.search(r"^ENDED (\S+)", output, re.MULTILINE)[1]) < opened:
        return math.inf
    rows = re.findall(r"^ *\d+ +(\S+) +(\S+) *$", output, re.MULTILINE)
    # A grain that has left its contact may bounce on the second wall while it crosses H_cut.
    last = grain.overlap_at_rest if pulled_by == "wall" else opened
    return [float(load) for gap, load in rows if float(gap) < last][-1]


def run_on(grain, first, level, lines):
    """By how much the grain has moved away [m] after a ramp up to `level` F_ad at t_c/first, but no farther than 0.95 F_ad,
    and a while under that load, and then `lines`."""
    steps = grain.steps(first)
    ramp = min(level, 0.95)
    last = round(steps * ramp / TOP)
    load = (f"{grain.force * TOP!r}*(step<={last})*step/{steps}+{grain.force * ramp!r}*(step>{last})"
            f"+{grain.force * (level - ramp)!r}*(step>{last + 20 * first})")
    text = script(grain, first, "exact", "addforce")
    text = text.replace(f"variable down equal -{grain.force * TOP!r}*step/{steps}", f"variable down equal -({load})")
    head, _, tail = text.rpartition("run ")
    with lammps.temporary_folder() as folder:
        code, output = lammps.run_text(head + f"run {last + 20 * first}\n" + lines + tail.partition("\n")[2], folder)
    if code != 0:
        raise AssertionError(output[-3000:])
    return float(re.search(r"^ENDED (\S+)", output, re.MULTILINE)[1])


def gap_after_another_step(grain, first, then, level):
    """By how much the grain has moved away [m] when `level` F_ad was held for 300 contact times at t_c/then, after a ramp
    up to it at t_c/first."""
    return run_on(grain, first, level, f"timestep {grain.contact_time / then!r}\nrun {300 * then}\n")


def gap_after_release(grain, division, level, hold, release):
    """The same when fixes held it, by the lines `hold`, until the lines `release`."""
    return run_on(grain, division, level,
                  f"{hold}\nrun {20 * division}\n{release}\nrun {300 * division}\n")
