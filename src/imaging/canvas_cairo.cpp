// A canvas as pixels, and as a page of a PDF file, by cairo.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>

#include "core/error.h"
#include "imaging/canvas.h"
#include "imaging/markup.h"

#ifdef BODKIN_ADDRESS_SANITIZER
// fontconfig, which finds the font for cairo, frees nothing at the end of a program.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier): the sanitizer's name
  return "leak:libfontconfig";
}
extern "C" const char* __lsan_default_options() {  // NOLINT(bugprone-reserved-identifier)
  return "print_suppressions=0";
}
#endif

namespace bodkin::imaging {

namespace {

constexpr double halo_width = 3.0;  // px
constexpr double halo_opacity = 0.7;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void require_success(cairo_status_t status, int width, int height) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw SystemError(fmt::format("a picture of {} x {} pixels could not be drawn: {}", width, height,
                                cairo_status_to_string(status)));
}

Surface surface_of(int width, int height) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy);
  require_success(cairo_surface_status(surface.get()), width, height);
  return surface;
}

// cairo's pixels are words of 0x00RRGGBB.
Surface surface_of(const ImageRgb& image) {
  Surface surface = surface_of(image.width, image.height);
  unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < image.height; ++row) {
    unsigned char* to = bytes + std::ptrdiff_t{row} * stride;
    for (int column = 0; column < image.width; ++column, to += 4) {
      const Rgb& pixel = image.at(column, row);
      const std::uint32_t word = std::uint32_t{pixel.red} << 16 | std::uint32_t{pixel.green} << 8 | pixel.blue;
      std::memcpy(to, &word, 4);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

void copy_pixels(cairo_surface_t* surface, ImageRgb& image) {
  cairo_surface_flush(surface);
  const unsigned char* const bytes = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int row = 0; row < image.height; ++row) {
    const unsigned char* from = bytes + std::ptrdiff_t{row} * stride;
    for (int column = 0; column < image.width; ++column, from += 4) {
      std::uint32_t word = 0;
      std::memcpy(&word, from, 4);
      image.at(column, row) = rgb(word);
    }
  }
}

void choose_font(cairo_t* context, double size, bool bold) {
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
}

// Letter widths proportional to the size, so that text takes the same space in pixels as in SVG.
void set_letter_shapes(cairo_t* context) {
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

double advance_of(cairo_t* context, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

}  // namespace

class CairoPainter {
 public:
  CairoPainter(cairo_surface_t* surface, double zoom) : context_(cairo_create(surface), cairo_destroy) {
    cairo_scale(context(), zoom, zoom);
    cairo_set_line_join(context(), CAIRO_LINE_JOIN_ROUND);
    set_letter_shapes(context());
  }

  // Draws everything on the canvas; returns cairo's status.
  cairo_status_t paint(const Canvas& canvas) {
    shapes(canvas);
    return cairo_status(context());
  }

 private:
  cairo_t* context() const { return context_.get(); }

  void shapes(const Canvas& canvas) {
    for (const Canvas::Shape& shape : canvas.shapes_) std::visit([this](const auto& one) { add(one); }, shape);
  }

  void use(const Ink& ink) {
    const Rgb colour = rgb(ink.colour);
    cairo_set_source_rgba(context(), colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, ink.opacity);
  }

  void trace(const Path& path) {
    cairo_new_path(context());
    for (const Path::Part& part : path.parts()) {
      switch (part.kind) {
        case Path::Kind::move:
          cairo_move_to(context(), part.at.x(), part.at.y());
          break;
        case Path::Kind::line:
          cairo_line_to(context(), part.at.x(), part.at.y());
          break;
        case Path::Kind::close:
          cairo_close_path(context());
          break;
        case Path::Kind::circle:
          cairo_new_sub_path(context());
          cairo_arc(context(), part.at.x(), part.at.y(), part.radius, 0.0, 2.0 * std::numbers::pi);
          cairo_close_path(context());
      }
    }
  }

  void add(const Canvas::Filled& shape) {
    trace(shape.path);
    use(shape.ink);
    cairo_fill(context());
  }

  void add(const Canvas::Stroked& shape) {
    const LineStyle& style = shape.style;
    trace(shape.path);
    use(style.ink);
    cairo_set_line_width(context(), style.width);
    cairo_set_dash(context(), style.dash.data(), static_cast<int>(style.dash.size()), 0.0);
    cairo_stroke(context());
  }

  void add(const Canvas::Written& shape) {
    const TextStyle& style = shape.style;
    cairo_save(context());
    choose_font(context(), style.size, style.bold);
    cairo_translate(context(), shape.at.x(), shape.at.y());
    cairo_rotate(context(), -style.angle * std::numbers::pi / 180.0);
    const double share = style.anchor == TextAnchor::start ? 0.0 : style.anchor == TextAnchor::middle ? 0.5 : 1.0;
    const double begin = share == 0.0 ? 0.0 : -share * advance_of(context(), shape.text);
    if (style.halo) {
      cairo_move_to(context(), begin, 0.0);
      cairo_text_path(context(), shape.text.c_str());
      use({0x000000, halo_opacity});
      cairo_set_line_width(context(), halo_width);
      cairo_set_dash(context(), nullptr, 0, 0.0);
      cairo_stroke(context());
    }
    use(style.ink);
    cairo_move_to(context(), begin, 0.0);
    cairo_show_text(context(), shape.text.c_str());
    cairo_restore(context());
  }

  void add(const Canvas::Pasted& shape) {
    const Surface image = surface_of(shape.image);
    cairo_save(context());
    cairo_rectangle(context(), shape.x, shape.y, shape.width, shape.height);
    cairo_clip(context());
    cairo_translate(context(), shape.x, shape.y);
    cairo_scale(context(), shape.width / shape.image.width, shape.height / shape.image.height);
    cairo_set_source_surface(context(), image.get(), 0.0, 0.0);
    cairo_pattern_set_extend(cairo_get_source(context()), CAIRO_EXTEND_PAD);
    cairo_paint(context());
    cairo_restore(context());
  }

  void add(const Canvas::Placed& shape) {
    cairo_save(context());
    cairo_translate(context(), shape.x, shape.y);
    cairo_scale(context(), shape.scale, shape.scale);
    cairo_rectangle(context(), 0.0, 0.0, shape.inner->width(), shape.inner->height());
    cairo_clip(context());
    shapes(*shape.inner);
    cairo_restore(context());
  }

  Context context_;
};

namespace {

void paint_pixels(const Canvas& canvas, const Surface& surface, double zoom, ImageRgb& image) {
  require_success(CairoPainter(surface.get(), zoom).paint(canvas), image.width, image.height);
  copy_pixels(surface.get(), image);
}

cairo_status_t append_bytes(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

ImageRgb Canvas::pixels(double zoom) const {
  ImageRgb image(static_cast<int>(std::lround(width_ * zoom)), static_cast<int>(std::lround(height_ * zoom)));
  paint_pixels(*this, surface_of(image.width, image.height), zoom, image);
  return image;
}

// Only the part of the image under the shapes goes through cairo: a few words on a large image are cheap.
void Canvas::draw_over(ImageRgb& image) const {
  if (shapes_.empty()) return;
  const cairo_rectangle_t all{0.0, 0.0, static_cast<double>(image.width), static_cast<double>(image.height)};
  const Surface shapes(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &all), cairo_surface_destroy);
  require_success(CairoPainter(shapes.get(), 1.0).paint(*this), image.width, image.height);
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  cairo_recording_surface_ink_extents(shapes.get(), &x, &y, &width, &height);
  const int left = std::max(0, static_cast<int>(std::floor(x))), top = std::max(0, static_cast<int>(std::floor(y)));
  const int right = std::min(image.width, static_cast<int>(std::ceil(x + width))),
            bottom = std::min(image.height, static_cast<int>(std::ceil(y + height)));
  if (left >= right || top >= bottom) return;
  ImageRgb part(right - left, bottom - top);
  for (int row = 0; row < part.height; ++row) std::copy_n(&image.at(left, top + row), part.width, &part.at(0, row));
  const Surface surface = surface_of(part);
  const Context context(cairo_create(surface.get()), cairo_destroy);
  cairo_set_source_surface(context.get(), shapes.get(), -left, -top);
  cairo_paint(context.get());
  require_success(cairo_status(context.get()), part.width, part.height);
  copy_pixels(surface.get(), part);
  for (int row = 0; row < part.height; ++row) std::copy_n(&part.at(0, row), part.width, &image.at(left, top + row));
}

std::string pdf(std::span<const Canvas> pages, const std::string& title) {
  std::string bytes;
  const Surface surface(cairo_pdf_surface_create_for_stream(append_bytes, &bytes, 1.0, 1.0), cairo_surface_destroy);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, printable_utf8(title).c_str());
  // The same pages give the same bytes, whenever they are written.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
  const auto require = [](cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
      throw SystemError(fmt::format("a PDF file could not be drawn: {}", cairo_status_to_string(status)));
  };
  for (const Canvas& page : pages) {
    cairo_pdf_surface_set_size(surface.get(), page.width(), page.height());
    require(CairoPainter(surface.get(), 1.0).paint(page));
    cairo_surface_show_page(surface.get());
  }
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
  return bytes;
}

double text_width(std::string_view text, double size, bool bold) {
  thread_local const Surface surface = surface_of(1, 1);
  thread_local const Context context(cairo_create(surface.get()), cairo_destroy);
  set_letter_shapes(context.get());
  choose_font(context.get(), size, bold);
  return advance_of(context.get(), printable_utf8(text));
}

}  // namespace bodkin::imaging
