#include "report/document_html.h"

#include <iterator>

#include "report/report_style.h"
#include <fmt/format.h>

#include "imaging/markup.h"

namespace bodkin::report {

namespace {

using imaging::escape_markup;

class HtmlWriter {
 public:
  std::string write(const Document& document) {
    const std::string title = escape_markup(document.title);
    emit(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{}</title>\n"
        "<style>{}</style>\n</head>\n<body>\n<main>\n<h1>{}</h1>\n<p class=\"under\">{}</p>\n",
        title, report_style(), title, escape_markup(document.subtitle));
    for (const Block& block : document.blocks) std::visit([this](const auto& each) { add(each); }, block);
    emit("</main>\n</body>\n</html>\n");
    return std::move(html_);
  }

 private:
  template <typename... Arguments>
  void emit(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(html_), text, std::forward<Arguments>(arguments)...);
  }

  // " name" of a grade, to follow other classes; empty without one.
  static std::string class_of(const std::optional<training::Grade>& grade) {
    return grade ? fmt::format(" {}", training::name_of(*grade)) : std::string();
  }

  void add(const Heading& heading) { emit("<h2>{}</h2>\n", escape_markup(heading.text)); }

  void add(const Paragraph& paragraph) {
    emit("<p class=\"{}\">{}</p>\n", paragraph.is_empty_section ? "none" : "under", escape_markup(paragraph.text));
  }

  void add(const Verdict& verdict) {
    emit("<div class=\"verdict {}\"><strong>{}</strong>\n<ul>\n", training::name_of(verdict.grade),
         escape_markup(verdict.headline));
    for (const Verdict::Finding& each : verdict.findings) {
      emit("<li{}>{}</li>\n", each.grade ? fmt::format(" class=\"{}\"", training::name_of(*each.grade)) : "",
           escape_markup(each.sentence));
    }
    emit("</ul>\n</div>\n");
  }

  void add(const Tiles& tiles) {
    emit("<div class=\"tiles\">\n");
    for (const Tiles::Tile& each : tiles.tiles) {
      emit("<div class=\"tile{}\"><b>{}</b><span>{}</span></div>\n", class_of(each.grade), escape_markup(each.value),
           escape_markup(each.title));
    }
    emit("</div>\n");
  }

  void add(const Table& table) {
    emit("<table{}>\n<thead><tr>", table.stays_whole ? " class=\"whole\"" : "");
    for (const Table::Column& each : table.columns)
      emit("<th{}>{}</th>", each.is_number ? " class=\"n\"" : "", escape_markup(each.title));
    emit("</tr></thead>\n<tbody>\n");
    for (const std::vector<Table::Cell>& row : table.rows) {
      emit("<tr>");
      for (std::size_t i = 0; i < row.size(); ++i) {
        const Table::Cell& cell = row[i];
        const std::string classes = (table.columns[i].is_number ? "n"
                                     : cell.is_muted            ? "none"
                                                                : "") +
                                    class_of(cell.grade);
        emit("<td{}>", classes.empty() ? "" : fmt::format(" class=\"{}\"", classes));
        if (cell.swatch) emit("<i class=\"swatch\" style=\"background:{}\"></i>", imaging::css_colour(*cell.swatch));
        emit("{}</td>", escape_markup(cell.text));
      }
      emit("</tr>\n");
    }
    emit("</tbody>\n</table>\n");
  }

  void add(const Facts& facts) {
    emit("<table class=\"whole\">\n");
    for (const Facts::Fact& each : facts.facts) {
      emit("<tr><th>{}</th><td class=\"long\">", escape_markup(each.name));
      if (each.folded.empty()) {
        emit("{}", escape_markup(each.value));
      } else {
        emit("<details><summary>{}</summary><pre>{}</pre></details>", escape_markup(each.value),
             escape_markup(each.folded));
      }
      emit("</td></tr>\n");
    }
    emit("</table>\n");
  }

  void add(const Picture& figure) {
    emit("<figure{}><img alt=\"{}\" src=\"{}\"/></figure>\n", figure.is_dark ? " class=\"dark\"" : "",
         escape_markup(figure.description), imaging::data_uri("image/svg+xml", figure.picture.svg()));
  }

  std::string html_;
};

}  // namespace

std::string html_of(const Document& document) {
  return HtmlWriter().write(document);
}

}  // namespace bodkin::report
