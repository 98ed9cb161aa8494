# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx, of the pages that pages.py has put into a folder. Needs nothing from the network when it is built or read."""
import os
from pathlib import Path

project = "Cohesion"
author = "The Cohesion developers"
copyright = author  # noqa: A001, Sphinx's name
version = release = os.environ.get("COHESION_VERSION", "")
extensions = ["myst_parser", "sphinx.ext.mathjax"]
source_suffix = {".md": "markdown"}
root_doc = "index"
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 6
myst_dmath_double_inline = True
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2, "titles_only": True}
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sourcelink = False
highlight_language = "none"
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
# Debian's MathJax is version 2, which MyST and Sphinx would take for version 3.
myst_update_mathjax = False
mathjax2_config = {"tex2jax": {"processClass": "math", "ignoreClass": "wy-body-for-nav"}}
MATHJAX = Path("/usr/share/javascript/mathjax")
if MATHJAX.exists():
    html_static_path.append(str(Path("mathjax-of-debian")))
