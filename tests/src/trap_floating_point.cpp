// SPDX-License-Identifier: BSD-3-Clause
// An OpenFOAM solver stops at a division by zero, an invalid operation or an overflow, in particle
// styles too. So the laws are tested with these trapped.
#include <cfenv>

namespace {
[[maybe_unused]] const int trapped = feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
}
