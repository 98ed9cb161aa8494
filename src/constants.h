// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion {

inline constexpr double pi = 3.14159265358979323846;

}  // namespace cohesion
