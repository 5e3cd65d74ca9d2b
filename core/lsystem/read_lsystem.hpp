// SPDX-License-Identifier: MIT
// The text format of L-systems, one statement in each line:
//
//   # a comment: from a '#' at the start of a line, or after a blank, to the end of the line
//   alphabet: ar al br bl            letters of more than one character; longest match
//   lr = 1.3                         a constant, for expressions
//   axiom: A(1, lr)                  also omega or ω
//   p1 : A(x) < B(y) > A(z) : y < 4 -> B(x + z)[A(y)] : 0.4
//   steps: 8    angle: 22.5    step: 1    width: 1    width_factor: 0.7    seed: 1
//   ignore: + - /                    symbols that contexts do not see
//   draw: F G    move: f             letters that draw, and that only move
//   turtle: words                    or abop_matrices, cpfg, lpfg_uncorrected
//   start: upwards                   or local
//   colours: #6b4a2b #457d29
//
// Several settings of the form `key: value` may share a line; everything else has its own. A line
// that begins with a blank goes on with the one before. Lines end with \n, \r\n or \r; the text is
// UTF-8 of at most a megabyte. In `colours`, only a '#' with a blank after it begins a comment.
//
// Letters. Any printable ASCII character but ( ) , : < > = # * is a letter, and blanks between
// modules mean nothing. Queries are ?P ?H ?L ?U. Other letters are declared by `alphabet:`, or as
// in `V : {a, b}`; to leave out letters of one character there is no error. No production replaces
// brackets, and they have no parameters; [ ] and { } must match each, but may cross. An empty
// successor may be written * or ε.
//
// Productions. Everything but predecessor and successor may be missing; the arrow is ->, ::= or →,
// the first in the line. Before the arrow, `name : rest` is a label if the name is a word (letters,
// digits, _) without brackets and the rest is a predecessor with its contexts; else what follows
// the colon is the condition, and * is none. What could be either (`A : n > 2 -> B` with a constant
// n) is refused; all three parts are never in doubt. * is a missing context, too. Contexts name
// each symbol that they step over, except the ignored ones; the left one has no brackets.
//
// Of several productions that fit a module those with contexts come before those without, then the
// first in the text is taken, whether conditions overlap or not. A production that can never be
// used because one of the same contexts without condition stands before it is refused; others that
// are never used, as far as can be seen, are named by unused_productions(). --> is refused where
// the first - could only end a context or condition.
//
// Expressions. expression_parser.hpp has the operators; there are sin cos tan atan (degrees), sqrt
// abs floor ceil exp log min max, and in productions random() and random(low, high), at most 256
// calls. Names have an ASCII letter or _, then letters, digits and _; they are no letters of the
// alphabet, so that a constant may be called like one. A constant is known below its line and in
// everything that is no constant; a parameter hides a constant of its name. The axiom, settings and
// probabilities take expressions of constants. Names that stand for nothing are allowed as
// parameters of queries in successors (`?P(x, y)`), where the turtle fills them in; until then they
// are 0. What is never finite is refused.
//
// Values. angle: finite; step, width, width_factor: > 0; steps: 0 to 1000000; seed: 0 to 2^53;
// draw, move: letters of one character that mean nothing else to the turtle; each replaces the
// default, and takes its letters from the other one's default.
//
// Limits. 256 symbols, 65535 productions, 255 parameters of a module and 1000 of a production, 256
// declared letters of 32 bytes, expressions nested 64 deep.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// Throws InputError "name:line:column: what (what to do)" for everything that is not such a text:
/// brackets that do not match, an unknown name, a wrong number of arguments, a second production
/// for the same predecessor, contexts and condition, probabilities that do not add up to 1 within
/// 1e-9, more than 256 symbols. What concerns the whole text (no axiom) has no line.
LSystem parse_lsystem(std::string_view text, std::string_view name);

/// The same from a file; throws InputError if it cannot be read or is larger than a megabyte.
LSystem read_lsystem(const std::filesystem::path& file);

}  // namespace phytobench
