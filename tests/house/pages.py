# SPDX-License-Identifier: BSD-3-Clause
"""pages.py SOURCE_DIR [PROGRAM ...]: every code block of every page is of a known kind (docs/contributing.md),
and what no engine runs is tried as far as it can be: lines of the shell by their syntax, the files and options that
they name, those of the programs given by running them; dictionaries by their braces, YAML and Python by their syntax.
Scripts of the engines are run by lammps.*.pages and liggghts.pages, the Python of docs/how-to by tests of its own."""
import ast
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop(1) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
BUILT = {Path(path).name: Path(path).resolve() for path in sys.argv[1:]}
del sys.argv[1:]

from cohesion_tests import page_expected, page_scripts
from cohesion_tests.page_blocks import Block, kind_of, shell_lines

KINDS = {"syntax", "python", "cmake", "yaml", "lammps", "lammps-part", "liggghts", "liggghts-part", "dictionary", "shell",
         "formula", "printed"}
#: Folders of the repository that lines of the shell name.
FOLDERS = {"examples", "scripts", "lammps-package", "liggghts-styles", "openfoam-coupling", "tests", "tools", "docs"}
#: Programs whose runs take minutes or need a script of the user: of these the options are looked up.
LONG = {"array-drag", "cohesion-translate"}


def named_files(text):
    """Of the repository, that lines of the shell name, if they are there or not."""
    words = [word.strip("'\"") for line in shell_lines(text) for word in line.split()]
    return [word for word in words if word.split("/")[0] in FOLDERS and "/" in word and "$" not in word]


def unknown_options(line, names):
    """Options of an example's program that neither it nor a module of the examples knows, as `--word`."""
    program = next((SOURCE / name for name in names if name.endswith(".py") and name in line), None)
    if program is None or not program.exists():
        return []
    beside = [program, *program.parent.glob("*.py"), *(SOURCE / "examples/common").rglob("*.py")]
    known = "\n".join(file.read_text() for file in beside)
    behind = line[line.index(".py") + 3:]
    return [word for word in re.findall(r"(?<!\S)--[a-z][\w-]*", behind) if f'"{word}"' not in known]


def faults_of_shell(block):
    found = []
    checked = subprocess.run(["bash", "-n"], input=block.text, text=True, capture_output=True)
    if checked.returncode != 0:
        found.append(checked.stderr.strip())
    names = named_files(block.text)
    found += [f"{name}: not there" for name in names if not (SOURCE / name).exists() and not re.match(r"[A-Z_]+$", name)]
    for line in shell_lines(block.text):
        found += [f"{option}: unknown to the program" for option in unknown_options(line, names)]
    return found


def programs_lines(block):
    """Assignments, and lines that begin with a program that was given."""
    lines = [line for line in shell_lines(block.text) if line.split()[0] in BUILT or re.match(r"\w+=", line)]
    return lines if any(line.split()[0] in BUILT for line in lines) else []


def faults_of_dictionary(block):
    text = re.sub(r"//.*", "", block.text)
    return [f"{a}{b} do not match" for a, b in ("{}", "()", "[]") if text.count(a) != text.count(b)]


def faults_of_yaml(block):
    try:
        import yaml
    except ImportError:
        return []
    try:
        yaml.safe_load(block.text)
    except yaml.YAMLError as error:
        return [str(error)]
    return []


def faults_of_python(block):
    try:
        ast.parse(block.text)
    except SyntaxError as error:
        return [str(error)]
    return []


