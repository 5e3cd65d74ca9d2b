// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/overlap/coverage.hpp"
#include "core/overlap/discs_file.hpp"
#include "core/overlap/overlap_registry.hpp"

namespace phytobench::cli {

namespace {

struct Overlaps {
  DiscTable table;
  std::string radius_column;
  std::optional<Rectangle> window;
  bool is_torus = false;
  OverlapPairs pairs;
  std::vector<double> overlap_sum;  ///< of each disc with all others, pair by pair
  Coverage coverage;

  double area(std::size_t i) const { return std::numbers::pi * table.radius[i] * table.radius[i]; }
};

void step(const char* what) {
  if (is_interrupted()) throw Interrupted("nothing was written");
  show_progress(what);
}

Overlaps find_overlaps(const OverlapOptions& options) {
  Overlaps result;
  if (!options.window.empty()) result.window = rectangle_from(options.window, "--window");
  result.is_torus = options.torus;
  if (options.torus && !result.window)
    throw InputError("--torus needs --window x0,y0,x1,y1: the sides that are joined");
  const OverlapEngineDescriptor& engine = overlap_engine_named(options.engine);
  const Ground ground{options.torus ? result.window : std::nullopt};
  step("reading discs");
  result.radius_column =
      options.radius.empty() ? usual_radius_column(options.discs) : options.radius;
  result.table = read_discs(options.discs, ground, result.radius_column);
  const Discs discs = result.table.discs();
  step("finding pairs");
  engine.create()->find(
      discs, ground,
      {.threads = options.threads, .most_pairs = static_cast<std::size_t>(options.most_pairs)},
      result.pairs);
  step("sorting pairs");
  result.pairs.sort_and_merge(discs.size());
  result.overlap_sum.assign(discs.size(), 0.0);
  for (std::size_t p = 0; p < result.pairs.size(); ++p)
    for (const DiscIndex i : {result.pairs.first()[p], result.pairs.second()[p]})
      result.overlap_sum[static_cast<std::size_t>(i)] += result.pairs.area()[p];
  step("measuring covered ground");
  result.coverage = coverage(discs, ground, result.window, options.threads,
                             static_cast<std::size_t>(options.most_pairs));
  return result;
}

/// Written piece by piece: as a tree in memory, millions of pairs would take gigabytes.
class JsonWriter {
 public:
  template <class... Values>
  void write(fmt::format_string<Values...> format, const Values&... values) {
    fmt::vformat_to(std::back_inserter(text_), format, fmt::make_format_args(values...));
    constexpr std::size_t enough = 1 << 20;
    if (text_.size() >= enough) flush();
  }
  void flush() {
    if (is_interrupted()) throw Interrupted("the document is incomplete");
    print(std::string(text_.data(), text_.size()));
    text_.clear();
  }

