#include "cli/body_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "core/error.h"

namespace bodkin::cli {

namespace {

using FaceSetting = std::pair<std::string_view, double fem::ProbeFace::*>;
constexpr std::array<FaceSetting, 3> face_settings = {FaceSetting{"width_mm", &fem::ProbeFace::width},
                                                      FaceSetting{"thickness_mm", &fem::ProbeFace::thickness},
                                                      FaceSetting{"radius_mm", &fem::ProbeFace::radius}};

// The blank-separated words of a text.
std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return words;
    const auto end = std::min(text.find_first_of(" \t", first), text.size());
    words.push_back(text.substr(first, end - first));
    text.remove_prefix(end);
  }
}

void parse_face_setting(std::string_view word, fem::ProbeFace& face) {
  const auto sign = std::min(word.find('='), word.size());
  for (const auto& [name, member] : face_settings) {
    if (word.substr(0, sign) != name) continue;
    const std::string_view digits = word.substr(std::min(sign + 1, word.size()));
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), face.*member);
    if (error == std::errc() && end == digits.data() + digits.size()) return;
    throw InputError(fmt::format("--body: {} is '{}', expected a number of mm", name, digits));
  }
  throw InputError(
      fmt::format("--body: there is no setting '{}', expected width_mm, thickness_mm or radius_mm of the "
                  "probe's face, as SETTING=VALUE",
                  word.substr(0, sign)));
}

}  // namespace

void add_body_option(CLI::App& command, std::string& body) {
  add_text(
      command, "--body", body,
      "static (the default), or \"moving SETTING=VALUE ...\": a body that the second device's probe can press "
      "deeply, computed on a thread of its own; settings: width_mm, thickness_mm, radius_mm of the probe's face");
}

std::optional<fem::ProbeFace> parse_body(const std::string& body) {
  if (body.empty()) return {};
  const std::vector<std::string_view> words = split_words(body);
  const bool moves = !words.empty() && words.front() == "moving";
  if (!moves && (words.size() != 1 || words.front() != "static"))
    throw InputError(fmt::format("--body is '{}'; expected static, or moving with settings of the probe", body));
  if (!moves) return {};
  fem::ProbeFace face;
  for (std::size_t word = 1; word < words.size(); ++word) parse_face_setting(words[word], face);
  return face;
}

}  // namespace bodkin::cli
