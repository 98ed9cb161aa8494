# SPDX-License-Identifier: BSD-3-Clause
"""Texts of OpenFOAM's files that tests write."""

FILE = """FoamFile {{ version 2.0; format ascii; class {0}; object {1}; }}
"""
FIELD = FILE + """dimensions {2};
internalField {3};
boundaryField
{{
{4}}}
"""
LAMINAR = "simulationType laminar;\n"
