// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/plan_warning.h>

#include "../base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief The words for a kind of warning. In a sentence, {k.d} stands for the k-th
 * value with d decimals, {reason} for the reason. */
struct Words {
  const char* name; ///< in files
  const char* act;  ///< see WarningAdvice, as the next two
  Stake stake;
  double odds;
  const char* sentence;
  const char* opposite = nullptr; ///< the sentence if the last value is below 0
};

/** In the order of WarningKind. Odds of kinds that at least six random buildings had
 * are what of the rooms or square metres was wrong there, see doc/reliability.md; the
 * others are chosen. */
constexpr std::array<Words, static_cast<std::size_t>(WarningKind::Edited) + 1> words{{
    {"coverage", "scan again", Stake::Plan, 0.3,
     "{0.0} of the {1.0} m2 of floor that was seen are in the model, {2.0} %; the "
     "largest part that is missing has {3.0} m2{at}, z {4.1} to {5.1} m: {reason}"},
    {"unit", "check the unit", Stake::Plan, 0.5, "{reason}"},
    {"up", "check which way is up", Stake::Plan, 0.5, "{reason}"},
    {"lost_points", "", Stake::None, 0,
     "{0.0} % of the points are not finite: they were left out"},
    {"strays", "", Stake::None, 0,
     "{0.1} % of the points are scattered all over the air: they were left out"},
    {"noise", "scan again", Stake::Plan, 0.5,
     "half of the points lie {0.1} cm or more off the planes that fit them best: the "
     "scan is noisy, or its points are strewn"},
    {"positions", "check the positions", Stake::None, 0,
     "{0.0} of {1.0} positions of the scanner are not where the points were taken "
     "from: they lie on a surface, or rays from there go through walls that were seen; "
     "they were left out"},
    {"mirrors", "", Stake::None, 0,
     "{0.0} mirroring surfaces, such as panes, were found by the scanner's positions; "
     "{1.0} thinned points seen in them were left out"},
    {"levelled", "", Stake::None, 0,
     "the scan is tilted by {0.2} degrees, its up leans towards {1.0} degrees from x: "
     "it was made level; {reason}, the plan stays level"},
    {"sparse", "scan more densely", Stake::Plan, 0.1,
     "the scan is too sparse for cells of {0.2} m, its ceilings leave some empty: "
     "cells of {1.2} m are used, smaller things are lost"},
    {"no_plan", "look at", Stake::Plan, 0.05,
     "it has no plan and is not in the model: {reason}"},
    {"stage", "look at", Stake::Plan, 0.05, "{reason}"},
    {"left_out", "look at", Stake::Value, 0.5, "{0.1} m2{at} are left out: {reason}"},
    {"hidden", "look at", Stake::Room, 0.02,
     "{0.1} of its {1.1} m2 were not seen, as furniture or other things stand before "
     "them: its walls were drawn on until they meet"},
    {"open", "look at", Stake::Room, 0.03,
     "along {0.1} m of its outline neither a wall nor an opening was seen: it may go "
     "on there"},
    {"no_opening", "look for a door of", Stake::Value, 0.5,
     "one can walk to room {2.0}{at}, through a gap {0.2} m wide and {1.2} m high, but "
     "no opening was found there"},
    {"filled_in", "scan again in", Stake::Room, 0.35,
     "{0.0} % of its walls were not measured: {1.0} % are inferred behind what hides "
     "them, {2.0} % nobody saw"},
    {"guessed_wall", "measure", Stake::None, 0,
     "its place over {0.1} m is a guess: {1.0} % of it is inferred behind what hides "
     "it, {2.0} % nobody saw"},
    {"ceiling_apart", "look at", Stake::Value, 0.5,
     "{0.2} m2 of ceiling lie apart from the rest of its ceiling and are left out"},
    {"ceiling_unseen", "look at", Stake::Value, 0.3,
     "{0.1} m2 of its ceiling{at} were not seen, beside sides that lead up from it as "
     "those of joists do: it may be higher there"},
    {"part_unseen", "look at", Stake::Value, 0.3,
     "{0.1} m2 of a lower part of its ceiling{at} were not seen: it may end before the "
     "wall"},
    {"ceiling_off", "look at", Stake::Value, 0.3,
     "{0.1} m2 of its ceiling, {1.2} to {2.2} m above its floor, are more than 10 cm "
     "off the model"},
    {"floor_off", "look at", Stake::Value, 0.15,
     "{0.1} m2 of its floor, at {1.2} to {2.2} m from its main floor, are more than 10 "
     "cm off the model"},
    {"floor_unseen", "look at", Stake::Value, 0.2,
     "{0.1} m2 of its floor{at} were not seen, more than furniture hides: there may be "
     "a stage"},
    {"wall_off", "look at", Stake::Value, 0.5,
     "{0.1} m2 of what was seen there lie {1.0} cm before it",
     "{0.1} m2 of what was seen there lie {1.0} cm behind it"},
    {"standing", "look at", Stake::Value, 0.3,
     "{0.1} m2 of what was seen within it{at} reach up to the ceiling and are not in "
     "the plan"},
    {"hanging", "look at", Stake::Value, 0.5,
     "{0.1} m2 of its ceiling{at} lie {1.2} m below the rest, but of no side between "
     "more than {2.0} % was seen: they may be a thing that hangs there"},
    {"tilted", "look at", Stake::None, 0, "it is tilted by {0.2} degrees into the room",
     "it is tilted by {0.2} degrees out of the room"},
    {"not_adjusted", "", Stake::Plan, 0.05,
     "the plan is only as exact as thinned points are, it could not be fitted to the "
     "scan: {reason}"},
    {"crossing", "look at", Stake::Room, 0.02,
     "its solid runs into that of room {0.0}"},
    {"contradiction", "look at", Stake::Value, 0.5, "{reason}"},
    {"opening_closed", "", Stake::None, 0,
     "of {1.0} openings {0.0} are closed in the solid, number {reason} of "
     "floorplan.json"},
    {"no_solid", "look at", Stake::Room, 0.5, "it has no solid: {reason}"},
    {"not_in_ifc", "", Stake::None, 0,
     "of {1.0} openings {0.0} are not in the IFC, as they are in none of its walls: "
     "{reason}"},
    {"ifc_loss", "", Stake::None, 0, "{reason}"},
    {"mesh", "look at", Stake::None, 0, "{reason}"},
    {"mesh_volume", "look at", Stake::Room, 0.05,
     "its mesh holds {0.2} m3, but its solid {1.2} m3"},
    {"no_door", "look for a door of", Stake::Room, 0.1,
     "no door, passage or stair leads into it"},
    {"narrow_door", "look at", Stake::None, 0, "a door of {0.2} m"},
    {"small_room", "look at", Stake::Room, 0.5, "a room of {0.1} m2"},
    {"narrow_room", "look at", Stake::Room, 0.5, "nowhere wider than {0.2} m"},
    {"height", "look at", Stake::Room, 0.05, "{0.2} m high",
     "its ceiling lies {0.2} m below its floor{at}"},
    {"short_walls", "look at", Stake::Room, 0.25,
     "its walls are {0.2} m long on average: some may be furniture"},
    {"flat_arc", "look at", Stake::None, 0,
     "an arc that rises only {0.1} cm above its chord, of {1.1} m radius: it may be "
     "straight"},
    {"in_line", "look at", Stake::None, 0,
     "where it ends the edge of a soffit goes on along its line for {0.1} m: it may be "
     "the front of furniture"},
    {"raised_floor", "look at", Stake::Value, 0.5,
     "{0.1} m2 of its floor{at} lie {1.2} m higher: they may be a thing that stands "
     "there"},
    {"small_storey", "look at", Stake::Value, 0.5, "{reason}: a storey of {0.1} m2"},
    {"one_room", "look at", Stake::Value, 0.35,
     "it may be one room with room {2.0}, {1.0} % likely: little parts them where they "
     "meet{at}"},
    {"two_rooms", "look at", Stake::Value, 0.35,
     "{0.1} m2 of it may be a room of their own, {1.0} % likely: little joins them to "
     "the rest{at}"},
    {"edited", "", Stake::None, 0, "{reason}"},
}};
static_assert(words.back().name != nullptr, "a kind lacks words");

