// SPDX-License-Identifier: BSD-3-Clause
#include "minimum_cut.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <utility>

namespace pcl {
namespace sedr {

namespace {

using Graph = boost::compressed_sparse_row_graph<boost::directedS>;
using Edge = boost::graph_traits<Graph>::edge_descriptor;

/** @brief Arcs in pairs, there and back, one after the other. */
class Arcs {
public:
  /** @param pairs that will be added, at most */
  Arcs(std::size_t vertices, std::size_t pairs)
      : vertices_(vertices)
  {
    arcs_.reserve(2 * pairs);
  }

  void add(std::size_t from, std::size_t to, double capacity)
  {
    arcs_.push_back({from, to, capacity});
    arcs_.push_back({to, from, 0});
  }

  /** @brief Returns whether each vertex is on the source's side of a minimum cut. */
  std::vector<std::uint8_t> cut(std::size_t source, std::size_t sink) const
  {
    // Sorted by where they start; in the order in which they were added.
    std::vector<std::size_t> place(arcs_.size());
    std::vector<std::size_t> next(vertices_ + 1, 0);
    for (const Arc& arc : arcs_)
      ++next[arc.from + 1];
    for (std::size_t v = 0; v < vertices_; ++v)
      next[v + 1] += next[v];
    for (std::size_t k = 0; k < arcs_.size(); ++k)
      place[k] = next[arcs_[k].from]++;
    std::vector<std::pair<std::size_t, std::size_t>> sorted(arcs_.size());
    std::vector<double> capacity(arcs_.size());
    for (std::size_t k = 0; k < arcs_.size(); ++k) {
      sorted[place[k]] = {arcs_[k].from, arcs_[k].to};
      capacity[place[k]] = arcs_[k].capacity;
    }
    const Graph graph(boost::edges_are_sorted, sorted.begin(), sorted.end(), vertices_);
    std::vector<Edge> reverse(arcs_.size());
    for (std::size_t k = 0; k < arcs_.size(); ++k)
      reverse[place[k]] = Edge(arcs_[k].to, place[k ^ 1]);
    std::vector<double> residual(arcs_.size());
    std::vector<Edge> tree(vertices_);
    std::vector<boost::default_color_type> colour(vertices_);
    std::vector<double> distance(vertices_);
    const auto by_edge = boost::get(boost::edge_index, graph);
    const auto of = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), by_edge);
    };
    boost::boykov_kolmogorov_max_flow(
        graph, of(capacity), of(residual), of(reverse), tree.data(), colour.data(),
        distance.data(), boost::get(boost::vertex_index, graph), source, sink);
    std::vector<std::uint8_t> is_sources(vertices_);
    for (std::size_t v = 0; v < vertices_; ++v)
      is_sources[v] = colour[v] == boost::black_color ? 1 : 0;
    return is_sources;
  }

private:
  struct Arc {
    std::size_t from;
    std::size_t to;
    double capacity;
  };

  std::size_t vertices_;
  std::vector<Arc> arcs_;
};

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
  if (const double capacity = no_yes + yes_no - no_no - yes_yes; capacity > 0)
    pairs_.push_back({a, b, capacity});
}

std::vector<std::uint8_t>
BinaryEnergy::minimise() const
{
  // The source's side says yes.
  const std::size_t source = yes_.size();
  const std::size_t sink = source + 1;
  Arcs arcs(yes_.size() + 2, yes_.size() + pairs_.size());
  for (std::size_t v = 0; v < yes_.size(); ++v) {
    if (yes_[v] < 0)
      arcs.add(source, v, -yes_[v]);
    else if (yes_[v] > 0)
      arcs.add(v, sink, yes_[v]);
  }
  for (const Pair& pair : pairs_)
    arcs.add(pair.b, pair.a, pair.capacity);
  std::vector<std::uint8_t> answers = arcs.cut(source, sink);
  answers.resize(yes_.size());
  return answers;
}

} // namespace sedr
} // namespace pcl
