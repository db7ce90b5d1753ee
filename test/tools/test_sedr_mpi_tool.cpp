// SPDX-License-Identifier: BSD-3-Clause
#include "tool_cloud.h"
#include "tools/in_folder.h"
#include "tools/scans/room_scan_files.h"

#include <nlohmann/json.hpp>

#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <random>
#include <thread>

namespace {

using namespace programs;
using Strings = std::vector<std::string>;
namespace fs = std::filesystem;

class SedrMpiTool : public InFolder<> {
protected:
  /** Returns whether a folder goes: what cleans up may outlive ranks that were ended.
   */
  bool isGone(const std::string& name) const
  {
    for (int wait = 0; fs::exists(in(name)) && wait < 100; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return !fs::exists(in(name));
  }

  /** Allows mpirun for root and with more ranks than processors. */
  static void SetUpTestSuite()
  {
    for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                             "OMPI_MCA_rmaps_base_oversubscribe"})
      setenv(name, "1", 1);
  }

  static ProgramRun mpirun(int ranks, const Strings& arguments)
  {
    Strings all{"-n", std::to_string(ranks), SEDR_MPI};
    all.insert(all.end(), arguments.begin(), arguments.end());
    // After ranks ended with an error, Open MPI's mpiexec may wait for ever.
    constexpr int no_answer[] = {124, 137}; // of timeout
    ProgramRun result = run(MPIEXEC, all);
    for (int again = 0; again < 2 && (result.exit_code == no_answer[0] ||
                                      result.exit_code == no_answer[1]);
         ++again)
      result = run(MPIEXEC, all);
    return result;
  }

  /** Expects the same files in two folders, except for the times in the report. */
  static void expectSame(const fs::path& a, const fs::path& b)
  {
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(a)) {
      const fs::path name = entry.path().filename();
      ++files;
      if (name == "report.json")
        EXPECT_EQ(reportIn(a / name), reportIn(b / name));
      else
        EXPECT_TRUE(bytesOf(a / name) == bytesOf(b / name)) << b / name;
    }
    for (const auto& entry : fs::directory_iterator(b)) {
      EXPECT_TRUE(fs::exists(a / entry.path().filename())) << entry.path();
      --files;
    }
    EXPECT_EQ(files, 0u);
  }

  static nlohmann::json reportIn(const fs::path& path)
  {
    auto report = nlohmann::json::parse(bytesOf(path));
    for (auto& stage : report.at("stages"))
      stage.erase("seconds");
    report.at("input").erase("path");
    return report;
  }

  /** Returns the program's own messages, without those of mpirun. */
  static Strings saidIn(const std::string& err)
  {
    Strings said;
    std::istringstream lines(err);
    for (std::string line; std::getline(lines, line);)
      if (line.compare(0, 14, "pcl_sedr_mpi: ") == 0)
        said.push_back(line);
    return said;
  }
};

/** Two rooms, 20 cm apart. */
RoomScan
roomsApart()
{
  return scanOfRooms({{}, {4.57, -1.21, 3.2, 3, 2.5, 2}});
}

TEST_F(SedrMpiTool, GivesTheBytesOfOneProcessForAnyNumberOfRanks)
{
  writeFile(in("scan.pcd"), roomsApart().pcd(false));
  Strings arguments{in("scan.pcd"), in("alone"), "--threads", "1"};
  const ProgramRun alone = done(run(SEDR, arguments));
  for (const int ranks : {2, 3}) {
    arguments[1] = in("ranks_" + std::to_string(ranks));
    const ProgramRun result = done(mpirun(ranks, arguments));
    EXPECT_EQ(static_cast<std::ptrdiff_t>(saidIn(result.err).size()),
              std::count(alone.err.begin(), alone.err.end(), '\n'))
        << "once, not once a rank: " << result.err;
    EXPECT_EQ(result.out.rfind("2 rooms, ", 0), 0u) << result.out;
    expectSame(in("alone"), arguments[1]);
    EXPECT_EQ(reportIn(arguments[1] + "/report.json").at("rooms").size(), 2u);
  }
}

TEST_F(SedrMpiTool, GivesTheBytesOfOneProcessOfE57AndLas)
{
  writeFile(in("scan.e57"), asE57(roomsApart()));
  writeFile(in("scan.las"), asLas(roomsApart()));
  for (const std::string scan : {"scan.e57", "scan.las"}) {
    Strings arguments{in(scan), in(scan + "_alone"), "--no-mesh", "--threads", "1"};
    done(run(SEDR, arguments));
    arguments[1] = in(scan + "_ranks");
    done(mpirun(2, arguments));
    expectSame(in(scan + "_alone"), arguments[1]);
    const auto report = reportIn(arguments[1] + "/report.json");
    if (scan == "scan.e57")
      EXPECT_EQ(report.at("positions").at("known"), 2);
    else
      EXPECT_TRUE(report.at("positions").is_null());
  }
}

