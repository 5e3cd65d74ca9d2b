// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/build_inputs.hpp"

#include "benchmarks/comparison/side_fixture.hpp"
#include "benchmarks/comparison/variable_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

class BuildInputs : public SideFolder {
 protected:
  /// Sets CXX to a program that says so of itself.
  void identify_compiler(const std::string& text) {
    cxx_.set(write_script("a-compiler", "echo '" + text + "'; echo more").string());
  }

  Variable cxx_{"CXX"}, flags_{"CXXFLAGS"};
};

TEST_F(BuildInputs, AreTheCompilerAndTheVariablesThatBuildsRead) {
  identify_compiler("a compiler 1");
  flags_.set("-O1");
  const std::string before = build_inputs();
  EXPECT_THAT(before, testing::StartsWith("compiler: a compiler 1\nCXX: "));
  EXPECT_THAT(before, HasSubstr("\nCXXFLAGS: -O1\n"));
  EXPECT_EQ(build_inputs(), before);
  identify_compiler("a compiler 2");
  EXPECT_EQ(change_of_inputs(before, build_inputs()),
            "compiler was 'a compiler 1' and is 'a compiler 2'");
}

TEST_F(BuildInputs, MayHoldArgumentsOfTheCompilerOrNoCompiler) {
  identify_compiler("a compiler 1");
  const std::string program = (folder_ / "a-compiler").string();
  cxx_.set(program + " -m64");
  EXPECT_THAT(build_inputs(), testing::StartsWith("compiler: a compiler 1\n"));
  cxx_.set(program + "-not");
  EXPECT_THAT(build_inputs(), testing::StartsWith("compiler: \n"));
}

TEST(ChangeOfInputs, IsTheFirstOneOrThatNothingIsKnown) {
  EXPECT_EQ(change_of_inputs("A: 1\nB: 2\n", "A: 1\nB: 2\n"), "");
  EXPECT_EQ(change_of_inputs("A: 1\nB: 2\n", "A: 1\nB: \n"), "B was '2' and is ''");
  const std::string unknown = "nobody knows what it was built with";
  EXPECT_EQ(change_of_inputs("", "A: 1\n"), unknown);
  EXPECT_EQ(change_of_inputs("A: 1\n", "A: 1\nB: 2\n"), unknown);
  EXPECT_EQ(change_of_inputs("X: 1\n", "A: 1\n"), unknown);
}

}  // namespace
}  // namespace phytobench
