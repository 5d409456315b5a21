#pragma once

#include <QHash>
#include <QRegularExpression>
#include <QStringList>
#include <QTranslator>
#include <filesystem>
#include <string>
#include <vector>

namespace bodkin::views {

// A language of the window other than English. It is read from two unprocessed files of Qt Linguist: window_CODE.ts
// contains the window's own texts, words_CODE.ts those of other modules (tissues, procedures, verdicts, devices). The
// latter are whole sentences with numbers in them; %1 to %9 of the context "Words" represent variable parts, which
// are also translated; #1 to #9 represent numbers.
class Language : public QTranslator {
 public:
  // `code`: "de". Throws InputError, with file and line, when a file is missing or is not a .ts.
  Language(const QString& code, const std::filesystem::path& folder);

  // Null without a translation. Of the plural forms the first is for one, the last for any other number.
  QString translate(const char* context, const char* text, const char* comment, int count) const override;
  bool isEmpty() const override { return false; }
  // Whether the dictionary of other modules has an entry of its own for this text, or for a sentence with %1 to %9
  // for its variable parts. A combination of several entries has none.
  bool has_entry(const QString& text) const;

 private:
  struct Pattern {
    QRegularExpression text;
    QString begins, ends;      // text before the first place and after the last one, for quick rejection
    std::vector<int> numbers;  // of the places, in the order of the text
    QString translation;
  };

  void read(const std::filesystem::path& file);
  void add_pattern(const QString& text, const QString& translation);
  QString words(const QString& text) const;
  QString by_pattern(const QString& text) const;

  QHash<QString, QStringList> texts_;      // by context and text; several forms of a plural
  QHash<QString, QString> anywhere_;       // only by text
  std::vector<Pattern> patterns_;          // the most specific first
  mutable QHash<QString, QString> cache_;  // results of words(), because views draw the same texts repeatedly
};

// The codes of the window's languages: "en", and those with both files in the folder.
QStringList languages_in(const std::filesystem::path& folder);

// Text of another module in the language of the window; unchanged if the dictionary does not have it.
QString in_words(const std::string& text);

}  // namespace bodkin::views
