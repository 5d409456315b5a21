#include "training/cohort.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "patient/prepared_body.h"
#include "session/case_digest.h"
#include "session/operator_file.h"
#include "session/session_run.h"
#include "session/session_schema.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "io/resources.h"
#include "training/procedure_file.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_trainees = 1'000'000;
constexpr std::int64_t most_threads = 1024;

struct CohortArguments {
  std::string plan;
  std::string output = "cohort.csv";
  std::string performer;
  std::int64_t trainees = 100;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  std::string part;
};

constexpr const char* cohort_footer = R"(Examples:
  bodkin cohort plan.xml --trainees 1000 --seed 7       simulated trainees who learn
  bodkin cohort plan.xml --operator expert -o experts.csv
                                                         a table of experts, for 'bodkin score --experts'

  mpirun -n 8 bodkin cohort plan.xml --trainees 100000  shared among processes, on one machine or many

The same plan, seed and patients give the same table for any number of threads and
processes. The same command continues an interrupted run. docs/cohorts.md explains plans, trainees and the table.)";

// "2/4" as the second of four parts. Throws InputError naming its origin `where`.
training::CohortPart part_of(const std::string& text, const std::string& where) {
  std::uint64_t number = 0, count = 0;
  char slash = '\0';
  std::istringstream stream(text);
  if (!(stream >> number >> slash >> count) || slash != '/' || !stream.eof() || number < 1 || number > count) {
    throw InputError(fmt::format(
        "{} is '{}'; expected the number of this process and the number of processes, such as 2/4", where, text));
  }
  return {number - 1, count};
}

