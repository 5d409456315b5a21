#include <QRegularExpression>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "views/language.h"
#include <gtest/gtest.h>

// Errors thrown by other modules appear in the window as whole sentences. They are read from the source, so that a
// new sentence without German text is found.

namespace bodkin::views {
namespace {

namespace fs = std::filesystem;

using Tokens = std::vector<std::string>;

// The modules of the window; the others are commands and separate programs.
constexpr std::array modules = {"anatomy", "app",      "core",     "forces", "haptics", "imaging",
                                "io",      "link",     "patient",  "scene",  "session", "simulation",
                                "station", "tracking", "training", "views"};
// Files whose errors appear on the command line only.
const std::set<std::string> without_window = {"app/benchmark.cpp",   "app/main.cpp",
                                              "app/script.cpp",      "station/ultrasound_request.cpp",
                                              "training/cohort.cpp", "training/cusum.cpp"};

// Words, literals with their quotation marks, and signs; no blanks or comments.
Tokens tokens_of(const std::string& source) {
  static const QRegularExpression token(
      QStringLiteral(R"(//[^\n]*|/\*.*?\*/|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)'|\w+|\s+|.)"),
      QRegularExpression::DotMatchesEverythingOption);
  Tokens tokens;
  auto found = token.globalMatch(QString::fromStdString(source));
  while (found.hasNext()) {
    const QString text = found.next().captured(0);
    if (text[0].isSpace() || text.startsWith(QLatin1String("//")) || text.startsWith(QLatin1String("/*"))) continue;
    tokens.push_back(text.toStdString());
  }
  return tokens;
}

bool is_literal(const std::string& token) {
  return token.front() == '"';
}

// Splits at a sign outside all brackets.
std::vector<Tokens> split(const Tokens& tokens, const std::string& sign) {
  std::vector<Tokens> parts(1);
  int depth = 0;
  for (const std::string& token : tokens) {
    depth += token == "(" || token == "[" || token == "{";
    depth -= token == ")" || token == "]" || token == "}";
    if (depth == 0 && token == sign)
      parts.emplace_back();
    else
      parts.back().push_back(token);
  }
  return parts;
}

std::string unquoted(const std::string& literal) {
  std::string text;
  for (std::size_t i = 1; i + 1 < literal.size(); ++i) {
    if (literal[i] != '\\') {
      text += literal[i];
    } else {
      ++i;
      text += literal[i] == 'n' ? '\n' : literal[i];
    }
  }
  return text;
}

constexpr char hole = '\x01';  // a variable part

// Adjacent literals; a variable part if there is anything else between them.
std::string literals(const Tokens& tokens) {
  std::string text;
  for (const std::string& token : tokens) {
    if (!is_literal(token)) return {hole};
    text += unquoted(token);
  }
  return text.empty() ? std::string{hole} : text;
}

// The text of an expression: literals, fmt::format and sums of both.
std::string text_of(const Tokens& tokens) {
  if (split(tokens, "?").size() > 1) return {hole};
  const std::vector<Tokens> terms = split(tokens, "+");
  if (terms.size() > 1) {
    std::string sum;
    for (const Tokens& term : terms) sum += text_of(term);
    return sum;
  }
  const auto begins_with = [&tokens](const Tokens& words) {
    return tokens.size() > words.size() && std::equal(words.begin(), words.end(), tokens.begin());
  };
  if (begins_with({"std", ":", ":", "string", "("})) return literals(Tokens(tokens.begin() + 5, tokens.end() - 1));
  if (!begins_with({"fmt", ":", ":", "format", "("})) return literals(tokens);
  QString format = QString::fromStdString(literals(split(Tokens(tokens.begin() + 5, tokens.end() - 1), ",").front()));
  static const QRegularExpression place(QStringLiteral(R"(\{[^{}]*\})"));
  format.replace(QLatin1String("{{"), QLatin1String("\x02")).replace(QLatin1String("}}"), QLatin1String("\x03"));
  format.replace(place, QString(QLatin1Char(hole)));
  return format.replace(QLatin1Char('\x02'), QLatin1Char('{'))
      .replace(QLatin1Char('\x03'), QLatin1Char('}'))
      .toStdString();
}

// In the dictionary's notation: %1 to %9 in order for the variable parts.
QString numbered(const std::string& text) {
  QString made;
  int number = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != hole) {
      std::size_t end = i;
      while (end < text.size() && text[end] != hole) ++end;
      made += QString::fromStdString(text.substr(i, end - i));
      i = end - 1;
    } else if (i == 0 || text[i - 1] != hole) {
      made += QStringLiteral("%%1").arg(++number);
    }
  }
  return made;
}

