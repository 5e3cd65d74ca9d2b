// SPDX-License-Identifier: MIT
#include "reports/compact_svg.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reports/svg_path_data.hpp"
#include "reports/svg_tokens.hpp"

namespace phytobench {

namespace {

/// Groups that only hand attributes down: what is composed as a whole, or named, stays.
bool is_plain_group(const std::string& tag) {
  for (const char* own : {" opacity=", " id=", " filter=", " mask=", " clip-path=", " style="})
    if (tag.find(own) != std::string::npos) return false;
  return true;
}

SvgTokens with_joined_groups(const SvgTokens& tokens) {
  SvgTokens joined;
  std::vector<std::string> open;
  std::string closed;  // the opening tag of the group that ended last
  for (const std::string& token : tokens) {
    if (opens(token, "g")) {
      open.push_back(token);
      if (!joined.empty() && joined.back() == "</g>" && closed == token && is_plain_group(token))
        joined.pop_back();
      else
        joined.push_back(token);
    } else if (token == "</g>" && !open.empty()) {
      const bool is_empty = joined.back() == open.back() && is_plain_group(open.back());
      if (is_empty) {
        joined.pop_back();
      } else {
        joined.push_back(token);
        closed = open.back();
      }
      open.pop_back();
    } else {
      joined.push_back(token);
    }
  }
  return joined;
}

std::string without_attribute(const std::string& tag, const std::string& name) {
  const std::size_t start = tag.find(" " + name + "=\"");
  if (start == std::string::npos) return tag;
  const std::size_t end = tag.find('"', start + name.size() + 3) + 1;
  return tag.substr(0, start) + tag.substr(end);
}

/// The opening tag of a text that was in a group with this transform.
std::string placed_text(const std::string& transform) {
  const std::size_t comma = transform.find(',');
  const bool only_moves = transform.starts_with("translate(") && comma != std::string::npos &&
                          transform.find(')') + 1 == transform.size();
  if (!only_moves) return "<text transform=\"" + transform + "\">";
  constexpr std::size_t start = std::string_view("translate(").size();
  return fmt::format("<text x=\"{}\" y=\"{}\">", transform.substr(start, comma - start),
                     transform.substr(comma + 1, transform.size() - comma - 2));
}

/// Groups around one text hand down letters and colour only; the text has its place itself. So
/// those of neighbours are equal.
SvgTokens with_placed_letters(SvgTokens tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const std::string transform = attribute_of(tokens[i], "transform");
    if (!opens(tokens[i], "g") || tokens[i + 1] != "<text>" || transform.empty()) continue;
    const auto end =
        std::find(tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end(), "</text>");
    if (end == tokens.end() || end + 1 == tokens.end() || *(end + 1) != "</g>") continue;
    tokens[i] = without_attribute(tokens[i], "transform");
    tokens[i + 1] = placed_text(transform);
  }
  return tokens;
}

/// A line of a grid or an axis: it may be drawn before letters and lines of its kind.
bool is_rule(const std::string& token) {
  return token.starts_with("<path ") && token.ends_with("'/>") &&
         token.find(" d='M") != std::string::npos && token.find(" fill") == std::string::npos &&
         (token.find(" stroke='currentColor'") != std::string::npos ||
          token.find(" class=\"gridline\"") != std::string::npos);
}

/// Lines of one look as one path, and letters after them.
class Rules {
 public:
  void add_line(const std::string& path) {
    const std::size_t data = path.find(" d='") + 4;
    const std::string look = path.substr(0, data);
    const auto own = std::find_if(lines_.begin(), lines_.end(),
                                  [&](const auto& line) { return line.first == look; });
    std::string& all = own == lines_.end() ? lines_.emplace_back(look, "").second : own->second;
    all += path.substr(data, path.size() - data - 3);
  }
  void add_letters(const std::string& token) { letters_.push_back(token); }

  void flush_into(SvgTokens& tokens) {
    for (const auto& [look, data] : lines_) tokens.push_back(look + data + "'/>");
    tokens.insert(tokens.end(), letters_.begin(), letters_.end());
    *this = {};
  }

 private:
  std::vector<std::pair<std::string, std::string>> lines_;  ///< data by the tag before it
  SvgTokens letters_;
};

/// Within a group that fills nothing: axes, grid and their numbers, which stand mixed.
SvgTokens with_joined_rules(const SvgTokens& tokens) {
  SvgTokens joined;
  Rules rules;
  std::vector<bool> fills;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool here = !fills.empty() && !fills.back();
    if (here && is_rule(tokens[i])) {
      rules.add_line(tokens[i]);
      continue;
    }
    if (here && opens(tokens[i], "g") && i + 1 < tokens.size() && opens(tokens[i + 1], "text") &&
        is_plain_group(tokens[i])) {
      while (tokens[i] != "</g>" && i + 1 < tokens.size()) rules.add_letters(tokens[i++]);
      rules.add_letters(tokens[i]);
      continue;
    }
    rules.flush_into(joined);
    if (opens(tokens[i], "g")) fills.push_back(attribute_of(tokens[i], "fill") != "none");
    if (tokens[i] == "</g>" && !fills.empty()) fills.pop_back();
    joined.push_back(tokens[i]);
  }
  rules.flush_into(joined);
  return joined;
}

