# SPDX-License-Identifier: BSD-3-Clause
"""What the examples share: runs of their own, cases, tables, pictures."""
