// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief What an opening is. */
enum class OpeningKind { Unknown, Door, Window, Passage };

/** @brief The end of an opening at which its leaf hangs; both: it has two leaves. */
enum class OpeningHinge { Unknown, Start, End, Both };

/** @brief Whether a leaf, sash or blind shuts an opening. */
enum class OpeningState { Unknown, Closed, Ajar, Open };

/** @brief A wall that an opening is in: an element of a room's boundary. */
struct OpeningWall {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::size_t element = 0;
};

/** @brief Depth of an opening whose reveals were not seen, metres. */
constexpr double unseen_reveal = 0.3;

/** @brief A door, window or passage through a wall; metres. */
struct PlanOpening {
  OpeningKind kind = OpeningKind::Unknown;
  /** Ids of the rooms on its two sides: first the one to the left of the direction from
   * start to end; 0 outside, or a side that is not in the plan. */
  std::array<std::uint32_t, 2> rooms{};
  std::vector<OpeningWall> walls;                  ///< one or two; none of a column
  Eigen::Vector2d start = Eigen::Vector2d::Zero(); ///< in the middle of the wall
  Eigen::Vector2d end = Eigen::Vector2d::Zero();   ///< in the middle of the wall
  double bottom = 0;
  double top = 0;   ///< of an arched head: its highest point
  double rise = 0;  ///< of an arched head; 0: it is flat
  double depth = 0; ///< of a wall with two faces its thickness, else of the reveals as
                    ///< far as they were seen, from 0.1 m up, or unseen_reveal
  OpeningHinge hinge = OpeningHinge::Unknown;
  std::uint32_t swing = 0; ///< the one of `rooms` it opens into, if the hinge is known
  OpeningState state = OpeningState::Unknown;
  double confidence = 0;    ///< probability of `kind`, or of the likeliest if unknown
  double residual = 0;      ///< standard deviation of its edges
  double deviation_95 = 0;  ///< distance from its edges within which 95 % of the points
                            ///< that show them lie; 0: none does
  std::uint32_t number = 0; ///< in its kind, see numberOpenings(); 0: not numbered yet

  double width() const { return (end - start).norm(); }
  double height() const { return top - bottom; }
  bool leadsOutside() const { return rooms[0] == 0 || rooms[1] == 0; }
  bool hasSeenReveals() const { return depth != unseen_reveal; }
};

/** @brief A leaf of a door, at the face of the wall that it turns away from. */
struct OpeningLeaf {
  Eigen::Vector2d hinge = Eigen::Vector2d::Zero();
  Eigen::Vector2d shut = Eigen::Vector2d::Zero(); ///< where it ends when shut
  Eigen::Vector2d open = Eigen::Vector2d::Zero(); ///< likewise, turned by 90 degrees
};

/** @brief Returns the leaves of an opening whose hinge is known. */
std::vector<OpeningLeaf> leavesOf(const PlanOpening& opening);

/** @brief Returns the hand of a door's leaf as one sees it who pushes it open, as IFC
 * does: "left" or "right", where its hinges are; "double"; "" if it is not known. */
std::string leafOf(const PlanOpening& opening);

/** @brief Checks whether an opening is at a place in plan: beside its width, less than
 * 0.5 m off the middle of its wall, at heights that overlap its own. */
bool isAt(const PlanOpening& opening,
          const Eigen::Vector2d& place,
          double bottom,
          double top);

/** @brief Returns the name of a kind in files: "door". */
const char* nameOf(OpeningKind kind);

/** @brief Returns the number of an opening on drawings and in schedules: "D3" for a
 * door, "W12" for a window, "P1" for a passage, "O2" for one of unknown kind. */
std::string markOf(const PlanOpening& opening);

} // namespace pcl::sedr
