// SPDX-License-Identifier: BSD-3-Clause
#include "ribs.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr::sim {

namespace {

constexpr double kSame = 1e-6;     ///< metres; closer positions are equal
constexpr double kThinnest = 1e-3; ///< metres; thinner pieces are left out

/** @brief The range of positions across the ribs that one rib occupies. */
struct Strip {
  double low = 0.0;
  double high = 0.0;
};

/** @brief A family of ribs with its strips; `across` points to the left of the ribs. */
struct Deck {
  Vec2 along;
  Vec2 across;
  std::vector<Strip> strips;
};

using Corners = std::vector<Vec2>; // of a convex polygon, counter-clockwise

Deck
deckOf(const Loop& outline, const RibFamily& family)
{
  Deck deck;
  deck.along = {std::cos(family.direction), std::sin(family.direction)};
  deck.across = leftOf(deck.along);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const LoopVertex& vertex : outline) {
    low = std::min(low, dot(vertex.position, deck.across));
    high = std::max(high, dot(vertex.position, deck.across));
  }
  const double half = 0.5 * family.width;
  const double first = low + family.first.value_or(0.5 * family.spacing);
  for (int i = 0; first + i * family.spacing + half <= high + kSame; ++i) {
    const double middle = first + i * family.spacing;
    if (middle - half >= low - kSame)
      deck.strips.push_back({middle - half, middle + half});
  }
  return deck;
}

/** @brief Returns the positions across the ribs of a strip's ends and corners. */
std::vector<double>
cutsOf(const Loop& outline, const Deck& deck, const Strip& strip)
{
  std::vector<double> cuts{strip.low, strip.high};
  for (const LoopVertex& vertex : outline) {
    const double place = dot(vertex.position, deck.across);
    if (place > strip.low + kSame && place < strip.high - kSame)
      cuts.push_back(place);
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end(),
                         [](double a, double b) { return b - a < kSame; }),
             cuts.end());
  return cuts;
}

/** @brief Crossing of a wall with the two sides of a strip without corners. */
struct Crossing {
  double at_low = 0.0;  ///< along the ribs
  double at_high = 0.0; ///< along the ribs
};

std::vector<Crossing>
crossingsOf(const Loop& outline, const Deck& deck, const Strip& strip)
{
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Element wall = elementOf(outline, i);
    const double start = dot(wall.start, deck.across);
    const double end = dot(wall.end, deck.across);
    if (std::min(start, end) > strip.low + kSame ||
        std::max(start, end) < strip.high - kSame)
      continue;
    const auto along = [&](double place) {
      const double t = (place - start) / (end - start);
      return dot(wall.start + t * (wall.end - wall.start), deck.along);
    };
    crossings.push_back({along(strip.low), along(strip.high)});
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) {
              return a.at_low + a.at_high < b.at_low + b.at_high;
            });
  return crossings;
}

/** @brief Returns the parts of a strip within the outline, as quadrangles. */
std::vector<Corners>
piecesWithin(const Loop& outline, const Deck& deck, const Strip& strip)
{
  std::vector<Corners> pieces;
  const std::vector<double> cuts = cutsOf(outline, deck, strip);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const auto crossings = crossingsOf(outline, deck, {cuts[i], cuts[i + 1]});
    const auto corner = [&](double along, double across) {
      return along * deck.along + across * deck.across;
    };
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      pieces.push_back({corner(crossings[k].at_low, cuts[i]),
                        corner(crossings[k + 1].at_low, cuts[i]),
                        corner(crossings[k + 1].at_high, cuts[i + 1]),
                        corner(crossings[k].at_high, cuts[i + 1])});
  }
  return pieces;
}

/** @brief Returns the part of a polygon where dot(p, normal) is at most @p limit. */
Corners
clipped(const Corners& polygon, Vec2 normal, double limit)
{
  Corners kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    const double da = dot(a, normal) - limit;
    const double db = dot(b, normal) - limit;
    if (da <= kSame)
      kept.push_back(a);
    if ((da < -kSame && db > kSame) || (da > kSame && db < -kSame))
      kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

bool
isThin(const Corners& polygon)
{
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += 0.5 * cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return polygon.size() < 3 || area < kThinnest * kThinnest;
}

/** @brief Returns the parts of @p polygon outside the strips of @p deck. */
std::vector<Corners>
outsideOf(const Deck& deck, Corners polygon)
{
  std::vector<Corners> parts;
  for (const Strip& strip : deck.strips) {
    parts.push_back(clipped(polygon, deck.across, strip.low));
    polygon = clipped(polygon, -1.0 * deck.across, -strip.high);
  }
  parts.push_back(std::move(polygon));
  parts.erase(std::remove_if(parts.begin(), parts.end(), isThin), parts.end());
  return parts;
}

Loop
loopOf(const Corners& corners)
{
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (length(corners[(i + 1) % corners.size()] - corners[i]) > kSame)
      loop.push_back({corners[i]});
  return loop;
}

} // namespace

std::vector<std::vector<Loop>>
ribLoops(const Loop& outline, const std::vector<RibFamily>& families)
{
  std::vector<Deck> decks;
  for (const RibFamily& family : families)
    decks.push_back(deckOf(outline, family));
  std::vector<std::vector<Loop>> loops(decks.size());
  for (std::size_t i = 0; i < decks.size(); ++i)
    for (const Strip& strip : decks[i].strips) {
      std::vector<Corners> pieces = piecesWithin(outline, decks[i], strip);
      for (std::size_t later = i + 1; later < decks.size(); ++later) {
        std::vector<Corners> rest;
        for (const Corners& piece : pieces)
          for (Corners& part : outsideOf(decks[later], piece))
            rest.push_back(std::move(part));
        pieces = std::move(rest);
      }
      for (const Corners& piece : pieces)
        if (!isThin(piece))
          loops[i].push_back(loopOf(piece));
    }
  return loops;
}

} // namespace pcl::sedr::sim
