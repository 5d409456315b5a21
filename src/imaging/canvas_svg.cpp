// A canvas as an SVG document.
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "imaging/canvas.h"
#include "imaging/markup.h"
#include "imaging/png_file.h"

namespace bodkin::imaging {

namespace {

// With at most two digits after the point, without trailing zeros.
std::string px(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string colour_of(const char* what, const Ink& ink) {
  std::string text = fmt::format(" {}=\"{}\"", what, css_colour(ink.colour));
  if (ink.opacity < 1.0) text += fmt::format(" {}-opacity=\"{}\"", what, px(ink.opacity));
  return text;
}

std::string data_of(const Path& path) {
  std::string data;
  for (const Path::Part& part : path.parts()) {
    const std::string x = px(part.at.x()), y = px(part.at.y()), r = px(part.radius);
    switch (part.kind) {
      case Path::Kind::move:
        data += fmt::format("M{} {}", x, y);
        break;
      case Path::Kind::line:
        data += fmt::format("L{} {}", x, y);
        break;
      case Path::Kind::close:
        data += "Z";
        break;
      case Path::Kind::circle:
        fmt::format_to(std::back_inserter(data), "M{} {}a{} {} 0 1 0 {} 0a{} {} 0 1 0 -{} 0Z",
                       px(part.at.x() - part.radius), y, r, r, px(2.0 * part.radius), r, r, px(2.0 * part.radius));
    }
  }
  return data;
}

}  // namespace

class SvgWriter {
 public:
  std::string write(const Canvas& canvas) {
    emit(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n",
        canvas.width_, canvas.height_);
    shapes(canvas);
    emit("</svg>\n");
    return std::move(svg_);
  }

 private:
  template <typename... Arguments>
  void emit(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(svg_), text, std::forward<Arguments>(arguments)...);
  }

  void shapes(const Canvas& canvas) {
    for (const Canvas::Shape& shape : canvas.shapes_) std::visit([this](const auto& one) { add(one); }, shape);
  }

  void add(const Canvas::Filled& shape) {
    emit("<path d=\"{}\"{}/>\n", data_of(shape.path), colour_of("fill", shape.ink));
  }

  void add(const Canvas::Stroked& shape) {
    const LineStyle& style = shape.style;
    std::string dash;
    for (const double length : style.dash) dash += fmt::format("{}{}", dash.empty() ? "" : " ", px(length));
    emit("<path d=\"{}\" fill=\"none\"{} stroke-width=\"{}\" stroke-linejoin=\"round\"{}/>\n", data_of(shape.path),
         colour_of("stroke", style.ink), px(style.width),
         dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash));
  }

  void add(const Canvas::Written& shape) {
    const TextStyle& style = shape.style;
    const std::string x = px(shape.at.x()), y = px(shape.at.y());
    std::string look = colour_of("fill", style.ink);
    if (style.anchor == TextAnchor::middle) look += " text-anchor=\"middle\"";
    if (style.anchor == TextAnchor::end) look += " text-anchor=\"end\"";
    if (style.bold) look += " font-weight=\"bold\"";
    if (style.angle != 0.0) look += fmt::format(" transform=\"rotate({} {} {})\"", px(-style.angle), x, y);
    if (style.halo) {
      look +=
          " stroke=\"#000\" stroke-width=\"3\" stroke-opacity=\"0.7\" paint-order=\"stroke\" "
          "stroke-linejoin=\"round\"";
    }
    emit("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}>{}</text>\n", x, y, px(style.size), look,
         escape_markup(shape.text));
  }

  void add(const Canvas::Pasted& shape) {
    emit("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" xlink:href=\"{}\"/>\n",
         px(shape.x), px(shape.y), px(shape.width), px(shape.height), data_uri("image/png", encode_png(shape.image)));
  }

  void add(const Canvas::Placed& shape) {
    const double width = shape.inner->width(), height = shape.inner->height();
    emit("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}>\n", px(shape.x), px(shape.y), px(shape.scale * width),
         px(shape.scale * height),
         shape.scale == 1.0 ? "" : fmt::format(" viewBox=\"0 0 {} {}\"", px(width), px(height)));
    shapes(*shape.inner);
    emit("</svg>\n");
  }

  std::string svg_;
};

std::string Canvas::svg() const {
  return SvgWriter().write(*this);
}

}  // namespace bodkin::imaging
