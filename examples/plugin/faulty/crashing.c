/* SPDX-License-Identifier: MIT */
/* Dies in the third call of associate(). Raises the signal itself, so that no sanitizer can turn it
 * into something else. */
#include <signal.h>

#include "faulty.h"

static int32_t crash(void* engine, const phytobench_node* new_nodes, int32_t count,
                     int32_t* nearest) {
  static int calls = 0; /* of all engines together, so that only the first one gets that far */
  if (++calls == 3) raise(SIGSEGV);
  return associate(engine, new_nodes, count, nearest);
}

PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("crashing");
  table.associate = crash;
  return &table;
}
