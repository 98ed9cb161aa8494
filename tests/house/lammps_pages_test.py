# SPDX-License-Identifier: BSD-3-Clause
"""The pages for doc/src of LAMMPS (docs/site/lammps_pages.py) are valid for Sphinx and have LAMMPS' headings."""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import lammps_pages

SOURCE = Path(__file__).resolve().parents[2]
CONF = """from pygments.lexers.special import TextLexer
def setup(app):
    app.add_lexer("LAMMPS", TextLexer)
"""
INDEX = "Pages\n=====\n\n.. toctree::\n   :glob:\n\n   *\n"
PAGE = """# fix a/b command, compute c/d command

**It** *acts* on
`x`s ([there](../theory/a.md)).

## Syntax

```
fix ID group a/b [yes|no] *
```

- *yes* = as [b](fix_b.md#top)

## Parameters

| word | default |
|---|---|
| `e` | |

## Example

```
fix 1 all a/b yes
```

## Description

The mass $m$.
"""
MADE = """.. index:: fix a/b
.. index:: compute c/d

fix a/b command
===============

compute c/d command
===================

Syntax
\"\"\"\"\"\"

.. parsed-literal::

   fix ID group a/b [yes\\|no] \\*

* *yes* = as :doc:`b <fix_b>`

.. list-table::
   :header-rows: 1

   * - word
     - default
   * - ``e``
     -

Examples
\"\"\"\"\"\"\"\"

.. code-block:: LAMMPS

   fix 1 all a/b yes

Description
\"\"\"\"\"\"\"\"\"\"\"

**It** *acts* on
``x``\\ s (there).

The mass :math:`m`.

Restrictions
\"\"\"\"\"\"\"\"\"\"\"\"

See :doc:`Runs with soft contacts <soft_contact_runs>`.

Related commands
\"\"\"\"\"\"\"\"\"\"\"\"\"\"\"\"

:doc:`fix_b`, :doc:`soft_contact_runs`

Default
\"\"\"\"\"\"\"

The defaults are those of the parameters.
"""


class Pages(unittest.TestCase):
    def test_of_a_command(self):
        self.assertEqual(lammps_pages.page(PAGE), MADE)

    def test_sections_without_a_place_stop(self):
        with self.assertRaises(ValueError):
            lammps_pages.page(PAGE + "\n## Other\n\nWords.\n")

    def test_all_are_read_by_sphinx_without_a_warning(self):
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
            pages, built = Path(folder) / "pages", Path(folder) / "built"
            lammps_pages.main(SOURCE, pages)
            (pages / "conf.py").write_text(CONF)
            (pages / "index.rst").write_text(INDEX)
            done = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-n", "-W", "--keep-going", "-b", "text",
                                   pages, built], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            texts = {file.stem: file.read_text() for file in built.glob("*.txt")}
        self.assertEqual(set(texts), {"index", *(file.stem for file in (SOURCE / "docs/lammps-package").glob("*.md"))})
        self.assertEqual([name for name, text in texts.items() if re.search(r"``|:doc:|:math:|\]\(", text)], [])


if __name__ == "__main__":
    unittest.main()
