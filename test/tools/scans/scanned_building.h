// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_writer.h"
#include "las_writer.h"
#include "plan_file.h"
#include "scan_file.h"
#include "tool_cloud.h"
#include "tools/in_folder.h"
#include "tools/sample_files.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace programs {

/** A simulated room as E57 and LAS in a national grid, and the plan of its PCD. */
class ScannedBuilding : public ::testing::Test {
protected:
  /** Position of the building in its grid. */
  static inline const Eigen::Vector3d place{691600, 5336000, 12};

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
    const pcl::sedr::tools::ToolCloud scan =
        pcl::sedr::tools::loadCloud(in("study/scan.pcd"));
    for (const auto& p : *scan.points)
      points_.push_back(p.getVector3fMap().cast<double>());
    pcl::sedr::tools::ScanSettings settings;
    settings.positions = in("study/positions.txt");
    stations_ = pcl::sedr::tools::ScanFile(in("study/scan.pcd"), settings).positions();
    ASSERT_EQ(stations_.size(), 3u);
  }

  static void TearDownTestSuite()
  {
    folder_.reset();
    points_.clear();
    stations_.clear();
    plan_.rooms.clear();
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
    return {E57TestField::ofReals<double>("sphericalRange", range),
            E57TestField::ofReals<double>("sphericalAzimuth", azimuth),
            E57TestField::ofReals<double>("sphericalElevation", elevation)};
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
    if (plan_.rooms.empty()) {
      const std::vector<std::string> positions{"--positions",
                                               in("study/positions.txt")};
      ASSERT_EQ(model(in("study/scan.pcd"), "model", positions).exit_code, 0);
      plan_ = pcl::sedr::tools::loadPlan(in("model/floorplan.json")).plan;
      ASSERT_FALSE(plan_.rooms.empty());
    }
    const std::string path = in(folder) + "/floorplan.json";
    const pcl::sedr::PlanDocument file = pcl::sedr::tools::loadPlan(path);
    const pcl::sedr::Floorplan& plan = file.plan;
    const pcl::sedr::Origin& origin = file.origin;
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

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline std::vector<Eigen::Vector3d> points_;
  static inline pcl::sedr::ScanPositions stations_;
  static inline pcl::sedr::Floorplan plan_;
};

} // namespace programs
