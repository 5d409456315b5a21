#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace bodkin::training {

// A page of docs/ holds this table, whose first line begins with `heading`; BODKIN_WRITE_PAGES=1 writes it there.
inline void expect_table_on_page(const std::string& page_name, const std::string& heading, const std::string& table) {
  const std::string file = BODKIN_REPOSITORY "/docs/" + page_name;
  std::ifstream stream(file);
  std::string page{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t begin = page.find(heading), end = page.find("\n\n", begin);
  ASSERT_NE(begin, std::string::npos) << file << " has no table that begins with " << heading;
  if (std::getenv("BODKIN_WRITE_PAGES") != nullptr) {
    page.replace(begin, end == std::string::npos ? std::string::npos : end + 1 - begin, table);
    std::ofstream(file) << page;
  }
  EXPECT_NE(page.find(table), std::string::npos) << "BODKIN_WRITE_PAGES=1 training_tests writes the table";
}

}  // namespace bodkin::training
