// SPDX-License-Identifier: BSD-3-Clause
// A simulated building as E57 and LAS in a national grid gives the plan of its PCD.
#include "e57_writer.h"
#include "las_writer.h"
#include "plan_file.h"
#include "scan_file.h"
#include "scan_options.h"
#include "tool_cloud.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace {

using namespace pcl::sedr::tools;
using pcl::sedr::Floorplan;
using pcl::sedr::Origin;
using programs::bytesOf;
using programs::E57TestField;
using programs::E57Writer;
using programs::LasSample;
using programs::ProgramRun;
using programs::run;
using programs::TemporaryFolder;
using programs::writeFile;

const Eigen::Vector3d place(691600, 5336000, 12); // of the building in its grid

class ScansAsTheyCome : public ::testing::Test {
protected:
  static void SetUpTestSuite()
  {
    scanBuilding("bls_room",
                 R"([{"stations": [[1.3, 1, 1.6], [4.3, 1.1, 1.5], [2.8, 3.4, 1.7]],
                      "rays": 64000, "jitter": 1, "max_range": 40, "noise": 0.01}])");
  }

  /** Simulates a building once for all tests, scanned from three stations. */
  static void scanBuilding(const std::string& name, const std::string& scanners)
  {
    folder_ = std::make_unique<TemporaryFolder>();
    auto scene = nlohmann::json::parse(bytesOf(SCENES "/" + name + ".json"));
    scene["scanners"] = nlohmann::json::parse(scanners);
    writeFile(in("scene.json"), scene.dump());
    ASSERT_EQ(run(SIMULATE_INDOOR_SCAN, {in("scene.json"), in("study")}).exit_code, 0);
    const ToolCloud scan = loadCloud(in("study/scan.pcd"));
    for (const auto& p : *scan.points)
      points_.push_back(p.getVector3fMap().cast<double>());
    ScanSettings settings;
    settings.positions = in("study/positions.txt");
    stations_ = ScanFile(in("study/scan.pcd"), settings).positions();
    ASSERT_EQ(stations_.size(), 3u);
    ASSERT_EQ(model(in("study/scan.pcd"), "model", {"--positions", settings.positions})
                  .exit_code,
              0);
    plan_ = *loadFloorplan(in("model/floorplan.json"));
  }

  static void TearDownTestSuite()
  {
    folder_.reset();
    points_.clear();
    stations_.clear();
  }

  static std::string in(const std::string& name)
  {
    return (folder_->path() / name).string();
  }

  static ProgramRun model(const std::string& scan,
                          const std::string& folder,
                          std::vector<std::string> options = {})
  {
    options.insert(options.begin(), {scan, in(folder), "--no-mesh"});
    return run(SEDR, options);
  }

  /** Returns the points that were scanned from a station. */
  static std::vector<Eigen::Vector3d> part(std::size_t scan)
  {
    const std::size_t end =
        scan + 1 < stations_.size() ? stations_[scan + 1].first_row : points_.size();
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = stations_[scan].first_row; i < end; ++i)
      points.push_back(points_[i] + place);
    return points;
  }

  /** Returns where a station is in the grid. */
  static Eigen::Vector3d stationOf(std::size_t scan)
  {
    return place + stations_[scan].place.cast<double>();
  }

  /** Returns the building as E57 of three scans with poses in the grid, all of them
   * or only the second one with spherical coordinates. */
  static std::string e57(bool are_all_spherical = false)
  {
    E57Writer writer;
    writer.packet_bytes = 60000;
    writer.is_uneven = true;
    for (std::size_t scan = 0; scan < 3; ++scan) {
      const double angle = 0.5 + static_cast<double>(scan);
      const Eigen::Quaterniond turn(
          Eigen::AngleAxisd(angle, Eigen::Vector3d(0.1, 0.2, 1).normalized()));
      const Eigen::Vector3d station = stationOf(scan);
      std::vector<Eigen::Vector3d> local;
      for (const Eigen::Vector3d& p : part(scan))
        local.push_back(turn.conjugate() * (p - station));
      writer.addScan("station " + std::to_string(scan),
                     scan == 1 || are_all_spherical ? spherical(local)
                                                    : cartesian(local),
                     E57Writer::pose(turn.w(), turn.x(), turn.y(), turn.z(),
                                     station.x(), station.y(), station.z()));
    }
    return writer.file();
  }

  static std::vector<E57TestField> spherical(const std::vector<Eigen::Vector3d>& points)
  {
    std::vector<double> range, azimuth, elevation;
    for (const Eigen::Vector3d& p : points) {
      range.push_back(p.norm());
      azimuth.push_back(std::atan2(p.y(), p.x()));
      elevation.push_back(std::asin(p.z() / p.norm()));
    }
    return {E57TestField::ofDoubles("sphericalRange", range),
            E57TestField::ofDoubles("sphericalAzimuth", azimuth),
            E57TestField::ofDoubles("sphericalElevation", elevation)};
  }

  static std::vector<E57TestField> cartesian(const std::vector<Eigen::Vector3d>& points)
  {
    std::vector<E57TestField> fields;
    constexpr std::int64_t reach = 30000000; // micrometres
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<std::int64_t> values;
      for (const Eigen::Vector3d& p : points)
        values.push_back(std::llround(p[axis] * 1e6));
      fields.push_back(E57TestField::ofIntegers(std::string("cartesian") + "XYZ"[axis],
                                                values, -reach, reach,
                                                "scale=\"1e-6\""));
    }
    return fields;
  }

  static std::string las()
  {
    LasSample las;
    las.scale = {1e-6, 1e-6, 1e-6};
    las.shift = {place.x(), place.y(), place.z()};
    for (const Eigen::Vector3d& p : points_) {
      las.points.emplace_back();
      for (int axis = 0; axis < 3; ++axis)
        las.points.back()[static_cast<std::size_t>(axis)] =
            static_cast<std::int32_t>(std::lround(p[axis] * 1e6));
    }
    return las.bytes();
  }

  /** Expects every corner within 0.1 mm of one in the PCD's plan, and the same floor
   * and ceiling. */
  static void expectPlan(const std::string& folder)
  {
    const std::string path = in(folder) + "/floorplan.json";
    const Floorplan plan = *loadFloorplan(path);
    const Origin origin = planOrigin(path);
    constexpr double tolerance = 1e-4; // metres
    ASSERT_EQ(plan.rooms.size(), plan_.rooms.size());
    for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
      const auto& found = plan.rooms[r].boundary.elements;
      const auto& expected = plan_.rooms[r].boundary.elements;
      ASSERT_EQ(found.size(), expected.size());
      for (const auto& element : found) {
        double nearest = 1;
        for (const auto& other : expected)
          nearest = std::min(
              nearest,
              (element.start + (origin.place - place).head<2>() - other.start).norm());
        EXPECT_LT(nearest, tolerance);
      }
      for (const auto& element : expected) {
        const Eigen::Vector2d& corner = element.start;
        const Eigen::Vector2d there = corner - (origin.place - place).head<2>();
        const double rise = origin.place.z() - place.z();
        EXPECT_NEAR(plan.rooms[r].ceiling.heightAt(there) + rise,
                    plan_.rooms[r].ceiling.heightAt(corner), tolerance);
        EXPECT_NEAR(plan.rooms[r].floor.heightAt(there) + rise,
                    plan_.rooms[r].floor.heightAt(corner), tolerance);
      }
    }
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static std::vector<Eigen::Vector3d> points_;
  static pcl::sedr::ScanPositions stations_;
  static Floorplan plan_;
};

