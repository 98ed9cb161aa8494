// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace cohesion {

/// A name that another has replaced and that is accepted for a time (docs/deprecation.md).
struct FormerName {
  std::string_view what;  ///< what it names, as in find_by_name()
  std::string_view name;
  std::string_view now;
  std::string_view refused_from;  ///< the first version that does not accept it
};

/// All former names that are accepted. A row goes with the version that it states.
inline constexpr std::array former_names{
    FormerName{"scheme", "event", "exact", "0.4.0"},
    FormerName{"style", "gran/liquid_bridge", "gran/liquidbridge", "0.4.0"},
    FormerName{"style", "gran/square_well", "gran/squarewell", "0.4.0"},
    FormerName{"style", "hard/square_well", "hard/squarewell", "0.4.0"},
    FormerName{"style", "square_well", "squarewell", "0.4.0"},
    FormerName{"style", "wall/gran/liquid_bridge", "wall/gran/liquidbridge", "0.4.0"},
    FormerName{"style", "wall/gran/square_well", "wall/gran/squarewell", "0.4.0"},
    FormerName{"style", "wall/hard/square_well", "wall/hard/squarewell", "0.4.0"},
};

/// What `name` is called now. Where it is a former name, warn(sentence) gets what a run says of it.
template <class Warn>
std::string current_name(std::string_view what, std::string_view name, Warn warn) {
  const auto* const former =
      std::find_if(former_names.begin(), former_names.end(),
                   [&](const FormerName& row) { return row.what == what && row.name == name; });
  if (former == former_names.end()) return std::string(name);
  const std::string now(former->now);
  warn(std::string(what) + " '" + std::string(name) + "' is now called '" + now + "'; write '" +
       now + "', since from version " + std::string(former->refused_from) +
       " on the old word stops the run");
  return now;
}

}  // namespace cohesion
