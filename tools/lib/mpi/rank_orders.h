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

namespace pcl::sedr::tools {

/** @brief Sends orders from rank 0 to the others, with all that they need to know of
 * files and options. */
class RankOrders {
public:
  /** @param mail of rank 0
   * @param threads of rank 0 for its own concurrent work
   * @param asked_threads of every rank; 0: its share of the machine
   * @param watch is informed of the ranks' work
   * @param kept receives finished results of rooms */
  RankOrders(RankMail& mail,
             unsigned threads,
             unsigned asked_threads,
             EndWatch& watch,
             KeptRooms& kept);

  /** @brief Thins a scan with an order per rank, see thinTogether(). */
  ThinnedScan thin(const std::vector<ThinOrder>& orders);

  const std::shared_ptr<RoomDealer>& rooms() const { return rooms_; }

private:
  RankMail& mail_;
  unsigned threads_;
  unsigned asked_threads_;
  EndWatch& watch_;
  std::shared_ptr<RoomDealer> rooms_;
};

/** @brief Makes the other ranks return from serve(). */
void sendHome(RankMail& mail);

/** @brief Executes orders on a rank other than the first, until told to finish.
 * @param fair_threads number of threads if an order gives none */
void serve(RankMail& mail, unsigned fair_threads);

} // namespace pcl::sedr::tools
