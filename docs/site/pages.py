# SPDX-License-Identifier: BSD-3-Clause
"""pages.py SOURCE_DIR FOLDER: puts the Markdown pages of the repository into FOLDER as Sphinx takes them, with a gallery
of the examples and indexes of styles, entries and warnings that are made from the pages themselves, and with the charts
of charts.py.

A link to a folder becomes one to its README, a link to a table (.csv) of docs/ a download, a link to another file its
name: the site has no copy of the sources. Links to pages stay, and Sphinx fails where one is dead."""
import csv
import os
import re
import shutil
import sys
from pathlib import Path

import charts
import message_index

LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\(([^()\s]+)\)")
FENCE = re.compile(r"(^```.*?^```\s*?$|`[^`\n]+`)", re.M | re.S)
MATHJAX = Path("/usr/share/javascript/mathjax")
#: Rows of expected figures that the gallery prints.
LONGEST_TABLE = 10
SECTIONS = (
    ("Getting started", ("docs/installing.md", "docs/what-to-choose.md", "docs/getting-started/first-dem-script.md",
                         "docs/getting-started/first-dem-script-liggghts.md",
                         "docs/getting-started/first-coupled-bed.md", "docs/getting-started/*.md",
                         "docs/terminology.md")),
    ("How-to", ("docs/how-to/README.md", "docs/how-to/*.md")),
    ("Use", ("docs/building.md", "docs/scope.md", "docs/clusters.md", "docs/costs.md")),
    ("Examples", ("gallery.md", "examples/README.md", "examples/*/README.md", "examples/*/studies.md")),
    ("Indexes", ("styles.md", "entries.md", "warnings.md")),
    ("LAMMPS", ("lammps-package/README.md", "docs/lammps-package/*.md")),
    ("LIGGGHTS", ("liggghts-styles/README.md", "docs/liggghts-styles/*.md")),
    ("OpenFOAM", ("docs/openfoam-coupling/*.md",)),
    ("Tools", ("docs/tools/*.md",)),
    ("Theory", ("docs/theory/*.md",)),
    ("Verification", ("docs/verification/published_cases.md", "docs/verification/*.md")),
    ("Change", ("CHANGELOG.md", "CONTRIBUTING.md", "docs/deprecation.md", "docs/contributing.md", "docs/*.md")),
)


def pages(source):
    """The README first; then by section, each page once."""
    found = [source / "README.md"]
    for _, patterns in SECTIONS:
        for pattern in patterns:
            found += [page for page in sorted(source.glob(pattern)) if page not in found]
    return found


def place(page):
    return Path("index.md") if page == Path("README.md") else page


