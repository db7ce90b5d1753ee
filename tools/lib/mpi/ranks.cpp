// SPDX-License-Identifier: BSD-3-Clause
#include "ranks.h"

#include "tool_error.h"

#include "sedr_filters/src/base/parallel.h"

#include <boost/mpi/collectives/all_gather.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/string.hpp>

#include <unistd.h>

#include <exception>
#include <vector>

namespace pcl::sedr::tools {

void
together(const Ranks& ranks, const std::function<void()>& step)
{
  std::string problem;
  try {
    step();
  }
  catch (const std::exception& error) {
    problem = "rank " + std::to_string(ranks.rank()) + " on '" +
              boost::mpi::environment::processor_name() + "': " + error.what();
  }
  std::vector<std::string> problems;
  boost::mpi::all_gather(ranks, problem, problems);
  problems.erase(std::remove(problems.begin(), problems.end(), ""), problems.end());
  if (problems.empty())
    return;
  const std::size_t more = problems.size() - 1;
  throw ToolError(problems.front() +
                  (more > 0 ? "; " + std::to_string(more) + " more failed" : ""));
}

unsigned
fairThreads(const Ranks& ranks)
{
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(ranks, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int ranks_here = 1;
  MPI_Comm_size(here, &ranks_here);
  MPI_Comm_free(&here);
  const long processors = std::max(1L, sysconf(_SC_NPROCESSORS_ONLN));
  // mpirun may have bound this rank to a few processors.
  return std::min(resolveThreads(0),
                  static_cast<unsigned>(std::max(1L, processors / ranks_here)));
}

} // namespace pcl::sedr::tools
