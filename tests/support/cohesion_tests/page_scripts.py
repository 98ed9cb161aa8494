# SPDX-License-Identifier: BSD-3-Clause
"""Scripts of pages as tests run them: complete ones as they are printed, and parts of scripts within the first complete
script of their page, of which they replace lines. Rules: docs/contributing.md, Code blocks of pages."""
import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from cohesion_tests import page_expected
from cohesion_tests.page_blocks import blocks, kind_of, logical_lines

SOURCE = Path(__file__).resolve().parents[3]
#: Commands of which a script has one for each name, the first word after the command.
NAMED = {"compute", "dump", "fix", "group", "region", "thermo_modify", "variable"}
#: Commands whose place in a script matters to all that follow.
BEFORE_PARTICLES = {"atom_style", "boundary", "comm_modify", "communicate", "create_box", "dimension", "lattice",
                    "newton", "plugin", "region", "units"}
#: Of LIGGGHTS' normal and rolling models, for parts that choose another than the script around them.
PROPERTIES = {"youngsModulus": "peratomtype", "poissonsRatio": "peratomtype", "coefficientRestitution": "peratomtypepair",
              "coefficientRollingFriction": "peratomtypepair", "coefficientRollingViscousDamping": "peratomtypepair"}
READS = re.compile(r"^read_(restart|data|dump)\s", re.MULTILINE)
PROPERTY_VALUE = {"youngsModulus": 5e6, "poissonsRatio": 0.25, "coefficientRestitution": 0.9}


def pages():
    """Of the repository, but for the list of changes."""
    listed = subprocess.run(["git", "-C", SOURCE, "ls-files", "-co", "--exclude-standard", "*.md"], text=True,
                            capture_output=True)
    names = listed.stdout.split("\n")[:-1] if listed.returncode == 0 else [
        str(file.relative_to(SOURCE)) for file in sorted(SOURCE.rglob("*.md"))
        if "build" not in file.relative_to(SOURCE).parts]
    return [name for name in names if name != "CHANGELOG.md" and (SOURCE / name).exists()]


def programs():
    """Of this package, by the words of its build."""
    return {"cohesion-mapping", "cohesion-powder", "cohesion-translate", "array-drag", "cohesiveBedFoam", "cohesion-studies", "lmp-cohesion",
            "liggghts-cohesion"}


def all_blocks():
    """Each code block of each page with its kind."""
    return [(block, kind_of(block, programs())) for page in pages() for block in blocks(page, (SOURCE / page).read_text())]


def titled(text):
    """Commands and styles of a page, by its title: `# pair_style a, fix b command`."""
    names = re.split(r"(?: command| model)?, ", re.sub(r" (command|model)s?$", "", text.split("\n")[0].removeprefix("# ")))
    return [tuple(name.rsplit(" ", 1)) for name in names if " " in name]


def uses(pattern, engine, page):
    """Whether a script of the engine on a page, or a part of one, has the pattern; the page must have a complete one."""
    found = [(block.text, kind) for block, kind in all_blocks() if block.page == page and kind in (engine, engine + "-part")]
    texts = [re.sub(r"[ \t]+", " ", re.sub(r"&[ \t]*\n", " ", text)) for text, _ in found]
    return any(kind == engine for _, kind in found) and any(re.search(pattern, text, re.MULTILINE) for text in texts)


def parts(text):
    """Those of a block: paragraphs stand for themselves."""
    return [part for part in re.split(r"\n\s*\n", text) if logical_lines(part)]


def _key(line):
    words = line.split()
    return (words[0], words[1]) if words[0] in NAMED and len(words) > 1 else (words[0],)


