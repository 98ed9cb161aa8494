// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// OpenFOAM 1912 writes [[deprecated]] behind the type that a function returns, where it would
// belong to that type. GCC passes over it; Clang refuses it, as C++ does. Included before all else
// where Clang compiles, so that it says nothing.
#include "stdFoam.H"

#undef FOAM_DEPRECATED
#undef FOAM_DEPRECATED_FOR
#define FOAM_DEPRECATED(since)
#define FOAM_DEPRECATED_FOR(since, replacement)
