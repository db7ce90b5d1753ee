// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_lines.h"

#include "../formats/decimal_text.h"
#include "ceiling_borders.h"
#include "line_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr {
namespace {

constexpr double straight = 1; ///< distance of corners that are one, millimetres
constexpr double sample = 1;   ///< of a line along which two surfaces meet, millimetres

/** @brief Finds the lines of a room's ceiling. */
class LineFinder {
public:
  LineFinder(const PlanRoom& room, double finest)
      : room_(room)
      , finest_(finest)
      , borders_(room, finest)
  {}

  CeilingLines find()
  {
    CeilingLines found;
    for (const std::vector<std::size_t>& line : borders_.lines())
      addPieces(line, found.lines);
    found.part = borders_.parts();
    found.shown = borders_.shown();
    found.borders = borders_.borders();
    return found;
  }

private:
  /** @brief Returns places along a line, on the curve in which its surfaces meet:
   * borders follow that by cells only. */
  std::vector<Eigen::Vector2d> placesAlong(const std::vector<std::size_t>& line,
                                           const std::vector<Eigen::Vector2d>& ends)
  {
    std::vector<Eigen::Vector2d> places{ends.front()};
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Eigen::Vector2d way = ends[k + 1] - ends[k];
      const double steps = std::ceil(way.norm() / (sample * finest_));
      for (double i = 1; i < steps; ++i)
        places.push_back(
            placeOfMeeting({borders_.limitOf(line[k])}, ends[k] + i / steps * way));
      places.push_back(ends[k + 1]);
    }
    return places;
  }

  void addPieces(const std::vector<std::size_t>& line, std::vector<CeilingLine>& found)
  {
    const std::vector<Eigen::Vector2d> places = borders_.placesOf(line);
    const bool is_crease =
        borders_.share(line, [](const Meeting& m) { return m.is_crease; }) >= 0.5;
    if (const PlanElement* arc = borders_.arcAt(line.front())) {
      const bool is_whole = (places.front() - places.back()).norm() < 1e-6;
      found.push_back({is_whole
                           ? *arc
                           : partPassing(*arc, places.front(), places.back(),
                                         borders_.border(line[line.size() / 2]).middle),
                       is_crease,
                       {}});
      return;
    }
    const std::size_t begin = found.size();
    for (const PlanElement& piece :
         withoutBulges(piecesOf(placesAlong(line, places), straight * finest_),
                       min_part_area * finest_ * finest_))
      found.push_back({piece, is_crease, {}});
    const auto longest =
        std::max_element(found.begin() + static_cast<std::ptrdiff_t>(begin),
                         found.end(), [](const CeilingLine& a, const CeilingLine& b) {
                           return a.element.length() < b.element.length();
                         });
    if (is_crease)
      longest->text = textOf(line, longest->element);
  }

  std::string textOf(const std::vector<std::size_t>& line,
                     const PlanElement& piece) const
  {
    constexpr double level = 0.05; // maximum height difference along a level line
    const Eigen::Vector2d middle = (piece.start + piece.end) / 2;
    const auto offOf = [&](std::size_t e) {
      return (borders_.border(e).middle - middle).norm();
    };
    const std::size_t nearest =
        *std::min_element(line.begin(), line.end(), [&](std::size_t a, std::size_t b) {
          return offOf(a) < offOf(b);
        });
    const PlanSlab& ceiling = borders_.slabOn(nearest, true);
    if (!borders_.border(nearest).meeting.is_crease ||
        std::abs(ceiling.heightAt(piece.start) - ceiling.heightAt(piece.end)) >= level)
      return "";
    return (borders_.border(nearest).meeting.is_ridge ? "ridge " : "valley ") +
           decimalText(ceiling.heightAt(middle) - room_.floorAt(middle), 2);
  }

  const PlanRoom& room_;
  double finest_;
  CeilingBorders borders_;
};

} // namespace

bool
CeilingLines::isStep(int a, int b, const Eigen::Vector2d& place) const
{
  const auto found = borders.find(std::minmax({a, b}));
  if (found == borders.end())
    return false;
  return std::min_element(found->second.begin(), found->second.end(),
                          [&](const auto& one, const auto& other) {
                            return one.first.distance(place) <
                                   other.first.distance(place);
                          })
      ->second;
}

CeilingLines
ceilingLines(const PlanRoom& room, double finest)
{
  if (room.hasFacets())
    return LineFinder(room, finest).find();
  CeilingLines none;
  none.shown.resize(room.details.size() + 1);
  std::iota(none.shown.begin(), none.shown.end(), -1);
  none.part.resize(room.details.size() + 1);
  std::iota(none.part.begin(), none.part.end(), std::size_t{0});
  return none;
}

} // namespace pcl::sedr
