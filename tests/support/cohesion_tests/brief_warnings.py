# SPDX-License-Identifier: BSD-3-Clause
"""What a run says of itself, in a few words: warnings of our styles in both engines, and which of them tell that a
number may be wrong."""
import re
from collections import namedtuple

# One warning: what its text has, in short, and whether it tells that a number may be wrong: a step too long or too
# short, or a rule that acted. An overlap tells of the material. `subject`: that of src/advice, where it is one of its.
Warned = namedtuple("Warned", "pattern brief fits subject", defaults=(False, None))
KNOWN = (
    Warned("a contact takes ([^ ]*) time steps", r"\1 steps per contact", True, "contact_steps"),
    Warned("makes contacts unstable", "contacts unstable", False, "stability"),  # an error, no warning
    Warned("makes particles with several contacts unstable", "several contacts unstable", True, "steadiness"),
    Warned("crosses the surface cut-off in ([^ ]*) time steps", r"\1 steps in the cut-off", True, "cutoff_steps"),
    Warned("the speed below which pairs stick, [^ ]*, open by ([^ ]*) %", r"escape open by \1 %", True,
           "escape_velocity"),
    Warned("rounded places leave .* open by up to ([^ ]*) %", r"rounded places, \1 %", True, "rounding"),
    Warned("the overlap of a resting pair is ([^ ]*) %", r"resting overlap \1 %", False, "static_overlap"),
    Warned("the largest overlap of an impact is ([^ ]*) %", r"impact overlap \1 %", False, "impact_overlap"),
    Warned("would stick less with a stiffer spring", "", False, "softness"),
    Warned("leaves its well by more than ([^ ]*) of the radii", r"leaves its well by \1 radii in a step", True),
    Warned("came nearer by more than ([^ ]*) of its radii", r"came nearer by \1 radii in a step", True),
    Warned("([^ ]*) times in this run a pair, or a particle and a wall, turned", r"\1 steps not resolved to their end",
           True),
    Warned("turned round a hundred times or more within one step", "a step not resolved to its end", True),
    Warned("made collisions elastic and frictionless", "inelastic collapse", True),
    Warned("particles with their centres behind a wall", "particles behind a wall at the start", True),
    Warned("particles that a wall cuts through", "a wall through particles at the start", True),
    Warned("is near a face of region", "a narrow region", False),
    Warned("particles fly up to .* above 70 % of the", "flights near the list's limit", False),
    Warned("([^ ]*) pairs of hard cores .*overlap", r"\1 hard cores overlap at the start", True),
)
# The engine's own: no warning that a number is wrong.
OF_THE_ENGINE = ("thermo_modify", "thermo_style")
ROUNDED = "rounded places"
CONTACT = r"\d+ - (?:\d+|wall)"


# What a brief text that tells of a wrong number looks like.
FITS = tuple(known.brief.replace(r"\1", r"\S+") for known in KNOWN if known.fits)


def short(message):
    for known in KNOWN:
        found = re.search(known.pattern, message)
        if found:
            return found.expand(known.brief)
    return re.sub(r"^(pair_style|fix|cohesion model)[^:]*: ", "", re.sub(r" \(\S+:\d+\)", "", message))


def warnings(output, contacts):
    """Those of a run in short. Warnings of contacts that do not occur name them in brackets;
    `contacts`: those that do occur, as the styles name them ("1 - 2", "1 - wall")."""
    found, others = set(), {}
    for message in re.findall("WARNING: (.*)", output):
        if any(of_engine in message for of_engine in OF_THE_ENGINE) or not short(message):
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
    """Warnings of contacts that occur."""
    return "; ".join(part for part in said.split("; ") if not elsewhere(part))


def fits(said, words=FITS):
    """Warnings that a number may be wrong: "warned"; "elsewhere" of contacts alone that do not occur; or
    "silent"."""
    about = [elsewhere(part) for part in said.split("; ") if any(re.search(word, part) for word in words)]
    return "silent" if not about else "elsewhere" if all(about) else "warned"
