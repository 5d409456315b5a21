#include "station/driver_inquiry.h"

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <iterator>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/error.h"
#include "io/child_process.h"

namespace bodkin::station {

namespace {

using DriverLoader = std::function<const bodkin_driver&(const std::string&)>;

constexpr std::chrono::seconds inquiry_patience{5};  // of the child, with the driver
constexpr io::ChildLimits inquiry_limits{
    .memory = 0, .processor = std::chrono::seconds(60), .wall = std::chrono::seconds(8)};

// The contents of the child's one line of JSON.
nlohmann::json inquiry_result(const bodkin_driver& driver, const std::string& settings, bool wants_devices) {
  nlohmann::json answer_json = {
      {"name", driver.name}, {"summary", driver.summary}, {"devices", nlohmann::json::array()}};
  if (!wants_devices) return answer_json;
  try {
    for (const haptics::FoundDevice& device : haptics::list_devices(driver, settings, inquiry_patience)) {
      answer_json["devices"].push_back({{"identity", device.identity}, {"title", device.title}});
    }
  } catch (const haptics::DeviceError& error) {
    answer_json["fault"] = static_cast<int>(error.fault());
    answer_json["sentence"] = error.what();
  }
  return answer_json;
}

nlohmann::json answer_to(const std::string& request, const DriverLoader& load) {
  try {
    const nlohmann::json json = nlohmann::json::parse(request);
    return inquiry_result(load(json.at("driver").get<std::string>()), json.at("settings").get<std::string>(),
                          json.at("devices").get<bool>());
  } catch (const InputError& error) {
    return {{"refused", error.what()}};
  } catch (const std::exception& error) {
    return {{"broken", error.what()}};
  }
}

haptics::DeviceFault fault_in(const nlohmann::json& answer_json) {
  const int number = answer_json.value("fault", 0);
  const bool known = number >= 0 && number <= static_cast<int>(haptics::DeviceFault::vendor_error);
  return known ? static_cast<haptics::DeviceFault>(number) : haptics::DeviceFault::vendor_error;
}

DriverAnswer answer_from(const nlohmann::json& answer_json, DriverAnswer answer) {
  if (answer_json.contains("refused")) throw InputError(answer_json.at("refused").get<std::string>());
  if (answer_json.contains("broken")) {
    answer.fault = haptics::DeviceFault::vendor_error;
    answer.sentence = answer_json.at("broken").get<std::string>();
    return answer;
  }
  answer.name = answer_json.at("name").get<std::string>();
  answer.summary = answer_json.at("summary").get<std::string>();
  for (const nlohmann::json& device : answer_json.at("devices")) {
    answer.devices.push_back({device.at("identity").get<std::string>(), device.at("title").get<std::string>()});
  }
  answer.fault = fault_in(answer_json);
  answer.sentence = answer_json.value("sentence", "");
  return answer;
}

std::string end_of(const io::ChildResult& result, const std::string& driver) {
  const std::string advice = driver.find('/') == std::string::npos
                                 ? "reinstall its vendor's software, or remove it"
                                 : "remove the file, or ask whoever made it for another one";
  switch (result.end) {
    case io::ChildEnd::out_of_time:
      return fmt::format("the driver {} has not answered within {} s: {}", driver, inquiry_limits.wall.count(),
                         advice);
    case io::ChildEnd::killed:
      return fmt::format("the driver {} crashed ({}): {}", driver, strsignal(result.signal), advice);
    case io::ChildEnd::interrupted:
    case io::ChildEnd::exited:
      break;
  }
  return fmt::format("the driver {} ended the program that asked it (exit code {}): {}", driver, result.exit_code,
                     advice);
}

}  // namespace

DriverAnswer ask_driver(const std::string& driver, const std::string& settings, Inquiry inquiry,
                        const std::filesystem::path& program) {
  DriverAnswer answer;
  answer.driver = driver;
  const nlohmann::json request = {
      {"driver", driver}, {"settings", settings}, {"devices", inquiry == Inquiry::devices}};
  std::string line;
  const io::ChildResult result =
      io::run_child(program.empty() ? std::filesystem::read_symlink("/proc/self/exe") : program,
                    {driver_inquiry_argument}, request.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace),
                    -1, inquiry_limits, [&](std::string_view text) { line = text; });
  const nlohmann::json answer_json = nlohmann::json::parse(line, nullptr, false);
  if (answer_json.is_object()) return answer_from(answer_json, std::move(answer));
  answer.fault = haptics::DeviceFault::vendor_error;
  answer.sentence = end_of(result, driver);
  return answer;
}

int answer_driver_inquiry(const DriverLoader& load) {
  // A vendor's library may write to standard output: it is given another one.
  const int answers = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (answers < 0 || nowhere < 0 || dup2(nowhere, STDOUT_FILENO) < 0) return 1;
  const std::string request{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  const std::string line =
      answer_to(request, load).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
  const bool whole = write(answers, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  _exit(whole ? 0 : 1);  // without the exit handlers of a vendor's library
}

}  // namespace bodkin::station
