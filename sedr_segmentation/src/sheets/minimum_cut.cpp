// SPDX-License-Identifier: BSD-3-Clause
#include "minimum_cut.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>

namespace pcl {
namespace sedr {

namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;

struct Arc {
  double capacity = 0;
  double residual = 0;
  Traits::edge_descriptor reverse;
};

using Graph = boost::
    adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Arc>;

void
addArcs(Graph& graph, std::size_t from, std::size_t to, double there, double back)
{
  const auto forward = boost::add_edge(from, to, graph).first;
  const auto backward = boost::add_edge(to, from, graph).first;
  graph[forward].capacity = there;
  graph[backward].capacity = back;
  graph[forward].reverse = backward;
  graph[backward].reverse = forward;
}

} // namespace

void
BinaryEnergy::addPair(std::size_t a,
                      std::size_t b,
                      double no_no,
                      double no_yes,
                      double yes_no,
                      double yes_yes)
{
  yes_[a] += yes_no - no_no;
  yes_[b] += yes_yes - yes_no;
  pairs_.push_back({a, b, std::max(0.0, no_yes + yes_no - no_no - yes_yes)});
}

std::vector<std::uint8_t>
BinaryEnergy::minimise() const
{
  // The source's side says yes.
  const std::size_t source = yes_.size();
  const std::size_t sink = source + 1;
  Graph graph(yes_.size() + 2);
  for (std::size_t v = 0; v < yes_.size(); ++v) {
    if (yes_[v] < 0)
      addArcs(graph, source, v, -yes_[v], 0);
    else if (yes_[v] > 0)
      addArcs(graph, v, sink, yes_[v], 0);
  }
  for (const Pair& pair : pairs_)
    addArcs(graph, pair.b, pair.a, pair.capacity, 0);
  std::vector<Traits::edge_descriptor> tree(boost::num_vertices(graph));
  std::vector<boost::default_color_type> colour(boost::num_vertices(graph));
  std::vector<double> distance(boost::num_vertices(graph));
  boost::boykov_kolmogorov_max_flow(
      graph, boost::get(&Arc::capacity, graph), boost::get(&Arc::residual, graph),
      boost::get(&Arc::reverse, graph), tree.data(), colour.data(), distance.data(),
      boost::get(boost::vertex_index, graph), source, sink);
  std::vector<std::uint8_t> answers(yes_.size());
  for (std::size_t v = 0; v < yes_.size(); ++v)
    answers[v] = colour[v] == boost::black_color ? 1 : 0;
  return answers;
}

} // namespace sedr
} // namespace pcl
