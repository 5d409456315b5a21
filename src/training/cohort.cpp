#include "training/cohort.h"

#include <algorithm>
#include <fstream>
#include <mutex>
#include <sstream>

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "core/parallel_for.h"
#include "core/random.h"
#include "training/cusum.h"
#include "training/metric_groups.h"
#include "training/plan_progress.h"
#include "training/planning_rules.h"
#include "training/score.h"
#include "training/score_json.h"
#include "training/simulated_attempt.h"
#include "training/simulated_probe.h"
#include "training/surface_voxels.h"
#include "training/trainee.h"

namespace bodkin::training {

namespace {

// Whether a rule is about the slice of an ultrasound machine.
bool asks_for_probe(const Procedure& procedure) {
  const std::vector<Metric> of_the_slice = metrics_of_ultrasound();
  return std::any_of(procedure.rules.begin(), procedure.rules.end(), [&](const Rule& rule) {
    return std::any_of(of_the_slice.begin(), of_the_slice.end(),
                       [&](const Metric& metric) { return metric.name == rule.metric; });
  });
}

namespace fs = std::filesystem;

constexpr std::string_view end_of_trainee = "# end of trainee ";

// The rows of one trainee, each with its line end.
using Block = std::string;

class Cohort {
 public:
  explicit Cohort(const CohortSettings& settings)
      : settings_(settings),
        partial_(partial_file(settings)),
        first_line_(fmt::format("# {}\n", settings.fingerprint)),
        blocks_(settings.trainees) {}

  CohortResult run(const Progress& progress) {
    for (const fs::path& file : partial_files()) {
      if (file != partial_) load(file);
    }
    const std::vector<std::uint64_t> own = load(partial_);
    // Rewritten, so that a truncated row is not continued.
    std::string known = first_line_;
    for (const std::uint64_t trainee : own) known += blocks_[trainee] + end_line(trainee);
    write_file(partial_, known);
    std::vector<std::uint64_t> missing;
    for (std::uint64_t trainee = 0; trainee < blocks_.size(); ++trainee) {
      const bool is_done = !blocks_[trainee].empty();
      result_.continued += is_done ? 1 : 0;
      if (!is_done && trainee % settings_.part.count == settings_.part.index) missing.push_back(trainee);
    }
    for (const CohortStage& stage : settings_.stages) {
      const anatomy::Case& patient = *stage.patient;
      surfaces_.push_back(surfaces_of({&patient.structures, &patient.tissues}, patient.description, patient.library,
                                      stage.procedure));
    }
    stream_.open(partial_, std::ios::binary | std::ios::app);
    parallel_for(
        missing.size(), "practising", progress, [&](std::size_t i) { finish(missing[i], practise(missing[i])); },
        settings_.threads);
    stream_.close();
    put_together();
    return std::move(result_);
  }

 private:
  static std::string end_line(std::uint64_t trainee) { return fmt::format("{}{}\n", end_of_trainee, trainee); }

  static fs::path partial_file(const CohortSettings& settings) {
    const CohortPart& part = settings.part;
    fs::path file = settings.output;
    file += part.count == 1 ? ".partial" : fmt::format(".partial-{}-of-{}", part.index + 1, part.count);
    return file;
  }

  // Of this cohort, by any part. One that another part removes meanwhile is omitted.
  std::vector<fs::path> partial_files() const {
    const fs::path folder = settings_.output.has_parent_path() ? settings_.output.parent_path() : fs::path(".");
    const std::string beginning = settings_.output.filename().string() + ".partial";
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(beginning) && !name.ends_with(".part"))
        files.push_back(settings_.output.parent_path() / name);
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  // Writes the table when every trainee is done; otherwise another part will.
  void put_together() {
    const std::vector<fs::path> files = partial_files();
    for (const fs::path& file : files) load(file);
    result_.is_whole = std::none_of(blocks_.begin(), blocks_.end(), [](const Block& block) { return block.empty(); });
    if (!result_.is_whole) return;
    std::string table = "trainee,stage,attempt,skill," + score_csv_columns() + "\n";
    for (const Block& block : blocks_) table += block;
    write_file(settings_.output, table);
    std::error_code ignored;
    for (const fs::path& file : files) fs::remove(file, ignored);
    summarise();
  }

