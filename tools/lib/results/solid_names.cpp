// SPDX-License-Identifier: BSD-3-Clause
#include "solid_names.h"

#include <fstream>
#include <sstream>

namespace pcl {
namespace sedr {
namespace tools {

std::map<std::uint32_t, std::string>
solidNames(const std::string& path)
{
  std::map<std::uint32_t, std::string> names;
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string comment;
    std::string element;
    std::string name;
    std::uint32_t number = 0;
    if (words >> comment >> element >> number >> name && comment == "comment" &&
        element == "element")
      names[number] = name;
  }
  return names;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
