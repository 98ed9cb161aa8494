# SPDX-License-Identifier: BSD-3-Clause
"""An OpenFOAM case that cohesiveBedFoam runs: copy it, change entries, mesh it, solve it."""

import os
import re
import shutil
import subprocess
from pathlib import Path

from cohesion_studies import package_tree
from cohesion_studies.build_summary import missing
from cohesion_studies.job_pool import RunError, dies_with_us
from cohesion_studies.mpi_start import short_start


class CaseError(RunError):
    """A program of the case failed; the text ends with the last lines of its log."""


SCRIPT = "openfoam/environment.sh"
# Particle engines, as a case names them: their adapters, and what these need of the package
ADAPTERS = {"lammps": ("openfoam/libcohesionLammpsEngine.so", "LAMMPS package"),
            "liggghts": ("openfoam/libcohesionLiggghtsEngine.so", "LIGGGHTS styles")}


def environment(build, engines=()):
    """Environment (dict) in which the programs of the build folder `build` run, with the particle engines `engines`.

    Raises CaseError when the folder has not been built, or without one of the engines."""
    build = package_tree.tree(build)
    for file, part in ((SCRIPT, "OpenFOAM coupling"), *(ADAPTERS[engine] for engine in sorted(engines))):
        reason = missing(build, file, part)
        if reason:
            raise CaseError(reason)
    output = subprocess.run(
        ["bash", "-c", f"source '{build / SCRIPT}' && env -0"], check=True, capture_output=True
    ).stdout
    return dict(item.split("=", 1) for item in output.decode().split("\0") if "=" in item)


class FoamCase:
    """A case folder. Every program writes its log to log.<program> there."""

    def __init__(self, template, folder, env, overwrite=False):
        """Copies the case `template` to `folder`; env as from environment().

        Raises CaseError when the folder exists and overwrite is not set."""
        self.folder = Path(folder).resolve()
        self.env = dict(env, FOAM_CASE=str(self.folder))
        if self.folder.exists():
            if not overwrite:
                raise CaseError(f"'{self.folder}' already exists: remove it or name another folder")
            shutil.rmtree(self.folder)
        shutil.copytree(template, self.folder)

    def set(self, file, entry, value):
        """Set a dictionary entry, for instance set("system/controlDict", "endTime", 0.1). What the file includes, and
        its macros, stay as they are."""
        self._call(["foamDictionary", "-disableFunctionEntries", file, "-entry", entry, "-set", str(value)])

    def edit(self, file, **words):
        """Gives entries of a dictionary, each where it stands, once, other values, without a program of OpenFOAM's."""
        path = self.folder / file
        text = path.read_text()
        for name, value in words.items():
            text, found = re.subn(rf"(?m)^(\s*{name}\s+)[^;]*;", lambda m, new=value: f"{m[1]}{new};", text)
            if found != 1:
                raise CaseError(f"{path}: {found} entries '{name}'")
        path.write_text(text)

    def mesh(self):
        """blockMesh, the sets and patches that have a dictionary, and the start fields."""
        self.run("blockMesh")
        if (self.folder / "system/topoSetDict").exists():
            self.run("topoSet")
        if (self.folder / "system/createPatchDict").exists():
            self.run("createPatch", "-overwrite")
        shutil.copytree(self.folder / "0.orig", self.folder / "0", dirs_exist_ok=True)

    def start(self, *arguments, ranks=1):
        """Start cohesiveBedFoam in the background; returns the process (Popen)."""
        command = ["cohesiveBedFoam", *arguments]
        if ranks > 1:
            command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command, "-parallel"]
        with open(self.log("cohesiveBedFoam"), "w") as log:
            return subprocess.Popen(
                dies_with_us(command), cwd=self.folder, stdout=log, stderr=log, stdin=subprocess.DEVNULL,
                env={**short_start(ranks if ranks > 1 else 0), **self.env},
            )

    def solve(self, *arguments, ranks=1):
        """Run cohesiveBedFoam, on more than one rank after decomposePar; returns its log."""
        if ranks > 1:
            self.set("system/decomposeParDict", "numberOfSubdomains", ranks)
            self.run("decomposePar", "-force")
        self.finish(self.start(*arguments, ranks=ranks))
        return self.log("cohesiveBedFoam").read_text()

    def finish(self, process):
        """Wait for start()'s process; raises CaseError when it failed."""
        if process.wait() != 0:
            raise CaseError(f"cohesiveBedFoam failed in {self.folder}:\n" + self.tail())

    def run(self, program, *arguments):
        with open(self.log(program), "w") as log:
            status = subprocess.run(
                [program, *arguments], cwd=self.folder, env=self.env, stdout=log, stderr=log
            ).returncode
        if status != 0:
            raise CaseError(f"{program} failed in {self.folder}:\n" + self.tail(program))

    def log(self, program):
        return self.folder / f"log.{program}"

    def tail(self, program="cohesiveBedFoam", lines=25):
        return "\n".join(self.log(program).read_text().splitlines()[-lines:])

    def progress(self):
        """(share done [1], seconds left) from the solver's log; None before the first step."""
        with open(self.log("cohesiveBedFoam"), "rb") as log:
            log.seek(max(0, os.path.getsize(log.name) - 4000))
            text = log.read().decode(errors="replace")
        found = re.findall(r"^Time = .*\((\S+) %, \S+ s elapsed, about (\S+) s left\)", text, re.M)
        return (float(found[-1][0]) / 100, float(found[-1][1])) if found else None

    def _call(self, command):
        result = subprocess.run(
            command, cwd=self.folder, env=self.env, capture_output=True, text=True
        )
        if result.returncode != 0:
            raise CaseError(" ".join(command) + ":\n" + result.stdout + result.stderr)
