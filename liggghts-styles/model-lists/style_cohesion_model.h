// SPDX-License-Identifier: GPL-2.0-or-later
// The engine's headers include this list to name its models; these are ours.
#include "cohesion_models.h"
