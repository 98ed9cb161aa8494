// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

namespace cohesion::tools {

/// A line of what a program prints.
struct Line {
  std::string name;  // of the value in --csv
  std::string text;
  double value;
  const char* unit;
};

/// Prints them as a table, or as comma-separated values with all digits.
class Lines {
 public:
  explicit Lines(bool csv) : csv_(csv) {
    if (csv_) std::puts("name,value,unit");
  }

  void heading(const std::string& text) const {
    if (!csv_) std::printf("\n%s\n", text.c_str());
  }
  void operator()(const Line& line) const {
    if (csv_)
      std::printf("%s,%.17g,%s\n", line.name.c_str(), line.value, line.unit);
    else
      std::printf("  %-46s %-11.4g %s\n", line.text.c_str(), line.value, line.unit);
  }
  void note(const std::string& text) const {
    if (!csv_) std::printf("  %s\n", text.c_str());
  }

 private:
  bool csv_;
};

}  // namespace cohesion::tools
