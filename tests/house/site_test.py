# SPDX-License-Identifier: BSD-3-Clause
"""The site's index of warnings (docs/site/message_index.py) has the rows of all tables of messages, and no others."""
import sys
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "docs/site"))
import message_index
import pages

PAGE = """# Page
| keyword | meaning | unit |
|---|---|---|
| `a` | b | c |

## Warnings

| Message | Meaning | Remedy |
|---|---|---|
| a step \\| of N | too long | [shorter](other.md#steps) |

text

| message | remedy |
|---|---|
| d | e |

```
| message | meaning | remedy |
| in | a | block |
```
"""


class MessageIndex(unittest.TestCase):
    def test_rows_of_tables_with_the_header_alone(self):
        self.assertEqual(list(message_index.rows_of(PAGE)),
                         [("a step \\| of N", "too long", "[shorter](other.md#steps)")])

    def test_order_is_by_words_without_article_and_marks(self):
        rows = [("the step",), ("*a wall*",), ("... cells",), ("Particles",)]
        self.assertEqual(sorted(rows, key=message_index.key),
                         [("... cells",), ("Particles",), ("the step",), ("*a wall*",)])

    def test_every_row_of_the_repository_is_there_once_with_its_pages(self):
        site = pages.Site(SOURCE, Path("unused"))
        found = {row for page in site.pages for row in message_index.rows_of((SOURCE / page).read_text())}
        self.assertGreater(len(found), 50)
        text = message_index.warnings(site)
        self.assertEqual(text.count("\n| "), len(found) + 1)
        self.assertNotIn("](#", text)


if __name__ == "__main__":
    unittest.main()
