# SPDX-License-Identifier: BSD-3-Clause
"""Puts a table into a page of the documentation."""
import re


def replace_section(file, title, lines):
    """The table of the section `## title` in `file` becomes `lines`; what else the section says stays. A section
    that is not there is added at the end."""
    text = file.read_text() if file.exists() else ""
    table = "\n".join(lines) + "\n"
    heading = re.search(rf"^## {re.escape(title)}\n", text, re.M)
    if not heading:
        file.write_text(f"{text.rstrip()}\n\n## {title}\n\n{table}".lstrip())
        return
    end = re.compile(r"^## ", re.M).search(text, heading.end())
    end = end.start() if end else len(text)
    section = text[heading.end():end]
    old = re.search(r"^\|.*\n(\|.*\n)*", section, re.M)
    section = (section[:old.start()] + table + section[old.end():]) if old else (
        section.rstrip() + "\n\n" + table + "\n")
    file.write_text(text[:heading.end()] + section + text[end:])
