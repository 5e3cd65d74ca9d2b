// SPDX-License-Identifier: MIT
// Where code from outside is at the moment, readable from another process: it may crash or never
// come back.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

namespace phytobench {

/// The functions of a plugin (phytobench_engine.h).
enum class PluginCall : std::int32_t {
  none,
  load,  ///< its own initialisers, and phytobench_engine()
  create,
  associate,
  remove,
  removed,
  destroy,
  last_error,
};

/// "associate() in iteration 3", "removed() in removal 2", "create()".
std::string described(PluginCall call, std::int32_t number);

/// Lies in memory that two processes share. Written by the one that calls plugins.
struct PluginPulse {
  std::atomic<std::uint64_t> beats{0};             ///< one more with each call and each return
  std::atomic<std::int32_t> plugin{0};             ///< which of several
  std::atomic<std::int32_t> number{0};             ///< of the association or removal, from 0
  std::atomic<PluginCall> call{PluginCall::none};  ///< the latest
  std::atomic<bool> is_inside{false};              ///< has not returned from it

  static_assert(std::atomic<std::uint64_t>::is_always_lock_free &&
                std::atomic<PluginCall>::is_always_lock_free);
};

/// Which pulse a plugin's calls are noted in, and as what. Without a pulse nothing is noted.
struct PluginWatch {
  PluginPulse* pulse = nullptr;
  std::int32_t plugin = 0;
};

/// Notes a call for as long as it lives.
class WatchedCall {
 public:
  WatchedCall(const PluginWatch& watch, PluginCall call, std::int32_t number)
      : pulse_(watch.pulse) {
    if (pulse_ == nullptr) return;
    pulse_->plugin = watch.plugin;
    pulse_->number = number;
    pulse_->call = call;
    pulse_->is_inside = true;
    ++pulse_->beats;
  }
  ~WatchedCall() {
    if (pulse_ == nullptr) return;
    pulse_->is_inside = false;
    ++pulse_->beats;
  }
  WatchedCall(const WatchedCall&) = delete;
  WatchedCall& operator=(const WatchedCall&) = delete;

 private:
  PluginPulse* pulse_;
};

}  // namespace phytobench