std::unique_ptr<TemporaryFolder> ScansAsTheyCome::folder_;
std::vector<Eigen::Vector3d> ScansAsTheyCome::points_;
pcl::sedr::ScanPositions ScansAsTheyCome::stations_;
Floorplan ScansAsTheyCome::plan_;

TEST_F(ScansAsTheyCome, E57OfThreePosesInAGridGivesThePlanAndEveryOutputItsOrigin)
{
  writeFile(in("scan.e57"), e57());
  const ProgramRun made = model(in("scan.e57"), "of_e57");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.err.find("counted from (6916"), std::string::npos) << made.err;
  expectPlan("of_e57");
  EXPECT_EQ(made.err.find("positions"), std::string::npos) << made.err;
  EXPECT_EQ(nlohmann::json::parse(bytesOf(in("of_e57/report.json")))
                .at("positions")
                .at("known"),
            3);
  const Origin origin = planOrigin(in("of_e57/floorplan.json"));
  EXPECT_FALSE(origin.isZero());
  EXPECT_EQ(origin, planOrigin(in("of_e57/report.json")));
  for (const char* name :
       {"structure.pcd", "solid.ply", "solid.obj", "floorplan.svg", "floorplan.dxf"})
    EXPECT_NE(bytesOf(in("of_e57/") + name).find(origin.comment()), std::string::npos)
        << name;
  for (const char* name : {"structure.pcd", "solid.ply", "solid.obj"})
    EXPECT_EQ(originOfModel(in("of_e57/") + name), origin) << name;
  EXPECT_EQ(loadCloud(in("of_e57/structure.pcd")).origin, origin);
}

