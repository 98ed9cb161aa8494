// SPDX-License-Identifier: GPL-2.0-or-later
// The engine's headers include this list to name its models; these are those we combine.
#include "tangential_model_history.h"
#include "tangential_model_no_history.h"