  // Takes over the trainees that are complete in the file, and returns them.
  std::vector<std::uint64_t> load(const fs::path& file) {
    std::vector<std::uint64_t> found;
    std::ifstream stream(file, std::ios::binary);
    std::string line;
    if (!stream || !std::getline(stream, line)) return found;
    if (line + "\n" != first_line_) {
      throw InputError(fmt::format(
          "{} was begun with another plan, seed, patient or version; remove it, or give another name with --output",
          file.string()));
    }
    Block block;
    while (std::getline(stream, line)) {
      if (!line.starts_with(end_of_trainee)) {
        block += line + "\n";
        continue;
      }
      std::uint64_t trainee = blocks_.size();
      std::istringstream(line.substr(end_of_trainee.size())) >> trainee;
      if (trainee < blocks_.size() && !block.empty()) {
        blocks_[trainee] = block;
        found.push_back(trainee);
      }
      block.clear();
    }
    return found;
  }

  Block practise(std::uint64_t number) const {
    const Trainee trainee = draw_trainee(settings_.seed, number);
    Block rows;
    int done = 0;
    for (std::size_t stage = 0; stage < settings_.stages.size(); ++stage) {
      const CohortStage& here = settings_.stages[stage];
      std::vector<StageAttempt> attempts;
      StageProgress progress;
      for (int attempt = 1; attempt <= here.plan.attempts; ++attempt, ++done) {
        const double skill = settings_.performer ? 1.0 : trainee.skill_after(done);
        const simulation::OperatorScript script =
            settings_.performer ? *settings_.performer : operator_of_skill(settings_.novice, settings_.expert, skill);
        const std::uint64_t chance =
            mix64(settings_.seed) ^ mix64(number + 1) ^ mix64(0x5EED0000ULL + static_cast<std::uint64_t>(done));
        session::Session session = simulate_attempt(
            *here.patient, script, here.path, chance,
            {.ending = completing_id(here.procedure, here.patient->library), .whole_body = here.whole_body});
        if (asks_for_probe(here.procedure)) hold_probe(session, script, chance);
        const Score result = score(session, here.patient->description, here.procedure,
                                   {&here.patient->structures, &here.patient->tissues, &surfaces_[stage]});
        rows +=
            fmt::format("{},{},{},{},{}\n", number, stage + 1, attempt, number_text(skill), score_csv_fields(result));
        attempts.push_back({static_cast<int>(stage + 1), result.verdict, score_points(result)});
        progress = progress_in(here.plan, attempts);
        if (progress.is_passed) {
          ++done;
          break;
        }
      }
      if (here.plan.must_pass && !progress.is_passed) break;  // the trainee stays in this stage
    }
    return rows;
  }

  void finish(std::uint64_t trainee, Block rows) {
    const std::lock_guard guard(lock_);
    stream_ << rows << end_line(trainee) << std::flush;
    if (!stream_) throw SystemError(fmt::format("{} cannot be written; is the disk full?", partial_.string()));
    blocks_[trainee] = std::move(rows);
  }

  void summarise() {
    std::vector<int> passed, all;
    const Cusum cusum({});
    for (const Block& block : blocks_) {
      std::istringstream lines(block);
      std::vector<char> failed;
      for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        std::string verdict;
        for (int field = 0; field < 5; ++field) std::getline(fields, verdict, ',');
        ++result_.attempts;
        ++result_.verdicts[verdict];
        const std::size_t attempt = failed.size();
        failed.push_back(verdict == name_of(Grade::fail) || verdict == name_of(Grade::dangerous) ? 1 : 0);
        if (passed.size() <= attempt) {
          passed.push_back(0);
          all.push_back(0);
        }
        passed[attempt] += verdict == name_of(Grade::pass) ? 1 : 0;
        ++all[attempt];
      }
      const std::vector<Cusum::Point> curve = cusum.curve(failed);
      result_.mastered +=
          std::any_of(curve.begin(), curve.end(), [](const Cusum::Point& point) { return point.mastery; }) ? 1 : 0;
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      result_.passed_by_attempt.push_back(static_cast<double>(passed[i]) / all[i]);
  }

  const CohortSettings& settings_;
  fs::path partial_;
  std::string first_line_;
  std::vector<Block> blocks_;  // by trainee; empty: not done
  std::mutex lock_;            // guards stream_
  std::ofstream stream_;
  std::vector<PatientSurfaces> surfaces_;  // by stage
  CohortResult result_;
};

}  // namespace

CohortResult run_cohort(const CohortSettings& settings, const Progress& progress) {
  return Cohort(settings).run(progress);
}

}  // namespace bodkin::training
