// SPDX-License-Identifier: MIT
// What a history keeps of a benchmark. Seconds are not among it: they belong to the machine's mood
// of that day, and nothing here can hold them.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <utility>

namespace phytobench {

/// A work counter, the instructions of a run under callgrind, or the time divided by that of a
/// reference kernel in the same run.
class HistoryQuantity {
 public:
  /// "counter:search_evaluations". Throws InputError where the name is not of letters, digits and
  /// "_-./".
  static HistoryQuantity counter(const std::string& name);
  static HistoryQuantity instructions() { return HistoryQuantity("instructions"); }
  static HistoryQuantity ratio() { return HistoryQuantity("ratio"); }

  /// From its text. Throws InputError naming the three kinds.
  static HistoryQuantity named(const std::string& text);

  const std::string& text() const { return text_; }
  bool is_counter() const { return text_.starts_with("counter:"); }
  bool is_ratio() const { return text_ == "ratio"; }

  friend auto operator<=>(const HistoryQuantity&, const HistoryQuantity&) = default;

 private:
  explicit HistoryQuantity(std::string text) : text_(std::move(text)) {}
  std::string text_;
};

class HistoryValue {
 public:
  /// Throws InputError for more than 2^63 - 1. The quantity is no ratio.
  static HistoryValue counted(const std::string& benchmark, const std::string& inputs,
                              const HistoryQuantity& quantity, std::uint64_t count);

  /// Throws InputError unless the ratio is positive and finite.
  static HistoryValue ratio(const std::string& benchmark, const std::string& inputs, double ratio);

  const std::string& benchmark() const { return benchmark_; }
  const std::string& inputs() const { return inputs_; }  ///< SHA-256; empty if unknown
  const HistoryQuantity& quantity() const { return quantity_; }
  std::int64_t count() const { return count_; }  ///< of what is counted

  /// The count or the ratio.
  double number() const { return quantity_.is_ratio() ? ratio_ : static_cast<double>(count_); }

  /// All digits of a count, six of a ratio.
  std::string text() const;

  friend bool operator==(const HistoryValue&, const HistoryValue&) = default;

 private:
  HistoryValue(std::string benchmark, std::string inputs, HistoryQuantity quantity)
      : benchmark_(std::move(benchmark)),
        inputs_(std::move(inputs)),
        quantity_(std::move(quantity)) {}

  std::string benchmark_;
  std::string inputs_;
  HistoryQuantity quantity_;
  std::int64_t count_ = 0;
  double ratio_ = 0.0;
};

}  // namespace phytobench
