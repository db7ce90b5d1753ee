// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"
#include "sample_files.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_types.h>

namespace programs {

using Label = pcl::sedr::StructureLabel;

/** The geometry of a test room; metres. */
struct BoxRoom {
  double x = 0.37; ///< its corner
  double y = -1.21;
  double width = 4;
  double depth = 3;
  double height = 2.5;
  std::uint32_t id = 1;
  bool has_soffit = false; ///< 0.6 m wide along the wall at `x`, 0.4 m deep
};

/** A point of a scan with its true label and room. */
struct RoomPoint {
  float x, y, z;
  Label label;
  std::uint32_t room;
};

/** A scan of flat pieces with points 5 cm apart, each up to 2 mm off its piece. */
class RoomScan {
public:
  std::vector<RoomPoint> points;

  /** Adds the rectangle from `low` to `high`, which have one coordinate in common. */
  void addPiece(const Eigen::Vector3d& low,
                const Eigen::Vector3d& high,
                Label label,
                std::uint32_t room)
  {
    constexpr double step = 0.05;
    const int across = high.x() == low.x() ? 0 : high.y() == low.y() ? 1 : 2;
    const int u = (across + 1) % 3;
    const int v = (across + 2) % 3;
    const long columns = std::lround((high[u] - low[u]) / step);
    const long rows = std::lround((high[v] - low[v]) / step);
    for (long i = 0; i < columns; ++i)
      for (long j = 0; j < rows; ++j) {
        Eigen::Vector3d p = low;
        p[u] += step * (static_cast<double>(i) + 0.5);
        p[v] += step * (static_cast<double>(j) + 0.5);
        p[across] += 0.004 * (random() - 0.5);
        points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()),
                          static_cast<float>(p.z()), label, room});
      }
  }

  /** Adds floor, ceiling and walls, a doorway in the wall at y, a cupboard that hides a
   * part of the wall at y + depth, and a table. */
  void addRoom(const BoxRoom& room)
  {
    struct Piece {
      Eigen::Vector3d low;
      Eigen::Vector3d high;
      Label label;
    };
    const double w = room.width;
    const double d = room.depth;
    const double h = room.height;
    const double low = h - 0.4;
    const double soffit = room.has_soffit ? 0.6 : 0; // without, its pieces are empty
    const double left = room.has_soffit ? low : h;
    const Eigen::Vector3d corner(room.x, room.y, 0);
    for (const Piece& piece : std::vector<Piece>{
             {{0, 0, 0}, {w, d - 0.5, 0}, Label::Floor}, // none below the cupboard
             {{soffit, 0, h}, {w, d, h}, Label::Ceiling},
             {{0, 0, low}, {soffit, d, low}, Label::Detail},
             {{soffit, 0, left}, {soffit, d, h}, Label::Detail},
             {{0, 0, 0}, {0, d, left}, Label::Wall},
             {{w, 0, 0}, {w, d, h}, Label::Wall},
             {{0, 0, 0}, {soffit, 0, low}, Label::Wall},
             {{0, d, 0}, {soffit, d, low}, Label::Wall},
             {{soffit, 0, 0}, {2, 0, h}, Label::Wall}, // the doorway is 2 m high
             {{2, 0, 2}, {3, 0, h}, Label::Wall},
             {{3, 0, 0}, {w, 0, h}, Label::Wall},
             {{soffit, d, 0}, {1.5, d, h}, Label::Wall}, // the cupboard is 1.8 m high
             {{1.5, d, 1.8}, {2.5, d, h}, Label::Wall},
             {{2.5, d, 0}, {w, d, h}, Label::Wall},
             {{1.5, d - 0.5, 0}, {2.5, d - 0.5, 1.8}, Label::Other},
             {{1.5, d - 0.5, 1.8}, {2.5, d, 1.8}, Label::Other},
             {{1.5, d - 0.5, 0}, {1.5, d, 1.8}, Label::Other},
             {{2.5, d - 0.5, 0}, {2.5, d, 1.8}, Label::Other},
             {{1.2, 0.8, 0.75}, {2.8, 1.6, 0.75}, Label::Other}})
      addPiece(corner + piece.low, corner + piece.high, piece.label,
               piece.label == Label::Other ? 0 : room.id);
  }

  /** Returns a PCD of x, y, z and the number of the point as intensity, and with label
   * and room if requested. */
  std::string pcd(bool with_labels) const
  {
    std::string bytes = pcdHeader(
        with_labels ? "x y z intensity label room" : "x y z intensity", points.size());
    const auto append = [&](const auto& value) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      append(points[i].x);
      append(points[i].y);
      append(points[i].z);
      append(static_cast<float>(i));
      if (!with_labels)
        continue;
      append(static_cast<std::uint32_t>(points[i].label));
      append(points[i].room);
    }
    return bytes;
  }

  /** Adds another scan raised by `height`; its rooms are numbered from `rooms` + 1. */
  void addRaised(const RoomScan& other, double height, std::uint32_t rooms)
  {
    for (RoomPoint p : other.points) {
      p.z += static_cast<float>(height);
      p.room += p.room > 0 ? rooms : 0;
      points.push_back(p);
    }
  }

  /** Returns the scan without the points for which `test` is true. */
  template <typename Test>
  RoomScan without(Test test) const
  {
    RoomScan rest;
    for (const auto& p : points)
      if (!test(p))
        rest.points.push_back(p);
    return rest;
  }

  RoomScan withoutLabel(Label label) const
  {
    return without([&](const RoomPoint& p) { return p.label == label; });
  }

private:
  double random()
  {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<double>(state_ >> 8) / (1 << 24);
  }

  std::uint32_t state_ = 1;
};

inline RoomScan
scanOf(const BoxRoom& room = BoxRoom())
{
  RoomScan scan;
  scan.addRoom(room);
  return scan;
}

inline RoomScan
scanOfRooms(const std::vector<BoxRoom>& rooms)
{
  RoomScan scan;
  for (const BoxRoom& room : rooms)
    scan.addRoom(room);
  return scan;
}

/** The true plan of a room without a soffit. */
inline pcl::sedr::PlanRoom
planOf(const BoxRoom& room)
{
  return sedr_test::roomOf(
      sedr_test::rectangle(room.x, room.y, room.x + room.width, room.y + room.depth),
      room.height, room.id);
}

} // namespace programs
