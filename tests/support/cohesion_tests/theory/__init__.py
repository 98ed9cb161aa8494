# SPDX-License-Identifier: BSD-3-Clause
"""Reference solutions: laws, motions and kinetic theories written out again, that know nothing of the package."""