TEST_F(ScansAsTheyCome, SphericalE57GivesThePlan)
{
  writeFile(in("spherical.e57"), e57(true));
  ASSERT_EQ(model(in("spherical.e57"), "of_spherical").exit_code, 0);
  expectPlan("of_spherical");
}

/** Two rooms and the closet beside them, each scanned from its own station. */
class RoomsAsTheyCome : public ScansAsTheyCome {
protected:
  static void SetUpTestSuite()
  {
    scanBuilding("closet",
                 R"([{"stations": [[3, 2.4, 1.6], [6.9, 4.3, 1.5], [9.5, 2.6, 1.7]],
                      "rays": 200000, "jitter": 1, "max_range": 40, "noise": 0.01}])");
  }
};

TEST_F(RoomsAsTheyCome, E57OfEitherKindAndLasGiveThePlan)
{
  EXPECT_EQ(plan_.rooms.size(), 3u);
  for (const bool is_spherical : {false, true}) {
    writeFile(in("scan.e57"), e57(is_spherical));
    ASSERT_EQ(model(in("scan.e57"), "of_e57").exit_code, 0);
    expectPlan("of_e57");
  }
  writeFile(in("scan.las"), las());
  ASSERT_EQ(model(in("scan.las"), "of_las").exit_code, 0);
  expectPlan("of_las");
}

TEST_F(ScansAsTheyCome, PosesThatAreNotWhereTheScannerStoodDoNoHarm)
{
  std::swap(stations_[0].place, stations_[2].place);
  const std::string swapped = e57();
  std::swap(stations_[0].place, stations_[2].place);
  writeFile(in("swapped.e57"), swapped);
  ASSERT_EQ(model(in("swapped.e57"), "of_swapped").exit_code, 0);
  expectPlan("of_swapped");
}

TEST_F(ScansAsTheyCome, LasGivesThePlanAlsoByTheStandardInput)
{
  writeFile(in("scan.las"), las());
  ASSERT_EQ(model(in("scan.las"), "of_las").exit_code, 0);
  expectPlan("of_las");
  const std::string command = "cat " + programs::quoted(in("scan.las")) + " | " +
                              programs::quoted(PARALLEL_VOXEL_GRID) + " - " +
                              programs::quoted(in("piped.pcd")) + " 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  ASSERT_EQ(run(PARALLEL_VOXEL_GRID, {in("scan.las"), in("thinned.pcd")}).exit_code, 0);
  EXPECT_EQ(bytesOf(in("piped.pcd")), bytesOf(in("thinned.pcd")));
}

TEST_F(ScansAsTheyCome, TwoScansOfASiteAreComparedInOneFrame)
{
  writeFile(in("site.las"), las());
  ASSERT_EQ(model(in("site.las"), "one").exit_code, 0);
  ASSERT_EQ(model(in("site.las"), "two", {"--origin", "691590.5,5335990,0"}).exit_code,
            0);
  ASSERT_EQ(model(in("site.las"), "three", {"--origin-of", in("two")}).exit_code, 0);
  EXPECT_EQ(planOrigin(in("two/floorplan.json")), (Origin{{691590.5, 5335990, 0}}));
  EXPECT_EQ(planOrigin(in("three/floorplan.json")),
            planOrigin(in("two/floorplan.json")));
  const ProgramRun compared = run(STRUCTURE_COMPARE, {in("one"), in("two")});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_EQ(compared.out, "nothing has changed\n");
}

