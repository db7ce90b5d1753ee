// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/rank_mail.h"
#include "mpi/rank_orders.h"
#include "mpi/scan_parts.h"
#include "run_tool.h"
#include "sedr/model_run.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_segmentation/plan_refit.h>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

using namespace pcl::sedr::tools;

namespace {

constexpr int rooms_missing = 3; ///< exit code: some rooms were lost

/** @brief How many threads each of the ranks on this machine may have. */
unsigned
fairThreads(const boost::mpi::communicator& ranks)
{
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(ranks, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int ranks_here = 1;
  MPI_Comm_size(here, &ranks_here);
  MPI_Comm_free(&here);
  const long processors = std::max(1L, sysconf(_SC_NPROCESSORS_ONLN));
  // mpirun may have bound this rank to a few of them.
  return std::min(pcl::sedr::resolveThreads(0),
                  static_cast<unsigned>(std::max(1L, processors / ranks_here)));
}

/** @brief The scan as report.json names it. */
std::string
joined(const std::vector<std::string>& paths)
{
  std::string all;
  for (const std::string& path : paths)
    all += (all.empty() ? "" : ", ") + path;
  return all;
}

std::vector<ThinOrder>
thinOrders(const std::vector<ScanInput>& inputs, double unit, std::size_t ranks)
{
  std::vector<ThinOrder> orders;
  for (const auto& ranges : dealRows(inputs, ranks)) {
    ThinOrder order;
    order.ranges = ranges;
    order.rows = rowsOf(inputs);
    order.excerpt_step =
        pcl::sedr::rawStep(order.rows, pcl::sedr::RefitParameters().most_points);
    order.unit = unit;
    orders.push_back(order);
  }
  return orders;
}

/** @brief Makes the model with the help of the other ranks. */
int
makeModelTogether(const std::string& tool,
                  ModelSettings& settings,
                  const std::vector<std::string>& scans,
                  RankMail& mail,
                  unsigned fair_threads)
{
  const unsigned asked = settings.threads;
  settings.threads = asked > 0 ? asked : fair_threads;
  settings.input = joined(scans);
  Reconstruction chain;
  apply(settings, chain);
  RankOrders orders(mail, settings.threads, asked);
  chain.getChain().room_workers = orders.rooms();
  const int exit_code = makeModel(tool, settings, chain, [&] {
    const std::vector<ScanInput> inputs = findInputs(scans);
    auto thin_orders =
        thinOrders(inputs, settings.unit, static_cast<std::size_t>(mail.size()));
    chain.setThinning([&orders, &chain, thin_orders]() mutable {
      for (ThinOrder& order : thin_orders)
        order.inverse_leaf =
            Eigen::Array3f::Ones() / chain.getVoxelGrid().getLeafSize().array();
      return orders.thin(thin_orders);
    });
    return rowsOf(inputs);
  });
  for (const std::string& loss : orders.rooms()->losses())
    std::cerr << tool << ": the model is not whole: " << loss << '\n';
  return orders.rooms()->losses().empty() ? exit_code : rooms_missing;
}

} // namespace

int
main(int argc, char** argv)
{
  boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
  const boost::mpi::communicator ranks;
  RankMail mail(ranks);
  const unsigned fair_threads = fairThreads(ranks);
  if (!mail.isFirst()) {
    serve(mail, fair_threads);
    return 0;
  }
  ModelSettings settings{Reconstruction()};
  std::vector<std::string> scans;
  Options options(
      "pcl_sedr_mpi",
      "Reconstructs ceiling, floor and walls of an indoor scan as pcl_sedr does, with "
      "the same result, on several processes or machines: mpirun -n 4 pcl_sedr_mpi "
      "SCAN OUTPUT_DIR.\nMachines need the files under the same names.");
  options.files("SCAN", scans,
                "PCD or PLY file, z up, or a folder of them; several are one scan");
  options.file("OUTPUT_DIR", settings.folder,
               "folder for the results, made if missing");
  addModelOptions(options, settings);
  const int exit_code = runTool(options, argc, argv, [&] {
    return makeModelTogether(options.tool(), settings, scans, mail, fair_threads);
  });
  sendHome(mail);
  return exit_code;
}
