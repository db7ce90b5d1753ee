// SPDX-License-Identifier: BSD-3-Clause
#include "ray_caster.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

/** @brief Difference of both distances, metres, beyond which a ray grazes its triangle
 * so much that its plane says nothing. */
constexpr double kGrazing = 1e-3;

} // namespace

RayCaster::RayCaster(const SceneMesh& scene)
    : scene_(scene)
{
  // One thread builds a tree that is the same in every run; the scene keeps the device.
  const std::shared_ptr<RTCDeviceTy> device(rtcNewDevice("threads=1"),
                                            rtcReleaseDevice);
  if (!device)
    throw std::runtime_error("Embree cannot be started");
  embree_.reset(rtcNewScene(device.get()), rtcReleaseScene);
  rtcSetSceneFlags(embree_.get(), RTC_SCENE_FLAG_ROBUST); // no ray passes between faces
  const TriangleMesh& mesh = scene.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (scene.surfaces[t] != Surface::Gap)
      triangles_.push_back(t);
  origin_ = triangles_.empty() ? Vec3(Vec3::Zero()) : mesh.bounds().center();
  const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t count) {
    return rtcSetNewGeometryBuffer(geometry, type, 0, format, 12, count);
  };
  if (!triangles_.empty()) {
    auto* place = static_cast<float*>(
        buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices.size()));
    for (const Vec3& vertex : mesh.vertices)
      for (int axis = 0; axis < 3; ++axis)
        *place++ = static_cast<float>(vertex[axis] - origin_[axis]);
    auto* corner = static_cast<std::uint32_t*>(
        buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles_.size()));
    for (const std::size_t t : triangles_)
      for (const std::uint32_t vertex : mesh.triangles[t])
        *corner++ = vertex;
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(embree_.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(embree_.get());
  if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot hold the scene");
}

std::optional<Hit>
RayCaster::nearest(const Ray& ray, double from, double to) const
{
  const Vec3 start = ray.origin - origin_;
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(start.x());
  query.ray.org_y = static_cast<float>(start.y());
  query.ray.org_z = static_cast<float>(start.z());
  query.ray.dir_x = static_cast<float>(ray.direction.x());
  query.ray.dir_y = static_cast<float>(ray.direction.y());
  query.ray.dir_z = static_cast<float>(ray.direction.z());
  query.ray.tnear = static_cast<float>(from);
  query.ray.tfar = static_cast<float>(to);
  query.ray.mask = ~0U;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    return std::nullopt;
  Hit hit{static_cast<double>(query.ray.tfar), triangles_[query.hit.primID]};
  const Vec3 normal = normalOf(hit.triangle);
  const double exact = normal.dot(scene_.mesh.corner(hit.triangle, 0) - ray.origin) /
                       normal.dot(ray.direction);
  if (std::abs(exact - hit.distance) < kGrazing)
    hit.distance = exact;
  return hit;
}

Vec3
RayCaster::normalOf(std::size_t triangle) const
{
  return scene_.mesh.scaledNormal(triangle).normalized();
}

} // namespace pcl::sedr::sim
