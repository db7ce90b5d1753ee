// SPDX-License-Identifier: BSD-3-Clause
// The programs that read scans: their options, what they write, and what they refuse.
#include "scanned_building.h"
#include "tools/option_help.h"

#include "sedr_filters/src/base/field_access.h"
#include "tools/reading_settings.h"

#include <filesystem>
#include <map>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using pcl::sedr::Origin;

class ScanTools : public ScannedBuilding {};

TEST(ScanPrograms, AllTakeTheSameReadingOptions)
{
  for (const char* program : {SEDR, PARALLEL_VOXEL_GRID, SCAN_TO_PCD,
#ifdef SEDR_MPI
                              SEDR_MPI
#endif
       }) {
    std::map<std::string, std::string> texts;
    for (const OptionHelp& option : optionsIn(run(program, {"--help"}).out))
      texts[option.name] = option.text;
    static std::map<std::string, std::string> first;
    if (first.empty())
      first = texts;
    for (const char* name :
         {"unit", "up", "origin", "scan", "skip-broken", "columns"}) {
      ASSERT_EQ(texts.count(name), 1u) << program << " --" << name;
      EXPECT_EQ(texts[name], first[name]) << program;
    }
  }
}

TEST_F(ScanTools, BadOptionsAndScansThatStayTooLargeAreOneSentence)
{
  writeFile(in("large.las"), las());
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--origin", "1,2"},
        {"--origin", "0,0,0"},
        {"--origin", in("nowhere")},
        {"--origin", in("large.las")},
        {"--origin", in("study/scan.pcd")},
        {"--scan", "2"},
        {"--skip-broken"},
        {"--columns", "x,y,z"}}) {
    const ProgramRun made = model(in("large.las"), "refused", options);
    expectSentence(made, 1);
    EXPECT_FALSE(std::filesystem::exists(in("refused")));
  }
}

TEST_F(ScanTools, ConvertersWriteWhatIsRead)
{
  writeFile(in("scan.e57"), e57());
  writeFile(in("scan.las"), las());
  const ProgramRun listed = run(SCAN_TO_PCD, {in("scan.e57"), "--list"});
  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_NE(listed.out.find("station 2"), std::string::npos) << listed.out;
  EXPECT_NE(listed.out.find(Origin{stationOf(1)}.text(", ")), std::string::npos)
      << listed.out;
  const ProgramRun both =
      run(SCAN_TO_PCD, {in("scan.e57"), in("one.pcd"), "--list", "--scan", "9"});
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_NE(both.err.find("it takes no --scan"), std::string::npos) << both.err;
  ASSERT_EQ(run(SCAN_TO_PCD, {in("scan.e57"), in("one.pcd"), "--scan", "1"}).exit_code,
            0);
  const ToolCloud one = loadCloud(in("one.pcd"));
  ASSERT_EQ(one.size(), part(0).size());
  for (std::size_t i = 0; i < one.size(); i += 100)
    EXPECT_LT((one.origin.toGiven((*one.points)[i].getVector3fMap().cast<double>()) -
               part(0)[i])
                  .norm(),
              3e-6);
  ASSERT_EQ(run(SCAN_TO_PCD, {in("scan.las"), in("all.ply")}).exit_code, 0);
  EXPECT_EQ(loadCloud(in("all.ply")).blob.data, loadCloud(in("scan.las")).blob.data);
  EXPECT_EQ(run(SCAN_TO_PCD, {in("scan.e57")}).exit_code, 1);
  const ProgramRun broken = run(SCAN_TO_PCD, {in("scan.e57") + "x", in("no.pcd")});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(in("no.pcd")));
}

TEST_F(ScanTools, AFileThatShrinksWhileItIsReadIsAnError)
{
  LasSample sample;
  sample.points.assign(200000, {1, 2, 3});
  for (std::size_t i = 0; i < sample.points.size(); ++i)
    sample.points[i][0] = static_cast<std::int32_t>(i);
  std::string lines;
  for (int i = 0; i < 100000; ++i)
    lines += std::to_string(i % 900) + " 2 3\n";
  for (const std::string& bytes : {sample.bytes(), e57(), lines}) {
    writeFile(in("shrinks"), bytes);
    const ScanFile scan(in("shrinks"), inPieces(100000));
    std::string reason;
    try {
      scan.forEachPiece([&](const pcl::sedr::RowSource::Piece& piece) {
        if (piece.first == 0)
          std::filesystem::resize_file(in("shrinks"), 300000);
        return true;
      });
    }
    catch (const std::exception& error) {
      reason = error.what();
    }
    EXPECT_NE(reason.find("could not be read to its end: it has become shorter"),
              std::string::npos)
        << reason;
  }
}

} // namespace
