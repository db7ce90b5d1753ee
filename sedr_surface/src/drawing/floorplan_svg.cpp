// SPDX-License-Identifier: BSD-3-Clause
#include "../formats/decimal_text.h"
#include "doorway_drawing.h"
#include "plan_drawing.h"
#include "svg_text.h"
#include "text_places.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

#include <pcl/sedr_filters/storeys.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace pcl {
namespace sedr {

namespace {

// Millimetres of paper.
constexpr double page_long = 297; // A4
constexpr double page_short = 210;
constexpr double margin_left = 20; // with the overall size
constexpr double margin_right = 8;
constexpr double margin_top = 8;
constexpr double margin_bottom = 30; // with overall size, scale bar and title
constexpr double least_width = 140;  // of the page: scale bar, scale and north
constexpr double room_font = 3.2;
constexpr double size_font = 2.0;

/** @brief Writes a plan on a page. */
class SvgPage {
public:
  /** @param bounds of what the page has room for
   * @param name of what is drawn, empty for all there is */
  SvgPage(const Floorplan& plan,
          double scale,
          const Eigen::AlignedBox2d& bounds,
          const std::string& name,
          const Origin& origin)
      : plan_(plan)
      , scale_(scale)
      , bounds_(bounds)
      , name_(svgText(name))
      , origin_(origin)
  {
    if (bounds_.isEmpty())
      bounds_.extend(Eigen::Vector2d(0, 0));
    drawn_ = bounds_.sizes() * 1000 / scale_;
    size_.x() = std::max(least_width, margin_left + drawn_.x() + margin_right);
    size_.y() = margin_top + drawn_.y() + margin_bottom;
  }

  std::string write()
  {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         << "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\""
         << mm(size_.x()) << "mm\" height=\"" << mm(size_.y()) << "mm\" viewBox=\"0 0 "
         << mm(size_.x()) << ' ' << mm(size_.y())
         << "\">\n<title>Floor plan 1:" << mm(scale_) << (name_.empty() ? "" : ", ")
         << name_ << "</title>\n";
    if (!origin_.isZero())
      out_ << "<desc>" << origin_.comment() << "</desc>\n";
    out_ << "<style>" << svg_style << "</style>\n"
         << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    for (const PlanRoom& room : plan_.rooms)
      writeRoom(room);
    writeDoorways();
    writeStairs();
    if (!plan_.rooms.empty()) {
      writeOverallSize();
      writeScaleBar();
      writeTitle();
      writeNorth();
    }
    out_ << "</svg>\n";
    return out_.str();
  }

private:
  Eigen::Vector2d onPage(const Eigen::Vector2d& p) const
  {
    return {margin_left + (p.x() - bounds_.min().x()) * 1000 / scale_,
            margin_top + (bounds_.max().y() - p.y()) * 1000 / scale_};
  }

  std::string at(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d q = onPage(p);
    return mm(q.x()) + " " + mm(q.y());
  }

  /** @brief The path of an element whose start has been reached. */
  std::string pathTo(const PlanElement& e) const
  {
    if (!e.isArc())
      return "L " + at(e.end);
    const double sweep = e.sweep();
    const std::string radius = mm(e.radius * 1000 / scale_);
    const auto arcTo = [&](const Eigen::Vector2d& end, double turn) {
      // The page's y runs down, so that what turns left turns right.
      return "A " + radius + " " + radius + " 0 " +
             (std::abs(turn) > M_PI ? "1" : "0") + (turn > 0 ? " 0 " : " 1 ") + at(end);
    };
    if (std::abs(sweep) < 1.9 * M_PI)
      return arcTo(e.end, sweep);
    // Ends that coincide say nothing of a circle: two halves do.
    return arcTo(e.pointAt(e.length() / 2), sweep / 2) + " " + arcTo(e.end, sweep / 2);
  }

  std::string pathOf(const PlanLoop& loop) const
  {
    std::string path = "M " + at(loop.elements.front().start);
    for (const PlanElement& e : loop.elements)
      path += " " + pathTo(e);
    return path + " Z";
  }

