#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/geometry.h"
#include "imaging/image_rgb.h"

namespace bodkin::imaging {

// Every image of the program is drawn on a canvas: slices, meshes, plots and the screen of the ultrasound machine.
// Lengths are px of the image, from its upper left corner to the right and down.

// A colour, 0xRRGGBB, and its opacity, 0 to 1.
struct Ink {
  std::uint32_t colour = 0;
  double opacity = 1.0;

  Ink(std::uint32_t rgb_colour = 0, double covers = 1.0) : colour(rgb_colour), opacity(covers) {}  // NOLINT: implicit
};

struct LineStyle {
  Ink ink;
  double width = 1.0;
  std::vector<double> dash = {};  // lengths of strokes and gaps, alternating, above 0; empty: a solid line
};

enum class TextAnchor { start, middle, end };

struct TextStyle {
  double size = 12.0;  // px
  Ink ink;
  TextAnchor anchor = TextAnchor::start;
  bool bold = false;
  double angle = 0.0;  // degrees, counter-clockwise
  bool halo = false;   // a dark border, for text on an image
};

// Lines, polygons and circles that are filled or stroked together.
class Path {
 public:
  static Path segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  static Path polyline(const std::vector<Eigen::Vector2d>& points);
  static Path polygon(const std::vector<Eigen::Vector2d>& points);
  static Path rectangle(double x, double y, double width, double height);
  static Path circle(const Eigen::Vector2d& centre, double radius);
  // An upright cross that reaches `half` to each side.
  static Path cross(const Eigen::Vector2d& centre, double half);

  void move_to(const Eigen::Vector2d& point) { parts_.push_back({Kind::move, point}); }
  void line_to(const Eigen::Vector2d& point) { parts_.push_back({Kind::line, point}); }
  void close() { parts_.push_back({Kind::close}); }
  void add(const Path& other) { parts_.insert(parts_.end(), other.parts_.begin(), other.parts_.end()); }

  enum class Kind : std::uint8_t { move, line, close, circle };
  struct Part {
    Kind kind;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    double radius = 0.0;
  };
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_;
};

// Drawn elements are stored as shapes, the last on top, and exported as an SVG document, in which text stays text and
// lines are sharp at any size, or as pixels. Both are the same for the same shapes. A shape with a coordinate that is
// not finite is left out.
class Canvas {
 public:
  Canvas(double width, double height) : width_(width), height_(height) {}

  double width() const { return width_; }
  double height() const { return height_; }
  void set_size(double width, double height);

  void fill_all(const Ink& ink) { fill(Path::rectangle(0.0, 0.0, width_, height_), ink); }
  void fill(Path path, const Ink& ink);
  void stroke(Path path, LineStyle style);
  // `at`: on the base line; the style's anchor says which end of the text is there.
  void text(const Eigen::Vector2d& at, std::string_view text, const TextStyle& style);
  // The image, stretched smoothly to `width` x `height`, with its upper left corner at (x, y).
  void image(ImageRgb image, double x, double y, double width, double height);
  // All of `inner`, `scale` times as large, with its upper left corner at (x, y), clipped to its size.
  void place(Canvas inner, double x, double y, double scale = 1.0);

  // An SVG document.
  std::string svg() const;
  // The image with `zoom` pixels per px; black where nothing is drawn. Throws SystemError when memory is short or the
  // image has more than 32767 pixels on a side.
  ImageRgb pixels(double zoom) const;
  // As pixels(), as the bytes of a PNG file.
  std::string png(double zoom) const;
  // Draws the shapes over an image, a pixel per px.
  void draw_over(ImageRgb& image) const;

 private:
  struct Filled {
    Path path;
    Ink ink;
  };
  struct Stroked {
    Path path;
    LineStyle style;
  };
  struct Written {
    Eigen::Vector2d at;
    std::string text;
    TextStyle style;
  };
  struct Pasted {
    ImageRgb image;
    double x, y, width, height;
  };
  struct Placed {
    std::shared_ptr<const Canvas> inner;
    double x, y, scale;
  };
  using Shape = std::variant<Filled, Stroked, Written, Pasted, Placed>;
  friend class SvgWriter;
  friend class CairoPainter;

  double width_, height_;
  std::vector<Shape> shapes_;
};

// The canvases as the pages of a PDF file, 1 px = 1/72 inch, each of its own size. Text stays text. Throws
// SystemError when memory is short.
std::string pdf(std::span<const Canvas> pages, const std::string& title);

// Width in px of a text in the font of the images, DejaVu Sans.
double text_width(std::string_view text, double size, bool bold = false);

}  // namespace bodkin::imaging
