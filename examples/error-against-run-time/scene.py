# SPDX-License-Identifier: BSD-3-Clause
"""Scene files: what is run, with which settings, and what is compared with what."""

import re
from collections import namedtuple
from pathlib import Path

import yaml

# scheme: its name; step: value of the step variable.
Setting = namedtuple("Setting", "scheme step")

TAKES = ("last", "first", "change", "mean", "max", "min", "rms")
TOP = {"title", "script", "command", "variables", "step", "schemes", "seeds", "repeats", "quantities",
       "reference"}
# Names in braces that a command may have besides variables: folder of the scene file, engine, build folder, Python.
OF_US = ("scene", "lmp", "plugin", "build", "python")
QUANTITY = {  # entry of a quantity: its meaning
    "column": "of the thermo output (of the last run that has it), or of 'file'; required",
    "file": "a table with spaces or commas, whose first line has the names",
    "take": "last (default), first, change, mean, max, min, rms of the column",
    "from": "share of its rows that is omitted at the beginning",
    "reference": "a number, 'finest SCHEME' or {scheme: NAME, step: VALUE}; default: that of the scene",
    "relative_to": "divisor of the errors; default: the reference; required if that is 0",
    "over_seeds": "mean (default): error of the mean over seeds; largest: the worst seed",
    "resolution": "smallest error that the quantity resolves",
    "resolution_relative": "unresolved share of an error: grades 1.2 times apart are 0.2",
    "wish": "accepted error",
    "unit": "of a reference that is a number"}


class SceneError(ValueError):
    """A scene file, or what the command line changes in it, cannot be meant so."""


def check(good, where, what, right):
    if not good:
        raise SceneError(f"{where}: {what}; {right}")


def known(found, allowed, where):
    unknown = sorted(set(found) - set(allowed))
    check(not unknown, where, f"unknown entry '{', '.join(unknown)}'", "known are " + ", ".join(sorted(allowed)))


def numbers(values, where):
    """List of the numbers > 0 in `values`; '1e-6' without a point is text to YAML."""
    try:
        values = [float(value) for value in (values if isinstance(values, list) else [values])]
    except (TypeError, ValueError):
        values = []
    check(values and all(0 < v < float("inf") for v in values), where, "no numbers above zero",
          "give a list like [1.0e-6, 1.0e-5]")
    return values


def number(entries, name, default, where):
    try:
        return float(entries.get(name, default))
    except (TypeError, ValueError):
        raise SceneError(f"{where}: {name} '{entries[name]}'; give a number") from None


def whole(entries, name, default, where):
    value = number(entries, name, default, where)
    check(value >= 1 and value == int(value), where, f"{name} {value:g}", "a whole number, 1 or more")
    return int(value)


def named(entries, where):
    """The entries of a dict that may be left empty."""
    entries = {} if entries is None else entries
    check(isinstance(entries, dict), where, "has no entries", "variables: {name: value}")
    return entries


class Quantity:
    """What is read from a run, and what it should be."""

    def __init__(self, name, entries, scene, where):
        where = f"{where}: quantity '{name}'"
        check(isinstance(entries, dict), where, "has no entries", "give at least 'column'")
        known(entries, QUANTITY, where)
        check("column" in entries, where, "has no 'column'", "name a column of the thermo output or of 'file'")
        self.name, self.column = name, str(entries["column"])
        self.file, self.unit = entries.get("file"), entries.get("unit", "")
        self.take = entries.get("take", "last")
        check(self.take in TAKES, where, f"take '{self.take}'", "one of " + ", ".join(TAKES))
        self.start = number(entries, "from", 0.0, where)
        check(0 <= self.start < 1, where, f"from {self.start}", "a share of the rows, at least 0 and below 1")
        self.over_seeds = entries.get("over_seeds", "mean")
        check(self.over_seeds in ("mean", "largest"), where, f"over_seeds '{self.over_seeds}'", "mean or largest")
        self.resolution = number(entries, "resolution", 0.0, where)
        check(self.resolution >= 0, where, f"resolution {self.resolution}", "an error of at least zero")
        self.grade = number(entries, "resolution_relative", 0.0, where)
        check(self.grade >= 0, where, f"resolution_relative {self.grade}", "a share of the error of at least zero")
        self.wish = number(entries, "wish", 0.01, where)
        check(self.wish > 0, where, f"wish {self.wish}", "an error above zero")
        self.reference = self.read_reference(entries.get("reference", scene.reference), scene, where)
        self.scale = number(entries, "relative_to", 0.0, where) if "relative_to" in entries else None
        check(self.scale is None or self.scale > 0, where, f"relative_to {self.scale}", "a number above zero")
        check(self.scale is not None or self.reference != 0.0, where, "an error relative to a reference of 0",
              "give 'relative_to'")

    @staticmethod
    def read_reference(given, scene, where):
        """A number, or the Setting whose run is the reference."""
        if isinstance(given, dict):
            known(given, {"scheme", "step"}, where + ", reference")
            check(given.get("scheme") in scene.schemes, where, f"reference of scheme '{given.get('scheme')}'",
                  "one of " + ", ".join(scene.schemes))
            steps = scene.schemes[given["scheme"]]["steps"]
            return Setting(given["scheme"], numbers(given.get("step", min(steps)), where + ", reference, step")[0])
        if isinstance(given, str) and given.startswith("finest"):
            name = given[len("finest"):].strip() or next(iter(scene.schemes))
            check(name in scene.schemes, where, f"reference '{given}'", "finest SCHEME, of " + ", ".join(scene.schemes))
            return Setting(name, min(scene.schemes[name]["steps"]))
        try:
            return float(given)
        except (TypeError, ValueError):
            raise SceneError(f"{where}: reference '{given}'; a number, 'finest SCHEME' or "
                             "{scheme: NAME, step: VALUE}") from None


