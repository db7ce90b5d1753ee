// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/scan/scan_up.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <pcl/sedr_segmentation/building_frame.h>

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
  if (!chain_.up_doubt_.empty() && reason != chain_.up_doubt_)
    chain_.problem += "; " + chain_.up_doubt_;
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

bool
ChainRun::checkUp(const ScanPositions& positions)
{
  if (chain_.trust_up)
    return true;
  std::vector<Eigen::Vector3d> stations;
  for (const ScanPosition& position : positions)
    if (position.isKnown())
      stations.push_back(position.place.cast<double>());
  if (stations.empty() && sight_)
    for (const Eigen::Vector3f& place : sight_->places())
      stations.push_back(place.cast<double>());
  const UpDoubt doubt =
      doubtOfUp(PointView(*chain_.cloud), *allIndices(chain_.cloud->size()), stations,
                chain_.room_segmentation.getNumberOfThreads(), chain_.priors_,
                {chain_.up_is_known, chain_.unit_is_known});
  chain_.seems_in_feet_ = doubt.is_in_feet;
  if (doubt.isDoubtful())
    chain_.up_doubt_ = doubt.reason;
  if (doubt.isCertain())
    return refuse(doubt.reason);
  if (doubt.feet_nats > UpDoubt::certain)
    return refuse(doubt.unit_reason);
  if (doubt.isDoubtful())
    warn({WarningKind::Up, {}, 0, 0, doubt.reason});
  if (doubt.tilt.angle > 0) {
    chain_.levelling = Levelling::of(doubt.tilt.up, middleOf(*chain_.cloud));
    warn(warningOf(WarningKind::Levelled,
                   chain_.keep_levelled ? "points, mesh and solid stay level"
                                        : "points, mesh and solid are turned back",
                   {chain_.levelling->angle() * 180 / M_PI,
                    chain_.levelling->direction() * 180 / M_PI}));
  }
  return true;
}

bool
ChainRun::findFrame(const ScanPositions& positions, bool own)
{
  chain_.failed_stage = "input";
  if (const std::string wrong = problemOf(chain_.priors_); !wrong.empty())
    return fail(wrong);
  if (!checkUp(positions))
    return false;
  chain_.frame = own ? findBuildingFrame(PointView(*chain_.cloud), {},
                                         chain_.room_segmentation.getNumberOfThreads(),
                                         chain_.levelFrame().rotation,
                                         chain_.plane_detection.getGridSize())
                     : chain_.levelFrame();
  return true;
}

void
ChainRun::moveToBuilding()
{
  for (auto& p : *chain_.cloud)
    p.getVector3fMap() =
        chain_.frame.toBuilding(p.getVector3fMap().cast<double>()).cast<float>();
  chain_.floorplan_fitting.moveRawPoints(
      [&](const Eigen::Vector3d& p) { return chain_.frame.toBuilding(p); });
  if (sight_)
    sight_ = std::make_shared<SightLines>(sight_->moved(chain_.frame));
}

void
ChainRun::moveBack()
{
  const BuildingFrame back = chain_.frame.to(chain_.levelFrame());
  const Eigen::Vector3d shift = back.toBuilding(Eigen::Vector3d::Zero());
  const auto movePlace = [&](Eigen::Vector2d& at) {
    at = back.toBuilding({at.x(), at.y(), 0}).head<2>();
  };
  for (auto& p : *chain_.cloud)
    p.getVector3fMap() =
        back.toBuilding(p.getVector3fMap().cast<double>()).cast<float>();
  for (auto& p : *chain_.structure) {
    p.getVector3fMap() =
        back.toBuilding(p.getVector3fMap().cast<double>()).cast<float>();
    p.getNormalVector3fMap() =
        (back.rotation * p.getNormalVector3fMap().cast<double>()).cast<float>();
  }
  *chain_.plan = moved(std::move(*chain_.plan), back.yaw(), shift);
  for (PlanWarning& warning : chain_.warnings)
    movePlace(warning.at);
  for (CoverageGap& gap : chain_.coverage.left_out) {
    movePlace(gap.at);
    gap.floor += shift.z();
    gap.ceiling += shift.z();
  }
}

void
ChainRun::warnOfInput()
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
}

bool
ChainRun::findStructure()
{
  warnOfInput();
  const std::size_t n = chain_.cloud->size();
  const bool is_found =
      runStage("RoomSegmentation", n, &ChainRun::partRooms) &&
      runStage("HorizontalPlaneDetection", n, &ChainRun::findPlanes) &&
      runStage("CeilingBoundaryWallGrowing", n, &ChainRun::growWalls) &&
      runStage("FloorplanFitting", n, &ChainRun::fitPlan) &&
      runStage("OpeningDetection", n, &ChainRun::findOpenings) &&
      runStage("StructureRefinement", n, &ChainRun::refine) &&
      runStage("VerticalHoleRepair", chain_.reports.back().points_out,
               &ChainRun::repair);
  chain_.coverage = coverageOf(chain_.getBuilding(), *chain_.plan);
  moveBack();
  return is_found &&
         runStage("FloorplanExtrusion", chain_.structure->size(), &ChainRun::extrude);
}

bool
ChainRun::makeMesh()
{
  return runStage("StructuralPoisson", chain_.structure->size(), &ChainRun::mesh);
}

} // namespace pcl::sedr
