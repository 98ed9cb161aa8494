# SPDX-License-Identifier: BSD-3-Clause
"""scripts/page-figures counts words by their kind, and the pages that it counts as generated have their program:
page_figures_test.py SCRIPTS."""
import importlib.machinery
import importlib.util
import sys
import unittest
from pathlib import Path

SCRIPTS = Path(sys.argv.pop(1))
sys.dont_write_bytecode = True
loader = importlib.machinery.SourceFileLoader("page_figures", str(SCRIPTS / "page-figures"))
page_figures = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
loader.exec_module(page_figures)

PAGE = """# A title

Three words here.

| a |
|---|

```
run 1
| no table |
```

## Measured

<!-- table
select no from words
-->
| e | f 1 |
|---|---|
| g |

## Behind

| h |
"""


class Words(unittest.TestCase):
    def test_kinds(self):
        found = page_figures.count(PAGE)
        # Neither bars of tables nor signs of headings are words.
        self.assertEqual(dict(found), {"prose": 2 + 3 + 1 + 1, "tables": 1 + 1, "blocks": 2 + 2, "generated": 4,
                                       "by hand": 7 + 2 + 4})

    def test_all_tables_of_a_generated_page(self):
        self.assertEqual(page_figures.count(PAGE, True)["generated"], 1 + 4 + 1)

    def test_folders(self):
        for page, folder in (("README.md", "."), ("docs/scope.md", "docs"), ("docs/theory/drag.md", "docs/theory"),
                             ("examples/shear/README.md", "examples")):
            self.assertEqual(page_figures.folder_of(page), folder)

    def test_generated_pages_and_their_programs_exist(self):
        for pair in page_figures.GENERATED.items():
            for name in pair:
                self.assertTrue((SCRIPTS.parent / name).exists(), name)


if __name__ == "__main__":
    unittest.main()
