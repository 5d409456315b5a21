// The menu of the 3-D view: contents, viewpoint, stereo, and export.
#include <QAction>
#include <QFileDialog>
#include <QMenu>
#include <algorithm>
#include <array>

#include "views/language.h"
#include "views/view3d.h"

#include "core/error.h"

namespace bodkin::views {

namespace {

constexpr double message_time = 6.0;  // s

}  // namespace

QPointF View3d::in_picture(const QPointF& at) const {
  QPointF pixel = at * scale_;
  if (stereo_ == scene::Stereo::side_by_side && scene_ && pixel.x() >= scene_->width()) pixel.rx() -= scene_->width();
  return pixel;
}

std::vector<scene::SoftwareView*> View3d::scenes() const {
  std::vector<scene::SoftwareView*> all;
  if (scene_) all.push_back(scene_.get());
  if (right_scene_) all.push_back(right_scene_.get());
  return all;
}

void View3d::set_stereo(scene::Stereo stereo) {
  if (!scene_ || stereo == stereo_) return;
  stereo_ = stereo;
  right_scene_.reset();
  if (stereo_ != scene::Stereo::off) right_scene_ = make_scene(scene_->shared_surfaces());
  fit_picture();
}

scene::PixelBox View3d::draw_scenes() {
  const scene::PixelBox drawn = scene_->draw();
  if (stereo_ == scene::Stereo::off) return drawn;
  const scene::PixelBox other = right_scene_->draw();
  if (drawn.empty() && other.empty()) return {};
  const scene::Picture &left = scene_->picture(), &right = right_scene_->picture();
  if (stereo_ == scene::Stereo::anaglyph) {
    scene::mix_anaglyph(left, right, stereo_picture_);
  } else {
    stereo_picture_ = scene::Picture(2 * left.width, left.height);
    for (int y = 0; y < left.height; ++y) {
      std::copy(left.row(y), left.row(y) + left.width, stereo_picture_.row(y));
      std::copy(right.row(y), right.row(y) + right.width, stereo_picture_.row(y) + left.width);
    }
  }
  return {0, 0, stereo_picture_.width, stereo_picture_.height};
}

void View3d::show_message(const QString& sentence) {
  message_ = sentence;
  message_until_ = clock_ + message_time;
  update();
}

bool View3d::save_surfaces(const QString& folder, scene::SurfaceFormat format) {
  if (!scene_) return false;
  try {
    const auto files = scene::export_surfaces(scene_->surfaces(), folder.toStdString(), format);
    show_message(tr("%n surface(s) saved in %1", nullptr, static_cast<int>(files.size())).arg(folder));
    return true;
  } catch (const SystemError& error) {
    show_message(in_words(error.what()));
    return false;
  }
}

bool View3d::save_picture(const QString& file) {
  const bool saved = grab().save(file);
  show_message(saved
                   ? tr("Picture saved as %1").arg(file)
                   : tr("%1 cannot be written; choose a folder that may be written to, and a name that ends in .png")
                         .arg(file));
  return saved;
}

// Dialogs are not modal: the needle continues behind them.
void View3d::open_menu(const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setObjectName(objectName() + QStringLiteral(".menu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QMenu* views = menu->addMenu(tr("View"));
  const std::array<QString, scene::standard_view_count> names = {
      tr("Beside the needle"), tr("From behind"),   tr("From the front"), tr("From the left"),
      tr("From the right"),    tr("From the head"), tr("From the feet")};
  for (int i = 0; i < scene::standard_view_count; ++i) {
    QAction* action = views->addAction(names[static_cast<std::size_t>(i)]);
    connect(action, &QAction::triggered, this, [this, i] { choose_view(static_cast<scene::StandardView>(i)); });
  }
  QMenu* stereo = menu->addMenu(tr("Stereo"));
  const std::array<QString, 3> ways = {tr("Off"), tr("Side by side"), tr("Red and cyan glasses")};
  for (int i = 0; i < 3; ++i) {
    QAction* action = stereo->addAction(ways[static_cast<std::size_t>(i)]);
    action->setCheckable(true);
    action->setChecked(static_cast<int>(stereo_) == i);
    connect(action, &QAction::triggered, this, [this, i] { set_stereo(static_cast<scene::Stereo>(i)); });
  }
  QMenu* surfaces = menu->addMenu(tr("Save surfaces"));
  surfaces->setEnabled(is_ready());
  for (const scene::SurfaceFormat format :
       {scene::SurfaceFormat::stl, scene::SurfaceFormat::ply, scene::SurfaceFormat::vtp}) {
    QAction* action = surfaces->addAction(QString::fromLatin1(name_of(format).data()).toUpper());
    connect(action, &QAction::triggered, this, [this, format] {
      auto* dialog = new QFileDialog(this, tr("Folder for the surfaces"));
      dialog->setFileMode(QFileDialog::Directory);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
      dialog->setModal(false);
      connect(dialog, &QFileDialog::fileSelected, this,
              [this, format](const QString& folder) { save_surfaces(folder, format); });
      dialog->show();
    });
  }
  connect(menu->addAction(tr("Save picture")), &QAction::triggered, this, [this] {
    auto* dialog = new QFileDialog(this, tr("Picture of the patient"), QString(), tr("Pictures (*.png)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setModal(false);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { save_picture(file); });
    dialog->show();
  });
  menu->popup(at);
}

}  // namespace bodkin::views
