# SPDX-License-Identifier: BSD-3-Clause
"""The Python scripts that a page shows."""
import re
import textwrap


def python_blocks(readme):
    return [textwrap.dedent(block) for block in re.findall(r"^ *```python\n(.*?)^ *```$", readme.read_text(),
                                                            re.MULTILINE | re.DOTALL)]
