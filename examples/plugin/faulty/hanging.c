/* SPDX-License-Identifier: MIT */
/* Never returns from the first removal. */
#include "faulty.h"

static void hang(void* engine, const int32_t* points, int32_t count) {
  volatile int forever = 1;
  while (forever) removed(engine, points, count);
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("hanging");
  table.removed = hang;
  return &table;
}
