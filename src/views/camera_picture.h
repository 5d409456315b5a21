#pragma once

#include <QWidget>
#include <memory>

#include "imaging/image_rgb.h"

namespace bodkin::views {

// A camera's image at the largest size of the widget; a text if there is none.
class CameraPicture : public QWidget {
  Q_OBJECT
 public:
  explicit CameraPicture(QWidget* parent = nullptr);

  // Null: none.
  void show_picture(std::shared_ptr<const imaging::ImageRgb> picture);
  // Shows a text instead of an image.
  void show_words(const QString& words);
  const std::shared_ptr<const imaging::ImageRgb>& picture() const { return picture_; }

 signals:
  // An image has been painted for the first time.
  void painted();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const imaging::ImageRgb> picture_;
  bool is_new_ = false;  // not painted yet
  QString words_;
};

}  // namespace bodkin::views
