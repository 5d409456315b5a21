#include "report/document_pdf.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace bodkin::report {

namespace {

using imaging::Canvas;
using imaging::Ink;
using imaging::Path;
using imaging::text_width;
using imaging::TextAnchor;
using imaging::TextStyle;

// Points, 1/72 inch.
constexpr double page_width = 595.28, page_height = 841.89;  // A4
constexpr double margin = 42.0;
constexpr double content_width = page_width - 2.0 * margin;
constexpr double content_bottom = page_height - margin - 14.0;
constexpr double text_size = 9.0, small_size = 8.0;
constexpr double line_height = 1.4;   // of the size of the text
constexpr double base_line = 1.02;    // of the size of the text, below the line's upper edge
constexpr double cell_padding = 5.0;  // left and right of a cell's text
constexpr double highest_figure = 330.0;

constexpr std::uint32_t ink = 0x16222C, muted_ink = 0x5A6873, rule = 0xDFE4E8, card = 0xF4F6F8;

std::uint32_t ink_of(training::Grade grade) {
  constexpr std::array<std::uint32_t, 4> inks = {0x1D7A4F, 0x8A6100, 0xA3471A, 0xB3121D};
  return inks[static_cast<std::size_t>(grade)];
}

std::uint32_t back_of(training::Grade grade) {
  constexpr std::array<std::uint32_t, 4> backs = {0xE6F4EC, 0xFDF3D7, 0xFBEEE4, 0xFDE3E4};
  return backs[static_cast<std::size_t>(grade)];
}

struct Font {
  double size = text_size;
  bool bold = false;

  double height() const { return line_height * size; }
};

// The longest prefix of `word` not wider than `width`, at least one character; never a part of a UTF-8 character.
std::size_t fitting_part(std::string_view word, double width, const Font& font) {
  std::size_t fits = 0;
  for (std::size_t end = 1; end <= word.size(); ++end) {
    if (end < word.size() && (static_cast<unsigned char>(word[end]) & 0xC0U) == 0x80U) continue;
    if (fits > 0 && text_width(word.substr(0, end), font.size, font.bold) > width) break;
    fits = end;
  }
  return fits;
}

// The text in lines not wider than `width`, divided at spaces, and within wider words.
std::vector<std::string> wrapped(std::string_view text, double width, const Font& font) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const std::size_t space = std::min(text.find(' '), text.size());
    std::string_view word = text.substr(0, space);
    text.remove_prefix(std::min(space + 1, text.size()));
    const std::string longer = lines.back().empty() ? std::string(word) : fmt::format("{} {}", lines.back(), word);
    if (text_width(longer, font.size, font.bold) <= width) {
      lines.back() = longer;
      continue;
    }
    if (!lines.back().empty()) lines.emplace_back();
    while (text_width(word, font.size, font.bold) > width && word.size() > 1) {
      const std::size_t part = fitting_part(word, width, font);
      if (part == word.size()) break;
      lines.back() = word.substr(0, part);
      lines.emplace_back();
      word.remove_prefix(part);
    }
    lines.back() = word;
  }
  return lines;
}

// Column widths that fill the page: numbers get the width that they need, text shares the rest.
std::vector<double> column_widths(const Table& table) {
  constexpr double widest = 230.0, narrowest = 40.0;
  std::vector<double> widths;
  double numbers = 0.0, texts = 0.0;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    double width = text_width(table.columns[i].title, small_size, true);
    for (const std::vector<Table::Cell>& row : table.rows)
      width = std::max(width, text_width(row[i].text, text_size) + (row[i].swatch ? 13.0 : 0.0));
    widths.push_back(std::clamp(width, narrowest, widest) + 2.0 * cell_padding);
    (table.columns[i].is_number ? numbers : texts) += widths.back();
  }
  const double scale = texts > 0.0 ? (content_width - numbers) / texts : content_width / numbers;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (texts <= 0.0 || !table.columns[i].is_number) widths[i] *= scale;
  }
  return widths;
}

// Scale of a figure from its canvas to the page.
double scale_of(const Canvas& picture) {
  return std::min(content_width / picture.width(), highest_figure / picture.height());
}

// The minimum height of the content below a heading on its page.
double least_height(const Block& block) {
  const auto* const figure = std::get_if<Picture>(&block);
  return figure != nullptr ? scale_of(figure->picture) * figure->picture.height() : 50.0;
}

