// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/result_folder.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/straightening.h>
#include <pcl/sedr_surface/mesh_distance.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Facts of a room for the page; unknown ones are empty. */
struct RoomFacts {
  std::uint32_t id = 0;
  double area = 0;      ///< of the floor, square metres
  double perimeter = 0; ///< metres
  double height = 0;    ///< mean, metres
  double volume = 0;    ///< cubic metres
  std::size_t walls = 0;
  std::size_t columns = 0;
  std::size_t details = 0;
  std::optional<double> wall_area;      ///< of the solid, square metres
  std::optional<double> repaired_share; ///< of its points, added and not seen
  std::optional<bool> mesh_closed;
  std::optional<bool> solid_closed;
  std::string mesh_problem;
  std::string solid_problem;
};

struct StageFacts {
  std::string name;
  std::size_t points_in = 0;
  std::size_t points_out = 0;
  double seconds = 0;
};

/** @brief A seen area that is not in the plan. */
struct GapFacts {
  std::string reason;
  double area = 0; ///< square metres
  double floor = 0;
  double ceiling = 0;
  double x = 0;
  double y = 0;
  bool counts = true;
};

/** @brief Coverage of the floor. */
struct CoverageFacts {
  double seen = 0;     ///< square metres
  double modelled = 0; ///< square metres
  double share = 0;
  std::vector<GapFacts> left_out;
};

/** @brief Content of report.json and floorplan.json, as far as present. */
struct ReportData {
  std::string scan; ///< path as given
  std::size_t points = 0;
  double unit = 1; ///< metres
  std::vector<RoomFacts> rooms;
  std::vector<StageFacts> stages;
  std::optional<CoverageFacts> coverage;
  std::vector<std::pair<std::string, std::string>> parameters; ///< name, value
  std::vector<std::string> warnings;
  std::optional<DistanceStatistics> distances; ///< from labelled scan to mesh
  std::size_t mesh_triangles = 0;
  Floorplan plan;
  WallTilts tilts;                     ///< of walls of the plan
  double max_wall = Priors().max_wall; ///< maximum thickness of a wall, metres
  std::vector<PlanStorey> storeys;     ///< of the plan, from the lowest up

  double area() const;
  double volume() const;
};

/** @brief Reads both files; members that are missing or of another type are skipped. */
ReportData readReportData(const ResultFolder& folder);

} // namespace pcl::sedr::tools
