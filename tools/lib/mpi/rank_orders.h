// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "end_watch.h"
#include "kept_rooms.h"
#include "part_of_scan.h"
#include "rank_mail.h"
#include "room_dealer.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <memory>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What rank 0 has the others do. They know nothing of files and options but
 * what an order says. */
class RankOrders {
public:
  /** @param mail of rank 0
   * @param threads of rank 0 for what it does at the same time as the others
   * @param asked_threads of every rank, 0: what its machine has for it
   * @param watch is told what the ranks hold
   * @param kept gets what is finished of rooms */
  RankOrders(RankMail& mail,
             unsigned threads,
             unsigned asked_threads,
             EndWatch& watch,
             KeptRooms& kept);

  /** @brief Has a scan thinned, see thinTogether(); an order for every rank. */
  ThinnedScan thin(const std::vector<ThinOrder>& orders);

  const std::shared_ptr<RoomDealer>& rooms() const { return rooms_; }

private:
  RankMail& mail_;
  unsigned threads_;
  unsigned asked_threads_;
  EndWatch& watch_;
  std::shared_ptr<RoomDealer> rooms_;
};

/** @brief Sends the others home: they return from serve(). */
void sendHome(RankMail& mail);

/** @brief What a rank that is not the first does: what it is ordered, until it is sent
 * home.
 * @param fair_threads how many threads this rank may have, if it is not told */
void serve(RankMail& mail, unsigned fair_threads);

} // namespace tools
} // namespace sedr
} // namespace pcl
