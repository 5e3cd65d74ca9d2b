/* SPDX-License-Identifier: MIT */
/* A nearest-node engine from outside: what a shared library offers so that phytobench can prove it
 * exact and race it. This file is all it needs; it is C99 and C++.
 *
 * The library exports one function, phytobench_engine(), which returns its table of functions.
 *
 * The task. Attraction points are given once. Nodes are only added and never move; points are only
 * removed. After every addition each live point wants the nearest of all nodes so far that
 * perceives it. A node perceives a point if
 *   - their squared distance is at most setup->squared_reach, and
 *   - setup->perceives_all_around is 1, or the point lies within the perception angle around the
 *     node's direction: dot(direction, point - node) >= setup->cosine * sqrt(squared distance).
 * Of nodes equally near the one with the lowest index wins. Nodes are numbered from 0 in the order
 * in which associate() got them.
 *
 * Exactly means to the last bit, because a tie that is decided by rounding grows another tree:
 *   - every distance and every perception test is rounded as phytobench_squared_distance() and
 *     phytobench_perceives() round it, that is in that order of operations, in double precision,
 *     without fused multiply-add (see "How to compile");
 *   - compare squared distances, not roots: two different squares can have the same root;
 *   - an index may reject nodes by other sums only if it leaves room for their rounding.
 * All coordinates are finite and so small that no squared distance overflows. The influence
 * distance may be infinite. Directions have unit length, but for rounding.
 *
 * Points may coincide with each other and with nodes; at distance 0 a node perceives a point.
 *
 * Order of calls: create(), then associate() and remove() (or removed()) in any order and any
 * number, then destroy(). A removal may come before the first associate(), and its killers may be
 * nodes that associate() gets only later. There may be no points, no new nodes and no killers.
 * After a call that reported a failure only last_error(), from the same thread, and destroy()
 * follow. Several engines may live at once, with calls of one between calls of another, but never
 * at the same time: nothing of an engine may be kept in global variables.
 *
 * Threads: calls for one engine need not come from the same thread. An engine may use up to
 * setup->threads threads, itself included, within a call; none of them may still work when the call
 * returns, though idle ones of a pool may wait. Answers are the same for any number.
 *
 * Memory: arrays belong to whoever passed them. `points` stays alive and unchanged from create() on
 * until destroy() is called, and need not be copied; destroy() itself must not read it, because it
 * may be gone by then. Whoever starts an engine afresh (reset() in phytobench's own sources) gets
 * destroy() first and then create() with the new points. Every other array and struct lives only
 * until the call returns. An array of no elements may be null. What the library allocates it frees,
 * at the latest in destroy(): that is measured.
 *
 * No function may end the program, let a C++ exception out, write to standard output, or leave the
 * floating-point environment, the locale, signal handlers, open files or the working folder other
 * than it found them. The floating-point environment is looked at after every call, and after the
 * library was loaded: rounding, masks, flush-to-zero, denormals-are-zero.
 *
 * How to compile. Machines with fused multiply-add (any with -march=native today, and 64-bit ARM
 * always) round otherwise where a compiler contracts a * b + c to it:
 *   - gcc contracts unless it is told -ffp-contract=off (or, in C, a standard such as -std=c99); it
 *     knows no #pragma STDC FP_CONTRACT;
 *   - clang contracts within an expression unless it is told -ffp-contract=off; it also obeys
 *     #pragma STDC FP_CONTRACT OFF, which must then stand before this header is included, because
 *     the functions below are compiled with the plugin.
 * Neither may get -ffast-math or -Ofast, not even where it only links: that links code which
 * changes the floating-point environment of whoever loads the library. With CMake,
 * find_package(phytobench COMPONENTS plugin) has the target phytobench::plugin, which brings this
 * header and the flag. */
#ifndef PHYTOBENCH_ENGINE_H
#define PHYTOBENCH_ENGINE_H

#include <float.h>
#include <math.h>
#include <stdint.h>

#ifdef __FAST_MATH__
#error "-ffast-math changes the last bit of distances; compile the engine without it"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD == 2
#error "long double arithmetic changes the last bit of distances; compile with -msse2 -mfpmath=sse"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface. Within a version functions are only added, at the end of the table. */
#define PHYTOBENCH_ENGINE_ABI 1

/* The answer for a point that no node perceives. */
#define PHYTOBENCH_NO_NODE (-1)

