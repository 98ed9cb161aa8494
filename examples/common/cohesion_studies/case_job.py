# SPDX-License-Identifier: BSD-3-Clause
"""A run of cohesiveBedFoam in a case folder of its own, made anew of a case when it starts."""

import json
from pathlib import Path

from cohesion_studies import package_tree
from cohesion_studies.foam_case import FoamCase
from cohesion_studies.job_pool import Job, digest_of

MARK = "settings.json"  # in the folder of a case that was made here: it may be made anew


def fingerprint(template, build, env, others=()):
    """Of all that runs of the case `template` depend on beside their settings, programs of the folder `build` included,
    and files `others`: tells an earlier run of the same. env: as environment() of foam_case gives it."""
    build = package_tree.tree(build)
    folders = [Path(f) for f in env["LD_LIBRARY_PATH"].split(":") if f.startswith(str(build))]
    return digest_of([*Path(template).rglob("*"), build / "openfoam/cohesiveBedFoam",
                      *(f for folder in folders for f in folder.glob("*.so")), *others])


class CaseJob(Job):
    """`kind`: beside which others of its kind stand in tables; `template`: the case that it is made of, where copied() is
    not another's; `readers`: the modules that read its figures; `folder`, `settings` and `work` as in Job. To be defined
    by a kind of run: change(), figures()."""

    case = None  # FoamCase, once it has been made

    def __init__(self, folder, kind, env, settings, readers, template=None, work=1.0):
        self.kind, self.env, self.template = kind, env, template
        super().__init__(folder, settings, work=work, readers=digest_of([module.__file__ for module in readers]))

    def copied(self):
        """The case (FoamCase) in its folder, as it is before change()."""
        return FoamCase(self.template, self.folder, self.env, overwrite=True)

    def change(self):
        """What the settings change of the case, before its mesh is made."""

    def set_entries(self, changed):
        """`changed`: {file: {entry: value}} of the case."""
        for file, entries in changed.items():
            for name, value in entries.items():
                self.case.set(file, name, value)

    def prepare(self):
        """Makes the case, with its mesh."""
        self.case = self.copied()
        (self.folder / MARK).write_text(json.dumps(self.settings))
        self.change()
        self.case.mesh()
        (self.folder / "case.foam").touch()  # what ParaView opens

    def start(self):
        self.prepare()
        return self.case.start()

    def share(self):
        progress = self.case.progress()
        return progress[0] if progress else 0.0

    def tail(self):
        return self.case.tail()
