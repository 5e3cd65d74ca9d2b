// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/worker_client.hpp"

#include <cstdlib>

#include "benchmarks/comparison/processor_split.hpp"
#include "benchmarks/comparison/side_fixture.hpp"

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
  for (const std::string& text : {std::string(), std::string("{}"), std::string("\0", 1),
                                  to_json(std::vector<CalibratedBenchmark>{})})
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
  EXPECT_EQ(message_of<EnvironmentError>([&] { client(says + "3").verify({"a"}); }),
            "new: its worker, asked to verify, ended with exit code 3: no such thing");
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

TEST_F(WorkerClients, FindOutWhichBenchmarkKillsTheWorkerWhileItIsTimed) {
  write("answer",
        to_json(std::vector<SampledBenchmark>{{.name = "a", .samples = {TimedSample{}}}}));
  const auto sampled =
      client(crashes_on_b)
          .sample({.benchmarks = {{.name = "a", .iterations = 1}, {.name = "b", .iterations = 1}}});
  ASSERT_EQ(sampled.size(), 2u);
  EXPECT_EQ(sampled[0].objection, "");
  EXPECT_EQ(sampled[0].samples.size(), 1u);
  EXPECT_THAT(sampled[1].objection, HasSubstr("its worker was killed by signal 11"));
  EXPECT_THAT(message_of<EnvironmentError>([&] { client(crashes_on_b).calibrate({"b"}, 10.0); }),
              HasSubstr("while 'b' was calibrated"));
}

TEST_F(WorkerClients, StopAWorkerThatHangs) {
  WorkerClient hanging =
      client("exec sleep 60", {.sample_ms = 1.0, .verify_limit_s = 0.1, .sample_limit_s = 0.1});
  EXPECT_EQ(hanging.verify({"a"}).front().objection, "its worker took longer than 0.1 s");
  const SamplePlan plan{.samples = 1, .benchmarks = {{.name = "a", .iterations = 1}}};
  EXPECT_THAT(hanging.sample(plan).front().objection, HasSubstr("took longer than 0.11 s"));
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
