// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/worker_client.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "benchmarks/comparison/processor_split.hpp"
#include "benchmarks/comparison/side_fixture.hpp"
#include "benchmarks/comparison/worker_deaths.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

/// A worker that is a shell script: it prints files, or fails in some way.
class WorkerClients : public SideFolder {
 protected:
  WorkerClient client(const std::string& script, const WorkerClientOptions& options = {}) const {
    return WorkerClient(
        {.origin = {.given = "new"},
         .worker = write_script("phytobench_worker", "cd \"$(dirname \"$0\")\"\n" + script),
         .worker_options = {"--handicap", "0.1"}},
        options);
  }

  /// One that answers every call with this text.
  WorkerClient answering(const std::string& text) const {
    write("answer", text);
    return client("echo \"$@\" > arguments; cat > input; cat answer");
  }

  std::string arguments() const { return read_text_file(folder_ / "arguments"); }
};

const std::vector<VerifiedBenchmark> both = {
    {.name = "a", .inputs = "1", .answer = "2", .work = {{"steps", 7}}},
    {.name = "b", .inputs = "3", .answer = "4", .objection = "wrong"}};

TEST_F(WorkerClients, PassOnWhatTheWorkerIsAndHas) {
  WorkerClient asked = answering(to_json(WorkerDescription{
      .compiler = "GNU", .flags = "-O3", .benchmarks = {{.name = "a"}, {.name = "b"}}}));
  EXPECT_EQ(asked.describe().compiler, "GNU");
  EXPECT_EQ(asked.names(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(arguments(), "list --handicap 0.1\n");
}

TEST_F(WorkerClients, VerifyAndCountInTheOrderAskedFor) {
  WorkerClient asked = answering(to_json(both));
  const auto verified = asked.verify({"b", "a"});
  EXPECT_EQ(arguments(), "verify --handicap 0.1 b a\n");
  ASSERT_EQ(verified.size(), 2u);
  EXPECT_EQ(verified[0].name, "b");
  EXPECT_EQ(verified[0].objection, "wrong");
  EXPECT_EQ(verified[1].answer, "2");
  EXPECT_EQ(asked.counters({"a", "b"})[0].work.at("steps"), 7u);
  EXPECT_EQ(arguments(), "counters --handicap 0.1 a b\n");
}

TEST_F(WorkerClients, RefuseAnswersForOtherBenchmarks) {
  WorkerClient asked = answering(to_json(both));
  EXPECT_THAT(message_of<InputError>([&] {
                asked.verify({"a", "c"});
              }),
              HasSubstr("new: did not answer for 'c'"));
  EXPECT_THAT(message_of<InputError>([&] { asked.verify({"b"}); }),
              HasSubstr("new: answered for 'a' unasked"));
  EXPECT_THAT(message_of<InputError>([&] {
                asked.verify({"a", "b", "b"});
              }),
              HasSubstr("did not answer for 'b'"));
}

TEST_F(WorkerClients, RefuseAnswersThatCannotBeRead) {
  for (const std::string& text :
       {std::string("{}"), std::string("\0", 1), to_json(std::vector<CalibratedBenchmark>{})})
    EXPECT_THAT(message_of<InputError>([&] { answering(text).verify({"a"}); }),
                testing::StartsWith("new: "));
}

TEST_F(WorkerClients, Calibrate) {
  WorkerClient asked =
      answering(to_json(std::vector<CalibratedBenchmark>{{.name = "a", .iterations = 9}}));
  EXPECT_EQ(asked.calibrate({"a"}, 12.5).front().iterations, 9u);
  EXPECT_EQ(arguments(), "calibrate --handicap 0.1 --sample-ms 12.5 a\n");
}

TEST_F(WorkerClients, SampleWhatIsPlanned) {
  const SamplePlan plan{.seed = 5, .samples = 3, .benchmarks = {{.name = "a", .iterations = 2}}};
  WorkerClient asked = answering(to_json(
      std::vector<SampledBenchmark>{{.name = "a", .samples = {{.iterations = 2, .cpu_s = 0.5}}}}));
  EXPECT_EQ(asked.sample(plan).front().samples.front().cpu_s, 0.5);
  EXPECT_EQ(arguments(), "sample --handicap 0.1\n");
  EXPECT_EQ(read_text_file(folder_ / "input"), to_json(plan));
  EXPECT_TRUE(asked.sample({}).empty());
}

TEST_F(WorkerClients, PassOnWhatTheWorkerObjectsTo) {
  const std::string says = "echo 'phytobench_worker: no such thing' >&2; exit ";
  EXPECT_EQ(message_of<InputError>([&] { client(says + "2").describe(); }), "new: no such thing");
  EXPECT_EQ(message_of<NothingSelected>([&] { client(says + "4").describe(); }),
            "new: no such thing");
  EXPECT_EQ(message_of<EnvironmentError>([&] { client(says + "3").describe(); }),
            "new: its worker, asked to list, ended with exit code 3: no such thing");
  EXPECT_EQ(message_of<EnvironmentError>([&] { client("exit 1").describe(); }),
            "new: its worker, asked to list, ended with exit code 1");
  EXPECT_THAT(message_of<EnvironmentError>([&] { client("kill -ABRT $$").describe(); }),
              HasSubstr("new: its worker, asked to list, was killed by signal 6"));
}

/// Crashes where the benchmark b takes part.
constexpr const char* crashes_on_b = R"sh(
cat > input
echo "$@" >> calls
case "$* $(cat input)" in *' b'*|*'"b"'*) kill -SEGV $$;; esac
cat answer
)sh";

