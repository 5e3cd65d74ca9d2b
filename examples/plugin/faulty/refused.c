/* SPDX-License-Identifier: MIT */
/* Libraries that must not be used as engines; a definition says what is wrong with the table. */
#include "faulty.h"

#ifdef NO_SYMBOL
PHYTOBENCH_EXPORT const phytobench_engine_v1* some_other_function(void) {
  static phytobench_engine_v1 table;
  table = table_named("no_symbol");
  return &table;
}
#else
PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void) {
  static phytobench_engine_v1 table;
  table = table_named("refused");
#if defined(NO_TABLE)
  return NULL;
#elif defined(WRONG_ABI)
  table.abi = PHYTOBENCH_ENGINE_ABI + 1;
#elif defined(SHORT_TABLE)
  table.size = 8;
#elif defined(BAD_NAME)
  table.name = "Nearest Scan";
#elif defined(TAKEN_NAME)
  table.name = "voxel_grid";
#elif defined(NO_SUMMARY)
  table.summary = NULL;
#elif defined(NO_ASSOCIATE)
  table.associate = NULL;
#endif
  return &table;
}
#endif
