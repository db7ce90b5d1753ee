// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_writer.h"
#include "las_writer.h"
#include "scan_file.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/in_folder.h"
#include "tools/sample_files.h"

#include <pcl/io/pcd_io.h>

#include <random>

namespace programs {

/** Writes a binary_compressed PCD. */
inline void
saveCompressed(const std::string& path, const pcl::PCLPointCloud2& blob)
{
  ASSERT_EQ(pcl::PCDWriter().writeBinaryCompressed(path, blob), 0);
}

/** Writes a blob, with the viewpoint at the origin. */
inline void
saveBlob(const std::string& path, const pcl::PCLPointCloud2& blob)
{
  pcl::sedr::tools::ToolCloud cloud;
  cloud.blob = blob;
  pcl::sedr::tools::saveCloud(path, cloud);
}

/** Writes a scan as it is read. */
inline void
copyScan(const std::string& path, const pcl::sedr::tools::ScanFile& scan)
{
  pcl::sedr::tools::saveScan(path, scan, scan);
}

/** Returns settings that read a scan in pieces of about so many bytes. */
inline pcl::sedr::tools::ScanSettings
inPieces(std::size_t bytes)
{
  pcl::sedr::tools::ScanSettings settings;
  settings.piece_bytes = bytes;
  return settings;
}

/** A folder for scans that a test writes and reads. */
class ScanFolder : public InFolder<> {
protected:
  /** Writes a file and returns its path. */
  std::string write(const std::string& bytes, const std::string& name = "scan") const
  {
    writeFile(in(name), bytes);
    return in(name);
  }

  pcl::sedr::tools::ToolCloud
  load(const std::string& bytes,
       const pcl::sedr::tools::ScanSettings& settings = {}) const
  {
    return pcl::sedr::tools::loadCloud(write(bytes), settings);
  }

  /** Returns the one sentence that refuses the bytes; "" if they are read. */
  std::string refusal(const std::string& bytes,
                      const pcl::sedr::tools::ScanSettings& settings = {}) const
  {
    try {
      load(bytes, settings);
      return "";
    }
    catch (const pcl::sedr::tools::ToolError& error) {
      const std::string sentence = error.what();
      EXPECT_EQ(error.exitCode(), pcl::sedr::tools::BadUse);
      EXPECT_FALSE(says(sentence, "\n"));
      EXPECT_LT(sentence.size(), 600u) << sentence;
      return sentence;
    }
  }

  /** A file that is refused, and a part of the sentence. */
  struct Refusal {
    std::string bytes;
    std::string part;
  };

  void expectRefusals(const std::vector<Refusal>& table) const
  {
    for (const Refusal& row : table) {
      const std::string sentence = refusal(row.bytes);
      EXPECT_NE(sentence, "") << "read, though: " << row.part;
      EXPECT_TRUE(says(sentence, row.part)) << row.part << "\nis not in: ";
    }
  }
};

/** Returns `bytes` with the first `from` replaced. */
inline std::string
replaced(std::string bytes, const std::string& from, const std::string& to)
{
  return bytes.replace(bytes.find(from), from.size(), to);
}

/** Returns three coordinates of `n` points within `reach` of 0, in 0.1 mm. */
inline std::vector<std::vector<std::int64_t>>
wholeCoordinates(std::size_t n, std::int64_t reach)
{
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(-reach, reach);
  std::vector<std::vector<std::int64_t>> xyz(3);
  for (std::size_t i = 0; i < n; ++i)
    for (auto& axis : xyz)
      axis.push_back(coordinate(random));
  return xyz;
}

/** Returns coordinates as scaled integers, shifted by 0, 1 and 2 m. */
inline std::vector<E57TestField>
integerFields(const std::vector<std::vector<std::int64_t>>& xyz, std::int64_t reach)
{
  std::vector<E57TestField> fields;
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.push_back(E57TestField::ofIntegers(
        std::string("cartesian") + "XYZ"[axis], xyz[axis], -reach, reach,
        "scale=\"0.0001\" offset=\"" + std::to_string(axis) + "\""));
  return fields;
}

/** Returns cartesian coordinates as floats or doubles. */
inline std::vector<E57TestField>
realFields(const std::vector<double>& x,
           const std::vector<double>& y,
           const std::vector<double>& z)
{
  return {E57TestField::ofReals<double>("cartesianX", x),
          E57TestField::ofReals<double>("cartesianY", y),
          E57TestField::ofReals<double>("cartesianZ", z)};
}

/** Returns a LAS file of three points: (2, 0, 6.5), (1, 2, 3), (0.999, 2.001, 5.147).
 */
inline LasSample
threeLasPoints()
{
  LasSample las;
  las.points = {{1000, -2000, 3500}, {0, 0, 0}, {-1, 1, 2147}};
  las.shift = {1, 2, 3};
  return las;
}

} // namespace programs
