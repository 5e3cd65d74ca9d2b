// SPDX-License-Identifier: MIT
// The places of a work that a claim's locator names: how a reader who knows only the work finds it.
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

enum class PlaceKind { equation, figure, table, section, listing, requirement, other };

/// "eq. 17" -> {equation, "17"}; "appendix table" -> {table, "appendix"}; "appendix A" ->
/// {section, "A"}; a locator without any of these -> {other, its text}.
struct Place {
  PlaceKind kind = PlaceKind::other;
  std::string number;
  friend bool operator==(const Place&, const Place&) = default;
};

/// By kind, then 4.9 before 4.11.
bool operator<(const Place& a, const Place& b);

/// All places, each once, in the order of the text. Letters of panels, steps, rows, columns and
/// pages are no places; a range, "(2.15) to (2.17)", gives all of its numbers.
std::vector<Place> places_of(std::string_view locator);

/// "Equation 17", "Chapter 5", "Section 5.2".
std::string shown(const Place& place);

/// What a search for the place looks for: "eq:17"; empty for other texts.
std::string search_token(const Place& place);

/// "Equations (Gleichungen)": the works are in German.
std::string_view heading_of(PlaceKind kind);

}  // namespace phytobench
