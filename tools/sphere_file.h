// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace cohesion::tools {

/// Spheres in a box from 0 to its edges, of any unit.
struct SphereFile {
  std::vector<double> box;
  std::vector<std::array<double, 4>> rows;  ///< x, y, z, diameter
};

/// Reads rows of x y z diameter, for which `box` is given, or the last frame of a text dump of
/// LAMMPS or LIGGGHTS with columns x y z and radius or diameter, which has its own box.
class SphereReader {
 public:
  explicit SphereReader(const std::string& path) : path_(path), in_(path) {
    if (!in_) throw std::runtime_error("--spheres " + path + ": cannot be read");
  }

  /// Throws std::runtime_error with the row unless all can be read.
  SphereFile read(const std::vector<double>& box) {
    SphereFile file{box, {}};
    const bool dump = in_.peek() == 'I';
    if (dump)
      read_dump(file);
    else
      read_rows(file);
    if (file.rows.empty()) fail("has no sphere");
    if (file.box.size() != 3) fail("has no box: give --box LX LY LZ");
    if (dump && !box.empty()) fail("is a dump, which has its box: leave --box out");
    return file;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("--spheres " + path_ + ": " + what);
  }

  /// The next line as words; false at the end.
  bool next(std::vector<std::string>& words) {
    std::string line;
    if (!std::getline(in_, line)) return false;
    line_++;
    std::istringstream split(line);
    words.clear();
    for (std::string word; split >> word;) words.push_back(word);
    return true;
  }

  double number(const std::vector<std::string>& words, std::size_t n, const std::string& is) const {
    std::size_t used = 0;
    double value = NAN;
    try {
      if (n < words.size()) value = std::stod(words[n], &used);
    } catch (const std::exception&) {
    }
    if (used == 0 || used != words[n].size() || !std::isfinite(value))
      fail("row " + std::to_string(line_) + " is not " + is);
    return value;
  }

  void read_rows(SphereFile& file) {
    for (std::vector<std::string> words; next(words);) {
      if (words.empty()) continue;
      std::array<double, 4> row;
      for (std::size_t k = 0; k < 4; k++) row[k] = number(words, k, "x y z diameter");
      file.rows.push_back(row);
    }
  }

  void read_dump(SphereFile& file) {
    std::array<double, 3> low{};
    for (std::vector<std::string> words; next(words);) {
      if (words.size() < 2 || words[0] != "ITEM:")
        fail("row " + std::to_string(line_) + " is not an ITEM");
      if (words[1] == "TIMESTEP") {
        file = {};
        next(words);
      } else if (words[1] == "NUMBER") {
        next(words);
        count_ = static_cast<long>(number(words, 0, "a number of atoms"));
      } else if (words[1] == "BOX") {
        if (words.size() > 3 && words[3] == "xy") fail("has a tilted box, which is not taken");
        for (double& edge : low) {
          next(words);
          edge = number(words, 0, "bounds of a box");
          file.box.push_back(number(words, 1, "bounds of a box") - edge);
        }
      } else if (words[1] == "ATOMS") {
        read_atoms(file, words, low);
      }
    }
  }

  void read_atoms(SphereFile& file, const std::vector<std::string>& head,
                  const std::array<double, 3>& low) {
    std::map<std::string, std::size_t> columns;
    for (std::size_t n = 2; n < head.size(); n++) columns[head[n]] = n - 2;
    const bool radius = columns.count("radius") > 0;
    for (const char* name : {"x", "y", "z", radius ? "radius" : "diameter"})
      if (columns.count(name) == 0)
        fail("has no column " + std::string(name) +
             "; columns x y z and radius or diameter are needed");
    std::vector<std::string> words;
    for (long n = 0; n < count_; n++) {
      if (!next(words))
        fail("ends after " + std::to_string(n) + " of " + std::to_string(count_) + " atoms");
      std::array<double, 4> row;
      const char* names[] = {"x", "y", "z"};
      for (int k = 0; k < 3; k++) row[k] = number(words, columns[names[k]], "an atom") - low[k];
      row[3] = radius ? 2.0 * number(words, columns["radius"], "an atom")
                      : number(words, columns["diameter"], "an atom");
      file.rows.push_back(row);
    }
  }

  std::string path_;
  std::ifstream in_;
  long line_ = 0, count_ = 0;
};

}  // namespace cohesion::tools
