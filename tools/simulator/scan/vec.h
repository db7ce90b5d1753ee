// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace pcl::sedr::sim {

constexpr double pi = 3.14159265358979323846;

/** @brief A point or vector in the plan, in metres. */
struct Vec2 {
  double x = 0.0;
  double y = 0.0;
};

/** @brief A point or vector in space, in metres, z up. */
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

inline Vec2
operator+(Vec2 a, Vec2 b)
{
  return {a.x + b.x, a.y + b.y};
}

inline Vec2
operator-(Vec2 a, Vec2 b)
{
  return {a.x - b.x, a.y - b.y};
}

inline Vec2
operator*(double s, Vec2 a)
{
  return {s * a.x, s * a.y};
}

inline double
dot(Vec2 a, Vec2 b)
{
  return a.x * b.x + a.y * b.y;
}

/** @brief Returns the z of the cross product: positive if @p b is left of @p a. */
inline double
cross(Vec2 a, Vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

inline double
length(Vec2 a)
{
  return std::hypot(a.x, a.y);
}

inline Vec2
normalized(Vec2 a)
{
  return (1.0 / length(a)) * a;
}

/** @brief Returns @p a rotated by 90 degrees counter-clockwise. */
inline Vec2
leftOf(Vec2 a)
{
  return {-a.y, a.x};
}

/** @brief Returns @p a rotated counter-clockwise by @p angle radians. */
inline Vec2
rotated(Vec2 a, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

inline Vec3
operator+(Vec3 a, Vec3 b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vec3
operator-(Vec3 a, Vec3 b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vec3
operator*(double s, Vec3 a)
{
  return {s * a.x, s * a.y, s * a.z};
}

inline double
dot(Vec3 a, Vec3 b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec3
cross(Vec3 a, Vec3 b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double
length(Vec3 a)
{
  return std::sqrt(dot(a, a));
}

/** @brief Returns the position of @p a in the plan. */
inline Vec2
plan(Vec3 a)
{
  return {a.x, a.y};
}

/** @brief Returns @p a at the height @p z. */
inline Vec3
lifted(Vec2 a, double z)
{
  return {a.x, a.y, z};
}

} // namespace pcl::sedr::sim
