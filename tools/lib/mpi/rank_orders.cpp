// SPDX-License-Identifier: BSD-3-Clause
#include "rank_orders.h"

#include "joint_step.h"
#include "joint_thinning.h"
#include "packing.h"
#include "tool_error.h"

#include <variant>

namespace pcl::sedr::tools {

namespace {

/** @brief Order to finish. */
struct GoHome {};

using What = std::variant<GoHome, ThinOrder, RoomJob>;

struct Order {
  std::uint32_t threads = 0; ///< 0: the rank's share of its machine
  What what;
};

} // namespace

} // namespace pcl::sedr::tools

BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::tools::GoHome)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::tools::ThinOrder,
                          ranges,
                          rows,
                          excerpt_step,
                          settings,
                          inverse_leaf,
                          removes_strays)
BOOST_FUSION_ADAPT_STRUCT(pcl::sedr::tools::Order, threads, what)

namespace boost::serialization {

/** The origin is known by then, so it always has a value. */
template <typename Archive>
void
serialize(Archive& archive, pcl::sedr::tools::ScanSettings& settings, unsigned)
{
  pcl::sedr::Origin origin = settings.origin.value_or(pcl::sedr::Origin());
  for (int axis = 0; axis < 3; ++axis)
    archive& origin.place[axis];
  settings.origin = origin;
  archive& settings.unit& settings.scan& settings.skip_broken& settings.columns;
}

} // namespace boost::serialization

namespace pcl::sedr::tools {

RankOrders::RankOrders(RankMail& mail,
                       unsigned threads,
                       unsigned asked_threads,
                       EndWatch& watch,
                       KeptRooms& kept)
    : mail_(mail)
    , threads_(threads)
    , asked_threads_(asked_threads)
    , watch_(watch)
{
  RoomHooks hooks;
  hooks.work = [threads](const RoomJob& job) { return workOn(job, threads); };
  hooks.order = [asked_threads](const RoomJob& job) {
    return pack(Order{asked_threads, job});
  };
  hooks.note = [&watch](int rank, const std::string& held) { watch.note(rank, held); };
  hooks.finished = [&kept](std::uint32_t room, const RoomResult& result) {
    kept.keep(room, result);
  };
  rooms_ = std::make_shared<RoomDealer>(mail, hooks);
}

ThinnedScan
RankOrders::thin(const std::vector<ThinOrder>& orders)
{
  for (int r = 0; r < mail_.size(); ++r) {
    const ThinOrder& order = orders[static_cast<std::size_t>(r)];
    watch_.note(r, textOf(order.ranges));
    if (r > 0)
      mail_.send(r, Subject::Order, pack(Order{asked_threads_, order}));
  }
  try {
    ThinnedScan scan = thinTogether(mail_, orders.front(), threads_);
    for (int r = 0; r < mail_.size(); ++r)
      watch_.note(r, "");
    return scan;
  }
  catch (const ToolError&) {
    throw; // all ranks have stopped
  }
  catch (...) {
    mail_.leave();
    throw;
  }
}

void
sendHome(RankMail& mail)
{
  for (int r = 1; r < mail.size(); ++r)
    mail.send(r, Subject::Order, pack(Order()));
}

void
serve(RankMail& mail, unsigned fair_threads)
{
  for (;;) {
    mail.waitFor(Subject::Order);
    const auto order = unpack<Order>(mail.receive(0, Subject::Order));
    const unsigned threads = order.threads > 0 ? order.threads : fair_threads;
    if (const auto* thin = std::get_if<ThinOrder>(&order.what)) {
      try {
        thinTogether(mail, *thin, threads);
      }
      catch (const StepFailed&) {
        continue; // rank 0 reports it
      }
    }
    else if (const auto* job = std::get_if<RoomJob>(&order.what))
      mail.send(0, Subject::Result,
                pack(workSafely(mail.rank(), *job, [threads](const RoomJob& one) {
                  return workOn(one, threads);
                })));
    else
      return;
  }
}

} // namespace pcl::sedr::tools
