// SPDX-License-Identifier: BSD-3-Clause
// Calls of the LAZ reader to LASzip, tested with a substitute: see laszip_stub. A file
// packed by LASzip itself is read in test_scan_samples.cpp if that library is
// installed.
#include "las_writer.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr::tools;
using programs::LasSample;
using programs::TemporaryFolder;
using programs::writeFile;

constexpr char packed = '\x80'; // bit of the format

LasSample
manyPoints()
{
  LasSample las;
  las.format = 2;
  las.record = 26;
  las.colour_offset = 20;
  las.colour = {0x1234, 0x5678, 0x9abc};
  las.intensity = 77;
  las.shift = {10, -20, 3};
  for (std::int32_t i = 0; i < 100000; ++i)
    las.points.push_back({i, -2 * i % 70001, i % 3001});
  return las;
}

/** Returns a LAS file whose header says LAZ. */
std::string
asLaz(const LasSample& las)
{
  std::string bytes = las.bytes();
  bytes[104] = static_cast<char>(bytes[104] | packed);
  return bytes;
}

class LazFiles : public ::testing::Test {
protected:
  std::string in(const std::string& name) { return (folder_.path() / name).string(); }

  std::string refusal(const std::string& bytes)
  {
    writeFile(in("scan.laz"), bytes);
    try {
      loadCloud(in("scan.laz"));
    }
    catch (const ToolError& error) {
      return error.what();
    }
    ADD_FAILURE() << "it was read";
    return {};
  }

  TemporaryFolder folder_;
};

TEST_F(LazFiles, GiveTheRowsOfTheSameLasWhateverThePieces)
{
  writeFile(in("scan.las"), manyPoints().bytes());
  writeFile(in("scan.laz"), asLaz(manyPoints()));
  const ToolCloud las = loadCloud(in("scan.las"));
  for (const std::size_t piece_bytes : {std::size_t{100000}, std::size_t{1} << 23}) {
    ScanSettings settings;
    settings.piece_bytes = piece_bytes;
    EXPECT_EQ(loadCloud(in("scan.laz"), settings).blob.data, las.blob.data)
        << piece_bytes;
  }
}

TEST_F(LazFiles, WhatLaszipRefusesIsOneSentenceWithItsReasonAndThePoint)
{
  std::string cut = asLaz(manyPoints());
  cut.resize(227 + 26 * 5000);
  const std::string reason = refusal(cut);
  EXPECT_NE(reason.find("chunk with index 7 is corrupt"), std::string::npos) << reason;
  EXPECT_NE(reason.find("at point 5000"), std::string::npos) << reason;
  EXPECT_NE(refusal(cut.substr(0, 227)).find("no chunk table"), std::string::npos);
}

} // namespace
