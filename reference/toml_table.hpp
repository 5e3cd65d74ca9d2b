// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace phytobench {

/// A TOML table of a paper file with checked access: a missing or wrong entry is an InputError that
/// names file, line and key. Hides the TOML library.
class TomlTable {
 public:
  static TomlTable read(const std::filesystem::path& file);

  std::string text(const std::string& key) const;
  std::string text_or(const std::string& key, const std::string& fallback) const;
  double number(const std::string& key) const;
  std::optional<double> number_if_given(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;
  std::vector<double> numbers(const std::string& key) const;
  std::vector<std::vector<std::string>> text_lists(const std::string& key) const;
  std::vector<std::vector<double>> number_lists(const std::string& key) const;
  TomlTable table(const std::string& key) const;
  std::vector<TomlTable> tables(const std::string& key) const;  ///< [[key]]; empty if absent

  bool has(const std::string& key) const;
  std::vector<std::string> keys() const;  ///< in file order

  /// Throws InputError at this table's line.
  [[noreturn]] void fail(const std::string& problem) const;

  /// Throws InputError if a key is none of these: a misspelt key must not be ignored.
  void allow_only(const std::vector<std::string>& known) const;

 private:
  struct Node;
  explicit TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

}  // namespace phytobench
