#include "views/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QXmlStreamReader>
#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::views {

namespace {

constexpr int most_cached = 4096;  // texts
constexpr QChar opening_quote(0x201e);
const QString words_context = QStringLiteral("Words");

QString key_of(const QString& context, const QString& text) {
  return context + QLatin1Char('\x04') + text;
}

std::filesystem::path file_of(const char* part, const QString& code, const std::filesystem::path& folder) {
  return folder / fmt::format("{}_{}.ts", part, code.toStdString());
}

// A <translation>: its text, or its forms of a plural; none if it is marked as unfinished.
QStringList read_translation(QXmlStreamReader& xml) {
  const bool unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
  QStringList forms;
  QString text;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isEndElement() && xml.name() == QLatin1String("translation")) break;
    if (xml.isStartElement()) {
      forms << xml.readElementText();
    } else if (xml.isCharacters()) {
      text += xml.text();
    }
  }
  if (unfinished) return {};
  return forms.isEmpty() ? QStringList(text) : forms;
}

QString with_upper_first(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

Language::Language(const QString& code, const std::filesystem::path& folder) {
  read(file_of("window", code, folder));
  read(file_of("words", code, folder));
  std::stable_sort(patterns_.begin(), patterns_.end(), [](const Pattern& a, const Pattern& b) {
    return a.text.pattern().size() > b.text.pattern().size();
  });
}

void Language::read(const std::filesystem::path& file) {
  QFile device(QString::fromStdString(file.string()));
  if (!device.open(QIODevice::ReadOnly))
    throw InputError(
        fmt::format("{}: this file of translations cannot be read; name another language", file.string()));
  QXmlStreamReader xml(&device);
  QString context, source;
  if (xml.readNextStartElement() && xml.name() != QLatin1String("TS"))
    xml.raiseError(QStringLiteral("expected the element TS of Qt Linguist"));
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("name")) {
      context = xml.readElementText();
    } else if (xml.name() == QLatin1String("source")) {
      source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      const QStringList forms = read_translation(xml);
      if (forms.isEmpty()) continue;
      texts_.insert(key_of(context, source), forms);
      if (context != words_context) {
        anywhere_.insert(source, forms.front());
      } else if (source.contains(QLatin1String("%1")) || source.contains(QLatin1String("#1"))) {
        add_pattern(source, forms.front());
      }
    }
  }
  if (xml.hasError()) {
    throw InputError(
        fmt::format("{}, line {}: {}", file.string(), xml.lineNumber(), xml.errorString().toStdString()));
  }
}

void Language::add_pattern(const QString& text, const QString& translation) {
  Pattern pattern;
  QString expression = QStringLiteral("^");
  QString piece;  // what stands since the last place
  for (int i = 0; i < text.size(); ++i) {
    const bool is_number = text[i] == QLatin1Char('#');
    if ((is_number || text[i] == QLatin1Char('%')) && i + 1 < text.size() && text[i + 1].isDigit()) {
      if (pattern.numbers.empty()) pattern.begins = piece;
      piece.clear();
      pattern.numbers.push_back(text[++i].digitValue());
      expression += is_number ? QStringLiteral("([-+]?[0-9.]+(?:e[-+]?[0-9]+)?|-?INF)") : QStringLiteral("(.+?)");
    } else {
      expression += QRegularExpression::escape(QString(text[i]));
      piece += text[i];
    }
  }
  pattern.ends = piece;
  pattern.text = QRegularExpression(expression + QLatin1Char('$'));
  pattern.translation = translation;
  patterns_.push_back(std::move(pattern));
}

QString Language::translate(const char* context, const char* text, const char* /*comment*/, int count) const {
  const QString source = QString::fromUtf8(text);
  const QString where = QString::fromUtf8(context);
  if (where == words_context) return words(source);
  auto found = texts_.constFind(key_of(where, source));
  // Qt Linguist omits the namespaces of a class if it has not seen them.
  if (found == texts_.constEnd()) found = texts_.constFind(key_of(where.section(QStringLiteral("::"), -1), source));
  if (found == texts_.constEnd()) return anywhere_.value(source);
  return count == 1 ? found->front() : found->back();
}

bool Language::has_entry(const QString& text) const {
  QString lower = text;
  if (!lower.isEmpty()) lower[0] = lower[0].toLower();
  return texts_.contains(key_of(words_context, text)) || texts_.contains(key_of(words_context, lower));
}

// Exactly, then with another first letter, then by a pattern, then sentence by sentence.
QString Language::words(const QString& text) const {
  if (const auto kept = cache_.constFind(text); kept != cache_.constEnd()) return *kept;
  const auto exactly = [this](const QString& source) {
    const QStringList forms = texts_.value(key_of(words_context, source));
    return forms.isEmpty() ? QString() : forms.front();
  };
  QString found = exactly(text);
  if (found.isNull() && !text.isEmpty() && text[0].isUpper()) {
    QString lower = text;
    lower[0] = lower[0].toLower();
    found = exactly(lower);
    if (!found.isNull()) found = with_upper_first(found);
  }
  const int end = text.indexOf(QLatin1String(". "));
  if (found.isNull() && end > 0) {
    const QString first = text.left(end + 1), rest = text.mid(end + 2);
    const QString one = words(first), other = words(rest);
    if (!one.isNull() || !other.isNull())
      found = (one.isNull() ? first : one) + QLatin1Char(' ') + (other.isNull() ? rest : other);
  }
  if (found.isNull()) found = by_pattern(text);
  if (cache_.size() >= most_cached) cache_.clear();
  cache_.insert(text, found);
  return found;
}

QString Language::by_pattern(const QString& text) const {
  for (const Pattern& pattern : patterns_) {
    if (!text.startsWith(pattern.begins) || !text.endsWith(pattern.ends)) continue;
    const QRegularExpressionMatch match = pattern.text.match(text);
    if (!match.hasMatch()) continue;
    QString made;
    for (int i = 0; i < pattern.translation.size(); ++i) {
      const QChar letter = pattern.translation[i];
      const bool place = (letter == QLatin1Char('%') || letter == QLatin1Char('#')) &&
                         i + 1 < pattern.translation.size() && pattern.translation[i + 1].isDigit();
      if (!place) {
        made += letter;
        continue;
      }
      const auto at =
          std::find(pattern.numbers.begin(), pattern.numbers.end(), pattern.translation[++i].digitValue());
      if (at == pattern.numbers.end()) continue;
      const QString part = match.captured(static_cast<int>(at - pattern.numbers.begin()) + 1);
      // Texts in quotation marks and names of elements appear literally in files.
      const bool is_name = made.endsWith(QLatin1Char('<')) || made.endsWith(opening_quote);
      const QString translated = is_name ? QString() : words(part);
      made += translated.isNull() ? part : translated;
    }
    return made;
  }
  return {};
}

QStringList languages_in(const std::filesystem::path& folder) {
  QStringList codes(QStringLiteral("en"));
  const QDir files(QString::fromStdString(folder.string()));
  for (const QString& name : files.entryList({QStringLiteral("window_*.ts")}, QDir::Files, QDir::Name)) {
    const QString code = name.mid(7, name.size() - 10);
    if (std::filesystem::is_regular_file(file_of("words", code, folder))) codes << code;
  }
  return codes;
}

QString in_words(const std::string& text) {
  return text.empty() ? QString() : QCoreApplication::translate("Words", text.c_str());
}

}  // namespace bodkin::views