TEST_F(ScansAsTheyCome, BadOptionsAndScansThatStayTooLargeAreOneSentence)
{
  writeFile(in("large.las"), las());
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--no-shift"},
        {"--origin", "1,2"},
        {"--origin", "0,0,0"},
        {"--origin", "0,0,0", "--no-shift"},
        {"--origin-of", in("nowhere")},
        {"--origin-of", in("large.las")},
        {"--origin-of", in("study/scan.pcd")},
        {"--scan", "2"}}) {
    const ProgramRun made = model(in("large.las"), "refused", options);
    EXPECT_EQ(made.exit_code, 1);
    EXPECT_TRUE(made.failsInOneSentence()) << made.err;
    EXPECT_FALSE(std::filesystem::exists(in("refused")));
  }
}

TEST_F(ScansAsTheyCome, ConvertersWriteWhatIsRead)
{
  writeFile(in("scan.e57"), e57());
  writeFile(in("scan.las"), las());
  const ProgramRun listed = run(E57_TO_PCD, {in("scan.e57"), "--list"});
  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_NE(listed.out.find("station 2"), std::string::npos) << listed.out;
  EXPECT_NE(listed.out.find(Origin{stationOf(1)}.text(", ")), std::string::npos)
      << listed.out;
  ASSERT_EQ(run(E57_TO_PCD, {in("scan.e57"), in("one.pcd"), "--scan", "1"}).exit_code,
            0);
  const ToolCloud one = loadCloud(in("one.pcd"));
  ASSERT_EQ(one.size(), part(0).size());
  for (std::size_t i = 0; i < one.size(); i += 100)
    EXPECT_LT((one.origin.toGiven((*one.points)[i].getVector3fMap().cast<double>()) -
               part(0)[i])
                  .norm(),
              3e-6);
  ASSERT_EQ(run(LAS_TO_PCD, {in("scan.las"), in("all.ply")}).exit_code, 0);
  EXPECT_EQ(loadCloud(in("all.ply")).blob.data, loadCloud(in("scan.las")).blob.data);
  EXPECT_EQ(run(E57_TO_PCD, {in("scan.e57")}).exit_code, 1);
  const ProgramRun broken = run(LAS_TO_PCD, {in("scan.e57") + "x", in("no.pcd")});
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(in("no.pcd")));
}

TEST_F(ScansAsTheyCome, PositionsTellWhatWindowsMirror)
{
  ASSERT_EQ(run(SIMULATE_INDOOR_SCAN, {"big_windows", in("glass"), "--rays", "8000"})
                .exit_code,
            0);
  const std::string scan = in("glass/scan.pcd");
  const auto positionsOf = [&](const std::string& folder) {
    return nlohmann::json::parse(bytesOf(in(folder) + "/report.json")).at("positions");
  };
  ASSERT_EQ(model(scan, "unknown").exit_code, 0);
  EXPECT_TRUE(positionsOf("unknown").is_null());
  const ProgramRun made =
      model(scan, "known", {"--positions", in("glass/positions.txt")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.err.find(" mirror"), std::string::npos) << made.err;
  EXPECT_EQ(positionsOf("known").at("known"), 40);
  EXPECT_GE(positionsOf("known").at("mirrors"), 1);
  EXPECT_GT(positionsOf("known").at("mirrored_points"), 1000);
  const ProgramRun refused = model(scan, "no", {"--positions", scan});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(refused.failsInOneSentence()) << refused.err;
}

TEST_F(ScansAsTheyCome, AFileThatShrinksWhileItIsReadIsAnError)
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
    const ScanFile scan(in("shrinks"), 1, 100000);
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
    EXPECT_NE(reason.find("300000 of its " + std::to_string(bytes.size()) +
                          " bytes are left"),
              std::string::npos)
        << reason;
  }
}

TEST_F(ScansAsTheyCome, AnOutputBeyondTheLimitOfFilesLeavesNothingBehind)
{
  std::filesystem::create_directory(in("limited"));
  const std::string command = "ulimit -f 8; " + programs::quoted(PARALLEL_VOXEL_GRID) +
                              " " + programs::quoted(in("study/scan.pcd")) + " " +
                              programs::quoted(in("limited/out.pcd")) + " 2>/dev/null";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_TRUE(std::filesystem::is_empty(in("limited")));
}

} // namespace