std::optional<double> svg_number_in(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

struct Circle {
  double left = 0.0;
  double y = 0.0;
  std::string radius;
  double diameter = 0.0;
};

/// "<circle cx="1" cy="2" r="3"/>"; nothing if it says more than that.
std::optional<Circle> circle_of(const std::string& tag) {
  const std::string cx = attribute_of(tag, "cx"), cy = attribute_of(tag, "cy"),
                    r = attribute_of(tag, "r");
  if (tag != fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>", cx, cy, r)) return std::nullopt;
  const auto x = svg_number_in(cx), y = svg_number_in(cy), radius = svg_number_in(r);
  if (!x || !y || !radius) return std::nullopt;
  return Circle{*x - *radius, *y, r, 2.0 * *radius};
}

/// Two arcs, which end where they begin; the next circle is placed from there. The two flags of an
/// arc need no space behind them.
std::string circle_data(const Circle& circle, const Circle* before) {
  return fmt::format("{0}{1:.7g} {2:.7g}a{3} {3} 0 10{4:.7g} 0 {3} {3} 0 10-{4:.7g} 0",
                     before ? "m" : "M", circle.left - (before ? before->left : 0.0),
                     circle.y - (before ? before->y : 0.0), circle.radius, circle.diameter);
}

/// Circles one after the other of a group that fills nothing.
SvgTokens with_joined_circles(const SvgTokens& tokens) {
  SvgTokens joined;
  std::vector<bool> outlined;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (opens(tokens[i], "g"))
      outlined.push_back(attribute_of(tokens[i], "fill") == "none" &&
                         tokens[i].find("opacity") == std::string::npos);
    if (tokens[i] == "</g>" && !outlined.empty()) outlined.pop_back();
    std::vector<Circle> circles;
    while (!outlined.empty() && outlined.back() && i + circles.size() < tokens.size())
      if (const auto circle = circle_of(tokens[i + circles.size()]))
        circles.push_back(*circle);
      else
        break;
    if (circles.size() < 2) {
      joined.push_back(tokens[i]);
      continue;
    }
    std::string data;
    for (std::size_t own = 0; own < circles.size(); ++own)
      data += circle_data(circles[own], own == 0 ? nullptr : &circles[own - 1]);
    joined.push_back("<path d=\"" + data + "\"/>");
    i += circles.size() - 1;
  }
  return joined;
}

/// Paths by steps where that loses nothing. Gnuplot names corners to a hundredth of a pixel, of
/// which a tenth is enough.
std::string with_steps(const std::string& token, bool rounded) {
  const std::size_t start = token.find(" d=");
  if (!token.starts_with("<path ") || start == std::string::npos) return token;
  const std::size_t first = start + 4, end = token.find(token[start + 3], first);
  const std::string data = token.substr(first, end - first);
  if (!rounded && !is_in_tenths(data)) return token;
  return token.substr(0, first) + stepwise_path_data(data) + token.substr(end);
}

/// What gnuplot says of each group although it is so anyway: colours are inherited, and no group
/// says otherwise of ends and joints.
std::string without_the_usual(std::string token) {
  if (!opens(token, "g")) return token;
  for (const auto& [name, usual] : {std::pair{"color", "currentColor"},
                                    {"stroke-linecap", "butt"},
                                    {"stroke-linejoin", "miter"}})
    if (attribute_of(token, name) == usual) token = without_attribute(token, name);
  return token;
}

}  // namespace

std::string compact_svg(const std::string& svg) {
  const SvgTokens tokens = with_joined_groups(svg_tokens(svg));
  const SvgTokens joined = with_joined_groups(with_joined_rules(with_placed_letters(tokens)));
  const bool is_gnuplots = svg.find("gnuplot_canvas") != std::string::npos;
  bool defines = false;  // marks, in a unit that those who use them enlarge
  std::string text;
  for (const std::string& token : with_joined_circles(joined)) {
    if (opens(token, "defs") || token == "</defs>") defines = token != "</defs>";
    text += with_steps(is_gnuplots ? without_the_usual(token) : token, is_gnuplots && !defines);
  }
  return text;
}

}  // namespace phytobench
