# SPDX-License-Identifier: BSD-3-Clause
"""The code blocks of pages, and of which kind each is: by what stands in it, so that no block needs a mark, and one that
is of no kind is an error. Convention of the kinds: docs/contributing.md, Code blocks of pages."""
import re
from typing import NamedTuple

FENCE = re.compile(r"^(\s*)(```+|~~~+)\s*(\w*)")
ITEM = re.compile(r"^(\s*)([-*]|\d+\.)(\s+)\S")
HEADING = re.compile(r"^ {0,3}(#{1,6})\s+(.*?)\s*#*\s*$")

#: First words of lines of the particle engines' scripts.
COMMANDS = set("""
    angle_style angle_coeff atom_modify atom_style bond_coeff bond_style boundary change_box clear comm_modify communicate
    compute compute_modify create_atoms create_box delete_atoms dielectric dimension displace_atoms dump dump_modify echo
    fix fix_modify group hard_particles if include jump label lattice log mass neigh_modify neighbor newton next
    pair_coeff pair_modify pair_style plugin print processors read_data read_dump read_restart region replicate rerun
    reset_ids reset_timestep restart run run_style set shell soft_particles special_bonds suffix thermo thermo_modify
    thermo_style timestep uncompute undump unfix units variable velocity write_data write_dump write_restart""".split())

#: What begins a line of the shell, but for the programs of this package and files of the repository.
SHELL = {"apt", "bash", "cd", "cmake", "ctest", "decomposePar", "env", "lmp", "liggghts", "module", "mpirun", "python3",
         "source", "srun", "tail"}


class Block(NamedTuple):
    page: str     # relative to the repository
    line: int     # of its first line
    section: str  # heading above it
    mark: str     # word behind the fence
    text: str     # without the indentation that all lines have in common

    @property
    def place(self):
        return f"{self.page}:{self.line}"


def blocks(page, text):
    """Fenced and indented ones, in lists, too."""
    found, section, content, after_blank = [], "", 0, True
    lines = text.split("\n")
    n = 0
    while n < len(lines):
        line = lines[n]
        fence, indent = FENCE.match(line), len(line) - len(line.lstrip())
        if fence:
            end = next(k for k in range(n + 1, len(lines)) if lines[k].strip() == fence[2])
            found.append(Block(page, n + 2, section, fence[3], _flush(lines[n + 1:end])))
            n, after_blank = end, False
        elif not line.strip():
            after_blank = True
        elif after_blank and indent >= content + 4:
            end = n
            while end < len(lines) and (not lines[end].strip() or lines[end].startswith(" " * (content + 4))):
                end += 1
            found.append(Block(page, n + 1, section, "", _flush(lines[n:end])))
            n = end - 1
        else:
            heading, item = HEADING.match(line), ITEM.match(line)
            if heading:
                section, content = heading[2], 0
            elif item:
                content = len(item[1] + item[2] + item[3])
            elif after_blank and indent < content:
                content = 0
            after_blank = bool(heading)
        n += 1
    return found


def _flush(lines):
    left = min((len(line) - len(line.lstrip()) for line in lines if line.strip()), default=0)
    return "\n".join(line[left:].rstrip() for line in lines).strip("\n") + "\n"


def logical_lines(text):
    """Of a script of an engine: without comments, continued lines as one."""
    joined = re.sub(r"&[ \t]*\n", " ", text)
    return [line for line in (re.sub(r"#.*", "", line).strip() for line in joined.split("\n")) if line]


def first_words(text):
    return [line.split()[0] for line in logical_lines(text)]


def is_complete(text):
    """Makes its particles and runs them."""
    makes = re.search(r"\b(create_box|read_data|read_restart)\b", "\n".join(logical_lines(text)))
    return bool(makes) and bool({"run", "rerun"} & set(first_words(text)))


def is_liggghts(block):
    """By the words that LIGGGHTS alone knows, and else by the folder of the page."""
    if re.search(r"pair_style\s+gran\s+model|wall/gran\s+model|property/global|mesh/surface|\bcommunicate\s", block.text):
        return True
    return "liggghts" in block.page and "plugin" not in first_words(block.text)


def _is_engine_script(block):
    """One line of a command makes it one, so that a misspelt command beside it is tried, and fails."""
    return any(word in COMMANDS for word in first_words(block.text))


def _shell_word(line):
    """The first word of a line of the shell that is no assignment."""
    words = re.sub(r'"[^"]*"', "", line).split()
    words = [word for word in words if not re.match(r"[A-Za-z_]\w*=", word) and word != "env"]
    return words[0] if words else ""


def shell_lines(text):
    """Continued lines as one, without comments and empty ones."""
    lines = re.sub(r"\\\n\s*", " ", text).split("\n")
    return [line for line in (re.sub(r"(^|\s)#.*", "", line).strip() for line in lines) if line]


def _is_shell(block, programs):
    if block.text.startswith("#!"):
        return True
    known = lambda word: word in SHELL or word.split("/")[-1] in programs or "/" in word
    lines = shell_lines(block.text)
    return bool(lines) and all(not _shell_word(line) or known(_shell_word(line)) for line in lines[:1])


def _is_synopsis(block, programs):
    """Of a program of this package, with what may be left out in brackets, or dots for more of it."""
    words = {_shell_word(line).split("/")[-1] for line in shell_lines(block.text)}
    return bool(words & set(programs)) and bool(re.search(r"\[-+\w]|\s\.\.\.|\|", block.text))


def _is_dictionary(block):
    """OpenFOAM's: entries that end in a semicolon, or in braces."""
    lines = [re.sub(r"//.*", "", line).strip() for line in block.text.split("\n")]
    lines = [line for line in lines if line]
    ends = all(re.search(r"[;{}()]$", line) or re.fullmatch(r'"?[\w|().*]+"?', line) for line in lines)
    return bool(lines) and ends and bool(re.search("[;{]", block.text))


def _is_formula(block):
    return all(" = " in line for line in block.text.split("\n") if line and not line.startswith(" "))


def _is_yaml(block):
    return bool(re.match(r"[a-z_]+: ", block.text))


def _is_printed(block):
    """What a program prints: most rows, or the last one, have numbers."""
    rows = [line for line in block.text.split("\n") if line.strip()]
    numbers = lambda row: len(re.findall(r"(?<![\w.])[-+]?\d[\d.]*(?:e[-+]?\d+)?(?![\w.])", row))
    return sum(numbers(row) >= 2 for row in rows) >= 0.5 * len(rows) > 0 or numbers(rows[-1]) >= 2


def kind_of(block, programs):
    """syntax, python, cmake, yaml, lammps or liggghts (complete scripts), lammps-part or liggghts-part, dictionary, shell,
    formula, printed; None where it is none of these. programs: names of the programs of this package."""
    if block.section == "Syntax":
        return "syntax"
    if block.mark == "python":
        return "python"
    if block.text.startswith("cmake_minimum_required"):
        return "cmake"
    if _is_dictionary(block):
        return "dictionary"
    if _is_engine_script(block):
        return ("liggghts" if is_liggghts(block) else "lammps") + ("" if is_complete(block.text) else "-part")
    if _is_formula(block):
        return "formula"
    if _is_shell(block, programs):
        return "syntax" if _is_synopsis(block, programs) else "shell"
    if _is_yaml(block):
        return "yaml"
    return "printed" if _is_printed(block) else None
