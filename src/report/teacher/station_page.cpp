#include "report/teacher/station_page.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string_view>

#include "report/report_style.h"
#include <fmt/format.h>

#include "imaging/markup.h"
#include "imaging/png_file.h"

namespace bodkin::report {

namespace {

using imaging::escape_markup;

constexpr const char* stations_style =
    "main{max-width:1500px}.stations{display:flex;flex-wrap:wrap;gap:16px}.station{border:1px solid "
    "#8886;border-radius:8px;padding:12px;"
    "width:340px}.station h2{margin:0 0 4px}.station img{width:100%;background:#000;border-radius:6px}.station svg{"
    "width:100%;height:90px;background:#fff;border-radius:6px}.station "
    "svg.side{height:auto;background:none;font-size:9px}"
    ".side text{fill:currentColor}.side .target{stroke:#0b7a75;stroke-width:2;stroke-dasharray:4 3}"
    ".side .needle{stroke:#222;stroke-width:3}.lost{color:#b3261e}";

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - at);
    for (std::size_t i = 0; i < 3; ++i)
      group = (group << 8U) | (i < left ? static_cast<std::uint8_t>(bytes[at + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= left ? digits[(group >> (18U - 6U * i)) & 63U] : '=';
  }
  return text;
}

std::string picture_of(const StationCard& card) {
  const auto width = static_cast<std::size_t>(std::max(card.picture_width, 0));
  const auto height = static_cast<std::size_t>(std::max(card.picture_height, 0));
  if (card.picture.empty() || card.picture.size() != width * height) return {};
  imaging::ImageRgb image;
  image.width = card.picture_width;
  image.height = card.picture_height;
  for (const std::uint8_t grey : card.picture) image.pixels.push_back({grey, grey, grey});
  return fmt::format("<img alt=\"ultrasound\" src=\"data:image/png;base64,{}\">\n",
                     base64(imaging::encode_png(image)));
}

struct Label {
  double left = 0.0, right = 0.0;  // px
  std::string text;
};

// Names over adjacent bands; wider bands are named first. A band without room gets no name.
std::vector<Label> labels_of(const std::vector<StationCardLayer>& layers, const std::vector<double>& borders) {
  constexpr double letter = 4.8;  // px
  std::vector<std::size_t> order(layers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return borders[a + 1] - borders[a] > borders[b + 1] - borders[b];
  });
  std::vector<Label> labels;
  for (const std::size_t i : order) {
    const double length = letter * static_cast<double>(layers[i].tissue.size());
    const double left = std::max(0.0, std::min(borders[i], borders.back() - length));
    const bool is_free = std::none_of(labels.begin(), labels.end(), [&](const Label& other) {
      return left < other.right && other.left < left + length;
    });
    if (is_free) labels.push_back({left, left + length, layers[i].tissue});
  }
  return labels;
}

// Side view of the needle among the tissues of the planned path: the skin on the left, the target as a line.
std::string side_view_of(const StationCard& card) {
  if (card.layers.empty()) return {};
  constexpr double width = 320.0, height = 64.0, air = 24.0, beyond = 15.0;  // px; mm behind the target
  constexpr double middle = 40.0;                                            // px
  const double reach = std::max({card.path + beyond, card.layers.back().from + 1.0, card.depth});
  const auto at = [&](double depth) { return air + (width - air) * std::clamp(depth / reach, 0.0, 1.0); };
  std::vector<double> borders;
  for (const StationCardLayer& layer : card.layers) borders.push_back(at(layer.from));
  borders.push_back(width);
  std::string drawn;
  for (std::size_t i = 0; i < card.layers.size(); ++i) {
    const StationCardLayer& layer = card.layers[i];
    fmt::format_to(std::back_inserter(drawn),
                   "<rect x=\"{:.1f}\" y=\"16\" width=\"{:.1f}\" height=\"48\" fill=\"{}\"><title>{}</title></rect>",
                   borders[i], borders[i + 1] - borders[i], escape_markup(layer.colour), escape_markup(layer.tissue));
  }
  for (const Label& label : labels_of(card.layers, borders))
    fmt::format_to(std::back_inserter(drawn), "<text x=\"{:.1f}\" y=\"11\">{}</text>", label.left,
                   escape_markup(label.text));
  if (card.path > 0.0)
    fmt::format_to(std::back_inserter(drawn), "<path class=\"target\" d=\"M{0:.1f} 16V64\"/>", at(card.path));
  const double tip = card.depth > 0.0 ? at(card.depth) : air;
  fmt::format_to(std::back_inserter(drawn), "<path class=\"needle\" d=\"M0 {0:g}H{1:.1f}\"/>", middle, tip);
  return fmt::format(
      "<svg class=\"side\" viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"the needle {:.1f} mm deep, the target "
      "at "
      "{:.0f} mm\">{}</svg>\n",
      width, height, std::max(card.depth, 0.0), card.path, drawn);
}

// The force over the last seconds.
std::string curve_of(const StationCard& card) {
  if (card.forces.size() < 2) return {};
  constexpr double width = 320.0, height = 90.0, margin = 4.0, least_force = 2.0;  // N
  const double first = card.forces.front().first, last = card.forces.back().first;
  double most = least_force;
  for (const auto& [time, force] : card.forces) most = std::max(most, force);
  std::string points;
  for (const auto& [time, force] : card.forces) {
    const double x = margin + (width - 2.0 * margin) * (last > first ? (time - first) / (last - first) : 0.0);
    const double y = height - margin - (height - 2.0 * margin) * std::clamp(force / most, 0.0, 1.0);
    fmt::format_to(std::back_inserter(points), "{:.1f},{:.1f} ", x, y);
  }
  return fmt::format(
      "<svg viewBox=\"0 0 {:g} {:g}\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\"force over {:.0f} s, at "
      "most "
      "{:.2f} N\"><polyline fill=\"none\" stroke=\"#0b7a75\" stroke-width=\"2\" points=\"{}\"/></svg>\n",
      width, height, last - first, most, points);
}

std::string card_of(const StationCard& card) {
  std::string html = fmt::format("<div class=\"station\"><h2>{}</h2>\n", escape_markup(card.place));
  if (!card.trouble.empty())
    return html + fmt::format("<p class=\"lost\">not connected: {}</p></div>\n", escape_markup(card.trouble));
  if (!card.runs) return html + "<p>waits for a procedure</p></div>\n";
  html +=
      fmt::format("<p>{}, {}<br>step: <b>{}</b><br>{:.1f} mm deep in {}, <b>{:.2f} N</b><br>last: {}; force {}</p>\n",
                  escape_markup(card.patient), escape_markup(card.procedure),
                  card.step.empty() ? "none yet" : escape_markup(card.step), std::max(card.depth, 0.0),
                  escape_markup(card.tissue), card.force, card.event.empty() ? "-" : escape_markup(card.event),
                  escape_markup(card.guard));
  return html + side_view_of(card) + picture_of(card) + curve_of(card) + "</div>\n";
}

}  // namespace

std::string stations_page(const std::vector<StationCard>& cards) {
  std::string all;
  for (const StationCard& card : cards) all += card_of(card);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta http-equiv=\"refresh\" "
      "content=\"1\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>Stations</title>\n<style>\n{}{}"
      "</style>\n</head>\n<body>\n<main>\n<p class=\"under\"><a href=\"/\">All "
      "trainees</a></p>\n<h1>Stations</h1>\n<p "
      "class=\"under\">{} stations, {} connected; updated every second</p>\n<div "
      "class=\"stations\">\n{}</div>\n</main>\n</body>\n</"
      "html>\n",
      report_style(), stations_style, cards.size(),
      std::count_if(cards.begin(), cards.end(), [](const StationCard& card) { return card.trouble.empty(); }),
      all.empty() ? "<p>no station was named; start 'bodkin teacher --station HOST'</p>\n" : all);
}

}  // namespace bodkin::report
