#include "views/camera_picture.h"

#include <QImage>
#include <QPainter>
#include <utility>

#include "views/theme.h"

namespace bodkin::views {

namespace {

constexpr int least_picture_width = 320, least_picture_height = 180, words_margin = 40;  // pixels

}  // namespace

CameraPicture::CameraPicture(QWidget* parent) : QWidget(parent) {
  setMinimumSize(least_picture_width, least_picture_height);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void CameraPicture::show_picture(std::shared_ptr<const imaging::ImageRgb> picture) {
  picture_ = std::move(picture);
  is_new_ = picture_ != nullptr;
  update();
}

void CameraPicture::show_words(const QString& words) {
  if (words == words_) return;
  words_ = words;
  if (picture_ == nullptr) update();  // else they are not seen, and a picture takes long to paint
}

void CameraPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const Theme& theme = Theme::dark();  // pictures stand on black in both themes
  painter.fillRect(rect(), theme.ground);
  if (picture_ == nullptr || picture_->width == 0) {
    painter.setPen(theme.second);
    const QRect box = rect().adjusted(words_margin, words_margin, -words_margin, -words_margin);
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, words_);
    return;
  }
  const QImage image(reinterpret_cast<const uchar*>(picture_->pixels.data()), picture_->width, picture_->height,
                     3 * picture_->width, QImage::Format_RGB888);
  QRect box(QPoint(), image.size().scaled(size(), Qt::KeepAspectRatio));
  box.moveCenter(rect().center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(box, image);
  if (!std::exchange(is_new_, false)) return;
  painter.end();
  emit painted();
}

}  // namespace bodkin::views