TEST_F(WorkerClients, FindOutWhichBenchmarkKillsTheWorker) {
  write("answer", to_json(std::vector<VerifiedBenchmark>{{.name = "a", .answer = "2"}}));
  const auto verified = client(crashes_on_b).verify({"a", "b"});
  ASSERT_EQ(verified.size(), 2u);
  EXPECT_EQ(verified[0].answer, "2");
  EXPECT_EQ(verified[0].objection, "");
  EXPECT_EQ(verified[1].name, "b");
  EXPECT_THAT(verified[1].objection, HasSubstr("its worker was killed by signal 11"));
  EXPECT_THAT(read_text_file(folder_ / "calls"), HasSubstr("0.1 a b\nverify"));
}

/// The death that an action ends with; no reason if it does not.
template <class Action>
WorkerDeath death_of(const Action& action) {
  return death_in(action).value_or(WorkerDeath{});
}

SamplePlan plan_of(const std::vector<std::string>& names) {
  SamplePlan plan{.samples = 1, .benchmarks = {}};
  for (const std::string& name : names)
    plan.benchmarks.push_back({.name = name, .iterations = 1, .answer = {}});
  return plan;
}

TEST_F(WorkerClients, NeverTimeInFurtherProcessesWhatWasAskedForInOne) {
  write("answer",
        to_json(std::vector<SampledBenchmark>{{.name = "a", .samples = {TimedSample{}}}}));
  WorkerClient asked = client(crashes_on_b);
  EXPECT_THAT(death_of([&] {
                asked.sample(plan_of({"a", "b"}));
              }).reason,
              HasSubstr("its worker was killed by signal 11"));
  const auto calibrate_both = [&] { asked.calibrate({"a", "b"}, 10.0); };
  EXPECT_THAT(death_of(calibrate_both).reason, HasSubstr("its worker was killed by signal 11"));
  const std::string calls = read_text_file(folder_ / "calls");
  EXPECT_EQ(std::count(calls.begin(), calls.end(), '\n'), 2) << calls;
  EXPECT_EQ(asked.sample(plan_of({"a"})).front().samples.size(), 1u);
}

/// Ends where the benchmark b takes part, as a plugin can end the program that loads it.
std::string ends_on_b(const std::string& how) {
  return "cat > input\ncase \"$* $(cat input)\" in *' b'*|*'\"b\"'*) " + how +
         ";; esac\ncat answer";
}

TEST_F(WorkerClients, TakeAnUnexpectedEndForAVerdictOnTheBenchmarkAlone) {
  const std::map<std::string, std::string> endings = {
      {"exit 0", "its worker ended with exit code 0 without an answer"},
      {"exit 1", "its worker ended with exit code 1"},
      {"echo 'out of ideas' >&2; exit 2", "its worker ended with exit code 2: out of ideas"},
      {"echo 'phytobench_worker: disk full' >&2; exit 3",
       "its worker ended with exit code 3: disk full"},
      {"exit 4", "its worker ended with exit code 4"}};
  for (const auto& [how, reason] : endings) {
    write("answer", to_json(std::vector<VerifiedBenchmark>{{.name = "a", .answer = "2"}}));
    WorkerClient asked = client(ends_on_b(how));
    const auto verified = asked.verify({"a", "b"});
    ASSERT_EQ(verified.size(), 2u) << how;
    EXPECT_EQ(verified[0].answer, "2") << how;
    EXPECT_EQ(verified[0].objection, "") << how;
    EXPECT_EQ(verified[1].objection, reason);
    EXPECT_EQ(death_of([&] { asked.sample(plan_of({"b"})); }).reason, reason);
    EXPECT_EQ(death_of([&] { asked.calibrate({"b"}, 1.0); }).reason, reason);
  }
}

