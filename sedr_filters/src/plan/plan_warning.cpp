// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plan_warning.h>

#include "../base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief The words for a kind of warning. In a sentence, {k.d} stands for the k-th
 * value with d decimals, {reason} for the reason. */
struct Words {
  const char* name;     ///< in files
  const char* several;  ///< what several of them are called
  const char* unit;     ///< of the first values, which add up unless it is %; or empty
  const char* sentence; ///< about one
  const char* opposite = nullptr; ///< the sentence if the last value is below 0
};

/** In the order of WarningKind. */
constexpr std::array<Words, 42> words{{
    {"coverage", "", "",
     "{0.0} of the {1.0} m2 of floor that was seen are in the model, {2.0} %; the "
     "largest part that is missing has {3.0} m2{at}, z {4.1} to {5.1} m: {reason}"},
    {"unit", "", "", "{reason}"},
    {"up", "", "", "{reason}"},
    {"lost_points", "", "", "{0.0} % of the points are not finite: they were left out"},
    {"strays", "", "",
     "{0.1} % of the points are scattered all over the air: they were left out"},
    {"positions", "", "",
     "{0.0} of {1.0} positions of the scanner are not where the points were taken "
     "from: they lie on a surface, or rays from there go through walls that were seen; "
     "they were left out"},
    {"mirrors", "", "",
     "{0.0} mirroring surfaces, such as panes, were found by the scanner's positions; "
     "{1.0} thinned points seen in them were left out"},
    {"levelled", "", "",
     "the scan is tilted by {0.2} degrees, its up leans towards {1.0} degrees from x: "
     "it was made level; {reason}, the plan stays level"},
    {"sparse", "", "",
     "the scan is too sparse for cells of {0.2} m, its ceilings leave some empty: "
     "cells of {1.2} m are used, smaller things are lost"},
    {"no_plan", "rooms have no plan and are not in the model", "",
     "it has no plan and is not in the model: {reason}"},
    {"stage", "rooms could not be worked on", "", "{reason}"},
    {"left_out", "places are left out", "m2", "{0.1} m2{at} are left out: {reason}"},
    {"hidden", "rooms are partly hidden behind furniture or other things", "m2",
     "{0.1} of its {1.1} m2 were not seen, as furniture or other things stand before "
     "them: its walls were drawn on until they meet"},
    {"open", "rooms may go on where neither a wall nor an opening was seen", "m",
     "along {0.1} m of its outline neither a wall nor an opening was seen: it may go "
     "on there"},
    {"no_opening", "ways between rooms have no opening in the plan", "m",
     "one can walk to room {2.0}{at}, through a gap {0.2} m wide and {1.2} m high, but "
     "no opening was found there"},
    {"filled_in", "rooms have walls of which a large part was not measured", "%",
     "{0.0} % of its walls were not measured: {1.0} % are inferred behind what hides "
     "them, {2.0} % nobody saw"},
    {"guessed_wall", "walls are guesses", "m",
     "its place over {0.1} m is a guess: {1.0} % of it is inferred behind what hides "
     "it, {2.0} % nobody saw"},
    {"ceiling_apart", "rooms have parts of a ceiling that lie apart and are left out",
     "m2",
     "{0.2} m2 of ceiling lie apart from the rest of its ceiling and are left out"},
    {"ceiling_off", "rooms have ceilings more than 10 cm off the model", "m2",
     "{0.1} m2 of its ceiling, {1.2} to {2.2} m above its floor, are more than 10 cm "
     "off the model"},
    {"floor_off", "rooms have floors more than 10 cm off the model", "m2",
     "{0.1} m2 of its floor, at {1.2} to {2.2} m from its main floor, are more than 10 "
     "cm off the model"},
    {"floor_unseen",
     "rooms have floors of which more than furniture hides was not seen", "m2",
     "{0.1} m2 of its floor{at} were not seen, more than furniture hides: there may be "
     "a stage"},
    {"wall_off", "walls are off what was seen", "m2",
     "{0.1} m2 of what was seen there lie {1.0} cm before it",
     "{0.1} m2 of what was seen there lie {1.0} cm behind it"},
    {"standing", "rooms hold more than walls and columns up to the ceiling", "m2",
     "{0.1} m2 of what was seen within it reach up to the ceiling and are no wall or "
     "column of the plan"},
    {"half_wall", "rooms hold half walls, which are not in the plan", "m",
     "what stands{at} like a half wall, {0.1} m long and {1.1} m high, is not in the "
     "plan"},
    {"tilted", "walls are tilted", "", "it is tilted by {0.2} degrees into the room",
     "it is tilted by {0.2} degrees out of the room"},
    {"not_adjusted", "", "",
     "the plan is only as exact as thinned points are, it could not be fitted to the "
     "scan: {reason}"},
    {"crossing", "solids of rooms run into others", "",
     "its solid runs into that of room {0.0}"},
    {"contradiction", "places of the plan contradict each other, the solid is simpler",
     "m2", "{reason}"},
    {"opening_closed", "", "",
     "of {1.0} openings {0.0} are closed in the solid, number {reason} of "
     "floorplan.json"},
    {"no_solid", "rooms have no solid", "", "it has no solid: {reason}"},
    {"not_in_ifc", "", "",
     "of {1.0} openings {0.0} are not in the IFC, as they are in none of its walls: "
     "{reason}"},
    {"ifc_loss", "things are not in the IFC", "", "{reason}"},
    {"mesh", "meshes are not closed, or closed by a guess", "", "{reason}"},
    {"mesh_volume", "rooms have meshes and solids of different volumes", "",
     "its mesh holds {0.2} m3, but its solid {1.2} m3"},
    {"no_door", "rooms have no door", "m2", "no door, passage or stair leads into it"},
    {"narrow_door", "doors are narrow", "", "a door of {0.2} m"},
    {"small_room", "rooms are small", "", "a room of {0.1} m2"},
    {"narrow_room", "rooms are narrow", "", "nowhere wider than {0.2} m"},
    {"height", "rooms have unusual heights", "", "{0.2} m high",
     "its ceiling lies {0.2} m below its floor{at}"},
    {"ragged", "rooms have many walls", "", "{0.1} walls in 10 m of its outline"},
    {"flat_arc", "arcs are so flat that they may be straight", "",
     "an arc that rises only {0.1} cm above its chord, of {1.1} m radius: it may be "
     "straight"},
    {"small_storey", "storeys are small", "", "{reason}: a storey of {0.1} m2"},
}};

