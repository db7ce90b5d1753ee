// SPDX-License-Identifier: BSD-3-Clause
#include "model/model_run.h"
#include "mpi/end_watch.h"
#include "mpi/joint_step.h"
#include "mpi/kept_rooms.h"
#include "mpi/rank_mail.h"
#include "mpi/rank_orders.h"
#include "mpi/scan_parts.h"
#include "prior_values.h"
#include "run_tool.h"
#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_segmentation/src/refit/plan_refit.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

using namespace pcl::sedr::tools;

namespace {

constexpr const char* tool_name = "pcl_sedr_mpi";

/** @brief Returns the share of threads of each rank on this machine. */
unsigned
fairThreads(const boost::mpi::communicator& ranks)
{
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(ranks, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int ranks_here = 1;
  MPI_Comm_size(here, &ranks_here);
  MPI_Comm_free(&here);
  const long processors = std::max(1L, sysconf(_SC_NPROCESSORS_ONLN));
  // mpirun may have bound this rank to a few processors.
  return std::min(pcl::sedr::resolveThreads(0),
                  static_cast<unsigned>(std::max(1L, processors / ranks_here)));
}

std::vector<ThinOrder>
thinOrders(const std::vector<ScanInput>& inputs,
           const ScanSettings& settings,
           std::size_t ranks)
{
  std::vector<ThinOrder> orders;
  for (const auto& ranges : dealRows(inputs, ranks)) {
    ThinOrder order;
    order.ranges = ranges;
    order.rows = rowsOf(inputs);
    order.excerpt_step =
        pcl::sedr::rawStep(order.rows, pcl::sedr::RefitParameters().max_points);
    order.settings = settings;
    orders.push_back(order);
  }
  return orders;
}

/** @brief Returns at rank 0 the total bytes that the ranks have sent each other. All
 * ranks must call it. */
std::uint64_t
trafficOf(RankMail& mail)
{
  std::uint64_t sent = 0;
  for (const std::string& one : mail.gather(std::to_string(mail.sent())))
    sent += std::stoull(one);
  return sent;
}

/** @brief The parsed command line. */
struct Call {
  std::vector<std::string> scans;
  ModelSettings settings{Reconstruction()};
  bool tells_traffic = false;
};

/** @brief Makes the model with the help of the other ranks.
 * @param fair_threads default number of threads while other ranks work; alone, this
 * rank may use all processors */
int
makeModelTogether(const std::string& tool,
                  Call& call,
                  RankMail& mail,
                  EndWatch& watch,
                  unsigned fair_threads)
{
  ModelSettings& settings = call.settings;
  settings.input = boost::join(call.scans, ", ");
  settings.inputs = call.scans;
  Reconstruction chain;
  apply(settings, chain);
  if (settings.explain)
    std::cout << explained(chain.getPriors()) << std::flush;
  KeptRooms kept(settings.folder + "/rooms", watch);
  RankOrders orders(mail, settings.threads > 0 ? settings.threads : fair_threads,
                    settings.threads, watch, kept);
  chain.getChain().room_workers = orders.rooms();
  const std::vector<std::string>& losses = orders.rooms()->losses();
  try {
    makeModel(settings, chain, [&] {
      ScanSettings reading = settings.scan.resolved();
      const std::vector<ScanInput> inputs = findInputs(call.scans, reading);
      if (!reading.origin) // one frame for all files
        reading.origin = ScanFile(inputs.front().path, reading).origin();
      chain.setOrigin(*reading.origin);
      chain.setScanPositions(positionsOf(inputs, reading));
      auto thin_orders =
          thinOrders(inputs, reading, static_cast<std::size_t>(mail.size()));
      chain.setThinning([&orders, &chain, thin_orders]() mutable {
        for (ThinOrder& order : thin_orders) {
          order.inverse_leaf =
              Eigen::Array3f::Ones() / chain.getVoxelGrid().getLeafSize().array();
          order.removes_strays = chain.getVoxelGrid().getRemoveStrays();
        }
        return orders.thin(thin_orders);
      });
      return rowsOf(inputs);
    });
  }
  catch (const ToolError& error) {
    if (kept.place().empty())
      throw;
    throw ToolError(std::string(error.what()) + "; what was finished is in '" +
                        kept.place() + "'",
                    losses.empty() ? error.exitCode() : Incomplete);
  }
  kept.discard();
  for (const std::string& loss : losses)
    std::cerr << tool << ": the model is not whole: " << loss << '\n';
  return losses.empty() ? Done : Incomplete;
}

/** @brief Runs rank 0.
 * @return the exit code */
int
lead(int argc, char** argv, RankMail& mail, EndWatch& watch, unsigned fair_threads)
{
  Call call;
  Options options(
      tool_name,
      "Reconstructs ceiling, floor and walls of an indoor scan as pcl_sedr does, with "
      "the same result, on several processes or machines:\n"
      "mpirun -n 4 pcl_sedr_mpi SCAN OUTPUT_DIR\n"
      "Every machine needs the scan under the same name. Exit code 3: a rank has "
      "failed, and rooms are missing.");
  options.files(
      "SCAN", call.scans,
      "PCD, PLY, E57, LAS or text, z up, or a folder of them; several are one scan");
  options.file("OUTPUT_DIR", call.settings.folder,
               "folder for the results, made if missing");
  addModelOptions(options, call.settings);
  options.flag("traffic", call.tells_traffic,
               "tell how much the ranks sent each other");
  watch.begin();
  const int exit_code = runTool(options, argc, argv, [&] {
    return makeModelTogether(options.tool(), call, mail, watch, fair_threads);
  });
  watch.end();
  if (mail.hasLeft())
    boost::mpi::environment::abort(exit_code);
  sendHome(mail);
  const std::uint64_t sent = trafficOf(mail);
  if (call.tells_traffic)
    std::printf("%d ranks, %.1f MB from one to another\n", mail.size(),
                static_cast<double>(sent) / 1e6);
  return exit_code;
}

} // namespace

int
main(int argc, char** argv)
{
  EndWatch watch(tool_name);
  boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
  const boost::mpi::communicator ranks;
  RankMail mail(ranks);
  const unsigned fair_threads = fairThreads(ranks);
  if (mail.isFirst())
    return lead(argc, argv, mail, watch, fair_threads);
  EndWatch::standDown();
  try {
    serve(mail, fair_threads);
    trafficOf(mail);
  }
  catch (...) {
    std::cerr << tool_name << ": " << nameOf(mail.rank())
              << " failed: " << currentProblem() << std::endl;
    boost::mpi::environment::abort(BadUse);
  }
  return Done;
}
