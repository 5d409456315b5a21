#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace bodkin_test {

inline const std::filesystem::path repository = BODKIN_REPOSITORY;

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace bodkin_test
