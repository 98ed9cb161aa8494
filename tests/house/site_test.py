# SPDX-License-Identifier: BSD-3-Clause
"""The site's index of warnings (docs/site/message_index.py) has the rows of all tables of messages, and no others."""
import unittest
from pathlib import Path
from types import SimpleNamespace

import message_index

SOURCE = Path(__file__).resolve().parents[2]
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

    def test_every_row_of_the_repository_is_there_once(self):
        pages = [page.relative_to(SOURCE) for page in sorted((SOURCE / "docs").rglob("*.md"))]
        found = {row for page in pages for row in message_index.rows_of((SOURCE / page).read_text())}
        self.assertGreater(len(found), 50)
        site = SimpleNamespace(source=SOURCE, pages=pages, text_of=lambda page, text, place: text)
        text = message_index.warnings(site)
        lines = [line for line in text.splitlines() if line]
        self.assertEqual(len(lines), len(set(lines)))
        self.assertEqual([row for row in found if f"| {row[0]} | " not in text], [])
        self.assertNotIn("](#", text)


if __name__ == "__main__":
    unittest.main()
