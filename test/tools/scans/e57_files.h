// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_writer.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace programs {

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

class E57Files : public ::testing::Test {
protected:
  std::string write(const std::string& bytes)
  {
    const auto path = folder_.path() / "scan.e57";
    writeFile(path, bytes);
    return path.string();
  }

  pcl::sedr::tools::ToolCloud load(const E57Writer& writer,
                                   const pcl::sedr::tools::ScanSettings& settings = {})
  {
    return pcl::sedr::tools::loadCloud(write(writer.file()), settings);
  }

  /** Returns the error for the bytes; fails the test if they are read. */
  std::string refusal(const std::string& bytes,
                      const pcl::sedr::tools::ScanSettings& settings = {})
  {
    try {
      pcl::sedr::tools::loadCloud(write(bytes), settings);
    }
    catch (const pcl::sedr::tools::ToolError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
    ADD_FAILURE() << "it was read";
    return {};
  }

  TemporaryFolder folder_;
};

} // namespace programs
