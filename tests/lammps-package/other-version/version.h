// SPDX-License-Identifier: BSD-3-Clause
// In place of the engine's: a version that no engine has.
#define LAMMPS_VERSION "1 Jan 2000"