class Site:
    def __init__(self, source, folder):
        self.source, self.folder = source.resolve(), folder
        self.pages = [page.relative_to(self.source) for page in pages(self.source)]
        self.title = {page: title_of((self.source / page).read_text()) for page in self.pages}

    def write(self, name, text):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def link(self, page, match, new_place=None):
        """The link of a page as the site has it, there or on a page elsewhere."""
        picture, text, target = match.groups()
        if re.match(r"[a-z]+:|#", target):
            return match[0]
        path, hash_, anchor = target.partition("#")
        file = Path(os.path.normpath(page.parent / path))
        if (self.source / file).is_dir():
            file = file / "README.md"
        here = (place(page) if new_place is None else new_place).parent
        if picture or file in self.pages:
            where = os.path.relpath(place(file), here)
            return f"{picture}[{text}]({where}{hash_}{anchor})"
        if "`" in text:
            return text
        table = file.suffix == ".csv" and file.parts[0] == "docs"
        return f"{{download}}`{text} <{os.path.relpath(file, here)}>`" if table else f"`{text}`"

    def text_of(self, page, text, new_place=None):
        """With the links changed, code left alone."""
        parts = FENCE.split(text)
        return "".join(part if part.startswith("`") and number % 2 else
                       LINK.sub(lambda match: self.link(page, match, new_place), part)
                       for number, part in enumerate(parts))

    def copy_pages(self):
        base = charts.database(self.source)
        for page in self.pages:
            text = charts.drawn(base, page, (self.source / page).read_text(), self.folder / page.parent)
            text = self.text_of(page, joined(text))
            self.write(place(page), text + (self.contents() if place(page) == Path("index.md") else ""))
        for file in (*self.source.glob("docs/**/*.png"), *self.source.glob("docs/**/*.csv")):
            target = self.folder / file.relative_to(self.source)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, target)

    def contents(self):
        """The table of contents, for the sidebar."""
        done, text = {Path("README.md")}, ""
        for caption, patterns in SECTIONS:
            entries = []
            for pattern in patterns:
                made = [Path(pattern)] if pattern in MADE else \
                    [page for page in self.pages if page.match(pattern) and len(page.parts) == len(Path(pattern).parts)]
                entries += [page for page in made if page not in done]
                done.update(made)
            names = "\n".join(str(page.with_suffix("")) for page in entries)
            text += f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{names}\n```\n"
        return text


def joined(text):
    """Links whose text runs over the end of a line, in one line."""
    return re.sub(r"\[([^\[\]\n]*)\n\s*([^\[\]\n]*)\]\(", r"[\1 \2](", text)


def title_of(text):
    return re.search(r"^# (.*)$", text, re.M)[1]


def first_paragraph(text):
    """Below the title, but for a picture."""
    paragraphs = re.split(r"\n\s*\n", re.split(r"^# .*$", text, maxsplit=1, flags=re.M)[1].strip())
    return next(paragraph for paragraph in paragraphs if not paragraph.startswith("!["))


def command_of(text):
    """The first block of commands that runs a program of the examples."""
    for block in re.findall(r"^```\n(.*?)^```", text, re.M | re.S):
        if re.search(r"examples/|scripts/run-", block):
            return block
    return ""


def time_of(text):
    """The remark beside a command, or the first sentence that says how long it takes on how many cores."""
    remark = re.search(r"#\s*(\d[^\n]*\b(?:s|min|minutes|hours)\b[^\n]*)", command_of(text))
    if remark:
        return remark[1].strip() + "."
    prose = re.sub(r"^```.*?^```|^\|.*?$|^#.*?$", "", text, flags=re.M | re.S)
    for sentence in re.split(r"(?<=[.;])\s+|\n\s*\n", prose):
        if re.search(r"\bcores?\b|processor", sentence) and re.search(r"\d (?:s|min|minutes|hours?)\b|an hour", sentence):
            return " ".join(sentence.split())
    return ""


def expected_of(folder):
    file = folder / "expected.csv"
    if not file.exists():
        return ""
    with file.open() as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    if len(rows) > LONGEST_TABLE:
        return f"{len(rows)} expected figures are in `{folder.name}/expected.csv`.\n"
    table = ["| case | figure | from | to |", "|---|---|---|---|"]
    table += [f"| {row['case']} | {row['quantity'].replace('_', ' ')} | {row['low']} | {row['high']} |" for row in rows]
    return "Expected figures:\n\n" + "\n".join(table) + "\n"


def gallery(site):
    text = "# Gallery\n\nThe programs and tests of the examples check the expected figures.\n"
    for page in site.pages:
        if page.parts[0] != "examples" or page.name != "README.md" or len(page.parts) != 3:
            continue
        whole = joined((site.source / page).read_text())
        picture = re.search(r"!\[[^\]]*\]\([^)]*\)", whole)
        time = time_of(whole)
        said = [first_paragraph(whole), picture[0] if picture else "", f"```\n{command_of(whole)}```",
                "" if time.rstrip(".") in command_of(whole) else time]
        text += f"\n## {site.title[page]}\n\n[{page.parent}]({page})\n\n"
        text += site.text_of(page, "\n\n".join(part for part in said if part), Path("gallery.md")) + "\n\n"
        text += expected_of(site.source / page.parent)
    return text


def styles(site):
    text = "# Index of styles\n"
    for engine, folder in (("LAMMPS", "docs/lammps-package"), ("LIGGGHTS", "docs/liggghts-styles")):
        text += f"\n## {engine}\n\n| style | page |\n|---|---|\n"
        rows = []
        for page in site.pages:
            if str(page.parent) != folder:
                continue
            whole = (site.source / page).read_text()
            for line in re.findall(r"^# (.*)$", message_index.without_blocks(whole), re.M):
                if not re.search(r" (command|model)s?$", line):
                    continue
                for name in re.split(r"(?: command| model)?, ", re.sub(r" (command|model)s?$", "", line)):
                    rows.append(f"| {name} | [{page.stem}]({page}) |")
        text += "\n".join(sorted(rows, key=str.lower)) + "\n"
    return text


def entries(site):
    """Of the tables of the coupling's pages that begin with 'entry'."""
    rows = []
    for page in site.pages:
        if page.parent != Path("docs/openfoam-coupling"):
            continue
        section, inside = "", False
        for line in (site.source / page).read_text().splitlines():
            section = line.strip("# ") if line.startswith("#") else section
            cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
            inside = line.startswith("|") and (inside or cells[0].startswith("entry"))
            if inside and cells[0].startswith("`"):
                where = f"[{page.stem}]({page})" + (f", {section}" if section else "")
                rows.append(f"| {cells[0]} | {site.text_of(page, cells[1], Path('entries.md'))} | {where} |")
    return ("# Index of entries\n\nDictionaries of the coupling: couplingProperties, function objects, boundary conditions, "
            "the gas step.\n\n| entry | meaning | where |\n|---|---|---|\n" + "\n".join(sorted(rows, key=str.lower)) + "\n")


#: Pages that are made here.
MADE = {"gallery.md": gallery, "styles.md": styles, "entries.md": entries, str(message_index.PAGE): message_index.warnings}


def main(source, folder):
    shutil.rmtree(folder, ignore_errors=True)
    site = Site(source, folder)
    site.copy_pages()
    for name, make in MADE.items():
        site.write(name, make(site))
    here = Path(__file__).parent
    (folder / "_static").mkdir()
    shutil.copy(here / "site.css", folder / "_static")
    shutil.copy(here / "conf.py", folder)
    if MATHJAX.exists():
        shutil.copytree(MATHJAX, folder / "mathjax-of-debian/mathjax", symlinks=False,
                        ignore=shutil.ignore_patterns("unpacked", "test", "docs"))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