  void writePath(const char* kind, const std::string& path)
  {
    out_ << "<path class=\"" << kind << "\" d=\"" << path << "\"/>\n";
  }

  void writeText(const std::string& kind,
                 const Eigen::Vector2d& place,
                 double font,
                 const std::string& text,
                 double degrees = 0)
  {
    out_ << "<text class=\"" << kind << "\" x=\"" << mm(place.x()) << "\" y=\""
         << mm(place.y()) << "\" dy=\"0.35em\" font-size=\"" << mm(font) << '"';
    if (degrees != 0)
      out_ << " transform=\"rotate(" << mm(degrees) << ' ' << mm(place.x()) << ' '
           << mm(place.y()) << ")\"";
    out_ << '>' << text << "</text>\n";
  }

  void writeLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    writePath("line", "M " + mm(from.x()) + " " + mm(from.y()) + " L " + mm(to.x()) +
                          " " + mm(to.y()));
  }

  void writeRoom(const PlanRoom& room)
  {
    out_ << "<g id=\"room_" << room.id << "\">\n";
    writePath("room", pathOf(room.boundary));
    for (const PlanNiche& niche : room.niches)
      writePath("niche", pathOf(niche.boundary));
    Floorplan alone;
    alone.rooms.push_back(room);
    for (const DrawnElement& drawn : drawnElements(alone))
      if (drawn.layer == DrawnLayer::Detail || drawn.layer == DrawnLayer::FloorDetail ||
          drawn.layer == DrawnLayer::Headroom)
        writePath(drawn.layer == DrawnLayer::Detail     ? "detail"
                  : drawn.layer == DrawnLayer::Headroom ? "line headroom"
                                                        : "floor_detail",
                  "M " + at(drawn.element.start) + " " + pathTo(drawn.element));
    for (const PlanLoop& column : room.columns)
      writePath("column", pathOf(column));
    writePath("wall", pathOf(room.boundary));
    // What matters more takes its place first.
    const TextSpot spot = textSpotIn(room.boundary, room.columns);
    writeFitting("name halo", spot, roomTexts(room, spot.place, "m²"), room_font);
    for (const LevelNote& note : levelNotes(room, spot))
      writeFitting("level halo", note.spot, {note.text}, size_font);
    for (const PlanElement& e : room.boundary.elements)
      writeSize(e, room);
    out_ << "</g>\n";
  }

  /** @brief Gaps in the walls, over both faces. */
  void writeDoorways()
  {
    const auto doorways = drawnDoorways(plan_);
    if (doorways.empty())
      return;
    out_ << "<g class=\"doorways\">\n";
    for (const DrawnDoorway& doorway : doorways) {
      const auto& c = doorway.corners;
      writePath("doorway", "M " + at(c[0]) + " L " + at(c[1]) + " L " + at(c[2]) +
                               " L " + at(c[3]) + " Z");
      writePath("gap", "M " + at(c[0]) + " L " + at(c[1]) + " M " + at(c[2]) + " L " +
                           at(c[3]));
      for (const auto& [from, to] : doorway.jambs())
        writePath("jamb", "M " + at(from) + " L " + at(to));
    }
    out_ << "</g>\n";
  }

  void writeStairs()
  {
    for (const StairNote& note : stairNotes(plan_))
      if (texts_.take(onPage(note.place), size_font * halfSizeOf({note.text})))
        writeText("level halo", onPage(note.place), size_font, note.text);
  }

  /** @brief The font with which lines fit the radius of a spot, at most `font`; 0 where
   * they could not be read. */
  double fontFor(const TextSpot& spot,
                 const std::vector<std::string>& lines,
                 double font) const
  {
    constexpr double least = 1.1;
    const double fitting = spot.radius * 1000 / scale_ / halfSizeOf(lines).norm();
    return fitting < least ? 0 : std::min(font, fitting);
  }

