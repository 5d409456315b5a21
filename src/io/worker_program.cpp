#include "io/worker_program.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace bodkin::io {
namespace {

using nlohmann::json;

void parse_message(std::string_view line, WorkerOutput& output, const Progress& progress) {
  const json message = json::parse(line, nullptr, false);
  if (!message.is_object()) return;  // a library that talks to standard output
  if (message.contains("progress") && progress) {
    progress(message.value("progress", ""), std::clamp(message.value("fraction", 0.0), 0.0, 1.0));
  }
  if (message.contains("note")) output.notes.push_back(message.value("note", ""));
  if (message.contains("error")) {
    output.error = message.value("error", "");
    output.kind = message.value("kind", "input");
  }
  if (message.contains("result")) output.result = message["result"].dump();
}

}  // namespace

std::filesystem::path find_worker(const WorkerProgram& program) {
  if (const char* named = std::getenv(program.variable.c_str())) return named;
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path next_to_program = self.parent_path() / program.name;
  const std::filesystem::path installed = std::filesystem::path(BODKIN_INSTALLED_LIBEXEC) / program.name;
  const std::filesystem::path relocated = self.parent_path().parent_path() / "libexec" / "bodkin" / program.name;
  for (const std::filesystem::path& place : {next_to_program, relocated, installed}) {
    if (std::filesystem::exists(place, error)) return place;
  }
  throw SystemError(fmt::format(
      "{} is missing: it is neither next to the program ({}) nor in {}; build Bodkin with {}=ON or name it "
      "in {}",
      program.name, next_to_program.string(), installed.string(), program.option, program.variable));
}

WorkerOutput run_worker(const WorkerProgram& program, const std::string& verb, const std::string& arguments,
                        int inherited, const ChildLimits& limits, const Progress& progress) {
  WorkerOutput output;
  output.child = run_child(find_worker(program), {verb}, arguments, inherited, limits,
                           [&](std::string_view line) { parse_message(line, output, progress); });
  return output;
}

}  // namespace bodkin::io