const Words&
wordsOf(WarningKind kind)
{
  return words[static_cast<std::size_t>(kind)];
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

std::optional<WarningKind>
warningKindOf(const std::string& name)
{
  for (std::size_t k = 0; k < words.size(); ++k)
    if (words[k].name == name)
      return static_cast<WarningKind>(k);
  return {};
}

std::string
subjectOf(const PlanWarning& warning)
{
  const std::string room = std::to_string(warning.room);
  return warning.wall > 0    ? "wall " + room + "." + std::to_string(warning.wall)
         : warning.room == 0 ? ""
         : warning.kind == WarningKind::WallOff ? "column of room " + room
                                                : "room " + room;
}

std::string
sentenceOf(const PlanWarning& warning)
{
  const std::string subject = subjectOf(warning);
  return (subject.empty() ? "" : subject + ": ") + claimOf(warning);
}

std::string
claimOf(const PlanWarning& warning)
{
  std::string text;
  const Words& of_kind = wordsOf(warning.kind);
  const bool is_opposite =
      of_kind.opposite && !warning.values.empty() && warning.values.back() < 0;
  std::string words = is_opposite ? of_kind.opposite : of_kind.sentence;
  PlanWarning shown = warning;
  if (is_opposite)
    shown.values.back() *= -1;
  if (warning.kind == WarningKind::WallOff && warning.values.size() > 2) {
    words = "the ceiling goes on {1.0} cm behind it over {2.1} m, as above what stands "
            "before a wall: {0.1} m2 of it may be no wall";
    shown.values[1] = std::abs(shown.values[1]);
  }
  if (warning.kind == WarningKind::Standing && warning.values.size() > 1)
    words = "{0.1} m2 of what stands free in it{at}, as thin as a wall and up to {1.1} "
            "m high, are not in the plan: it may be a half wall";
  if (warning.kind == WarningKind::Crossing && !warning.values.empty() &&
      warning.values[0] == warning.room)
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
  return text + (warning.note.empty() ? "" : " (" + warning.note + ")");
}

WarningAdvice
adviceOn(WarningKind kind)
{
  const Words& of_kind = wordsOf(kind);
  return {of_kind.act, of_kind.stake, of_kind.odds};
}

} // namespace pcl::sedr
