// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief What an opening is. */
enum class OpeningKind { Unknown, Door, Window, Passage };

/** @brief The end of an opening at which its leaf hangs; both: it has two leaves. */
enum class OpeningHinge { Unknown, Start, End, Both };

/** @brief Whether a leaf, sash or blind shuts an opening. */
enum class OpeningState { Unknown, Closed, Ajar, Open };

/** @brief What shows an edge of an opening, from the worst to the best: nothing, so
 * that it may lie far off; the end of a leaf or pane; the end of the wall's face; or
 * the plane of its reveal. */
enum class EdgeSeen { Nothing, Leaf, Rim, Reveal };

/** @brief How an edge of an opening was seen. */
struct OpeningEdge {
  EdgeSeen seen = EdgeSeen::Nothing;
  double error = 0; ///< standard error of its place, metres; 0: not known
};

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
  double confidence = 0;   ///< probability of `kind`, or of the likeliest if unknown
  double residual = 0;     ///< root mean square of the errors of its edges
  double deviation_95 = 0; ///< distance from its edges within which 95 % of the points
                           ///< that show them lie; 0: none does
  std::array<OpeningEdge, 4> edges{}; ///< at start and end, at bottom and top
  bool is_confirmed = false;          ///< somebody looked, and it is as the plan has it
  std::uint32_t number = 0; ///< in its kind, see numberOpenings(); 0: not numbered yet

  double width() const;
  double height() const { return top - bottom; }
  bool leadsOutside() const { return rooms[0] == 0 || rooms[1] == 0; }
  bool hasSeenReveals() const { return depth != unseen_reveal; }
  /** @brief Returns the standard error of its width; 0: that of a jamb is not known. */
  double widthError() const
  {
    const double errors[] = {edges[0].error, edges[1].error};
    return std::min(errors[0], errors[1]) > 0 ? std::hypot(errors[0], errors[1]) : 0;
  }
  /** @brief Returns what shows the worse one of its jambs. */
  EdgeSeen jambsSeen() const { return std::min(edges[0].seen, edges[1].seen); }
  /** @brief Forgets how well its edges are known, as they were edited. */
  void forgetAccuracy()
  {
    residual = deviation_95 = 0;
    edges = {};
    is_confirmed = false;
  }
};

} // namespace pcl::sedr
