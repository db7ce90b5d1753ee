// SPDX-License-Identifier: BSD-3-Clause
#include "minimum_cut.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace pcl::sedr {

namespace {

using Number = std::uint32_t; // of a vertex or an arc
constexpr Number closed = std::numeric_limits<Number>::max();
using Graph = boost::compressed_sparse_row_graph<boost::directedS,
                                                 boost::no_property,
                                                 boost::no_property,
                                                 boost::no_property,
                                                 Number,
                                                 Number>;
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

  void add(Number from, Number to, double capacity)
  {
    arcs_.push_back({from, to, capacity});
    arcs_.push_back({to, from, 0});
  }

  /** @brief Returns whether each vertex is on the source's side of a minimum cut. */
  std::vector<std::uint8_t> cut(Number source, Number sink) const
  {
    // Sorted by where they start; in the order in which they were added.
    std::vector<Number> place(arcs_.size());
    std::vector<Number> next(vertices_ + 1, 0);
    for (const Arc& arc : arcs_)
      ++next[arc.from + 1];
    for (std::size_t v = 0; v < vertices_; ++v)
      next[v + 1] += next[v];
    for (std::size_t k = 0; k < arcs_.size(); ++k)
      place[k] = next[arcs_[k].from]++;
    std::vector<std::pair<Number, Number>> sorted(arcs_.size());
    std::vector<double> capacity(arcs_.size());
    for (std::size_t k = 0; k < arcs_.size(); ++k) {
      sorted[place[k]] = {arcs_[k].from, arcs_[k].to};
      capacity[place[k]] = arcs_[k].capacity;
    }
    const Graph graph(boost::edges_are_sorted, sorted.begin(), sorted.end(),
                      static_cast<Number>(vertices_));
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
    Number from;
    Number to;
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
  const std::size_t pairs = yes_.size() + pairs_.size(); // of arcs, at most
  if (pairs > std::numeric_limits<Number>::max() / 2)
    throw std::length_error("a minimum cut takes at most " +
                            std::to_string(std::numeric_limits<Number>::max() / 2) +
                            " questions and pairs of them, not " +
                            std::to_string(pairs));
  // The source's side says yes.
  std::vector<double> yes = yes_;
  const std::vector<Number> number = openQuestions(yes);
  const auto open = static_cast<std::size_t>(std::count_if(
      number.begin(), number.end(), [](Number n) { return n != closed; }));
  std::vector<std::uint8_t> answers(yes.size(), 0);
  if (open == 0)
    return answers;
  const auto source = static_cast<Number>(open);
  const Number sink = source + 1;
  Arcs arcs(open + 2, pairs);
  for (std::size_t v = 0; v < yes.size(); ++v)
    if (number[v] != closed && yes[v] < 0)
      arcs.add(source, number[v], -yes[v]);
    else if (number[v] != closed && yes[v] > 0)
      arcs.add(number[v], sink, yes[v]);
  for (const Pair& pair : pairs_)
    if (number[pair.a] != closed && number[pair.b] != closed)
      arcs.add(number[pair.b], number[pair.a], pair.capacity);
  const std::vector<std::uint8_t> cut = arcs.cut(source, sink);
  for (std::size_t v = 0; v < yes.size(); ++v)
    answers[v] = number[v] != closed ? cut[number[v]] : 0;
  return answers;
}

std::vector<std::uint32_t>
BinaryEnergy::openQuestions(std::vector<double>& yes) const
{
  std::vector<double> gain(yes.size(), 0); // of a yes, if all others say yes
  std::vector<std::size_t> first(yes.size() + 1, 0);
  for (const Pair& pair : pairs_) {
    gain[pair.a] += pair.capacity;
    ++first[pair.a + 1];
    ++first[pair.b + 1];
  }
  for (std::size_t v = 0; v < yes.size(); ++v)
    first[v + 1] += first[v];
  std::vector<const Pair*> of(2 * pairs_.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const Pair& pair : pairs_) {
    of[next[pair.a]++] = &pair;
    of[next[pair.b]++] = &pair;
  }
  std::vector<Number> number(yes.size(), 0);
  std::vector<std::size_t> no;
  const auto ask = [&](std::size_t v) {
    if (number[v] == closed || yes[v] < gain[v])
      return;
    number[v] = closed;
    no.push_back(v);
  };
  for (std::size_t v = 0; v < yes.size(); ++v)
    ask(v);
  for (std::size_t k = 0; k < no.size(); ++k)
    for (std::size_t at = first[no[k]]; at < first[no[k] + 1]; ++at) {
      const Pair& pair = *of[at];
      if (pair.a == no[k])
        yes[pair.b] += pair.capacity;
      else
        gain[pair.a] -= pair.capacity;
      ask(pair.a == no[k] ? pair.b : pair.a);
    }
  Number open = 0;
  for (Number& n : number)
    n = n == closed ? closed : open++;
  return number;
}

} // namespace pcl::sedr
