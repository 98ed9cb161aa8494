// SPDX-License-Identifier: GPL-2.0-or-later
// The engine's headers include this list to name its models; these are those we combine.
#include "normal_model_hertz.h"
#include "normal_model_hertz_stiffness.h"
#include "normal_model_hooke.h"
#include "normal_model_hooke_stiffness.h"
