// SPDX-License-Identifier: BSD-3-Clause
// Preloaded, the engine draws the first of its jests at every error, which it else adds to one in
// five.

#include <cstdlib>

int rand() noexcept { return 0; }
