// SPDX-License-Identifier: BSD-3-Clause
#include "quiet_output.h"

#include <cstdlib>
#include <sstream>
#include <string>

namespace pcl {
namespace sedr {
namespace {

// What multi_grid_octree_data.hpp and its neighbours print.
bool
isPoissonComplaint(const std::string& line)
{
  static const char* const beginnings[] = {
      "Vertex pair not in list",
      "Could not find vertex",
      "Bad Edge",
      "Bad Point Index",
      "[WARNING] Couldn't find root index",
      "[WARNING] Finest node does not have",
      "[WARNING] Bad average root",
      "[WARNING] Initial residual too low",
      "[WARNING] How did we leave the subtree",
      "Octree<Degree>::NonLinearSplatOrientedPoint",
      "\t(",
      "\t0",
      "\t1"};
  for (const char* beginning : beginnings)
    if (line.rfind(beginning, 0) == 0)
      return true;
  return false;
}

#ifdef __GLIBC__

// A stream into memory. It lives as long as the process: a thread may have got hold of
// it just before the end of a diversion and print into it later, which the next one
// then finds.
struct MemoryStream {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* stream = open_memstream(&text, &size);

  std::string take()
  {
    std::fflush(stream);
    const std::string taken(text, size);
    std::rewind(stream);
    return taken;
  }
};

MemoryStream&
outStream()
{
  static auto& stream = *new MemoryStream;
  return stream;
}

MemoryStream&
errStream()
{
  static auto& stream = *new MemoryStream;
  return stream;
}

// Passes on what is not pcl::Poisson's and counts the rest.
std::size_t
sift(const std::string& text, std::FILE* stream)
{
  std::size_t complaints = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (isPoissonComplaint(line))
      ++complaints;
    else
      std::fprintf(stream, "%s\n", line.c_str());
  }
  std::fflush(stream);
  return complaints;
}

#endif

} // namespace

#ifdef __GLIBC__

QuietOutput::QuietOutput()
{
  if (outStream().stream == nullptr || errStream().stream == nullptr)
    return;
  out_ = stdout;
  err_ = stderr;
  stdout = outStream().stream;
  stderr = errStream().stream;
}

std::size_t
QuietOutput::finish()
{
  if (out_ != nullptr) {
    stdout = out_;
    stderr = err_;
    out_ = err_ = nullptr;
    complaints_ = sift(outStream().take(), stdout) + sift(errStream().take(), stderr);
  }
  return complaints_;
}

#else

QuietOutput::QuietOutput() = default;

std::size_t
QuietOutput::finish()
{
  static_cast<void>(isPoissonComplaint);
  return complaints_;
}

#endif

QuietOutput::~QuietOutput()
{
  finish();
}

} // namespace sedr
} // namespace pcl
