// SPDX-License-Identifier: GPL-2.0-or-later
// The engine's list of combinations that it registers itself; ours are in register_combinations.h.