#if defined(_WIN32)
#define PHYTOBENCH_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define PHYTOBENCH_EXPORT __attribute__((visibility("default")))
#else
#define PHYTOBENCH_EXPORT
#endif

/* A point or vector; y points up. */
typedef struct phytobench_vector {
  double x, y, z;
} phytobench_vector;

typedef struct phytobench_node {
  phytobench_vector position;
  phytobench_vector direction; /* unit length */
} phytobench_node;

/* What holds for all calls. Copy it in create() if it is needed later. */
typedef struct phytobench_setup {
  double influence_distance;        /* >= 1e-100, in the unit of the points; may be infinite */
  double squared_reach;             /* influence_distance * influence_distance */
  double perception_half_angle_rad; /* (0, pi] */
  double cosine;                    /* of that angle, to be compared with exactly */
  int32_t perceives_all_around;     /* 1: the angle is pi, and is not tested at all */
  int32_t threads;                  /* an engine may use, at least 1 */
  int32_t associations;             /* how many associate() will follow at most; 0: not known */
  int32_t reserved;                 /* 0 */
} phytobench_setup;

/* The table of functions. Those marked "optional" may be null. `size` says how much of it there
 * is: a newer phytobench takes what is missing at the end of an older plugin's table for null, and
 * an older one does not look at what a newer plugin's holds beyond what it knows. It must reach to
 * destroy() at least. */
typedef struct phytobench_engine_v1 {
  uint32_t abi;        /* PHYTOBENCH_ENGINE_ABI */
  uint32_t size;       /* sizeof(phytobench_engine_v1), in bytes */
  const char* name;    /* [a-z0-9_]{1,64}, unlike that of any engine of phytobench */
  const char* summary; /* one sentence: how it finds the nearest node */

  /* A new engine for `count` points, numbered from 0; null if that fails. */
  void* (*create)(const phytobench_vector* points, int32_t count, const phytobench_setup* setup);

  /* Adds `count` nodes (maybe none) and answers for every live point. `nearest` has an entry for
   * every point, which holds what the engine wrote there last, and -1 before that: an engine may
   * write only what has changed. Each entry of a live point must be PHYTOBENCH_NO_NODE or the index
   * of a node so far; those of removed points are ignored. Returns 0, or anything else if it
   * fails. */
  int32_t (*associate)(void* engine, const phytobench_node* new_nodes, int32_t count,
                       int32_t* nearest);

  /* Optional. Removes every live point whose squared distance to one of `count` killers is at most
   * kill_distance * kill_distance, whatever the perception angle. Writes these points to `removed`,
   * each once, in any order; there is room for every live point. Returns how many they are, or a
   * negative number if it fails. If null, phytobench finds them. */
  int32_t (*remove)(void* engine, const phytobench_node* killers, int32_t count,
                    double kill_distance, int32_t* removed, int32_t capacity);

  /* Optional, and called only if remove() is null: phytobench has removed these `count` points,
   * ascending. An engine that does not want to know answers for them in vain. */
  void (*removed)(void* engine, const int32_t* points, int32_t count);

  /* Ends the engine and frees all it holds. Never called with null. */
  void (*destroy)(void* engine);

  /* Optional. Why the last call failed, in one line; `engine` is null after create() failed. Must
   * stay valid until the next call. */
  const char* (*last_error)(void* engine);
} phytobench_engine_v1;

/* What the library exports. The table must stay as it is while the library is loaded. */
PHYTOBENCH_EXPORT const phytobench_engine_v1* phytobench_engine(void);

/* The squared distance as everyone rounds it: (dx*dx + dy*dy) + dz*dz. Its arguments may be
 * swapped. */
static inline double phytobench_squared_distance(const phytobench_vector* a,
                                                 const phytobench_vector* b) {
  const double dx = a->x - b->x, dy = a->y - b->y, dz = a->z - b->z;
  return dx * dx + dy * dy + dz * dz;
}

/* Whether a node perceives a point at that squared distance. */
static inline int phytobench_perceives(const phytobench_setup* setup, const phytobench_node* node,
                                       const phytobench_vector* point, double squared_distance) {
  if (!(squared_distance <= setup->squared_reach)) return 0;
  if (setup->perceives_all_around) return 1;
  return node->direction.x * (point->x - node->position.x) +
             node->direction.y * (point->y - node->position.y) +
             node->direction.z * (point->z - node->position.z) >=
         setup->cosine * sqrt(squared_distance);
}

#ifdef __cplusplus
}
#endif

#endif
