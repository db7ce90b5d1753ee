// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "end_watch.h"

#include <pcl/sedr_surface/room_jobs.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Writes results of rooms as soon as they are finished, each file completely or
 * not at all: points to room_3.pcd, the mesh to room_3.ply. A successful run removes
 * them. */
class KeptRooms {
public:
  /** @param folder created when the first room is kept */
  KeptRooms(std::string folder, EndWatch& watch);

  /** @brief Writes a result, if possible; walls alone are not kept. */
  void keep(std::uint32_t room, const RoomResult& result);

  /** @brief Returns the folder of the files; empty if there are none. */
  std::string place() const { return files_.empty() ? "" : folder_.string(); }

  /** @brief Removes the files, and the folders created for them. */
  void discard();

private:
  void makeFolder();

  void write(const std::filesystem::path& file,
             std::uint32_t room,
             const RoomResult& result) const;

  std::filesystem::path folder_;
  EndWatch& watch_;
  std::vector<std::filesystem::path> made_; ///< folders, outermost first
  std::vector<std::filesystem::path> files_;
};

} // namespace pcl::sedr::tools
