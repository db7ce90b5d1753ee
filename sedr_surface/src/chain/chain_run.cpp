// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <pcl/sedr_segmentation/tilted_faces.h>

#include <chrono>
#include <cmath>

namespace pcl::sedr {

bool
ChainRun::runStage(const std::string& name,
                   std::size_t points_in,
                   bool (ChainRun::*step)(StageReport&))
{
  if (chain_.on_stage)
    chain_.on_stage(name);
  StageReport report{name, points_in, 0, 0};
  chain_.failed_stage = name;
  if (chain_.is_cancelled && chain_.is_cancelled()) {
    chain_.problem = "cancelled before " + name;
    return false;
  }
  const auto start = std::chrono::steady_clock::now();
  const bool is_done = (this->*step)(report);
  report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  chain_.reports.push_back(report);
  if (is_done)
    chain_.failed_stage.clear();
  return is_done;
}

bool
ChainRun::fail(const std::string& reason)
{
  chain_.problem = reason;
  const std::string doubt = inchProblem(PointView(*chain_.cloud), 0);
  if (!doubt.empty())
    chain_.problem += "; " + doubt;
  if (up_doubt_.isDoubtful() && reason != up_doubt_.reason)
    chain_.problem += "; " + up_doubt_.reason;
  return false;
}

void
ChainRun::warn(std::uint32_t room, const std::string& reason)
{
  warn({WarningKind::Stage, {}, room, 0, reason});
}

/** @brief Warns if half of the scanned points and more are not finite. */
void
ChainRun::warnOfLostPoints()
{
  const PointView raw = chain_.floorplan_fitting.getRawPoints();
  std::size_t lost = 0;
  for (std::size_t i = 0; i < raw.size(); ++i)
    lost += raw.isFinite(i) ? 0 : 1;
  if (lost > 0 && 2 * lost >= raw.size())
    warn({WarningKind::LostPoints,
          {100.0 * static_cast<double>(lost) / static_cast<double>(raw.size())}});
}

bool
ChainRun::checkScan()
{
  chain_.failed_stage = "input";
  if (const std::string wrong = problemOf(chain_.priors_); !wrong.empty())
    return fail(wrong);
  if (chain_.trust_up)
    return true;
  std::vector<Eigen::Vector3d> stations;
  for (const Eigen::Vector3f& place :
       sight_ ? sight_->places() : std::vector<Eigen::Vector3f>())
    stations.push_back(place.cast<double>());
  up_doubt_ = doubtOfUp(PointView(*chain_.cloud), *allIndices(chain_.cloud->size()),
                        stations, chain_.room_segmentation.getNumberOfThreads(),
                        chain_.priors_, chain_.unit_is_known);
  if (up_doubt_.isInclined())
    return fail(up_doubt_.reason);
  if (up_doubt_.isDoubtful())
    warn({WarningKind::Up, {}, 0, 0, up_doubt_.reason});
  return true;
}

namespace {

/** @brief Returns the centre of the bounding box of the finite points. */
Eigen::Vector3d
middleOf(const StructureChain::Cloud& cloud)
{
  Eigen::AlignedBox3d box;
  for (const auto& p : cloud)
    if (p.getVector3fMap().allFinite())
      box.extend(p.getVector3fMap().cast<double>().eval());
  return box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.center();
}

} // namespace

void
ChainRun::levelScan()
{
  if (!(up_doubt_.tilt.angle > 0))
    return;
  chain_.levelling = Levelling::of(up_doubt_.tilt.up, middleOf(*chain_.cloud));
  for (auto& p : *chain_.cloud)
    p.getVector3fMap() =
        chain_.levelling->level(p.getVector3fMap().cast<double>()).cast<float>();
  chain_.floorplan_fitting.moveRawPoints(
      [&](const Eigen::Vector3d& p) { return chain_.levelling->level(p); });
  if (sight_)
    sight_ = std::make_shared<SightLines>(sight_->levelled(*chain_.levelling));
  warn(warningOf(WarningKind::Levelled,
                 chain_.keep_levelled ? "points, mesh and solid stay level"
                                      : "points, mesh and solid are turned back",
                 {chain_.levelling->angle() * 180 / M_PI,
                  chain_.levelling->direction() * 180 / M_PI}));
}

void
ChainRun::makeWallsVertical()
{
  faces_ = tiltedFaces(PointView(*chain_.cloud), *allIndices(chain_.cloud->size()),
                       chain_.room_segmentation.getNumberOfThreads());
  if (faces_.empty())
    return;
  scanned_.reset(new Cloud(*chain_.cloud));
  for (auto& p : *chain_.cloud)
    p.getVector3fMap() =
        withVerticalWalls(faces_, p.getVector3fMap().cast<double>()).cast<float>();
}

bool
ChainRun::findStructure()
{
  warnOfLostPoints();
  if (chain_.stray_share >= 5e-4)
    warn({WarningKind::Strays, {100 * chain_.stray_share}});
  const MirrorFigures& mirrored = chain_.mirrored;
  if (mirrored.untrue > 0)
    warn({WarningKind::Positions,
          {static_cast<double>(mirrored.untrue),
           static_cast<double>(mirrored.positions)}});
  if (mirrored.points > 0)
    warn({WarningKind::Mirrors,
          {static_cast<double>(mirrored.mirrors),
           static_cast<double>(mirrored.points)}});
  if (!checkScan())
    return false;
  levelScan();
  makeWallsVertical();
  const std::size_t n = chain_.cloud->size();
  return runStage("RoomSegmentation", n, &ChainRun::partRooms) &&
         runStage("HorizontalPlaneDetection", n, &ChainRun::findPlanes) &&
         runStage("CeilingBoundaryWallGrowing", n, &ChainRun::growWalls) &&
         runStage("FloorplanFitting", chain_.cloud->size(), &ChainRun::fitPlan) &&
         runStage("OpeningDetection", chain_.cloud->size(), &ChainRun::findOpenings) &&
         runStage("StructureRefinement", chain_.cloud->size(), &ChainRun::refine) &&
         runStage("VerticalHoleRepair", chain_.reports.back().points_out,
                  &ChainRun::repair) &&
         runStage("FloorplanExtrusion", chain_.structure->size(), &ChainRun::extrude);
}

bool
ChainRun::makeMesh()
{
  return runStage("StructuralPoisson", chain_.structure->size(), &ChainRun::mesh);
}

} // namespace pcl::sedr
