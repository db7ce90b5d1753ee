// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/mapped_file.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace {

using namespace pcl::sedr::tools;
using programs::TemporaryFolder;
using programs::writeFile;

class CloudBytes : public ::testing::Test {
protected:
  ToolCloud load(const std::string& bytes)
  {
    writeFile(folder_.path() / "cloud", bytes);
    return loadCloud((folder_.path() / "cloud").string());
  }

  std::string refusal(const std::string& bytes)
  {
    try {
      load(bytes);
      return "";
    }
    catch (const ToolError& error) {
      return error.what();
    }
  }

  TemporaryFolder folder_;
};

TEST_F(CloudBytes, AnotherFileOfTheSameNameDoesNotMatter)
{
  const auto path = folder_.path() / "scan.xyz";
  writeFile(path, "1 2 3\n4 5 6\n");
  const MappedFile file(path.string());
  writeFile(folder_.path() / "short.xyz", "1\n");
  std::filesystem::rename(folder_.path() / "short.xyz", path);
  EXPECT_NO_THROW(file.checkWhole());
}

TEST_F(CloudBytes, PlyListsHaveWholeNumbersOfValues)
{
  const auto withCount = [](const std::string& type, const std::string& count) {
    return "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list " +
           type +
           " char i\nelement vertex 1\nproperty float x\nproperty float y\n"
           "property float z\nend_header\n" +
           count + std::string(12, '\0');
  };
  EXPECT_NE(refusal(withCount("float", std::string("\0\0\xc0\x3f", 4) + "b"))
                .find("no whole number"),
            std::string::npos);
  EXPECT_NE(
      refusal(withCount("char", "\xff")).find("list 1 of its element 'face' has -1"),
      std::string::npos);
  EXPECT_EQ(load(withCount("char", "\1b")).size(), 1u);
}

TEST_F(CloudBytes, RowsOfTextHaveTheNumbersOfTheHeader)
{
  const std::string pcd = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nDATA ascii\n";
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                          "property float y\nproperty float z\nend_header\n";
  for (const std::string& head : {pcd, ply}) {
    EXPECT_NE(refusal(head + "1 2 3\n4 5 6 7\n").find("point 2 has more than 3"),
              std::string::npos);
    EXPECT_NE(refusal(head + "1 2 3\n4 5 six\n").find("point 2 has 2 of 3"),
              std::string::npos);
    const ToolCloud large = load(head + "1e400 2 3\n1e-400 2 3\n");
    EXPECT_FALSE(std::isfinite((*large.points)[0].x)); // not 0
    EXPECT_EQ((*large.points)[1].x, 0);
  }
  EXPECT_NE(refusal("FIELDS x y z x\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 1\nDATA ascii\n"
                    "1 2 3 4\n")
                .find("two fields 'x'"),
            std::string::npos);
}

} // namespace
