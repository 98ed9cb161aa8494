# SPDX-License-Identifier: BSD-3-Clause
"""Every subset of deliverables can be configured, and its build knows where everything comes from; with the
engine missing or the deliverable switched off.

  subsets.py CMAKE SOURCE WORK            the test: none and each alone; what is asked for and missing
  subsets.py CMAKE SOURCE WORK --all      all 32 subsets, both ways
  subsets.py CMAKE SOURCE WORK --build    the test, and builds what each alone makes
"""
import itertools
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

# FindMPI compiles its trials anew each time; those of MPI's C++ binding, which nothing here uses, are left out.
PLAIN = ["-DMPI_CXX_SKIP_MPICXX=ON"]
# Option, what it needs, how the summary calls it
DELIVERABLES = {"COHESION_LAMMPS": ("LAMMPS", "LAMMPS package"),
                "COHESION_LIGGGHTS": ("LIGGGHTS", "LIGGGHTS styles"),
                "COHESION_OPENFOAM": ("OpenFOAM", "OpenFOAM coupling"),
                "COHESION_TOOLS": ("CLI11", "tools"), "COHESION_TESTS": ("GTest", "tests")}


def some():
    """None, and each alone."""
    return [set(), *({name} for name in DELIVERABLES)]


def every():
    return [set(chosen) for n in range(len(DELIVERABLES) + 1)
            for chosen in itertools.combinations(DELIVERABLES, n)]


def configure(cmake, source, folder, chosen, missing):
    """Code and output. Those not chosen are not found if `missing`, else switched off."""
    words = []
    for option, (package, _) in DELIVERABLES.items():
        out = option not in chosen
        words += [f"-D{option}={'OFF' if out and not missing else 'AUTO'}",
                  f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}={'ON' if out and missing else 'OFF'}"]
    return call([cmake, "-S", source, "-B", folder, "-G", "Ninja", *PLAIN, *words])


def call(command):
    done = subprocess.run(list(map(str, command)), text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout


def built(folder):
    """Options of what the summary says is built; it says of the others that they are left out, and why."""
    summary = (Path(folder) / "summary.txt").read_text()
    said = {option: re.search(rf"^  {what}: (for|with|left out,) \S", summary, re.M)
            for option, (_, what) in DELIVERABLES.items()}
    return {option for option, found in said.items() if found[1] != "left out,"}


def check(cmake, source, folder, chosen, here, missing):
    """What is wrong with the subset `chosen` of what is `here`, or nothing."""
    code, output = configure(cmake, source, folder, chosen, missing)
    if code:
        return output[-1500:]
    found = built(folder)
    if found != chosen & here:
        return f"builds {sorted(found)}"
    code, output = call(["ninja", "-C", folder, "-n"])  # goes through all inputs and makes nothing
    return output[-1500:] if code else ""


def check_error(cmake, source, folder, option):
    """What is asked for and missing is an error that names both."""
    package, _ = DELIVERABLES[option]
    words = [f"-D{other}={'ON' if other == option else 'OFF'}" for other in DELIVERABLES]
    words += [f"-DCMAKE_DISABLE_FIND_PACKAGE_{other}={'ON' if other == package else 'OFF'}"
              for other, _ in DELIVERABLES.values()]
    code, output = call([cmake, "-S", source, "-B", folder, "-G", "Ninja", *PLAIN, *words])
    text = " ".join(output.split())
    return "" if code and f"{option} is ON, but {package} was not found" in text else output[-1500:]


def main(cmake, source, work, *options):
    folder = Path(work)
    shutil.rmtree(folder, ignore_errors=True)
    code, output = configure(cmake, source, folder, set(DELIVERABLES), False)
    if code:
        sys.exit(output)
    here, failed, begin = built(folder), 0, time.time()
    print("found on this machine:", ", ".join(sorted(here)))
    if "--all" in options:
        cases = [(chosen, missing) for chosen in every() for missing in (False, True)]
    else:
        # Off for the first half, missing for the second
        cases = [(chosen, k % 2 == 0) for k, chosen in enumerate(some())]
    for number, (chosen, missing) in enumerate(cases, 1):
        wrong = check(cmake, source, folder, chosen, here, missing)
        if not wrong and "--build" in options and len(chosen) == 1:
            code, output = call(["ninja", "-C", folder, "-j2"])
            wrong = output[-1500:] if code else ""
        failed += bool(wrong)
        names = ", ".join(sorted(chosen)) or "nothing"
        print(f"{'FAILED' if wrong else 'ok':7}{names}; the others {'missing' if missing else 'off'}  "
              f"[{number}/{len(cases)}, {time.time() - begin:.0f} s]\n{wrong}".rstrip(), flush=True)
    for option in DELIVERABLES:
        # A folder of their own: an error leaves the cache half made.
        wrong = check_error(cmake, source, folder / "asked", option)
        failed += bool(wrong)
        print(f"{'FAILED' if wrong else 'ok':7}{option}=ON without it is an error\n{wrong}".rstrip())
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
