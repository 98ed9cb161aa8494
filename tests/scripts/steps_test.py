# SPDX-License-Identifier: BSD-3-Clause
"""What failed, found nothing or was left out does not pass for done. steps_test.py FOLDER_OF_THE_SCRIPTS"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(sys.argv.pop(1)).resolve()
SOURCED = f"set -euo pipefail; source '{SCRIPTS}/steps.sh'; source '{SCRIPTS}/engine_sources.sh'; sleep() {{ :; }}\n"
SUMMARY = """Cohesion 0.2.0
  LAMMPS package: for LAMMPS 4 Feb 2025 (stock)
  LIGGGHTS styles: left out, COHESION_LIGGGHTS is OFF
  OpenFOAM coupling: {coupling}
  current LAMMPS: left out, its source could not be fetched
  newest LAMMPS: left out, it could not be built
"""


class Steps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_text(self, text):
        """Exit code and output of lines that have the functions of the scripts."""
        own = {"COHESION_CACHE": self.folder / "cache", "COHESION_BUILD": self.folder,
               "PATH": f"{self.folder}:{os.environ['PATH']}"}
        done = subprocess.run(["bash", "-c", SOURCED + text], text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, env={**os.environ, **{k: str(v) for k, v in own.items()}})
        return done.returncode, done.stdout

    def fails(self, text, *words):
        code, output = self.run_text(text)
        self.assertNotEqual(code, 0, output)
        for word in words:
            self.assertIn(word, output)
        self.assertNotIn("done in", output)
        self.assertNotIn("went on", output)

    def goes(self, text, *words):
        code, output = self.run_text(text)
        self.assertEqual(code, 0, output)
        for word in words:
            self.assertIn(word, output)

    def program(self, name, text):
        """Stands before the machine's program of that name."""
        file = self.folder / name
        file.write_text("#!/bin/sh\n" + text)
        file.chmod(0o755)


class Failures(Steps):
    def test_of_a_command_in_the_middle(self):
        middle = "work() { false; echo went on; }\n"
        for way in ("", "retry ", "logged log ", "retry logged log "):
            with self.subTest(way):
                way = way.replace("log ", f"'{self.folder}/log' ")
                self.fails(middle + f"step 'some work' '1 s' {way}work", "FAILED: some work")
                log = self.folder / "log"
                self.assertNotIn("went on", log.read_text() if log.is_file() else "")

    def test_of_a_command_within_a_substitution(self):
        self.fails("name() { false; echo went on; }\nwork() { local n; n=$(name); echo \"$n\"; }\nstep work '1 s' work",
                   "FAILED: work")

    def test_are_tried_again(self):
        work = f"work() {{ echo turn >>'{self.folder}/turns'; [ \"$(wc -l <'{self.folder}/turns')\" = 3 ]; }}\n"
        self.goes(work + "step work '1 s' retry work", "done in")

    def test_show_the_log(self):
        self.fails(f"step work '1 s' logged '{self.folder}/log' ls /nowhere", "No such file", "the whole log")


class InstalledVersion(Steps):
    def test_of_a_package_that_is_known_and_not_installed(self):
        """dpkg-query prints an empty line for it and calls that a success."""
        self.program("dpkg-query", "[ \"$1\" = -S ] && echo 'liblammps0: /usr/lib/liblammps.so'; exit 0\n")
        self.fails("step headers '1 s' fetch_lammps_headers", "liblammps", "FAILED: headers")

    def test_of_a_library_that_no_package_has(self):
        self.program("dpkg-query", """[ "$1" = -S ] || exit 0
echo "no path found matching pattern $2" >&2
exit 1
""")
        for library, work in (("liblammps.so", "fetch_lammps_headers"), ("libOpenFOAM.so", "fetch_openfoam_headers")):
            self.fails(f"step headers '1 s' {work}", library, "FAILED: headers")

    def test_is_found_by_the_library(self):
        self.program("dpkg-query", """case "$1 $2 $3" in
  "-S "*/liblammps.so*) echo 'liblammps-dev:amd64: /usr/lib/x86_64-linux-gnu/liblammps.so' ;;
  "-W "*"liblammps-dev:amd64") printf 20250204+dfsg.1 ;;
  *) exit 1 ;;
esac
""")
        self.goes("installed liblammps.so", "20250204+dfsg.1")


class Tarball(Steps):
    def unpack(self, root, files=("src/version.h", "src/atom.h", "cmake/CMakeLists.txt", "lib/poems/src/body.h")):
        source = self.folder / "source"
        for file in files:
            (source / file).parent.mkdir(parents=True, exist_ok=True)
            (source / file).write_text(file)
        where, what = (source, ".") if root == "." else (self.folder, "source")
        subprocess.run(["tar", "-C", where, "-czf", self.folder / "lammps_1.orig.tar.gz", what], check=True)
        return f"unpack lammps '{self.folder}' '{self.folder}/tree' --exclude=cmake\n"

    def test_with_and_without_a_folder_around_it_all(self):
        for root in (".", "source"):
            with self.subTest(root):
                self.goes(self.unpack(root))
                tree = self.folder / "tree"
                self.assertEqual((tree / "src/atom.h").read_text(), "src/atom.h")
                self.assertEqual(sorted(p.name for p in tree.iterdir()), ["lib", "src"])
                self.assertFalse((self.folder / "unpacked").exists())
                shutil.rmtree(tree)

    def test_of_something_else_is_a_failure(self):
        for root in (".", "source"):
            text = self.unpack(root, files=("lib/poems/src/body.h",))
            self.fails(text + "echo went on", "lammps_1.orig.tar.gz has no src/")


class Words(Steps):
    def test_that_setup_does_not_know(self):
        done = subprocess.run([SCRIPTS / "setup", "--newest-lamps"], text=True, capture_output=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("does not know '--newest-lamps'", done.stderr)
        self.assertNotIn("==>", done.stdout)


class OtherSystems(Steps):
    def test_are_refused_with_what_to_do(self):
        other = "os_release() { case $1 in VERSION_CODENAME) echo noble ;; *) echo 'Ubuntu 24.04' ;; esac; }\n"
        self.fails(other + "require_known_debian; echo went on", "Debian 12 (bookworm) and 13 (trixie)",
                   "this is Ubuntu 24.04", "docs/building.md")

    def test_without_a_code_name_are_refused(self):
        self.fails("os_release() { :; }\nrequire_known_debian; echo went on", "Debian 12 (bookworm) and 13 (trixie)")

    def test_both_are_known(self):
        for name in ("bookworm", "trixie"):
            self.goes(f"os_release() {{ echo {name}; }}\nrequire_known_debian; echo went on", "went on")


class LeftOut(Steps):
    def test_is_a_failure(self):
        reason = "OpenFOAM was not found: no headers"
        (self.folder / "summary.txt").write_text(SUMMARY.format(coupling="left out, " + reason))
        self.fails("step build '1 s' require_complete", "OpenFOAM coupling: " + reason, "FAILED: build")

    def test_on_purpose_is_none(self):
        (self.folder / "summary.txt").write_text(SUMMARY.format(coupling="for OpenFOAM v1912"))
        self.goes("step build '1 s' require_complete", "done in")


if __name__ == "__main__":
    unittest.main()