 private:
  fmt::memory_buffer text_;
};

/// A list, one entry a line; `entry(i)` writes the i-th.
template <class Entry>
void write_list(JsonWriter& out, const char* key, std::size_t count, const Entry& entry) {
  out.write("  \"{}\": [", key);
  for (std::size_t i = 0; i < count; ++i) {
    out.write("{}\n    ", i > 0 ? "," : "");
    entry(i);
  }
  out.write("{}]", count > 0 ? "\n  " : "");
}

void write_json(const Overlaps& o, const OverlapOptions& options) {
  JsonWriter out;
  out.write("{{\n  \"schema\": \"phytobench/overlap-1\",\n");
  out.write("  \"discs\": {},\n", json_text(nlohmann::json(options.discs), -1));
  out.write("  \"radius_column\": {},\n", json_text(nlohmann::json(o.radius_column), -1));
  out.write("  \"engine\": \"{}\",\n", options.engine);
  if (o.window)
    out.write("  \"window\": [{}, {}, {}, {}],\n", o.window->low.x, o.window->low.y,
              o.window->high.x, o.window->high.y);
  else
    out.write("  \"window\": null,\n");
  out.write("  \"torus\": {},\n", o.is_torus);
  write_list(out, "pairs", o.pairs.size(), [&](std::size_t p) {
    out.write("{{\"i\": {}, \"j\": {}, \"area\": {}}}", o.pairs.first()[p], o.pairs.second()[p],
              o.pairs.area()[p]);
  });
  out.write(",\n");
  write_list(out, "plants", o.overlap_sum.size(), [&](std::size_t i) {
    out.write("{{\"i\": {}, \"area\": {}, \"overlap_sum\": {}, \"covered\": {}}}", i, o.area(i),
              o.overlap_sum[i], o.coverage.covered[i]);
  });
  out.write(",\n");
  // Without a window there is no end to what is not covered.
  const std::size_t first = o.window ? 0 : 1;
  write_list(out, "covered", o.coverage.by_times.size() - first, [&](std::size_t k) {
    out.write("{{\"times\": {}, \"area\": {}}}", k + first, o.coverage.by_times[k + first]);
  });
  out.write("\n}}\n");
  out.flush();
}

std::string ground_text(const Overlaps& o) {
  if (!o.window) return "open plane";
  return fmt::format("{} {:g},{:g} to {:g},{:g}", o.is_torus ? "torus" : "window", o.window->low.x,
                     o.window->low.y, o.window->high.x, o.window->high.y);
}

std::string covered_table(const Overlaps& o) {
  const auto& by_times = o.coverage.by_times;
  const double all =
      o.window ? o.window->area() : std::accumulate(by_times.begin(), by_times.end(), 0.0);
  std::string text = fmt::format("\n{:>13}  {:>14}  {:>9}\n", "times covered", "area",
                                 o.window ? "of window" : "of cover");
  for (std::size_t k = o.window ? 0 : 1; k < by_times.size(); ++k)
    if (k == 0 || by_times[k] > 0.0)
      text += fmt::format("{:>13}  {:>14.6g}  {:>8.3f}%\n", k, by_times[k],
                          all > 0.0 ? 100.0 * by_times[k] / all : 0.0);
  return text;
}

/// The plants that others cover most, by their share.
std::string most_covered(const Overlaps& o) {
  constexpr std::size_t shown = 10;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < o.overlap_sum.size(); ++i)
    if (o.coverage.covered[i] > 0.0) order.push_back(i);
  const std::size_t count = std::min(shown, order.size());
  if (count == 0) return {};
  const auto share = [&](std::size_t i) { return o.coverage.covered[i] / o.area(i); };
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      return share(a) != share(b) ? share(a) > share(b) : a < b;
                    });
  std::string text = fmt::format("\n{:>10}  {:>12}  {:>14}  {:>12}  {:>8}\n", "plant", "area",
                                 "sum over pairs", "covered", "share");
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = order[k];
    text += fmt::format("{:>10}  {:>12.6g}  {:>14.6g}  {:>12.6g}  {:>7.2f}%\n", i, o.area(i),
                        o.overlap_sum[i], o.coverage.covered[i], 100.0 * share(i));
  }
  return text;
}

std::string table(const Overlaps& o, const OverlapOptions& options) {
  double discs = 0.0, overlaps = 0.0;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < o.overlap_sum.size(); ++i) {
    discs += o.area(i);
    beyond += o.overlap_sum[i] > o.area(i);
  }
  for (const double area : o.pairs.area()) overlaps += area;
  return fmt::format(
             "{}: {} discs, radii in column {}, {}\n\n"
             "overlapping pairs         {}\narea of all discs         {:.6g}\n"
             "overlap, pair by pair     {:.6g}\ndiscs smaller than theirs  {}\n",
             options.discs, o.overlap_sum.size(), o.radius_column, ground_text(o), o.pairs.size(),
             discs, overlaps, beyond) +
         covered_table(o) + most_covered(o);
}

}  // namespace

int overlap(const OverlapOptions& options) {
  catch_interrupts();
  const Overlaps overlaps = find_overlaps(options);
  clear_progress();
  if (options.json)
    write_json(overlaps, options);
  else
    print(table(overlaps, options));
  return 0;
}

}  // namespace phytobench::cli
