// SPDX-License-Identifier: MIT
// An engine from outside: a shared library that phytobench_engine.h describes. It runs in this
// process and can do anything to it, so it should have passed try_plugin() before.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/nearest_node/engine.hpp"
#include "core/nearest_node/plugin/plugin_pulse.hpp"

struct phytobench_engine_v1;

namespace phytobench {

/// A plugin gave an answer that cannot be or is not right, reported a failure, or changed the
/// floating-point environment. The message says where and what, in one line.
class PluginMisbehaved : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a plugin says, as one line of at most 200 printable ASCII characters.
std::string plain_line(const char* text);

/// A loaded library. Its engines must not outlive it.
class EnginePlugin {
 public:
  /// Throws InputError that names the file and says what to do if it is no library, was built for
  /// another version of the interface, lacks a function, has no name of its own, or changes the
  /// floating-point environment by being loaded. A table that ends after destroy() is as good as
  /// one that holds more than this version knows.
  explicit EnginePlugin(const std::filesystem::path& file, const PluginWatch& watch = {});

  EnginePlugin(const EnginePlugin&) = delete;
  EnginePlugin& operator=(const EnginePlugin&) = delete;

  /// As any other engine's. Its engines throw PluginMisbehaved. Lives as long as the plugin.
  const EngineDescriptor& descriptor() const { return descriptor_; }

  const std::string& file() const { return file_; }  ///< as it was given
  const phytobench_engine_v1& table() const { return *table_; }
  const PluginWatch& watch() const { return watch_; }

 private:
  struct Close {
    void operator()(void* library) const;
  };

  std::string file_;
  PluginWatch watch_;
  std::unique_ptr<void, Close> library_;
  std::shared_ptr<const phytobench_engine_v1> table_;  // a copy: the plugin's own may be shorter
  std::string name_;
  std::string summary_;
  std::string source_;
  EngineDescriptor descriptor_;
};

}  // namespace phytobench
