#include "report/experiment_page.h"

#include <cmath>
#include <iterator>

#include "report/report_style.h"
#include <fmt/format.h>

#include "imaging/markup.h"

namespace bodkin::report {

namespace {

constexpr int digits = 4;  // of a number, and as many that differ from zero

constexpr const char* style = R"css(
figure { margin: 10px 0; }
dl { margin: 10px 0; } dt { font-weight: 600; } dd { margin: 0 0 8px; }
td.no { color: var(--poor); }
)css";

std::string number(double value) {
  return fmt::format("{:.{}g}", std::abs(value) < 5e-5 ? 0.0 : value, digits);
}

// Text without characters special to Markdown or HTML.
std::string in_markdown(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|#&!").find(c) != std::string_view::npos) safe += '\\';
    safe += c;
  }
  return safe;
}

const char* aggregation_words(io::Aggregation aggregation) {
  switch (aggregation) {
    case io::Aggregation::mean:
      return "mean";
    case io::Aggregation::highest:
      return "highest";
    case io::Aggregation::lowest:
      return "lowest";
    case io::Aggregation::first:
      return "first";
    case io::Aggregation::last:
      return "last";
  }
  return "";
}

// The non-empty parts of a caption, in their order.
std::vector<std::pair<const char*, std::string>> parts(const io::ExperimentCaption& caption) {
  std::vector<std::pair<const char*, std::string>> all = {{"Reproduces", caption.reproduces},
                                                          {"Parameters", caption.parameters},
                                                          {"Agrees", caption.agrees},
                                                          {"Differs", caption.differs}};
  std::erase_if(all, [](const auto& part) { return part.second.empty(); });
  return all;
}

std::string compared(const study::PublishedComparison& comparison) {
  return fmt::format("{} ({})", comparison.published.what, aggregation_words(comparison.published.aggregation));
}

}  // namespace

std::string with_unit(double value, io::Quantity quantity) {
  const std::string_view label = io::quantity_names[static_cast<std::size_t>(quantity)].label;
  return fmt::format("{} {}", number(value), label.substr(label.find(", ") + 2));
}

std::string figures_html(const std::vector<Figure>& figures) {
  std::string html;
  const auto emit = [&html]<typename... Arguments>(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(html), text, std::forward<Arguments>(arguments)...);
  };
  emit(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"/>\n<title>Published experiments, played again</title>\n"
      "<style>{}{}</style>\n</head>\n<body>\n<main>\n<h1>Published experiments, played again</h1>\n",
      report_style(), style);
  emit(
      "<p class=\"under\">Each needle below moved through Bodkin's haptic tick. Dashed lines are the expected "
      "numbers of the tables.</p>\n");
  for (const Figure& figure : figures) {
    const io::Experiment& experiment = figure.experiment;
    emit("<h2 id=\"{0}\">{1}</h2>\n", experiment.name, imaging::escape_markup(experiment.title));
    if (!experiment.paper.empty()) emit("<p class=\"under\">{}</p>\n", imaging::escape_markup(experiment.paper));
    emit("<figure><img src=\"{0}.svg\" alt=\"{1}\"/></figure>\n<dl>\n", experiment.name,
         imaging::escape_markup(experiment.caption.reproduces));
    for (const auto& [title, text] : parts(experiment.caption))
      emit("<dt>{}</dt><dd>{}</dd>\n", title, imaging::escape_markup(text));
    emit("</dl>\n");
    if (!figure.run.comparisons.empty()) {
      emit(
          "<table>\n<tr><th>what</th><th>from</th><th class=\"n\">expected</th><th class=\"n\">found</th>"
          "<th></th></tr>\n");
      for (const study::PublishedComparison& comparison : figure.run.comparisons) {
        const io::PublishedValue& published = comparison.published;
        emit(
            "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"{}\">{}</td></tr>\n",
            imaging::escape_markup(compared(comparison)), imaging::escape_markup(published.source),
            with_unit(published.value, published.quantity), with_unit(comparison.found, published.quantity),
            comparison.agrees ? "yes" : "no", comparison.agrees ? "agrees" : "differs");
      }
      emit("</table>\n");
    }
    emit("<p class=\"under\"><a href=\"{0}.csv\">{0}.csv</a></p>\n", experiment.name);
  }
  emit("</main>\n</body>\n</html>\n");
  return html;
}

std::string figures_markdown(const std::vector<Figure>& figures) {
  std::string text =
      "# Published experiments, played again\n\n"
      "Each needle below moved through Bodkin's haptic tick; dashed lines are the expected numbers of the tables. "
      "The page and "
      "its "
      "pictures\nare written by `bodkin figures` from the files in `share/bodkin/experiments`.\n";
  const auto emit = [&text]<typename... Arguments>(fmt::format_string<Arguments...> part, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text), part, std::forward<Arguments>(arguments)...);
  };
  for (const Figure& figure : figures) {
    const io::Experiment& experiment = figure.experiment;
    emit("\n## {}\n\n", in_markdown(experiment.title));
    if (!experiment.paper.empty()) emit("{}\n\n", in_markdown(experiment.paper));
    emit("![{0}]({1}.svg)\n\n", in_markdown(experiment.title), experiment.name);
    for (const auto& [title, part] : parts(experiment.caption)) emit("**{}.** {}\n\n", title, in_markdown(part));
    if (figure.run.comparisons.empty()) continue;
    emit("| what | from | expected | found | |\n|---|---|---|---|---|\n");
    for (const study::PublishedComparison& comparison : figure.run.comparisons) {
      const io::PublishedValue& published = comparison.published;
      emit("| {} | {} | {} | {} | {} |\n", in_markdown(compared(comparison)), in_markdown(published.source),
           with_unit(published.value, published.quantity), with_unit(comparison.found, published.quantity),
           comparison.agrees ? "agrees" : "differs");
    }
  }
  return text;
}

}  // namespace bodkin::report
