// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/room_samples.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace sedr_test {

/** A room in closed form: blocks of air of half a metre, and at most one round column.
 * Provides its exact surface with normals into the room, and evenly spaced points on
 * it. */
class LatticeRoom {
public:
  static constexpr double step = 0.5;

  using IsAir = std::function<bool(int, int, int)>;

  LatticeRoom(
      int nx,
      int ny,
      int nz,
      IsAir is_air = [](int, int, int) { return true; })
      : n_{nx, ny, nz}
      , is_air_(std::move(is_air))
  {}

  /** Adds a floor-to-ceiling column about lattice point (x, y). */
  LatticeRoom& withColumn(int x, int y, double radius)
  {
    column_ = {x * step, y * step};
    radius_ = radius;
    return *this;
  }

  /** Sets the pose of the room: turned about z, then shifted. */
  LatticeRoom& placed(double yaw_degrees, const Eigen::Vector3d& shift)
  {
    pose_ = Eigen::Translation3d(shift) *
            Eigen::AngleAxisd(yaw_degrees * M_PI / 180, Eigen::Vector3d::UnitZ());
    return *this;
  }

  pcl::sedr::TriangleMesh truth() const
  {
    pcl::sedr::TriangleMesh mesh;
    std::map<std::array<long, 3>, std::uint32_t> known;
    const auto vertex = [&](const Eigen::Vector3d& p) {
      const std::array<long, 3> key = {
          std::lround(p.x() * 1e6), std::lround(p.y() * 1e6), std::lround(p.z() * 1e6)};
      const auto found =
          known.try_emplace(key, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (found.second)
        mesh.vertices.push_back(pose_ * p);
      return found.first->second;
    };
    const auto triangle = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c, const Eigen::Vector3d& normal) {
      const bool right = (b - a).cross(c - a).dot(normal) > 0;
      mesh.triangles.push_back(
          {vertex(a), vertex(right ? b : c), vertex(right ? c : b)});
    };
    forEachFace([&](const Eigen::Vector3d& o, const Eigen::Vector3d& u,
                    const Eigen::Vector3d& v, const Eigen::Vector3d& n) {
      if (atColumn(o, u, v, n))
        return;
      triangle(o, o + u, o + u + v, n);
      triangle(o, o + u + v, o + v, n);
    });
    if (radius_ > 0)
      addColumn(triangle);
    return mesh;
  }

  /** Returns points in the middle of squares of the given side, with exact normals. */
  std::vector<pcl::sedr::OrientedPoint> points(double spacing) const
  {
    std::vector<pcl::sedr::OrientedPoint> points;
    const auto add = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
      points.push_back({(pose_ * p).cast<float>(), (pose_.linear() * n).cast<float>()});
    };
    const int k = static_cast<int>(std::lround(step / spacing));
    forEachFace([&](const Eigen::Vector3d& o, const Eigen::Vector3d& u,
                    const Eigen::Vector3d& v, const Eigen::Vector3d& n) {
      for (int i = 0; i < k; ++i)
        for (int j = 0; j < k; ++j) {
          const Eigen::Vector3d p = o + u * (i + 0.5) / k + v * (j + 0.5) / k;
          if (radius_ == 0 || n.z() == 0 || (p.head<2>() - column_).norm() > radius_)
            add(p, n);
        }
    });
    if (radius_ > 0) {
      const int around = static_cast<int>(std::lround(2 * M_PI * radius_ / spacing));
      const int up = static_cast<int>(std::lround(n_[2] * step / spacing));
      for (int i = 0; i < around; ++i)
        for (int j = 0; j < up; ++j)
          add(onColumn((i + 0.5) / around, (j + 0.5) / up), radial((i + 0.5) / around));
    }
    return points;
  }