class Pages(unittest.TestCase):
    maxDiff = None

    def test_each_block_is_of_a_kind(self):
        blocks = page_scripts.all_blocks()
        counts = {kind: sum(kind == other for _, other in blocks) for kind in sorted(KINDS)}
        print(", ".join(f"{kind} {count}" for kind, count in counts.items()))
        self.assertEqual([block.place for block, kind in blocks if kind not in KINDS], [])
        self.assertGreater(len(blocks), 150)

    def test_expected_results_are_those_of_scripts(self):
        texts = {}
        for block, _ in page_scripts.all_blocks():
            texts[block.page] = texts.get(block.page, "") + block.text
        found = {page: [name for name in page_expected.expected(page) if f"{name} = " not in texts.get(page, "")]
                 for page in page_scripts.pages()}
        self.assertEqual({page: names for page, names in found.items() if names}, {})

    def test_pages_of_tasks_are_short(self):
        tasks = [page for page in sorted((SOURCE / "docs/how-to").glob("*.md")) if page.name != "README.md"]
        words = {page.name: len(page.read_text().split()) for page in tasks}
        self.assertEqual({name: count for name, count in words.items() if not 250 <= count <= 700}, {})

    def test_what_no_engine_runs(self):
        checks = {"shell": faults_of_shell, "dictionary": faults_of_dictionary, "yaml": faults_of_yaml,
                  "python": faults_of_python}
        found = {block.place: checks[kind](block) for block, kind in page_scripts.all_blocks() if kind in checks}
        self.assertEqual({place: faults for place, faults in found.items() if faults}, {})

    @unittest.skipUnless(BUILT, "no program was given")
    def test_lines_of_programs_run(self):
        found, environment, assigned = {}, dict(os.environ), {}
        environment["PATH"] = ":".join([*sorted({str(path.parent) for path in BUILT.values()}), os.environ["PATH"]])
        for block, kind in page_scripts.all_blocks():
            before = assigned.setdefault(block.page, [])
            for line in programs_lines(block) if kind == "shell" else []:
                if re.match(r"\w+=", line):
                    before.append(line)
                    continue
                fault = self.fault_of(line, before, environment)
                if fault:
                    found[f"{block.place}: {line[:60]}"] = fault
        self.assertEqual(found, {})

    def fault_of(self, line, before, environment):
        program = line.split()[0]
        if program in LONG:
            told = subprocess.run([BUILT[program], "--help"], text=True, capture_output=True).stdout
            return [option for option in re.findall(r"(?<!\S)--[a-z][\w-]*", line) if f"{option} " not in told]
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["bash", "-ec", "\n".join([*before, line])], cwd=folder, env=environment, text=True,
                                  capture_output=True)
        return done.stderr[-300:] if done.returncode != 0 else None


class Rules(unittest.TestCase):
    """The check sees what it should."""

    def kind(self, text, section="", mark=""):
        return kind_of(Block("docs/page.md", 1, section, mark, text), page_scripts.programs())

    def test_what_is_of_no_kind(self):
        self.assertIsNone(self.kind("some words that are no script\n"))
        self.assertEqual(self.kind("pair_style gran/hamaker\npair_coef * * stiffness 1 2 3\n"), "lammps-part")
        self.assertEqual(self.kind("fix ID all something\n", "Syntax"), "syntax")
        self.assertEqual(self.kind("create_box 1 box\nrun 10\n"), "lammps")
        self.assertEqual(self.kind("communicate single vel yes\ncreate_box 1 box\nrun 10\n"), "liggghts")
        self.assertEqual(self.kind("drag    beetstra;   // the law\n"), "dictionary")
        self.assertEqual(self.kind("  a   b\nx 1 2\ny 3 4\n"), "printed")

    def test_results_out_of_range_or_missing(self):
        bounds = {"a b": (1, 2)}
        self.assertEqual(page_expected.faults(bounds, "a b = 3\na b = 1.5\n"), [])
        self.assertEqual(len(page_expected.faults(bounds, "a b = 2.1\n")), 1)
        self.assertEqual(page_expected.faults(bounds, "b = 1.5\n"), ["a b: not printed"])
        self.assertEqual(page_expected.printed_by("print 'a b = 1'", {**bounds, "c": (0, 1)}), bounds)

    def test_faults_of_the_shell(self):
        faults = lambda text: faults_of_shell(Block("page.md", 1, "", "", text))
        self.assertEqual(faults("python3 examples/fluidised-bed/run.py --engine liggghts\n"), [])
        self.assertEqual(len(faults("python3 examples/fluidised-bed/run.py --engin liggghts\n")), 1)
        self.assertEqual(len(faults("scripts/no-such-script\n")), 1)
        self.assertEqual(len(faults("if true; then\n")), 1)

    def test_blocks_in_lists_and_by_indentation_are_seen(self):
        from cohesion_tests.page_blocks import blocks
        text = "# T\n\n- item\n\n      run 1\n\ntext\n\n    run 2\n\n- one\n  continued\n\n  ```\n  run 3\n  ```\n"
        self.assertEqual([block.text for block in blocks("page.md", text)], ["run 1\n", "run 2\n", "run 3\n"])


if __name__ == "__main__":
    unittest.main()
