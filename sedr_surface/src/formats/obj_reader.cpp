// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_parsers.h"

#include <exception>
#include <sstream>

namespace pcl::sedr {
namespace {

// Returns the zero-based index of an OBJ word, "7", "7/1/2" or "-1" for the last
// vertex; -1 if invalid.
std::int64_t
objIndex(const std::string& word, std::size_t vertices)
{
  try {
    const long long index = std::stoll(word);
    const auto count = static_cast<std::int64_t>(vertices);
    const std::int64_t from_zero = index > 0 ? index - 1 : count + index;
    return index != 0 && from_zero >= 0 && from_zero < count ? from_zero : -1;
  }
  catch (const std::exception&) {
    return -1;
  }
}

std::string
inLine(std::size_t number)
{
  return " in line " + std::to_string(number);
}

} // namespace

bool
looksLikeObj(const std::string& content)
{
  std::istringstream lines(content);
  std::string line;
  std::string keyword;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    double coordinate = 0;
    if (words >> keyword && keyword == "v" && words >> coordinate)
      return true;
    if (line.find('\0') != std::string::npos)
      return false;
  }
  return false;
}

std::string
parseObj(const std::string& content, TriangleMesh& mesh)
{
  std::istringstream lines(content);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      Eigen::Vector3d vertex;
      if (!(words >> vertex.x() >> vertex.y() >> vertex.z()))
        return "has a vertex without three coordinates" + inLine(number);
      mesh.vertices.push_back(vertex);
    }
    else if (word == "f") {
      std::vector<std::uint32_t> polygon;
      while (words >> word) {
        const std::int64_t index = objIndex(word, mesh.vertices.size());
        if (index < 0)
          return "has a face with the bad vertex '" + word + "'" + inLine(number);
        polygon.push_back(static_cast<std::uint32_t>(index));
      }
      if (polygon.size() < 3)
        return "has a face with fewer than three vertices" + inLine(number);
      triangulatePolygon(mesh.vertices, polygon, mesh.triangles);
    }
  }
  return {};
}

} // namespace pcl::sedr