TEST_F(WorkerClients, StopAnAnswerAtItsOwnLimit) {
  WorkerClient hanging = client("exec sleep 60", {.sample_ms = 1.0, .answer_limit_s = 0.1});
  EXPECT_EQ(hanging.verify({"a"}).front().objection, "its worker took longer than 0.3 s");
  const WorkerDeath death = death_of([&] { hanging.sample(plan_of({"a"})); });
  EXPECT_EQ(death.reason, "its worker took longer than 0.21 s");
  EXPECT_TRUE(death.was_stopped);
}

TEST_F(WorkerClients, StopAWorkerThatHangs) {
  WorkerClient hanging =
      client("exec sleep 60", {.sample_ms = 1.0, .verify_limit_s = 0.1, .sample_limit_s = 0.1});
  EXPECT_EQ(hanging.verify({"a"}).front().objection, "its worker took longer than 0.1 s");
  const WorkerDeath death = death_of([&] { hanging.sample(plan_of({"a"})); });
  EXPECT_THAT(death.reason, HasSubstr("took longer than 0.11 s"));
  EXPECT_TRUE(death.was_stopped);
  EXPECT_THROW(hanging.calibrate({"a"}, 10.0), EnvironmentError);
  EXPECT_THROW(hanging.describe(), EnvironmentError);
}

TEST_F(WorkerClients, CanBeInterrupted) {
  WorkerClient hanging = client("exec sleep 60", {.is_interrupted = [] { return true; }});
  EXPECT_THROW(hanging.verify({"a"}), Interrupted);
}

TEST_F(WorkerClients, KeepTheWorkerOnItsProcessorWhileItIsTimed) {
  const std::vector<int> allowed = allowed_processors();
  ASSERT_FALSE(allowed.empty());
  write("answer", to_json(std::vector<CalibratedBenchmark>{{.name = "a"}}));
  client("grep Cpus_allowed_list /proc/self/status > where; cat answer",
         {.processor = allowed.back()})
      .calibrate({"a"}, 10.0);
  EXPECT_EQ(last_line(read_text_file(folder_ / "where")),
            "Cpus_allowed_list: " + std::to_string(allowed.back()));
}

std::size_t bytes_of(const ChildOptions& call) {
  std::size_t bytes = call.command.front().size() + 1;
  for (const std::string& word : call.command) bytes += word.size() + 1;
  for (const auto& [name, value] : call.environment)
    bytes += (name + "=" + value.value_or("")).size() + 1;
  return bytes;
}

TEST(WorkerCalls, TakeEquallyMuchOfTheStack) {
  const Side near{.worker = "/a/phytobench_worker"},
      far{.worker = "/a/very/much/longer/path/to/phytobench_worker", .data_folder = "/data"};
  for (const std::vector<std::string>& names : std::vector<std::vector<std::string>>{{}, {"a"}}) {
    const ChildOptions a = worker_call(near, "verify", names),
                       b = worker_call(far, "verify", names);
    EXPECT_EQ(bytes_of(a), bytes_of(b));
    EXPECT_EQ(a.environment.size(), b.environment.size());
  }
}

TEST(WorkerCalls, DoNotPassOnTheUsersEnvironment) {
  ::setenv("PHYTOBENCH_DATA", "/elsewhere", 1);
  const ChildOptions call = worker_call({.worker = "/a/phytobench_worker"}, "list", {});
  EXPECT_EQ(call.inherited, InheritedEnvironment::nothing);
  for (const auto& [name, value] : call.environment)
    if (name == "PHYTOBENCH_DATA") EXPECT_EQ(value, "");
  ::unsetenv("PHYTOBENCH_DATA");
}

}  // namespace
}  // namespace phytobench