// From --part, or from the launcher of this process: mpirun of Open MPI, or a launcher with PMI.
training::CohortPart part_of_this_process(const std::string& option) {
  if (!option.empty()) return part_of(option, "--part");
  struct Launcher {
    const char* rank;
    const char* size;
  };
  for (const Launcher& each :
       {Launcher{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, Launcher{"PMI_RANK", "PMI_SIZE"}}) {
    const char* const rank = std::getenv(each.rank);
    const char* const size = std::getenv(each.size);
    if (rank == nullptr || size == nullptr) continue;
    const std::uint64_t from_0 = std::strtoull(rank, nullptr, 10);
    return part_of(fmt::format("{}/{}", from_0 + 1, size), fmt::format("{}/{}", each.rank, each.size));
  }
  return {};
}

// The patients of a plan, each loaded once.
struct PlanPatient {
  anatomy::Case patient;
  std::shared_ptr<const fem::ContactBody> whole_body;  // null: rigid
};
using Patients = std::map<std::string, PlanPatient>;

training::CohortSettings cohort_settings(const CohortArguments& arguments, Patients& patients, Console& console) {
  training::CohortSettings settings;
  settings.trainees = static_cast<std::uint64_t>(arguments.trainees);
  settings.seed = static_cast<std::uint64_t>(arguments.seed);
  settings.part = part_of_this_process(arguments.part);
  // A launcher starts a process for each core.
  const bool is_launched = arguments.part.empty() && settings.part.count > 1;
  settings.threads = arguments.threads == 0 && is_launched ? 1 : static_cast<int>(arguments.threads);
  settings.output = arguments.output;
  settings.novice = session::load_operator("novice");
  settings.expert = session::load_operator("expert");
  if (!arguments.performer.empty()) settings.performer = session::load_operator(arguments.performer);
  const training::Plan plan = training::read_plan(arguments.plan);
  std::string all = fmt::format(
      "{} {} {} {}", BODKIN_VERSION, settings.trainees, settings.seed,
      session::operator_json(settings.performer.value_or(settings.expert)) + session::operator_json(settings.novice));
  for (const training::PlanStage& each : plan.stages) {
    training::CohortStage stage{.plan = each, .procedure = {}, .patient = nullptr, .path = {}};
    if (each.patient == training::built_in_patient) {
      throw InputError(fmt::format(
          "{}: stage '{}': the built-in patient exists only in the window; make a case with 'bodkin case synthesize'",
          arguments.plan, each.title));
    }
    const auto [place, is_new] = patients.try_emplace(each.patient);
    anatomy::Case& patient = place->second.patient;
    if (is_new) patient = io::load_case(each.patient, console.progress());
    if (!patient.description.procedure.path) {
      throw InputError(fmt::format("{}: stage '{}': the case {} has no planned path; plan one with 'bodkin case new'",
                                   arguments.plan, each.title, each.patient));
    }
    stage.path = *patient.description.procedure.path;
    if (is_new) {
      patient::prepare_body(
          patient, each.patient, stage.path, console.progress(), [&](const std::string& text) { console.note(text); },
          &place->second.whole_body);
    }
    stage.patient = &patient;
    stage.whole_body = place->second.whole_body;
    stage.procedure = each.procedure.empty() ? training::procedure_of_case(patient.description.procedure.name)
                                             : training::find_procedure(each.procedure);
    all += fmt::format(" {} {} {} {} {} {} {}{}", stage.procedure.name, each.attempts, each.passes, each.score_from,
                       each.mastery, each.must_pass,
                       io::read_text_file(fs::path(each.patient) / "case.xml", session::largest_case_xml),
                       session::mesh_digest(each.patient, patient.description.haptics.resistance));
    settings.stages.push_back(std::move(stage));
  }
  settings.fingerprint = session::text_checksum(all);
  return settings;
}

void print_cohort(const Console& console, const training::CohortResult& result, const CohortArguments& arguments) {
  console.line(fmt::format("{} attempts of {} trainees", result.attempts, arguments.trainees));
  for (const auto& [verdict, count] : result.verdicts)
    console.line(fmt::format("  {:<11} {:>7}  {:5.1f} %", verdict, count,
                             100.0 * count / static_cast<double>(result.attempts)));
  console.line("passed, by number of the attempt");
  for (std::size_t i = 0; i < result.passed_by_attempt.size(); ++i)
    console.line(fmt::format("  {:>4} {:6.1f} %", i + 1, 100.0 * result.passed_by_attempt[i]));
  if (arguments.performer.empty())
    console.line(fmt::format("mastery shown by {} of {} (CUSUM)", result.mastered, arguments.trainees));
  console.line(fs::absolute(arguments.output).lexically_normal().string());
}

void run_cohort_command(const CohortArguments& arguments, const CommandContext& context) {
  Console console(context);
  require_writable(arguments.output, "--output", arguments.plan);
  Patients patients;
  const training::CohortSettings settings = cohort_settings(arguments, patients, console);
  const training::CohortResult result = training::run_cohort(settings, console.progress());
  console.clear_bar();
  if (!result.is_whole) {
    console.note(fmt::format("part {} of {} is done; the part that ends last writes {}", settings.part.index + 1,
                             settings.part.count, arguments.output));
    return;
  }
  if (result.continued > 0) console.note(fmt::format("{} trainees were already done", result.continued));
  print_cohort(console, result, arguments);
  console.json(nlohmann::ordered_json{{"attempts", result.attempts},
                                      {"trainees", arguments.trainees},
                                      {"continued", result.continued},
                                      {"verdicts", result.verdicts},
                                      {"passed_by_attempt", result.passed_by_attempt},
                                      {"mastered", result.mastered},
                                      {"table", fs::absolute(arguments.output).lexically_normal().string()}}
                   .dump(2));
}

}  // namespace

void add_cohort_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "cohort", "Run simulated trainees through a plan, on all cores", cohort_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<CohortArguments>();
        add_text(command, "PLAN", arguments->plan, "File of the plan").required();
        add_whole_number(command, "--trainees", arguments->trainees, 1, most_trainees, "How many, 1 to 1000000");
        add_whole_number(command, "--seed", arguments->seed, 0, std::numeric_limits<std::int64_t>::max(),
                         "Seed of the random numbers");
        add_text(
            command, "--operator", arguments->performer,
            "expert, novice, expert_epidural, expert_lumbar_puncture, expert_to_target, expert_acupuncture or an "
            "operator file: performs in "
            "place of trainees who learn");
        add_text(command, "-o,--output", arguments->output, "The table (default: cohort.csv); it is replaced");
        add_whole_number(command, "--threads", arguments->threads, 0, most_threads,
                         "0: as many as the machine has cores");
        add_text(command, "--part", arguments->part,
                 "2/4: this process is the second of four (default: as mpirun says; the output's folder is common to "
                 "all)");
        on_run(command, [arguments, &context] { run_cohort_command(*arguments, context); });
      });
}

}  // namespace bodkin::cli
