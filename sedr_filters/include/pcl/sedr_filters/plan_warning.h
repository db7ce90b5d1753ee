// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief What a warning tells of, in the order of telling. */
enum class WarningKind {
  Coverage,      ///< modelled, seen m2, %; missing m2, z from, to; reason
  Unit,          ///< reason
  Up,            ///< reason
  LostPoints,    ///< %
  Strays,        ///< % of the points
  Noise,         ///< cm off planes of 30 cm, half of the points
  Positions,     ///< of the scanner, untrue, all
  Mirrors,       ///< surfaces, thinned points
  Levelled,      ///< degrees, direction; reason
  Sparse,        ///< cell wanted, used
  NoPlan,        ///< reason
  Stage,         ///< reason
  LeftOut,       ///< m2; reason
  Hidden,        ///< m2 unseen, all; m of outline unseen
  Open,          ///< m of outline without wall or opening
  NoOpening,     ///< m wide, high; the other room it leads to
  FilledIn,      ///< % of its walls not measured, inferred, unseen
  GuessedWall,   ///< m, % inferred, unseen
  CeilingApart,  ///< m2
  CeilingUnseen, ///< m2
  PartUnseen,    ///< m2 of a lower part of a ceiling
  CeilingOff,    ///< m2 off the model, from, to m above the floor
  FloorOff,      ///< likewise
  FloorUnseen,   ///< m2
  WallOff,       ///< m2 off, mean cm, above 0: before it; m of a ceiling behind it
  Standing,      ///< m2 of what is not in the plan; m high if it may be a half wall
  Hanging,       ///< m2, m below the rest, % seen of its best side
  Tilted,        ///< degrees, positive into the room
  NotAdjusted,   ///< reason
  Crossing,      ///< the other room; the room itself if both meet
  Contradiction, ///< m2 left out of the solid; reason
  OpeningClosed, ///< openings that stay closed in the solid, all; reason: numbers
  NoSolid,       ///< reason
  NotInIfc,      ///< openings in no wall, all; reason: numbers
  IfcLoss,       ///< reason
  Mesh,          ///< reason
  MeshVolume,    ///< m3 of the mesh, of the solid
  NoDoor,        ///< m2
  NarrowDoor,    ///< m
  SmallRoom,     ///< m2
  NarrowRoom,    ///< m
  Height,        ///< m
  ShortWalls,    ///< m: their mean
  FlatArc,       ///< rise in cm, radius in m
  InLine,        ///< m of the edge of a soffit that goes on where the wall ends
  RaisedFloor,   ///< m2, m above the floor
  SmallStorey,   ///< m2; reason: its name
  OneRoom,       ///< m2 of the smaller, % of chance; the other room
  TwoRooms,      ///< m2 of the smaller part, % of chance
  Edited         ///< reason
};

/** @brief What a warning puts at stake: nothing, as many square metres as its first
 * value tells, those of its room or those of the plan. */
enum class Stake { None, Value, Room, Plan };

/** @brief What to make of a kind of warning. */
struct WarningAdvice {
  const char* act; ///< what to do, before the name of a wall or room: "look at"
  Stake stake;     ///< other than that of a wall or opening, see Certainty
  double odds;     ///< probability that what is at stake is wrong
};

/** @brief What a stage doubts, for programs; sentenceOf() tells it in words. */
struct PlanWarning {
  WarningKind kind = WarningKind::Stage;
  std::vector<double> values{}; ///< see WarningKind; the first tells how much
  std::uint32_t room = 0;       ///< 0: not of one room
  std::size_t wall = 0;         ///< number within the room, from 1; 0: of no wall
  std::string reason{};         ///< of a stage, in words
  /** In plan; NaN if not known. */
  Eigen::Vector2d at =
      Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::string note{}; ///< on the warning, in words
};

/** @brief Returns a warning in words of its own. */
inline PlanWarning
warningOf(WarningKind kind,
          std::string reason,
          std::vector<double> values = {},
          std::uint32_t room = 0)
{
  return {kind, std::move(values), room, 0, std::move(reason)};
}

/** @brief Returns the name of a kind in files: "ceiling_off". */
std::string nameOf(WarningKind kind);

/** @brief Returns the kind of that name; nothing if there is none. */
std::optional<WarningKind> warningKindOf(const std::string& name);

WarningAdvice adviceOn(WarningKind kind);

/** @brief Returns what a warning is about: "wall 3.12", "room 3"; empty: the whole. */
std::string subjectOf(const PlanWarning& warning);

/** @brief Returns what it tells: "it is tilted by 2.10 degrees into the room". */
std::string claimOf(const PlanWarning& warning);

/** @brief Returns both: "wall 3.12: it is tilted by 2.10 degrees into the room". */
std::string sentenceOf(const PlanWarning& warning);

} // namespace pcl::sedr
