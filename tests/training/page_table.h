#pragma once

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace bodkin::training {

// The same words, and numbers with a relative difference of at most `share`.
inline bool is_same_table(const std::string& one, const std::string& other, double share) {
  std::istringstream a(one), b(other);
  std::string in_a, in_b;
  while (a >> in_a) {
    if (!(b >> in_b)) return false;
    if (in_a == in_b) continue;
    char *end_a = nullptr, *end_b = nullptr;
    const double x = std::strtod(in_a.c_str(), &end_a), y = std::strtod(in_b.c_str(), &end_b);
    if (*end_a != '\0' || *end_b != '\0' || !(std::abs(x - y) <= share * std::abs(x) + 0.011)) return false;
  }
  return !(b >> in_b);
}

// A page of docs/ contains this table, whose first line begins with `heading`; BODKIN_WRITE_PAGES=1 writes it.
// `share`: the allowed relative difference, because another processor's sine has other last digits.
inline void expect_table_on_page(const std::string& page_name, const std::string& heading, const std::string& table,
                                 double share = 0.0) {
  const std::string file = BODKIN_REPOSITORY "/docs/" + page_name;
  std::ifstream stream(file);
  std::string page{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t begin = page.find(heading);
  ASSERT_NE(begin, std::string::npos) << file << " has no table that begins with " << heading;
  const std::size_t end = page.find("\n\n", begin);
  const std::size_t size = end == std::string::npos ? std::string::npos : end + 1 - begin;
  if (std::getenv("BODKIN_WRITE_PAGES") != nullptr) {
    page.replace(begin, size, table);
    std::ofstream(file) << page;
    return;
  }
  const std::string there = page.substr(begin, size);
  EXPECT_TRUE(share > 0.0 ? is_same_table(there, table, share) : there == table)
      << "BODKIN_WRITE_PAGES=1 training_tests writes the table:\n"
      << table;
}

}  // namespace bodkin::training
