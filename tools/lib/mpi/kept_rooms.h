// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "end_watch.h"

#include <pcl/sedr_surface/room_jobs.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Writes what is finished of rooms as soon as it is, each file whole or not at
 * all: room_3.pcd, its points, and room_3.ply, its mesh. A run that ends well takes
 * them away. */
class KeptRooms {
public:
  /** @param folder made when the first room is kept */
  KeptRooms(std::string folder, EndWatch& watch);

  /** @brief Takes a result that came; walls alone are not kept, and what cannot be
   * written is not. */
  void keep(std::uint32_t room, const RoomResult& result);

  /** @brief Where they are; empty: there are none. */
  std::string place() const { return files_.empty() ? "" : folder_.string(); }

  /** @brief Takes all away again, and the folders that were made for them. */
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

} // namespace tools
} // namespace sedr
} // namespace pcl
