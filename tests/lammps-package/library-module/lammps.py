# SPDX-License-Identifier: BSD-3-Clause
"""Stands in for LAMMPS' Python module, which need not be installed: the same calls of the library COHESION_LIBRARY."""
import ctypes
import os


class lammps:
    def __init__(self, cmdargs=()):
        self.lib = ctypes.CDLL(os.environ["COHESION_LIBRARY"], ctypes.RTLD_GLOBAL)
        self.lib.lammps_open_no_mpi.restype = ctypes.c_void_p
        self.lib.lammps_extract_fix.restype = ctypes.POINTER(ctypes.c_double)
        words = [b"lammps", *(word.encode() for word in cmdargs)]
        self.lmp = ctypes.c_void_p(self.lib.lammps_open_no_mpi(
            len(words), (ctypes.c_char_p * len(words))(*words), None))

    def commands_string(self, text):
        self.lib.lammps_commands_string(self.lmp, text.encode())

    def extract_fix(self, name, style, kind, row=0, column=0):
        return self.lib.lammps_extract_fix(self.lmp, name.encode(), style, kind, row, column)[0]

    def finalize(self):
        self.lib.lammps_close(self.lmp)
        self.lib.lammps_mpi_finalize()
