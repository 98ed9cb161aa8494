// SPDX-License-Identifier: GPL-2.0-or-later
// The engine's headers include this list to name its models; these are those we combine.
#include "surface_model_default.h"