std::vector<std::string> thrown_in(const std::string& source) {
  std::vector<std::string> texts;
  const Tokens tokens = tokens_of(source);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if ((tokens[i] != "InputError" && tokens[i] != "SystemError") || tokens[i + 1] != "(") continue;
    std::size_t end = i + 1;
    for (int depth = 0; end < tokens.size(); ++end) {
      depth += tokens[end] == "(";
      depth -= tokens[end] == ")";
      if (depth == 0) break;
    }
    texts.push_back(text_of(Tokens(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 2,
                                   tokens.begin() + static_cast<std::ptrdiff_t>(end))));
  }
  return texts;
}

// Texts without a sentence of their own: names, numbers and embedded sentences.
bool is_frame(const QString& text) {
  static const QRegularExpression word(QStringLiteral("[A-Za-z]{3}"));
  QString bare = text;
  return !bare.remove(QRegularExpression(QStringLiteral("%\\d"))).contains(word);
}

// The file or part in front, "%1: " or "servo: ", has a pattern of its own.
bool is_known(const Language& german, std::string text) {
  static const QRegularExpression front(QStringLiteral("^(?:\x01|[a-z_ ]+)(?:, line \x01)?: "));
  while (true) {
    const QString written = numbered(text);
    if (german.has_entry(written) || is_frame(written)) return true;
    const QRegularExpressionMatch found = front.match(QString::fromStdString(text));
    if (!found.hasMatch()) return false;
    text = text.substr(static_cast<std::size_t>(found.captured(0).toStdString().size()));
  }
}

TEST(ErrorSentences, german_has_every_error_that_the_window_can_show) {
  const fs::path repository = BODKIN_REPOSITORY;
  const Language german(QStringLiteral("de"), repository / "share" / "bodkin" / "translations");
  int sentences = 0;
  for (const char* module : modules) {
    for (const auto& entry : fs::recursive_directory_iterator(repository / "src" / module)) {
      const fs::path& file = entry.path();
      if (file.extension() != ".cpp" && file.extension() != ".h") continue;
      if (without_window.contains(fs::relative(file, repository / "src").generic_string())) continue;
      std::ostringstream source;
      source << std::ifstream(file).rdbuf();
      if (source.str().find("Error(") == std::string::npos) continue;
      for (const std::string& text : thrown_in(source.str())) {
        ++sentences;
        EXPECT_TRUE(is_known(german, text)) << file.filename() << ": add \"" << numbered(text).toStdString()
                                            << "\" to share/bodkin/translations/words_de.ts";
      }
    }
  }
  EXPECT_GT(sentences, 500);
}

TEST(ErrorSentences, a_sentence_is_put_together_from_its_source) {
  const std::vector<std::string> found = thrown_in(
      "throw InputError(fmt::format(\"{}: {{x}} is {:g} mm, \"\n  \"expected {}\", file, 1.0, f(2)));\n"
      "throw SystemError(name + \" is not \" + std::string(\"there\") + (a ? \"b\" : \"c\"));  // \"no\"");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(numbered(found[0]).toStdString(), "%1: {x} is %2 mm, expected %3");
  EXPECT_EQ(numbered(found[1]).toStdString(), "%1 is not there%2");
}

TEST(ErrorSentences, a_real_one_is_german_throughout) {
  const Language german(QStringLiteral("de"), fs::path(BODKIN_REPOSITORY) / "share" / "bodkin" / "translations");
  const auto said = [&german](const char* text) {
    return german.translate("Words", text, nullptr, -1).toStdString();
  };
  EXPECT_EQ(said("/home/a/case.xml, line 12: <needle> has the unknown attribute 'colour'; it takes gauge, tip"),
            "/home/a/case.xml, Zeile 12: <needle> hat das unbekannte Attribut 'colour'; möglich: gauge, tip");
  EXPECT_EQ(said("ct.nii.gz: the gzip stream is truncated or damaged; copy the file again"),
            "ct.nii.gz: der gzip-Strom ist abgeschnitten oder beschädigt; kopieren Sie die Datei noch einmal");
  EXPECT_EQ(said("a.bodkin: the end of the file is missing; give a session file that 'bodkin run' wrote"),
            "a.bodkin: das Ende der Datei fehlt; geben Sie eine Sitzungsdatei an, die „bodkin run“ geschrieben hat");
  EXPECT_EQ(said("Skin: break force: break_force_N is 900 N, expected 0 to 100 N"),
            "Haut: Durchstichkraft: break_force_N ist 900 N, erwartet: 0 bis 100 N");
}

}  // namespace
}  // namespace bodkin::views
