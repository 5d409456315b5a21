#pragma once

#include <QHash>
#include <QRegularExpression>
#include <QStringList>
#include <QTranslator>
#include <filesystem>
#include <string>
#include <vector>

namespace bodkin::views {

// A language of the window besides English. It is read from two files of Qt Linguist as they are, without a step of
// the build: window_CODE.ts holds the window's own texts, words_CODE.ts those of other modules (tissues, procedures,
// verdicts, devices). The latter arrive as whole sentences with numbers in them; %1 to %9 of the context "Words"
// stand for what varies, and are translated in turn; #1 to #9 stand for a number.
class Language : public QTranslator {
 public:
  // `code`: "de". Throws InputError, with file and line, when a file is missing or is no .ts.
  Language(const QString& code, const std::filesystem::path& folder);

  // Null where there is no translation. Of the forms of a plural the first is for one thing, the last for any other
  // number.
  QString translate(const char* context, const char* text, const char* comment, int count) const override;
  bool isEmpty() const override { return false; }
  // True when the dictionary of other modules has an entry of its own for this, which is a text, or a sentence with
  // %1 to %9 for what varies in it. What is put together from several entries has none.
  bool has_entry(const QString& text) const;

 private:
  struct Pattern {
    QRegularExpression text;
    QString begins, ends;      // what stands before the first place and after the last one: quickly looked at
    std::vector<int> numbers;  // of the places, in the order in which they stand in the text
    QString translation;
  };

  void read(const std::filesystem::path& file);
  void add_pattern(const QString& text, const QString& translation);
  QString words(const QString& text) const;
  QString by_pattern(const QString& text) const;

  QHash<QString, QStringList> texts_;       // by context and text; several forms of a plural
  QHash<QString, QString> anywhere_;        // by text alone
  std::vector<Pattern> patterns_;           // those that say most first
  mutable QHash<QString, QString> lately_;  // what words() has found, for views draw the same texts over and over
};

// The codes of the languages that the window speaks: "en", and those with both files in the folder.
QStringList languages_in(const std::filesystem::path& folder);

// What another module says, in the language of the window; as it is where the dictionary does not have it.
QString in_words(const std::string& text);

}  // namespace bodkin::views
