#include "cli/station_requests.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "link/command.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/resources.h"
#include "io/xml_document.h"
#include "training/store/attempt_record.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

// The case named `wanted` inside `folder`; empty: `folder` itself. Never one outside.
std::string case_for(const std::string& folder, const std::string& wanted) {
  const fs::path inside = wanted.empty() ? fs::path(folder) : fs::path(folder) / wanted;
  std::error_code unreadable;
  if ((wanted.empty() || io::is_inside_name(wanted)) && fs::is_regular_file(inside / "case.xml", unreadable)) {
    const fs::path found = fs::canonical(inside, unreadable), root = fs::canonical(folder, unreadable);
    const auto [in_root, in_found] = std::mismatch(root.begin(), root.end(), found.begin(), found.end());
    if (in_root == root.end()) return inside.string();
  }
  throw InputError(fmt::format("this station has no case {}", io::in_quotes(wanted)));
}

// A plain name, which cannot lead outside by a link; the suffix is ours. Empty: no name.
std::string session_name(const std::string& wanted) {
  constexpr std::size_t longest = 100;
  if (wanted.empty()) return {};
  const bool is_plain = wanted.size() <= longest && wanted.front() != '.' && wanted.front() != '-' &&
                        std::all_of(wanted.begin(), wanted.end(), [](unsigned char letter) {
                          return letter >= ' ' && letter != '/' && letter != '\\' && letter != 0x7F;
                        });
  if (!is_plain) {
    throw InputError(fmt::format(
        "OutputFilename is {}, expected the name of a file in the station's folder, at most {} bytes and without a /",
        io::in_quotes(wanted), longest));
  }
  return fs::path(wanted).extension() == ".bodkin" ? wanted : wanted + ".bodkin";
}

}  // namespace

std::optional<StartRequest> StationRequests::read_request(const link::Message& message) {
  const std::optional<link::Command> command = link::command_of(message);
  if (!command) return std::nullopt;
  const bool loads = command->name == "LoadCase";
  if (!loads && command->name != "StartProcedure" && command->name != "StartRecording") {
    throw InputError(
        "no session runs here; StartProcedure or StartRecording with Case=\"name\" starts one, LoadCase chooses it");
  }
  const auto value = [&](const char* name) {
    const auto found = command->values.find(name);
    return found == command->values.end() ? std::string() : found->second;
  };
  const std::string wanted = value("Case").empty() ? chosen_ : value("Case");
  StartRequest request{case_for(folder_, wanted), value("Trainee"), session_name(value("OutputFilename"))};
  if (!request.trainee.empty()) training::check_label(request.trainee, "Trainee");
  if (loads) chosen_ = wanted;
  request.begins = !loads;
  return request;
}

}  // namespace bodkin::cli
