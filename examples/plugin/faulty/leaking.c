/* SPDX-License-Identifier: MIT */
/* Every answer is right, but destroy() frees nothing. */
#include "faulty.h"

static void forget(void* engine) {
  (void)engine;
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("leaking");
  table.destroy = forget;
  return &table;
}