private:
  bool air(int x, int y, int z) const
  {
    return x >= 0 && y >= 0 && z >= 0 && x < n_[0] && y < n_[1] && z < n_[2] &&
           is_air_(x, y, z);
  }

  template <typename Visit>
  void forEachFace(Visit visit) const
  {
    for (int x = 0; x < n_[0]; ++x)
      for (int y = 0; y < n_[1]; ++y)
        for (int z = 0; z < n_[2]; ++z)
          for (int axis = 0; axis < 3; ++axis)
            for (int sign = -1; sign <= 1; sign += 2) {
              const Eigen::Vector3i cell(x, y, z);
              Eigen::Vector3i next = cell;
              next[axis] += sign;
              if (!air(x, y, z) || air(next.x(), next.y(), next.z()))
                continue;
              Eigen::Vector3d origin = step * cell.cast<double>();
              if (sign > 0)
                origin[axis] += step;
              visit(origin,
                    Eigen::Vector3d(step * Eigen::Vector3d::Unit((axis + 1) % 3)),
                    Eigen::Vector3d(step * Eigen::Vector3d::Unit((axis + 2) % 3)),
                    Eigen::Vector3d(-sign * Eigen::Vector3d::Unit(axis)));
            }
  }

  bool atColumn(const Eigen::Vector3d& o,
                const Eigen::Vector3d& u,
                const Eigen::Vector3d& v,
                const Eigen::Vector3d& n) const
  {
    const Eigen::Vector3d centre = o + u / 2 + v / 2;
    return radius_ > 0 && n.z() != 0 &&
           (centre.head<2>() - column_).cwiseAbs().maxCoeff() < step;
  }

  Eigen::Vector3d radial(double turn) const
  {
    return {std::cos(2 * M_PI * turn), std::sin(2 * M_PI * turn), 0};
  }

  Eigen::Vector3d onColumn(double turn, double height_share) const
  {
    const Eigen::Vector3d r = radius_ * radial(turn);
    return {column_.x() + r.x(), column_.y() + r.y(), height_share * n_[2] * step};
  }

  // Adds the wall of the column and, on floor and ceiling, the rest of the square
  // around it.
  template <typename AddTriangle>
  void addColumn(AddTriangle add) const
  {
    constexpr int around = 96; // multiple of the eight lattice points of the square
    for (int i = 0; i < around; ++i) {
      const double t0 = static_cast<double>(i) / around;
      const double t1 = static_cast<double>((i + 1) % around) / around;
      const Eigen::Vector3d out = radial((i + 0.5) / around);
      add(onColumn(t0, 0), onColumn(t1, 0), onColumn(t1, 1), out);
      add(onColumn(t0, 0), onColumn(t1, 1), onColumn(t0, 1), out);
      for (int top = 0; top < 2; ++top) {
        const Eigen::Vector3d normal = Eigen::Vector3d::UnitZ() * (top ? -1 : 1);
        const Eigen::Vector3d corner = onSquare((i + around / 16) / (around / 8), top);
        add(onColumn(t0, top), onColumn(t1, top), corner, normal);
        const Eigen::Vector3d next =
            onSquare((i + 1 + around / 16) / (around / 8), top);
        if (corner != next)
          add(onColumn(t1, top), corner, next, normal);
      }
    }
  }

  // Returns one of the eight lattice points of the square around the column.
  Eigen::Vector3d onSquare(int i, double height_share) const
  {
    const Eigen::Vector3d r = radial((i % 8) / 8.);
    return {column_.x() + std::lround(r.x()) * step,
            column_.y() + std::lround(r.y()) * step, height_share * n_[2] * step};
  }

  std::array<int, 3> n_;
  IsAir is_air_;
  Eigen::Vector2d column_ = Eigen::Vector2d::Zero();
  double radius_ = 0;
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
};

/** 6 m x 5 m x 3 m. */
inline LatticeRoom
boxRoom()
{
  return LatticeRoom(12, 10, 6);
}

/** The box without a quarter. */
inline LatticeRoom
lRoom()
{
  return LatticeRoom(12, 10, 6, [](int x, int y, int) { return x < 6 || y < 5; });
}

/** The box with a soffit of 0.5 m x 1 m along two walls. */
inline LatticeRoom
soffitRoom()
{
  return LatticeRoom(12, 10, 6,
                     [](int x, int y, int z) { return z < 5 || (x >= 2 && y >= 2); });
}

/** The box with a round column of 0.3 m radius. */
inline LatticeRoom
columnRoom()
{
  return LatticeRoom(12, 10, 6).withColumn(5, 6, 0.3);
}

} // namespace sedr_test
