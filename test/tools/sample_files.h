// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/base/field_access.h"
#include <pcl/PCLPointCloud2.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace programs {

/** Returns the header of a binary PCD with fields of four bytes: whole numbers for
 * label and room, else floats. */
inline std::string
pcdHeader(const std::string& fields, std::size_t points)
{
  std::string sizes;
  std::string types;
  std::string counts;
  std::istringstream names(fields);
  for (std::string name; names >> name; sizes += " 4", counts += " 1")
    types += name == "label" || name == "room" ? " U" : " F";
  const std::string n = std::to_string(points);
  return "VERSION 0.7\nFIELDS " + fields + "\nSIZE" + sizes + "\nTYPE" + types +
         "\nCOUNT" + counts + "\nWIDTH " + n +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n + "\nDATA binary\n";
}

/** Returns a PCD of floats x y z, and a label if `labels` are given. */
inline std::string
pcdBytes(const std::vector<std::vector<float>>& points,
         const std::vector<std::uint32_t>& labels = {})
{
  std::string bytes =
      pcdHeader(labels.empty() ? "x y z" : "x y z label", points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    bytes.append(reinterpret_cast<const char*>(points[i].data()), 3 * sizeof(float));
    if (!labels.empty())
      bytes.append(reinterpret_cast<const char*>(&labels[i]), sizeof labels[i]);
  }
  return bytes;
}

/** Writes a file; a small one also to the folder that SEDR_SEEDS names, for fuzzers. */
inline void
writeFile(const std::filesystem::path& path, const std::string& bytes)
{
  constexpr std::size_t small = 8192;
  if (const char* const seeds = std::getenv("SEDR_SEEDS");
      seeds && bytes.size() < small)
    std::ofstream(
        seeds / std::filesystem::path(std::to_string(std::hash<std::string>()(bytes))),
        std::ios::binary)
        << bytes;
  std::filesystem::remove(
      path); // rewriting a file waits for the disk, creating one does not
  std::ofstream(path, std::ios::binary) << bytes;
}

/** A cloud of three points with fields of many types. */
inline pcl::PCLPointCloud2
manyFields()
{
  using Field = pcl::PCLPointField;
  pcl::PCLPointCloud2 blob;
  const std::vector<std::pair<std::string, std::uint8_t>> fields{
      {"x", Field::FLOAT32},       {"intensity", Field::FLOAT64},
      {"y", Field::FLOAT32},       {"z", Field::FLOAT32},
      {"rgb", Field::FLOAT32},     {"ring", Field::UINT16},
      {"flag", Field::INT8},       {"label", Field::INT16},
      {"normal_x", Field::FLOAT32}};
  for (const auto& [name, type] : fields) {
    Field field;
    field.name = name;
    field.datatype = type;
    field.count = 1;
    field.offset = blob.point_step;
    blob.fields.push_back(field);
    blob.point_step += static_cast<unsigned>(pcl::sedr::fieldSize(type));
  }
  blob.width = 3;
  blob.height = 1;
  blob.row_step = 3 * blob.point_step;
  blob.data.resize(blob.row_step);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t f = 0; f < fields.size(); ++f)
      pcl::sedr::writeField(&blob.data[i * blob.point_step + blob.fields[f].offset],
                            blob.fields[f].datatype,
                            static_cast<double>(10 * f + i) + (f < 4 ? 0.25 : 0));
  return blob;
}

} // namespace programs
