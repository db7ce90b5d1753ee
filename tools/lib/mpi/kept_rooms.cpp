// SPDX-License-Identifier: BSD-3-Clause
#include "kept_rooms.h"

#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/sedr_surface/mesh_io.h>

#include <utility>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

KeptRooms::KeptRooms(std::string folder, EndWatch& watch)
    : folder_(fs::absolute(folder))
    , watch_(watch)
{}

void
KeptRooms::makeFolder()
{
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path at = folder_; !fs::exists(at, error) && at != at.root_path();
       at = at.parent_path())
    missing.push_back(at);
  fs::create_directories(folder_, error);
  if (error)
    throw ToolError("cannot make the folder '" + folder_.string() +
                    "': " + error.message());
  made_.assign(missing.rbegin(), missing.rend());
}

void
KeptRooms::write(const fs::path& file,
                 std::uint32_t room,
                 const RoomResult& result) const
{
  if (const auto* points = std::get_if<RepairedRoom>(&result)) {
    saveStructure(file.string(), cloudOf(room, *points));
    return;
  }
  const std::string problem =
      savePly(file.string(), std::get<RoomSurface>(result).mesh);
  if (!problem.empty())
    throw ToolError(problem);
}

void
KeptRooms::keep(std::uint32_t room, const RoomResult& result)
{
  const auto* points = std::get_if<RepairedRoom>(&result);
  const auto* surface = std::get_if<RoomSurface>(&result);
  const bool has_points = points && !points->points.empty();
  const bool has_surface = surface && !surface->mesh.empty();
  if (!has_points && !has_surface)
    return;
  const fs::path file =
      folder_ / ("room_" + std::to_string(room) + (has_points ? ".pcd" : ".ply"));
  try {
    const auto locked = watch_.lock();
    if (files_.empty())
      makeFolder();
    write(file, room, result);
    files_.push_back(file);
  }
  catch (const ToolError&) {
    return; // writing the model will fail likewise, and report it
  }
  watch_.noteKept(folder_.string());
}

void
KeptRooms::discard()
{
  watch_.noteKept("");
  std::error_code error;
  for (const auto& file : files_)
    fs::remove(file, error);
  files_.clear();
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
    fs::remove(*folder, error); // only if it is empty
  made_.clear();
}

} // namespace pcl::sedr::tools
