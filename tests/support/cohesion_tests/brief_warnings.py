# SPDX-License-Identifier: BSD-3-Clause
"""What a run says of itself, in a few words: warnings of our styles in both engines, and which of them tell that a
number may be wrong."""
import re

SHORT = (("the overlap of a resting pair is ([^ ]*) %", r"resting overlap \1 %"),
         ("the largest overlap of an impact is ([^ ]*) %", r"impact overlap \1 %"),
         ("a contact takes ([^ ]*) time steps", r"\1 steps per contact"),
         ("makes contacts unstable", "contacts unstable"),
         ("crosses the surface cut-off in ([^ ]*) time steps", r"\1 steps in the cut-off"),
         ("the speed below which pairs stick, [^ ]*, open by ([^ ]*) %", r"escape open by \1 %"),
         ("rounded places leave .* open by up to ([^ ]*) %", r"rounded places, \1 %"),
         ("leaves its well by more than ([^ ]*) of the radii", r"leaves its well by \1 radii in a step"),
         ("came nearer by more than ([^ ]*) of its radii", r"came nearer by \1 radii in a step"))
# About the material, or the engine's own: no warning that a number is wrong.
NO_WARNING = ("would stick less with a stiffer spring", "thermo_modify", "thermo_style")
ROUNDED = "rounded places"
CONTACT = r"\d+ - (?:\d+|wall)"
# What says that a number may be wrong: a step too long or too short, or a rule that acted. An overlap tells of the
# material.
FITS = ("steps per contact", "steps in the cut-off", "escape open by", ROUNDED, "leaves its well by",
        "came nearer by", "inelastic collapse")


def short(message):
    for long, brief in SHORT:
        found = re.search(long, message)
        if found:
            return found.expand(brief)
    return re.sub(r"^(pair_style|fix|cohesion model)[^:]*: ", "", re.sub(r" \(\S+:\d+\)", "", message))


def warnings(output, contacts):
    """Those of a run in short. Behind what was said only of a contact that does not occur stands that, in brackets;
    `contacts`: those that do occur, as the styles name them ("1 - 2", "1 - wall")."""
    found, others = set(), {}
    for message in re.findall("WARNING: (.*)", output):
        if any(no in message for no in NO_WARNING):
            continue
        about = re.search(rf", ({CONTACT}): ", message)
        if about and about[1] not in contacts:
            others[short(message)] = about[1]
        else:
            found.add(short(message))
    found.update(f"{brief} ({contact})" for brief, contact in others.items() if brief not in found)
    return "; ".join(sorted(found))


def elsewhere(part):
    """Whether it was said only of a contact that does not occur."""
    return re.search(rf"\({CONTACT}\)$", part) is not None


def of_own(said):
    """What was said of contacts that occur."""
    return "; ".join(part for part in said.split("; ") if not elsewhere(part))


def fits(said, words=FITS):
    """What was said that a number may be wrong: "warned"; "elsewhere" of contacts alone that do not occur; or
    "silent"."""
    about = [elsewhere(part) for part in said.split("; ") if any(word in part for word in words)]
    return "silent" if not about else "elsewhere" if all(about) else "warned"
