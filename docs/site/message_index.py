# SPDX-License-Identifier: BSD-3-Clause
"""The page of all warnings: the rows of every table of the pages whose header is `message | meaning | remedy`, in
alphabetical order. Rows that are equal on several pages become one, with a link to each page."""
import re
from pathlib import Path

PAGE = Path("warnings.md")
HEADER = ("message", "meaning", "remedy")
HEAD = """# Index of warnings

Messages that a run or a program prints. The table is made from the tables of the pages in its last column. A capital
letter or dots stand for a value. Most messages begin with the style or fix that prints them.

| message | meaning | remedy | page |
|---|---|---|---|
"""


def cells_of(line):
    """Of a line of a table; none for another line."""
    if not line.lstrip().startswith("|"):
        return ()
    return tuple(cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1])


def without_blocks(text):
    return re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)


def rows_of(text):
    """Message, meaning and remedy of each row of the tables of a page."""
    inside = False
    for line in without_blocks(text).splitlines():
        cells = cells_of(line)
        if tuple(cell.lower() for cell in cells) == HEADER:
            inside = True
        elif not cells:
            inside = False
        elif inside and len(cells) == len(HEADER) and not all(re.fullmatch(r":?-+:?", cell) for cell in cells):
            yield cells


def key(row):
    """Letters and figures of the message without marks and a leading article."""
    words = re.sub(r"[^a-z0-9 ]", "", row[0].lower()).split()
    return words[1:] if words and words[0] in ("a", "an", "the") and len(words) > 1 else words, row


def warnings(site):
    """Text of the page. site: see pages.py."""
    places = {}
    for page in site.pages:
        for row in rows_of((site.source / page).read_text()):
            # A link within its page leads there from the index, too.
            cells = tuple(site.text_of(page, cell.replace("](#", f"]({page.name}#"), PAGE) for cell in row)
            pages = places.setdefault(cells, [])
            if page not in pages:
                pages.append(page)
    lines = [f"| {' | '.join(row)} | {', '.join(f'[{page.stem}]({page})' for page in places[row])} |"
             for row in sorted(places, key=key)]
    return HEAD + "\n".join(lines) + "\n"
