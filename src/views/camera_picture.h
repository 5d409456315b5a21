#pragma once

#include <QWidget>
#include <memory>

#include "imaging/image_rgb.h"

namespace bodkin::views {

// A camera's picture as large as the widget allows; words where there is none.
class CameraPicture : public QWidget {
  Q_OBJECT
 public:
  explicit CameraPicture(QWidget* parent = nullptr);

  // Null: none.
  void show_picture(std::shared_ptr<const imaging::ImageRgb> picture);
  // Instead of a picture.
  void show_words(const QString& words);
  const std::shared_ptr<const imaging::ImageRgb>& picture() const { return picture_; }

 signals:
  // A picture has been painted for the first time.
  void painted();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const imaging::ImageRgb> picture_;
  bool is_new_ = false;  // not painted yet
  QString words_;
};

}  // namespace bodkin::views
