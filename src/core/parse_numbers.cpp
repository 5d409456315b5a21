#include "core/parse_numbers.h"

#include <charconv>
#include <cmath>

#include "core/error.h"

namespace bodkin {

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char* cursor = text.data();
  const char* const end = text.data() + text.size();
  while (true) {
    double number = 0.0;
    const auto [next, failed] = std::from_chars(cursor, end, number);
    if (failed != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    if (next == end) return numbers;
    if (*next != ',' && *next != ' ') return {};
    cursor = next + 1;
  }
}

std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& origin) {
  std::vector<double> numbers = numbers_in(text);
  if (numbers.size() == count) return numbers;
  std::string sentence = origin;
  sentence.append(" is '").append(text).append("'; expected ").append(std::to_string(count));
  throw InputError(sentence.append(" finite numbers with commas between them"));
}

Vec3 parse_point(const std::string& text, const std::string& origin) {
  const std::vector<double> numbers = numbers_in(text);
  if (numbers.size() == 3 && text.find(' ') == std::string::npos) return {numbers[0], numbers[1], numbers[2]};
  std::string sentence = origin;
  sentence.append(" is '").append(text);
  throw InputError(sentence.append("'; expected three finite numbers in LPS mm such as 4.5,-45,293"));
}

}  // namespace bodkin