  /** @brief Lines about a spot, as large as fits its radius, up to `font`; nothing
   * where they could not be read. */
  void writeFitting(const char* kind,
                    const TextSpot& spot,
                    const std::vector<std::string>& lines,
                    double font)
  {
    font = fontFor(spot, lines, font);
    Eigen::Vector2d place = onPage(spot.place);
    if (font == 0 || !texts_.take(place, font * halfSizeOf(lines)))
      return;
    place.y() -= 0.65 * font * static_cast<double>(lines.size() - 1);
    for (const std::string& line : lines) {
      writeText(kind, place, font, line);
      place.y() += 1.3 * font;
    }
  }

  /** @brief The size of a wall beside its middle, else a third from either end, within
   * the room; nothing where there is no space for it. */
  void writeSize(const PlanElement& e, const PlanRoom& room)
  {
    for (const double share : {1.0 / 2, 1.0 / 3, 2.0 / 3})
      if (writeSizeAt(e, share * e.length(), room))
        return;
  }

  bool writeSizeAt(const PlanElement& e, double s, const PlanRoom& room)
  {
    const std::string text = sizeText(e);
    const Eigen::Vector2d half = size_font * halfSizeOf({text});
    const Eigen::Vector2d normal = e.normalAt(s);
    const Eigen::Vector2d place =
        e.pointAt(s) + 0.9 * size_font * scale_ / 1000 * normal;
    const double space = spaceFor(place, e, room) * 1000 / scale_;
    const double along = std::min(s, e.length() - s) * 1000 / scale_;
    if (along < half.x() + 1 || space < 0.8 * half.x() ||
        !texts_.take(onPage(place), turnedTo(normal, half)))
      return false;
    // Along the wall, read from below or from the right; a degree for walls that are
    // not quite upright.
    double degrees = std::atan2(normal.x(), normal.y()) * 180 / M_PI;
    if (degrees > 89)
      degrees -= 180;
    if (degrees <= -91)
      degrees += 180;
    writeText("size halo", onPage(place), size_font, text, degrees);
    return true;
  }

  /** @brief Distance of a place from all walls but one. */
  static double
  spaceFor(const Eigen::Vector2d& place, const PlanElement& wall, const PlanRoom& room)
  {
    double space = std::numeric_limits<double>::infinity();
    for (const PlanElement& other : room.boundary.elements)
      if (&other != &wall)
        space = std::min(space, other.distance(place));
    return space;
  }

  void writeOverallSize()
  {
    constexpr double off = 6;  // of the line from the plan
    constexpr double tick = 1; // half its length
    const Eigen::Vector2d low = onPage({bounds_.min().x(), bounds_.min().y()});
    const Eigen::Vector2d high = onPage({bounds_.max().x(), bounds_.max().y()});
    const double y = low.y() + off;
    const double x = low.x() - off;
    writeLine({low.x(), y}, {high.x(), y});
    writeLine({x, low.y()}, {x, high.y()});
    for (const double end : {low.x(), high.x()})
      writeLine({end - tick, y + tick}, {end + tick, y - tick});
    for (const double end : {low.y(), high.y()})
      writeLine({x - tick, end + tick}, {x + tick, end - tick});
    writeText("size", {(low.x() + high.x()) / 2, y + 2}, size_font,
              decimalText(bounds_.sizes().x(), 2));
    writeText("size", {x - 2, (low.y() + high.y()) / 2}, size_font,
              decimalText(bounds_.sizes().y(), 2), -90);
  }

