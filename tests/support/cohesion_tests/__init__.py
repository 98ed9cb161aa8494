# SPDX-License-Identifier: BSD-3-Clause
"""What the tests and the measuring programs share: here engines are started, their output is read, scenes are
written."""
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[3]
