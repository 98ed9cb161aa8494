# SPDX-License-Identifier: BSD-3-Clause
"""links.py SOURCE_DIR: every link in a page leads somewhere: to a file or folder of the repository, and to a heading
that is there, by the rule with which GitHub names headings. Web addresses are not asked for."""
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path
from urllib.parse import unquote

SOURCE = Path(sys.argv.pop(1) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])

INLINE = re.compile(r"!?\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(\s*<?([^()\s<>]*(?:\([^()\s]*\)[^()\s]*)*)>?(?:\s+\"[^\"]*\")?\s*\)")
IMAGE_IN_LINK = re.compile(r"!\[[^\[\]]*\]\(\s*([^()\s]+)\s*\)")
DEFINITION = re.compile(r"^ {0,3}\[[^\]]+\]:\s*<?(\S+?)>?\s*$", re.M)
HEADING = re.compile(r"^ {0,3}(#{1,6})\s+(.*?)\s*#*\s*$")
FENCE = re.compile(r"^\s*(```+|~~~+)")


def without_code_blocks(text):
    """The text with the lines of fenced blocks left empty, and without code within lines."""
    lines, fence = [], None
    for line in text.splitlines():
        mark = FENCE.match(line)
        if fence is None and mark:
            fence = mark[1]
            lines.append("")
        elif fence is not None:
            if mark and mark[1].startswith(fence) and line.strip() == mark[1]:
                fence = None
            lines.append("")
        else:
            lines.append(line)
    return "\n".join(lines)


def links(text):
    prose = re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", "code", without_code_blocks(text), flags=re.S)
    found = [match[1] for pattern in (INLINE, IMAGE_IN_LINK, DEFINITION) for match in pattern.finditer(prose)]
    return sorted(set(found))


def anchor_of(heading):
    """GitHub's: the text as it is read, small letters, no marks but - and _, blanks become -."""
    read = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
    read = re.sub(r"(?<![\w*])\*+([^*]+)\*+(?![\w*])", r"\1", read)
    return re.sub(r"[^\w\- ]", "", read.strip().lower()).replace(" ", "-")


def anchors(text):
    """Of all headings; the second of a name has -1 behind it."""
    seen, result = Counter(), set()
    for line in without_code_blocks(text).splitlines():
        match = HEADING.match(line)
        if match:
            name = anchor_of(match[2])
            result.add(f"{name}-{seen[name]}" if seen[name] else name)
            seen[name] += 1
    return result | set(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", text))


def pages(folder):
    """Those that git has or would take: what builds leave behind is not looked at. Without git, or in a copy that is no
    clone, all but what is in a folder `build`."""
    git = ["git", "-C", folder, "ls-files", "-co", "--exclude-standard", "*.md"]
    listed = shutil.which("git") and subprocess.run(git, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if listed and listed.returncode == 0:
        return [file for file in map(folder.joinpath, listed.stdout.split("\n")[:-1]) if file.exists()]
    return [file for file in sorted(folder.rglob("*.md")) if "build" not in file.relative_to(folder).parts]


def fault_of(page, link, folder):
    """What is wrong with the link of a page, or nothing."""
    if re.match(r"[a-zA-Z][a-zA-Z0-9+.-]*:", link):
        return None
    path, _, anchor = unquote(link).partition("#")
    target = (page.parent / path).resolve() if path else page
    if path.startswith("/") or not target.is_relative_to(folder.resolve()):
        return "leads out of the repository"
    if not target.exists():
        return "no such file"
    if anchor and target.is_dir():
        target = target / "README.md"
    if anchor and target.suffix == ".md" and anchor not in anchors(target.read_text()):
        return f"no such heading in {target.name}"
    return None


def dead_links(folder):
    faults = []
    for page in pages(folder):
        for link in links(page.read_text()):
            fault = fault_of(page.resolve(), link, folder)
            if fault:
                faults.append(f"{page.relative_to(folder)}: ({link}): {fault}")
    return faults


class Repository(unittest.TestCase):
    def test_there_are_links_to_look_at(self):
        self.assertGreater(sum(len(links(page.read_text())) for page in pages(SOURCE)), 300)

    def test_no_link_is_dead(self):
        self.assertEqual(dead_links(SOURCE), [])


class Rules(unittest.TestCase):
    """The check sees what it should, and nothing else."""

    def faults_of(self, text, name="page.md"):
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            (folder / "sub").mkdir()
            (folder / "other.md").write_text("# One `two`: *three*, 4.5 (six)\n## Again\n## Again\n```\n# no heading\n```\n")
            (folder / name).write_text(text)
            return len(dead_links(folder))

    def test_what_is_there(self):
        for link in ("other.md", "sub", "./sub/../other.md", "other.md#one-two-three-45-six", "other.md#again-1",
                     "#here", "https://nowhere.example/x", "mailto:a@b.example"):
            self.assertEqual(self.faults_of(f"# Here\n[text]({link})\n"), 0, link)

    def test_what_is_not(self):
        for link in ("missing.md", "sub/missing.md", "other.md#none", "other.md#no-heading", "other.md#again-2",
                     "#nowhere", "../out.md", "/etc/passwd"):
            self.assertEqual(self.faults_of(f"# Here\n[text]({link})\n"), 1, link)

    def test_images_and_references_count(self):
        self.assertEqual(self.faults_of("![picture](missing.png)\n"), 1)
        self.assertEqual(self.faults_of("[![picture](missing.png)](other.md)\n"), 1)
        self.assertEqual(self.faults_of("[word]: missing.md\n"), 1)
        self.assertEqual(self.faults_of("text that runs\n[over two\nlines](missing.md)\n"), 1)

    def test_code_does_not_count(self):
        self.assertEqual(self.faults_of("`[a](missing.md)`\n```\n[a](missing.md)\n```\n"), 0)
        self.assertEqual(self.faults_of("a[i](x) in `f[j](y)` c\n"), 1)


if __name__ == "__main__":
    unittest.main()