  /** @brief A bar of 25 to 65 mm in four parts, and the scale. */
  void writeScaleBar()
  {
    double length = 0.01; // metres
    for (int k = 0; length * 1000 / scale_ < 25; ++k)
      length *= k % 3 == 1 ? 2.5 : 2; // 1, 2, 5, 10
    const double part = length * 1000 / scale_ / 4;
    const double y = size_.y() - 12;
    for (int k = 0; k < 4; ++k)
      out_ << "<rect x=\"" << mm(margin_left + k * part) << "\" y=\"" << mm(y)
           << "\" width=\"" << mm(part) << "\" height=\"1.2\" fill=\""
           << (k % 2 == 0 ? "#111" : "#fff")
           << "\" stroke=\"#111\" stroke-width=\"0.15\"/>\n";
    for (int k = 0; k <= 4; k += 2)
      writeText("size", {margin_left + k * part, y + 3.2}, size_font,
                shortDecimalText(length * k / 4, 3) + (k == 4 ? " m" : ""));
    writeText("name", {margin_left + 4 * part + 20, y + 0.6}, room_font,
              "1:" + shortDecimalText(scale_, 2));
    if (!origin_.isZero())
      writeText("size start", {margin_left, size_.y() - 1.5}, size_font,
                "origin " + origin_.text(", ") + " m");
  }

  /** @brief The frame around the foot of the page, and what the drawing is of. */
  void writeTitle()
  {
    constexpr double height = 16.5;
    constexpr double off = 2; // of the frame from what is in it
    out_ << "<rect class=\"frame\" x=\"" << mm(margin_left - off) << "\" y=\""
         << mm(size_.y() - height) << "\" width=\""
         << mm(size_.x() - margin_left - margin_right + 2 * off) << "\" height=\""
         << mm(height - 0.3) << "\"/>\n";
    double area = 0;
    for (const PlanRoom& room : plan_.rooms)
      area += room.area();
    const std::size_t count = plan_.rooms.size();
    writeText("name start", {margin_left, size_.y() - 4.5}, room_font,
              (name_.empty() ? "Floor plan" : name_) + ", " + std::to_string(count) +
                  (count == 1 ? " room, " : " rooms, ") + decimalText(area, 2) + " m²");
  }

  /** @brief An arrow up the page, along y of the plan: north where its origin is a
   * place of a grid. */
  void writeNorth()
  {
    const Eigen::Vector2d tip(size_.x() - margin_right - 6, size_.y() - 12.5);
    const auto at = [&](double x, double y) {
      return mm(tip.x() + x) + " " + mm(tip.y() + y);
    };
    writePath("north", "M " + at(0, 0) + " L " + at(2, 7) + " L " + at(0, 5.5) + " L " +
                           at(-2, 7) + " Z");
    writeText("size", {tip.x(), tip.y() - 1.8}, size_font,
              origin_.isZero() ? "y" : "N");
  }

  Floorplan plan_;
  double scale_;
  Eigen::AlignedBox2d bounds_;
  std::string name_;
  Origin origin_;
  Eigen::Vector2d drawn_; ///< size of the plan on paper
  Eigen::Vector2d size_;  ///< of the page
  TextPlaces texts_;
  std::ostringstream out_;
};

} // namespace

double
drawingScale(const Floorplan& plan)
{
  const Eigen::AlignedBox2d bounds = boundsOf(plan);
  if (bounds.isEmpty() || !bounds.sizes().allFinite())
    return 100;
  const double width = 1000 * bounds.sizes().x() + 1e-6;
  const double height = 1000 * bounds.sizes().y() + 1e-6;
  const auto fits = [&](double scale, double page_width, double page_height) {
    return width / scale <= page_width - margin_left - margin_right &&
           height / scale <= page_height - margin_top - margin_bottom;
  };
  double scale = 10;
  for (int k = 0;
       !fits(scale, page_long, page_short) && !fits(scale, page_short, page_long); ++k)
    scale *= k % 3 == 1 ? 2.5 : 2; // 10, 20, 50, 100
  return scale;
}

std::string
floorplanToSvg(const Floorplan& plan,
               double scale,
               const PlanStorey* storey,
               const Origin& origin)
{
  return SvgPage(storey ? partOf(plan, *storey) : plan,
                 scale > 0 ? scale : drawingScale(plan), boundsOf(plan),
                 storey ? storey->name : "", origin)
      .write();
}

} // namespace sedr
} // namespace pcl