class Scene:
    """A scene file; `changes` are those of the command line: variables (dict), steps (dict of scheme to
    numbers), seeds (number of them). Raises SceneError."""

    def __init__(self, file, variables=None, steps=None, seeds=None):
        self.file = Path(file).resolve()
        self.name, self.folder = self.file.stem, self.file.parent
        where = str(file)
        try:
            entries = yaml.safe_load(self.file.read_text())
        except (OSError, yaml.YAMLError) as problem:
            raise SceneError(f"{where}: {problem}") from None
        check(isinstance(entries, dict), where, "is no scene", "see README.md for one")
        known(entries, TOP, where)
        self.title = entries.get("title", self.name)
        check(("script" in entries) != ("command" in entries), where, "needs a 'script' or a 'command'",
              "script: a LAMMPS input beside this file, or command: [program, argument, ...]")
        self.script, self.command = entries.get("script"), entries.get("command")
        if self.script:
            check((self.folder / self.script).is_file(), where, f"script '{self.script}' is not there",
                  f"paths count from {self.folder}")
        else:
            check(isinstance(self.command, list), where, "command is no list",
                  "command: [program, argument, ...]; {name} is replaced by the variable's value")
        self.variables = named(entries.get("variables"), where + ": variables")
        step = entries.get("step", {"variable": "dt", "unit": "s"})
        check(isinstance(step, dict), where, "'step' has no entries", "step: {variable: dt, unit: s}")
        known(step, {"variable", "unit"}, where + ": step")
        self.step, self.step_unit = step.get("variable", "dt"), step.get("unit", "")
        self.schemes = self.read_schemes(entries.get("schemes"), steps or {}, where)
        self.seed, self.seeds = self.read_seeds(entries.get("seeds", {}), seeds, where)
        self.repeats = whole(entries, "repeats", 1, where)
        self.set_variables(variables or {})
        self.check_command(where)
        self.reference = entries.get("reference")
        listed = entries.get("quantities")
        check(isinstance(listed, dict) and listed, where, "has no 'quantities'",
              "quantities: {name: {column: ..., reference: ...}}")
        self.quantities = [Quantity(name, q, self, where) for name, q in listed.items()]

    def read_schemes(self, schemes, changed, where):
        check(isinstance(schemes, dict) and schemes, where, "has no 'schemes'",
              "schemes: {name: {variables: {...}, steps: [...]}}")
        known(changed, schemes, "--steps")
        for name, scheme in schemes.items():
            check(isinstance(scheme, dict), where, f"scheme '{name}' has no entries", "give at least 'steps'")
            known(scheme, {"variables", "steps"}, f"{where}: scheme '{name}'")
            scheme["steps"] = numbers(changed.get(name, scheme.get("steps")), f"{where}: scheme '{name}': steps")
            scheme["variables"] = named(scheme.get("variables"), f"{where}: scheme '{name}': variables")
        return schemes

    def set_variables(self, changed):
        """Those of the command line: what a scheme, the step or the seed sets would not be what was asked for."""
        for name in changed:
            where = f"--set {name}"
            check(name != self.step, where, "is the step", "give --steps SCHEME=A,B,...")
            check(name != self.seed, where, "is the seed", "give --seeds N")
            check(not any(name in scheme["variables"] for scheme in self.schemes.values()), where,
                  "is set by the schemes", "edit the scene")
            check(name in self.read_variables(), where, "is no variable of the scene",
                  "there are " + ", ".join(sorted(self.read_variables())))
        self.variables = {**self.variables, **changed}

    def read_variables(self):
        """Names that the scene gives or that its script has a default for."""
        text = (self.folder / self.script).read_text() if self.script else ""
        return {*self.variables, *re.findall(r"^\s*variable\s+(\w+)\s+index\b", text, re.M)}

    def check_command(self, where):
        allowed = {*OF_US, *self.variables, self.step, *([self.seed] if self.seed else [])}
        for scheme in self.schemes:
            there = allowed | set(self.schemes[scheme]["variables"])
            for name in re.findall(r"\{(\w+)\}", " ".join(map(str, self.command or []))):
                check(name in there, f"{where}: command", f"'{{{name}}}' is no variable of scheme '{scheme}'",
                      "there are " + ", ".join(sorted(there)))

    @staticmethod
    def read_seeds(entries, count, where):
        check(isinstance(entries, dict), where, "'seeds' has no entries", "seeds: {variable: seed, count: 4}")
        known(entries, {"variable", "count"}, where + ": seeds")
        count = whole(entries if count is None else {"count": count}, "count", 1, where + ": seeds")
        check("variable" in entries or count == 1, where, f"{count} seeds, but no variable for them",
              "seeds: {variable: seed, count: 4}")
        return entries.get("variable"), list(range(1, count + 1))

    def settings(self):
        """All of them, references first where they are not among the schemes' own."""
        own = [Setting(name, step) for name, scheme in self.schemes.items() for step in scheme["steps"]]
        others = [q.reference for q in self.quantities if isinstance(q.reference, Setting)]
        return list(dict.fromkeys([*(r for r in others if r not in own), *own]))

    def rounds(self):
        """The seed of each round of runs."""
        return self.seeds * self.repeats

    def values(self, setting, seed):
        """Variables of one run."""
        values = {**self.variables, **self.schemes[setting.scheme]["variables"], self.step: setting.step}
        return {**values, self.seed: seed} if self.seed else values