class PageLayout {
 public:
  std::string write(const Document& document) {
    begin_page();
    lines(wrapped(document.title, content_width, {17.0, true}), margin, {17.0, true}, ink);
    lines(wrapped(document.subtitle, content_width, {}), margin, {}, muted_ink);
    y_ += 8.0;
    for (std::size_t i = 0; i < document.blocks.size(); ++i) {
      // A heading must not be the last line of a page.
      if (std::holds_alternative<Heading>(document.blocks[i]))
        need(40.0 + (i + 1 < document.blocks.size() ? least_height(document.blocks[i + 1]) : 0.0));
      std::visit([this](const auto& each) { add(each); }, document.blocks[i]);
    }
    number_pages(document.title);
    return imaging::pdf(pages_, document.title);
  }

 private:
  Canvas& page() { return pages_.back(); }

  void begin_page() {
    pages_.emplace_back(page_width, page_height);
    page().fill_all(0xFFFFFF);
    y_ = margin;
  }

  // Begins a new page unless `height` fits on this one, or not even on an empty page.
  void need(double height) {
    if (y_ + height > content_bottom && y_ > margin) begin_page();
  }

  void put(const std::string& text, double x, double y, const Font& font, std::uint32_t colour,
           TextAnchor anchor = TextAnchor::start) {
    TextStyle style;
    style.size = font.size;
    style.ink = colour;
    style.anchor = anchor;
    style.bold = font.bold;
    page().text({x, y + base_line * font.size}, text, style);
  }

  // Lines one below the other, continued on the next page when this one is full.
  void lines(std::span<const std::string> texts, double x, const Font& font, std::uint32_t colour) {
    for (const std::string& each : texts) {
      need(font.height());
      put(each, x, y_, font, colour);
      y_ += font.height();
    }
  }

  void add(const Heading& heading) {
    y_ += 12.0;
    lines(wrapped(heading.text, content_width, {12.0, true}), margin, {12.0, true}, ink);
    y_ += 3.0;
  }

  void add(const Paragraph& paragraph) {
    lines(wrapped(paragraph.text, content_width, {}), margin, {}, muted_ink);
    y_ += 5.0;
  }

