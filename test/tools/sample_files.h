// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace programs {

/** Bytes of a PCD of floats x y z, and a label where `labels` are given. */
inline std::string
pcdBytes(const std::vector<std::vector<float>>& points,
         const std::vector<std::uint32_t>& labels = {})
{
  const std::string n = std::to_string(points.size());
  std::string bytes = labels.empty() ? "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                                       "COUNT 1 1 1\n"
                                     : "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\n"
                                       "TYPE F F F U\nCOUNT 1 1 1 1\n";
  bytes += "WIDTH " + n + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n + "\nDATA binary\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    bytes.append(reinterpret_cast<const char*>(points[i].data()), 3 * sizeof(float));
    if (!labels.empty())
      bytes.append(reinterpret_cast<const char*>(&labels[i]), sizeof labels[i]);
  }
  return bytes;
}

inline void
writeFile(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace programs
