// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "joint_scan.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <boost/mpi/collectives/broadcast.hpp>
#include <boost/mpi/communicator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace pcl::sedr::tools {

using Ranks = boost::mpi::communicator;

/** @brief Runs a step on all ranks at the same time. If it fails on one, ToolError is
 * thrown on all, with the rank, its machine and the reason, so that none waits for
 * another. */
void together(const Ranks& ranks, const std::function<void()>& step);

/** @brief Returns the threads that a rank may use: its share of its machine. */
unsigned fairThreads(const Ranks& ranks);

/** @brief Calls `pass(bytes, size)` for the pieces of a list of plain values; MPI
 * counts with int. */
template <typename List, typename Pass>
void
passPieces(List& list, const Pass& pass)
{
  constexpr std::size_t at_once = std::size_t{1} << 26;
  const std::size_t size = list.size() * sizeof(list[0]);
  for (std::size_t at = 0; at < size; at += at_once)
    pass(reinterpret_cast<char*>(list.data()) + at,
         static_cast<int>(std::min(at_once, size - at)));
}

/** @brief Sends a list of plain values, as they lie in memory. */
template <typename List>
void
sendList(const Ranks& ranks, int to, List& list)
{
  ranks.send(to, 0, std::uint64_t{list.size()});
  passPieces(list, [&](char* bytes, int size) { ranks.send(to, 0, bytes, size); });
}

template <typename List>
List
receiveList(const Ranks& ranks, int from)
{
  std::uint64_t size = 0;
  ranks.recv(from, 0, size);
  List list(size, typename List::value_type());
  passPieces(list, [&](char* bytes, int n) { ranks.recv(from, 0, bytes, n); });
  return list;
}

/** @brief Gives all ranks the list of one; to be called on all. */
template <typename List>
void
shareList(const Ranks& ranks, List& list, int from)
{
  std::uint64_t size = list.size();
  boost::mpi::broadcast(ranks, size, from);
  list.resize(size);
  passPieces(list,
             [&](char* bytes, int n) { boost::mpi::broadcast(ranks, bytes, n, from); });
}

/** @brief Thins a scan on all ranks, each an equal run of its rows: the sums of their
 * voxels are added up, and every rank gets the means and the excerpt, the same bytes as
 * in one process. To be called on all ranks at the same time.
 * @param find_frame gives all ranks the same frame
 * @param grid its leaf, strays and threads */
ThinnedScan thinTogether(const Ranks& ranks,
                         const JointScan& scan,
                         const ParallelVoxelGrid<pcl::PointXYZ>& grid,
                         const FindFrame& find_frame);

/** @brief Deals the rooms out by number, and gathers their surfaces at rank 0. */
RoomSharing sharedRooms(const Ranks& ranks);

} // namespace pcl::sedr::tools
