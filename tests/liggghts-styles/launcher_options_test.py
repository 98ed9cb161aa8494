# SPDX-License-Identifier: BSD-3-Clause
"""The launcher takes what the stock program takes: options, a script from the standard input, signals."""

import os
import pathlib
import re
import signal
import subprocess
import tempfile
import time
import unittest

from cohesion_studies.mpi_start import short_start
from cohesion_tests.liggghts import SCENES, mpiexec, program

# Numbers that two runs of one program do not share.
CLOCK = re.compile(r"time|CPU|Memory usage|\d\d:\d\d:\d\d", re.IGNORECASE)
SCRIPT = (SCENES / "in.stock").read_text().replace("run           2000", "print 'n is ${n}'\nrun           ${n}")
N = ("-var", "n", "20")


class Options(unittest.TestCase):
    def outcome(self, way, options, ranks=0, **given):
        """Return code, what is printed, and the text of each file that is left, without times."""
        command = [program("LAUNCHER" if way == "launcher" else "STOCK"), *options]
        if ranks:
            command = [*mpiexec(), str(ranks), *command]
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "in.script").write_text(SCRIPT)
            done = subprocess.run(command, cwd=folder, env={**os.environ, **short_start(ranks)}, timeout=100,
                                  text=True, errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  **given)
            texts = {"printed": done.stdout, **{file.name: file.read_text(errors="replace")
                                                for file in folder.iterdir()}}
        return done.returncode, {key: [line for line in text.split("\n") if not CLOCK.search(line)]
                                 for key, text in texts.items()}

    def same(self, *options, files=("log.liggghts",), code=0, **given):
        stock, launcher = (self.outcome(way, options, **given) for way in ("stock", "launcher"))
        self.assertEqual(stock[0] == 0, code == 0, stock[1]["printed"][-20:])
        self.assertEqual(set(stock[1]), {"printed", "in.script", *files})
        # A line, in one place or more, says that it is the launcher; nothing else does.
        said = [[line for line in text if line.startswith("Cohesion ")] for text in launcher[1].values()]
        self.assertEqual(max(map(len, said)), 1)
        for text, lines in zip(launcher[1].values(), said):
            text[:] = [line for line in text if line not in lines]
        self.assertEqual(launcher, stock)
        return launcher[1]

    def refused(self, *options, word):
        """By both, with the same sentence. Behind it the engine may print bytes from memory that it has freed."""
        sentences = []
        for way in ("stock", "launcher"):
            code, texts = self.outcome(way, options)
            self.assertNotEqual(code, 0)
            sentences.append(re.search(r"ERROR[^(\n]*", "\n".join(texts["printed"]))[0])
        self.assertIn(word, sentences[0])
        self.assertEqual(*sentences)

    def test_script(self):
        for option in ("-in", "-i"):
            self.assertIn("n is 20", self.same(option, "in.script", *N)["printed"])
        self.assertIn("n is 20", self.same(*N, input=SCRIPT)["printed"])

    def test_variables(self):
        self.assertIn("n is 30", self.same("-in", "in.script", "-v", "n", "30", "20")["printed"])

    def test_output(self):
        of = ("-in", "in.script", *N)
        self.same(*of, "-log", "other.log", files=("other.log",))
        self.same(*of, "-l", "none", files=())
        self.same(*of, "-screen", "screen.txt", files=("log.liggghts", "screen.txt"))
        self.same(*of, "-sc", "none")
        self.assertIn("print 'n is ${n}'", self.same(*of, "-echo", "both")["printed"])

    def test_ranks(self):
        """The first one alone says what program it is: a line of another comes into one of the first's."""
        self.same("-in", "in.script", *N, ranks=2)

    def test_partitions(self):
        found = self.same("-in", "in.script", *N, "-partition", "2x1", "-plog", "log", "-pscreen", "screen", ranks=2,
                          files=("log.liggghts", "log.0", "log.1", "screen.0", "screen.1"))
        self.assertIn("n is 20", found["screen.1"])

    def test_help_and_what_is_no_option(self):
        self.same("-help", code=1)  # the engine ends so
        self.refused("-in", "in.script", "-nonsense", word="command-line")


class Signals(unittest.TestCase):
    STEPS = 10**9

    def wait(self, what, seconds=10):
        end = time.time() + seconds
        while not what():
            self.assertLess(time.time(), end, "nothing happens")
            time.sleep(0.01)

    def test_a_restart_file_on_request_and_an_orderly_end(self):
        text = SCRIPT.replace("thermo        100", "thermo 10\nthermo_modify flush yes")
        for way in ("STOCK", "LAUNCHER"):
            for end in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(way=way, end=end), tempfile.TemporaryDirectory() as name:
                    folder = pathlib.Path(name)
                    (folder / "in.script").write_text(text)
                    command = [program(way), "-in", "in.script", "-v", "n", str(self.STEPS), "-sc", "none"]
                    with subprocess.Popen(command, cwd=folder, env={**os.environ, **short_start()},
                                          stdout=subprocess.DEVNULL) as run:
                        try:
                            log = folder / "log.liggghts"
                            self.wait(lambda: log.exists() and re.search(r"^ +50 ", log.read_text(), re.MULTILINE))
                            run.send_signal(signal.SIGUSR1)
                            self.wait(lambda: list(folder.glob("restart_forced_*")))
                            run.send_signal(end)
                            self.assertEqual(run.wait(30), 0)
                        finally:
                            run.kill()
                    self.assertIn("Loop time", log.read_text())


if __name__ == "__main__":
    unittest.main()
