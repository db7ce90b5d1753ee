// SPDX-License-Identifier: BSD-3-Clause
#include "chain_stages.h"

#include "../mesh/mesh_repair.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <cmath>
#include <map>

namespace pcl::sedr {

TriangleMesh
StructureModel::inScanFrame(TriangleMesh mesh) const
{
  if (isMoved())
    for (Eigen::Vector3d& v : mesh.vertices)
      v = levelling->back(v);
  return mesh;
}

void
moveCloud(const BuildingFrame& frame, StructureModel::Cloud& cloud)
{
  for (auto& p : cloud)
    p.getVector3fMap() =
        frame.toBuilding(p.getVector3fMap().cast<double>()).cast<float>();
}

namespace {

template <typename Move>
void
moveStructure(const Move& move,
              const Eigen::Matrix3d& rotation,
              StructureModel::StructureCloud& structure)
{
  for (auto& p : structure) {
    p.getVector3fMap() = move(p.getVector3fMap().cast<double>()).template cast<float>();
    p.getNormalVector3fMap() =
        (rotation * p.getNormalVector3fMap().cast<double>()).cast<float>();
  }
}

} // namespace

StructureModel::StructureCloud::Ptr
StructureModel::structureInScanFrame() const
{
  if (!isMoved())
    return structure;
  const StructureCloud::Ptr turned(new StructureCloud(*structure));
  moveStructure([&](const Eigen::Vector3d& p) { return levelling->back(p); },
                levelling->rotation.transpose(), *turned);
  return turned;
}

void
moveBack(StructureModel& model)
{
  const BuildingFrame back = model.frame.to(model.levelFrame());
  const Eigen::Vector3d shift = back.toBuilding(Eigen::Vector3d::Zero());
  const auto movePlace = [&](Eigen::Vector2d& at) {
    at = back.toBuilding({at.x(), at.y(), 0}).head<2>();
  };
  moveCloud(back, *model.cloud);
  moveStructure([&](const Eigen::Vector3d& p) { return back.toBuilding(p); },
                back.rotation, *model.structure);
  *model.plan = moved(std::move(*model.plan), back.yaw(), shift);
  for (PlanWarning& warning : model.warnings)
    movePlace(warning.at);
  for (CoverageGap& gap : model.coverage.left_out) {
    movePlace(gap.at);
    gap.floor += shift.z();
    gap.ceiling += shift.z();
  }
}

void
warnOfInput(const PointView& raw, StructureModel& model)
{
  const auto warn = [&](WarningKind kind, std::vector<double> values) {
    model.warnings.push_back({kind, std::move(values)});
  };
  std::size_t lost = 0; // not finite
  for (std::size_t i = 0; i < raw.size(); ++i)
    lost += raw.isFinite(i) ? 0 : 1;
  if (lost > 0 && 2 * lost >= raw.size())
    warn(WarningKind::LostPoints,
         {100.0 * static_cast<double>(lost) / static_cast<double>(raw.size())});
  if (model.stray_share >= 5e-4)
    warn(WarningKind::Strays, {100 * model.stray_share});
  const MirrorFigures& mirrored = model.mirrored;
  if (mirrored.untrue > 0)
    warn(WarningKind::Positions, {static_cast<double>(mirrored.untrue),
                                  static_cast<double>(mirrored.positions)});
  if (mirrored.points > 0)
    warn(WarningKind::Mirrors,
         {static_cast<double>(mirrored.mirrors), static_cast<double>(mirrored.points)});
}

void
warnOfGuesses(StructureModel& model)
{
  constexpr double enough = 0.55;
  constexpr double worth_word = 0.5; // metres; shorter walls follow their neighbours
  const Floorplan& plan = *model.plan;
  for (const PlanRoom& room : plan.rooms) {
    const WallShares all = wallShares(plan, room);
    if (all.area > 0 && all.measured < enough)
      model.warnings.push_back(
          {WarningKind::FilledIn,
           {100 * (1 - all.measured), 100 * all.inferred, 100 * all.unseen},
           room.id});
    for (std::size_t e = 0; e < room.boundary.elements.size(); ++e) {
      const WallShares shares = wallShares(plan, room, e);
      const double length = room.boundary.elements[e].length();
      if (shares.isGuess() && length >= worth_word)
        model.warnings.push_back({WarningKind::GuessedWall,
                                  {length, 100 * shares.inferred, 100 * shares.unseen},
                                  room.id,
                                  e + 1});
    }
  }
}

void
warnOfVolumes(const std::vector<RoomSolidReport>& solids,
              const std::vector<RoomPoissonReport>& meshes,
              StructureModel& model)
{
  constexpr double exact = 0.2; // of a cell: how exact the surface of a mesh is
  std::map<std::uint32_t, double> volumes; // of closed solids, by room
  for (const RoomSolidReport& solid : solids)
    if (solid.closed)
      volumes[solid.room] = solid.volume;
  for (const RoomPoissonReport& mesh : meshes) {
    const auto solid = volumes.find(mesh.room);
    if (mesh.closed && solid != volumes.end() &&
        std::abs(mesh.volume - solid->second) > exact * mesh.cell * mesh.area)
      model.warnings.push_back(
          {WarningKind::MeshVolume, {mesh.volume, solid->second}, mesh.room});
  }
}

} // namespace pcl::sedr