  void add(const Verdict& verdict) {
    constexpr double bar = 5.0, inset = 14.0, bullet = 10.0;
    const Font strong{13.0, true};
    const double width = content_width - inset - 10.0;
    const std::vector<std::string> headline = wrapped(verdict.headline, width, strong);
    double height = 16.0 + static_cast<double>(headline.size()) * strong.height();
    std::vector<std::vector<std::string>> findings;
    for (const Verdict::Finding& each : verdict.findings) {
      findings.push_back(wrapped(each.sentence, width - bullet, {}));
      height += static_cast<double>(findings.back().size()) * Font().height() + 2.0;
    }
    need(height);
    const double top = y_, shown = std::min(height, content_bottom - top);
    page().fill(Path::rectangle(margin, top, content_width, shown), back_of(verdict.grade));
    page().fill(Path::rectangle(margin, top, bar, shown), ink_of(verdict.grade));
    y_ += 8.0;
    lines(headline, margin + inset, strong, ink_of(verdict.grade));
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const std::optional<training::Grade> grade = verdict.findings[i].grade;
      const std::uint32_t colour = grade && *grade != training::Grade::pass ? ink_of(*grade) : ink;
      y_ += 2.0;
      need(Font().height());
      page().fill(Path::circle({margin + inset + 3.0, y_ + 0.7 * text_size}, 1.4), colour);
      lines(findings[i], margin + inset + bullet, {}, colour);
    }
    y_ += 16.0;
  }

  void add(const Tiles& tiles) {
    constexpr int columns = 5;
    constexpr double gap = 6.0, height = 54.0, width = (content_width - (columns - 1) * gap) / columns;
    for (std::size_t i = 0; i < tiles.tiles.size(); ++i) {
      const auto column = static_cast<int>(i % columns);
      if (column == 0) {
        if (i > 0) y_ += height + gap;
        need(height);
      }
      const Tiles::Tile& tile = tiles.tiles[i];
      const double x = margin + column * (width + gap);
      page().fill(Path::rectangle(x, y_, width, height), card);
      if (tile.grade) page().fill(Path::rectangle(x, y_, 3.0, height), ink_of(*tile.grade));
      put(tile.value, x + 8.0, y_ + 4.0, {12.0, true}, ink);
      const Font font{7.0, false};
      const std::vector<std::string> title = wrapped(tile.title, width - 14.0, font);
      for (std::size_t line = 0; line < std::min<std::size_t>(title.size(), 3); ++line)
        put(title[line], x + 8.0, y_ + 21.0 + static_cast<double>(line) * font.height(), font, muted_ink);
    }
    if (!tiles.tiles.empty()) y_ += height + 8.0;
  }

  void table_head(const Table& table, const std::vector<double>& widths) {
    const Font font{small_size, true};
    std::vector<std::vector<std::string>> titles;
    std::size_t most = 1;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      titles.push_back(wrapped(table.columns[i].title, widths[i] - 2.0 * cell_padding, font));
      most = std::max(most, titles.back().size());
    }
    const double height = static_cast<double>(most) * font.height() + 4.0;
    double x = margin;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      cell_text(titles[i], x, widths[i], font, muted_ink, table.columns[i].is_number);
      x += widths[i];
    }
    y_ += height;
    page().fill(Path::rectangle(margin, y_ - 1.0, content_width, 0.8), muted_ink);
  }

  void cell_text(const std::vector<std::string>& texts, double x, double width, const Font& font,
                 std::uint32_t colour, bool is_number) {
    for (std::size_t line = 0; line < texts.size(); ++line) {
      put(texts[line], is_number ? x + width - cell_padding : x + cell_padding,
          y_ + 2.0 + static_cast<double>(line) * font.height(), font, colour,
          is_number ? TextAnchor::end : TextAnchor::start);
    }
  }

  void add(const Table& table) {
    constexpr double swatch = 7.0, beside_swatch = 12.0;
    const std::vector<double> widths = column_widths(table);
    std::vector<std::vector<std::vector<std::string>>> rows;
    std::vector<double> heights;
    double whole = 0.0;
    for (const std::vector<Table::Cell>& row : table.rows) {
      rows.emplace_back();
      std::size_t most = 1;
      for (std::size_t i = 0; i < row.size(); ++i) {
        const double room = widths[i] - 2.0 * cell_padding - (row[i].swatch ? beside_swatch : 0.0);
        rows.back().push_back(wrapped(row[i].text, room, {}));
        most = std::max(most, rows.back().back().size());
      }
      heights.push_back(static_cast<double>(most) * Font().height() + 4.0);
      whole += heights.back();
    }
    constexpr double head = 34.0;
    need(table.stays_whole ? whole + head : head + (heights.empty() ? 0.0 : heights.front()));
    table_head(table, widths);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (y_ + heights[r] > content_bottom) {
        begin_page();
        table_head(table, widths);
      }
      double x = margin;
      for (std::size_t i = 0; i < rows[r].size(); ++i) {
        const Table::Cell& cell = table.rows[r][i];
        const bool is_marked = cell.grade && *cell.grade != training::Grade::pass;
        const std::uint32_t colour = is_marked ? ink_of(*cell.grade) : cell.is_muted ? muted_ink : ink;
        if (cell.swatch) page().fill(Path::rectangle(x + cell_padding, y_ + 4.5, swatch, swatch), *cell.swatch);
        const double moved = cell.swatch ? beside_swatch : 0.0;
        cell_text(rows[r][i], x + moved, widths[i] - moved, {text_size, is_marked}, colour,
                  table.columns[i].is_number);
        x += widths[i];
      }
      y_ += heights[r];
      page().fill(Path::rectangle(margin, y_ - 0.5, content_width, 0.5), rule);
    }
    y_ += 8.0;
  }

  void add(const Facts& facts) {
    constexpr double name_width = 130.0;
    for (const Facts::Fact& each : facts.facts) {
      if (!each.folded.empty()) continue;
      const std::vector<std::string> name = wrapped(each.name, name_width - 10.0, {small_size, true});
      const std::vector<std::string> value = wrapped(each.value, content_width - name_width, {});
      need(Font().height() + 4.0);
      put(name.front(), margin, y_, {small_size, true}, muted_ink);
      lines(value, margin + name_width, {}, ink);
      y_ += 3.0;
    }
  }

  void add(const Picture& figure) {
    const double scale = scale_of(figure.picture);
    const double width = scale * figure.picture.width(), height = scale * figure.picture.height();
    need(height);
    page().place(figure.picture, margin + 0.5 * (content_width - width), y_, scale);
    y_ += height + 8.0;
  }

  void number_pages(const std::string& title) {
    const std::string short_title = wrapped(title, 0.7 * content_width, {7.5, false}).front();
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      TextStyle style;
      style.size = 7.5;
      style.ink = muted_ink;
      pages_[i].text({margin, page_height - margin + 4.0}, short_title, style);
      style.anchor = TextAnchor::end;
      pages_[i].text({page_width - margin, page_height - margin + 4.0},
                     fmt::format("page {} of {}", i + 1, pages_.size()), style);
    }
  }

  std::vector<Canvas> pages_;
  double y_ = margin;  // where the next block begins on the last page
};

}  // namespace

std::string pdf_of(const Document& document) {
  return PageLayout().write(document);
}

}  // namespace bodkin::report