TEST_F(SedrMpiTool, TakesAFolderAsOneScan)
{
  const RoomScan scan = roomsApart();
  const auto part = [&](std::size_t from, std::size_t to) {
    RoomScan some;
    for (std::size_t i = from; i < to; ++i)
      some.points.push_back(scan.points[i]);
    return some;
  };
  const std::size_t third = scan.points.size() / 3;
  fs::create_directory(in("scans"));
  writeFile(in("scans/1.pcd"), part(0, third).pcd(true));
  writeFile(in("packed.pcd"), part(third, 2 * third).pcd(false));
  ASSERT_EQ(pcl::PCDWriter().writeBinaryCompressed(
                in("scans/2.pcd"), pcl::sedr::tools::loadCloud(in("packed.pcd")).blob),
            0);
  writeFile(in("scans/3.pcd"), part(2 * third, scan.points.size()).pcd(false));
  writeFile(in("scan.pcd"), scan.pcd(false));
  Strings arguments{in("scan.pcd"), in("alone"), "--no-mesh", "--threads", "1"};
  done(run(SEDR, arguments));
  arguments[0] = in("scans");
  arguments[1] = in("ranks");
  const ProgramRun result = mpirun(4, arguments); // more than files
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expectSame(in("alone"), arguments[1]);
  const ProgramRun listed =
      done(mpirun(2, {in("scans/1.pcd"), in("scans/2.pcd"), in("scans/3.pcd"),
                      in("listed"), "--no-mesh", "--threads", "1"}));
  expectSame(in("alone"), in("listed"));
}

TEST_F(SedrMpiTool, TellsWhatIsWrongOnceAndNotOnceARank)
{
  for (const Strings& arguments : {Strings{},
                                   {"scan.pcd", "out", "--voxel-size", "0"},
                                   {in("missing.pcd"), in("out")}}) {
    const ProgramRun result = mpirun(2, arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(saidIn(result.err).size(), 1u) << result.err;
    EXPECT_EQ(result.out, "");
  }
  EXPECT_TRUE(isGone("out"));
  const ProgramRun help = done(mpirun(2, {"--help"}));
  EXPECT_EQ(help.err, "");
  const std::size_t usage = help.out.find("Usage: pcl_sedr_mpi SCAN... OUTPUT_DIR");
  ASSERT_NE(usage, std::string::npos);
  EXPECT_EQ(help.out.find("Usage", usage + 1), std::string::npos);
  EXPECT_EQ(mpirun(2, {"--version"}).out.find("pcl_sedr_mpi (SEDR) "), 0u);
}

TEST_F(SedrMpiTool, TellsOfAScanWithoutStructure)
{
  std::vector<std::vector<float>> points;
  for (int i = 0; i < 4000; ++i)
    points.push_back(
        {0.05f * static_cast<float>(i % 64), 0.05f * static_cast<float>(i / 64), 0});
  for (int i = 0; i < 40; ++i)
    points.push_back({0, 0, 0.05f * static_cast<float>(i)});
  writeFile(in("scan.pcd"), pcdBytes(points));
  const ProgramRun result = mpirun(2, {in("scan.pcd"), in("out")});
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(saidIn(result.err).size(), 1u) << result.err;
  EXPECT_TRUE(isGone("out"));
}

TEST_F(SedrMpiTool, TellsWhichRankCouldNotReadItsRows)
{
  std::string damaged = asE57(roomsApart());
  damaged[damaged.size() / 4] ^= 1; // one of the first pages, whose checksum is wrong
  writeFile(in("scan.e57"), damaged);
  const ProgramRun result = mpirun(2, {in("scan.e57"), in("out")});
  EXPECT_EQ(result.exit_code, 1);
  const Strings said = saidIn(result.err);
  ASSERT_EQ(said.size(), 1u) << result.err;
  EXPECT_EQ(said[0].find("pcl_sedr_mpi: rank 0 on '"), 0u) << said[0];
  EXPECT_TRUE(says(said[0], in("scan.e57")));
  EXPECT_TRUE(isGone("out"));
}

TEST_F(SedrMpiTool, TakesStraysUnitAndGapsOfTheWholeScan)
{
  RoomScan scan = roomsApart();
  std::mt19937 random(5);
  std::uniform_real_distribution<float> share(0, 1);
  for (int i = 0; i < 3000; ++i) { // in the air of one rank
    scan.points.push_back(scan.points.front());
    scan.points.back().x = 0.5f + 3 * share(random);
    scan.points.back().y = 0.5f + 2 * share(random);
    scan.points.back().z = 0.5f + 1.5f * share(random);
  }
  for (std::size_t i = 0; i < scan.points.size() / 8; ++i)
    scan.points[i].z = std::numeric_limits<float>::quiet_NaN();
  writeFile(in("scan.pcd"), scan.pcd(false));
  Strings arguments{in("scan.pcd"), in("alone"), "--no-mesh", "--threads", "1"};
  const int exit_code = run(SEDR, arguments).exit_code;
  arguments[1] = in("ranks");
  const ProgramRun result = mpirun(3, arguments);
  ASSERT_EQ(result.exit_code, exit_code) << result.err;
  if (exit_code == 0)
    expectSame(in("alone"), in("ranks"));

  for (auto& p : scan.points) {
    p.x *= 1000;
    p.y *= 1000;
    p.z *= 1000;
  }
  writeFile(in("scan.pcd"), scan.pcd(false));
  const ProgramRun large = mpirun(3, arguments);
  EXPECT_EQ(large.exit_code, run(SEDR, arguments).exit_code);
  EXPECT_TRUE(says(large.err, "if its unit is"));
}

} // namespace
