# SPDX-License-Identifier: BSD-3-Clause
"""Cases of the coupling, what a test of one is, and what is read of it."""
