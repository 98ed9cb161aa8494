# SPDX-License-Identifier: BSD-3-Clause
"""Scenes for LAMMPS, with their scripts: what tests and measuring programs run."""
