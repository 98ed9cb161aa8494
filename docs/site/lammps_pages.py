# SPDX-License-Identifier: BSD-3-Clause
"""lammps_pages.py SOURCE_DIR FOLDER: writes the pages of docs/lammps-package as reStructuredText for doc/src of LAMMPS.

The headings of a command are those of LAMMPS' template, in its order. Links to pages of other folders become text."""
import re
import sys
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.tree import SyntaxTreeNode
from mdit_py_plugins.dollarmath import dollarmath_plugin

OUTPUT = "Restart, fix_modify, output, run start/stop, minimize info"
#: Heading of LAMMPS: headings of a page here whose text goes there; '': above all headings.
TEMPLATE = {"Syntax": ("Syntax", "Parameters"), "Examples": ("Example",),
            "Description": ("", "Description", "Choosing", "Warnings"),
            OUTPUT: ("Output and restart", "Output, restart, restrictions",
                     "Output, restart, related fixes and computes"),
            "Restrictions": ("Restrictions",), "Related commands": (), "Default": (), "References": ("References",)}
SUBSECTIONS = ("Choosing", "Warnings")
LINES = {"#": "=", "##": '"', "###": "^"}


def heading(text, level):
    return f"{text}\n{LINES[level] * len(text)}"


def escaped(text):
    return re.sub(r"_(?!\w)", r"\\_", re.sub(r"([*`|\\])", r"\\\1", text))


def plain(node):
    if node.type == "softbreak":
        return " "
    return "".join(map(plain, node.children)) if node.children else node.content


def marked(node):
    """Text of an inline node, and whether marks enclose it."""
    if node.type in ("text", "softbreak"):
        return "\n" if node.type == "softbreak" else escaped(node.content), False
    if node.type == "code_inline":
        return f"``{node.content}``", True
    if node.type == "math_inline":
        return f":math:`{node.content}`", True
    if node.type in ("em", "strong"):
        return escaped(plain(node)).join([{"em": "*", "strong": "**"}[node.type]] * 2), True
    if node.type == "link":
        page = re.fullmatch(r"(\w+)\.md(#.*)?", node.attrs["href"])
        if page:
            return f":doc:`{plain(node)} <{page[1]}>`", True
        if node.attrs["href"].startswith("http"):
            return f"`{plain(node)} <{node.attrs['href']}>`__", True
        return inline(node), False
    raise ValueError(f"{node.type} is not converted")


def inline(node):
    """Marks begin and end at a blank, which a backslash hides, where a letter is next to them."""
    text = ""
    for child in node.children or []:
        new, has_marks = marked(child)
        if text and new and (has_marks and not re.search(r"[\s(\[{<'\"/:-]$", text)
                             or text.endswith(("`", "*")) and not re.match(r"[\s)\]}>'\".,:;!?/-]", new)):
            text += "\\ "
        text += new
    return text


def indented(text, first, width):
    """Behind `first`, with other lines at the given width."""
    return first + re.sub(r"\n(?=[^\n])", "\n" + " " * width, text)


def table(node):
    rows = [[" ".join(inline(cell.children[0]).split()) if cell.children else "" for cell in row.children]
            for part in node.children for row in part.children]
    lines = "\n".join("   * - " + "\n     - ".join(row) for row in rows)
    return ".. list-table::\n   :header-rows: 1\n\n" + re.sub(r" +$", "", lines, flags=re.M)


def block(node):
    if node.type == "paragraph":
        return inline(node.children[0])
    if node.type == "math_block":
        return indented(node.content.strip("\n"), ".. math::\n\n   ", 3)
    if node.type in ("fence", "code_block"):
        return indented(node.content.strip("\n"), ".. code-block:: LAMMPS\n\n   ", 3)
    if node.type in ("bullet_list", "ordered_list"):
        sign = {"bullet_list": "* ", "ordered_list": "#. "}[node.type]
        return "\n".join(indented(blocks(item.children), sign, len(sign)) for item in node.children)
    if node.type == "table":
        return table(node)
    raise ValueError(f"{node.type} is not converted")


def blocks(nodes):
    return "\n\n".join(block(node) for node in nodes)


def parts(nodes):
    """{heading of the second level, first '': text below it}."""
    found, name = {"": []}, ""
    for node in nodes:
        if node.type == "heading" and node.tag == "h2":
            name = plain(node)
            found[name] = []
        else:
            found[name].append(heading(plain(node), "###") if node.type == "heading" else block(node))
    return {name: "\n\n".join(texts) for name, texts in found.items()}


def syntax(text):
    """With its first block as typed text in which marks are escaped."""
    first, *rest = text.split("\n\n* ", 1)
    return "\n\n* ".join([escaped(first).replace(".. code-block:: LAMMPS", ".. parsed-literal::"), *rest])


def page(text):
    root = SyntaxTreeNode(MarkdownIt("commonmark").enable("table").use(dollarmath_plugin).parse(text))
    title, found = plain(root.children[0]), parts(root.children[1:])
    if "Syntax" not in found:
        return "\n\n".join([heading(title, "#"), *(f"{heading(name, '##')}\n\n{own}" if name else own
                                                   for name, own in found.items())]) + "\n"
    names = list(filter(None, re.split(r" commands?(?:, |$)|, ", title)))
    lines = [*(f".. index:: {name}" for name in names), "", *(heading(f"{name} command", "#") + "\n" for name in names)]
    found["Syntax"] = syntax(found["Syntax"])
    found.setdefault("Restrictions", "See :doc:`Runs with soft contacts <soft_contact_runs>`.")
    related = sorted(set(re.findall(r":doc:`[^`<]* <(\w+)>`", "\n".join(found.values()))))
    made = {"Related commands": [", ".join(f":doc:`{name}`" for name in related) or "none"],
            "Default": ["The defaults are those of the parameters." if "Parameters" in found else "none"]}
    for name, own in TEMPLATE.items():
        texts = [(f"{heading(one, '###')}\n\n" if one in SUBSECTIONS else "") + found.pop(one) + "\n" for one in own
                 if found.get(one)]
        texts += made.get(name, [])
        lines += [heading(name, "##"), "", *texts, ""] if texts else []
    if any(found.values()):
        raise ValueError(f"{title}: no place for {list(found)}")
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).rstrip() + "\n"


def main(source, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for file in sorted((source / "docs/lammps-package").glob("*.md")):
        (folder / f"{file.stem}.rst").write_text(page(file.read_text()))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