const Words&
wordsOf(WarningKind kind)
{
  return words[static_cast<std::size_t>(kind)];
}

double
firstOf(const PlanWarning& warning)
{
  return warning.values.empty() ? 0 : std::abs(warning.values.front());
}

/** @brief Returns what a placeholder stands for. */
std::string
filledIn(const std::string& name, const PlanWarning& warning)
{
  if (name == "reason")
    return warning.reason;
  if (name == "at")
    return warning.at.allFinite() ? " around (" + decimalText(warning.at.x(), 1) +
                                        ", " + decimalText(warning.at.y(), 1) + ")"
                                  : "";
  const auto k = static_cast<std::size_t>(name[0] - '0');
  return k < warning.values.size() ? decimalText(warning.values[k], name[2] - '0')
                                   : "?";
}

} // namespace

std::string
nameOf(WarningKind kind)
{
  return wordsOf(kind).name;
}

std::string
sentenceOf(const PlanWarning& warning)
{
  std::string text;
  if (warning.wall > 0)
    text = "wall " + std::to_string(warning.room) + "." + std::to_string(warning.wall) +
           ": ";
  else if (warning.room > 0)
    text = "room " + std::to_string(warning.room) + ": ";
  const Words& of_kind = wordsOf(warning.kind);
  const bool is_opposite =
      of_kind.opposite && !warning.values.empty() && warning.values.back() < 0;
  std::string words = is_opposite ? of_kind.opposite : of_kind.sentence;
  PlanWarning shown = warning;
  if (is_opposite)
    shown.values.back() *= -1;
  if (warning.kind == WarningKind::Crossing && firstOf(warning) == warning.room)
    words = "its solid meets itself";
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t open = std::min(words.find('{', at), words.size());
    text.append(words, at, open - at);
    const std::size_t close = words.find('}', open);
    if (open == words.size())
      break;
    text += filledIn(words.substr(open + 1, close - open - 1), shown);
    at = close + 1;
  }
  return text;
}

std::vector<std::string>
summaryOf(const std::vector<PlanWarning>& warnings, std::size_t most)
{
  std::map<WarningKind, std::vector<const PlanWarning*>> kinds;
  for (const PlanWarning& warning : warnings)
    kinds[warning.kind].push_back(&warning);
  std::vector<std::string> lines;
  std::size_t told = 0;
  for (const auto& [kind, all] : kinds) {
    if (lines.size() + 1 == most && kinds.size() > most) {
      lines.push_back("and " + std::to_string(warnings.size() - told) + " more of " +
                      std::to_string(kinds.size() - lines.size()) +
                      " other kinds, see the report");
      break;
    }
    told += all.size();
    const PlanWarning& worst =
        **std::max_element(all.begin(), all.end(), [](const auto* a, const auto* b) {
          return firstOf(*a) < firstOf(*b);
        });
    const Words& of_kind = wordsOf(kind);
    if (all.size() == 1) {
      lines.push_back(sentenceOf(worst));
      continue;
    }
    const std::string unit = of_kind.unit;
    double sum = 0;
    for (const PlanWarning* warning : all)
      sum += firstOf(*warning);
    std::string line = std::to_string(all.size()) + " " + of_kind.several;
    if (!unit.empty() && unit != "%")
      line += ", " + decimalText(sum, 1) + " " + unit + " in all";
    lines.push_back(line + (unit.empty() ? "; first: " : "; most: ") +
                    sentenceOf(unit.empty() ? *all.front() : worst));
  }
  return lines;
}

} // namespace pcl::sedr