def framed(part, script):
    """A part of a script at the end of a whole one, without the lines that have the same command and name; what comes
    before the particles, and pairs, in the place of those. With a pair_style go all pairs of the other, and its walls
    unless the part has some. Every run is of no step."""
    new, old = logical_lines(part), [line for line in logical_lines(script) if line.split()[0] not in ("run", "print")]
    if any(line.split()[0] == "pair_style" for line in new):
        walls = any(re.match(r"fix\s+\S+\s+\S+\s+wall/", line) for line in new)
        gone = lambda line: line.split()[0] in ("pair_style", "pair_coeff") or (not walls and re.match(r"fix\s+\S+\s+\S+\s+wall/", line))
        place = next(k for k, line in enumerate(old) if line.startswith("pair_style"))
        old = [line for line in old[:place] if not gone(line)] + ["@"] + [line for line in old[place:] if not gone(line)]
    elif any(line.split()[0] == "pair_coeff" for line in new):
        place = next(k for k, line in enumerate(old) if line.startswith("pair_coeff"))
        old = [line for line in old if not line.startswith("pair_coeff")]
        old.insert(place, "@")
    pairs = [line for line in new if line.split()[0] in ("pair_style", "pair_coeff")]
    others = [line for line in new if line not in pairs]
    for line in others:
        same = [k for k, other in enumerate(old) if _key(other) == _key(line) and line.split()[0] not in ("run", "print")]
        if same and line.split()[0] in BEFORE_PARTICLES:
            old[same[0]] = line
        else:
            old = [other for k, other in enumerate(old) if k not in same] + [line]
    # What is printed may name what the part has.
    printed = [line for line in old if line.split()[0].startswith("thermo")]
    old = [line for line in old if line not in printed]
    first_run = next((k for k, line in enumerate(old) if line.startswith("run ")), len(old))
    old = old[:first_run] + printed + old[first_run:]
    lines = [other for line in old for other in (pairs if line == "@" else [line])]
    types = [int(word) for line in pairs if line.startswith("pair_coeff") for word in line.split()[1:3] if word.isdigit()]
    lines = [_of_types(line, max(types, default=1)) for line in lines]
    return "\n".join(re.sub(r"^run\s.*", "run 0", line) for line in lines + ["run 0"]) + "\n"


def _of_types(line, types):
    words = line.split()
    if words[0] != "create_box" or int(words[1]) >= types:
        return line
    return " ".join([words[0], str(types), *words[2:]])


def with_properties(script):
    """LIGGGHTS' script with the properties that any of its models asks for."""
    lines = logical_lines(script)
    types = next(int(line.split()[1]) for line in lines if line.startswith("create_box"))
    place = next(k for k, line in enumerate(lines) if line.startswith("pair_style"))
    for name, kind in PROPERTIES.items():
        if not re.search(rf"\b{name}\b", script):
            count, head = (types, "") if kind == "peratomtype" else (types**2, f"{types} ")
            values = " ".join([str(PROPERTY_VALUE.get(name, 0.1))] * count)
            lines.insert(place, f"fix {name} all property/global {name} {kind} {head}{values}")
    return "\n".join(lines) + "\n"


def scripts(engine, default):
    """Place and texts of all scripts of an engine, `lammps` or `liggghts`: before one that reads a file, all complete
    ones above it on its page. default: the page whose script is around parts of pages that have none."""
    found = [(block, kind) for block, kind in all_blocks() if kind in (engine, engine + "-part")]
    whole = {}
    for block, kind in found:
        if kind == engine:
            whole.setdefault(block.page, []).append(block.text)
    for block, kind in found:
        if kind == engine:
            above = whole[block.page][:whole[block.page].index(block.text)] if READS.search(block.text) else []
            yield block.place, [*above, block.text]
            continue
        if re.search(r"^create_box\s", block.text, re.MULTILINE):
            # The particles of a coupled case: the solver sets its variables and runs it.
            yield block.place, [f"variable dt index 1e-5\n{block.text}\nrun 0\n"]
            continue
        for number, part in enumerate(parts(block.text)):
            yield f"{block.place} part {number + 1}", [framed(part, whole.get(block.page, whole[default])[0])]


def fault_of_output(place, script, output):
    """The first warning of a complete script, or result that its page does not expect."""
    if " part " in place:
        return None
    results = page_expected.printed_by(script, page_expected.expected(place.split(":")[0]))
    return next(iter(re.findall(r"^WARNING.*", output, re.MULTILINE) + page_expected.faults(results, output)), None)


def run_all(cases, run):
    """What run(place, *scripts) says of each case that it finds fault with, two at a time; each case in a folder of its
    own."""
    with ThreadPoolExecutor(max_workers=min(2, os.cpu_count() or 1)) as pool:
        said = list(pool.map(lambda case: (case[0], run(case[0], *case[1])), cases))
    return {place: fault for place, fault in said if fault}
