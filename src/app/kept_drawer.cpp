#include "app/kept_drawer.h"

#include <QSettings>
#include <QString>

namespace bodkin::app {

namespace {

QString drawer_setting() {
  return QStringLiteral("volume/drawn_by");
}

QString text_of(scene::VolumeDrawer drawer) {
  const std::string_view name = scene::name_of(drawer);
  return QString::fromLatin1(name.data(), static_cast<int>(name.size()));
}

}  // namespace

scene::VolumeDrawer kept_volume_drawer() {
  const QString kept = QSettings().value(drawer_setting()).toString();
  for (const scene::VolumeDrawer drawer : scene::volume_drawers) {
    if (kept == text_of(drawer)) return drawer;
  }
  return scene::VolumeDrawer::automatic;
}

void keep_volume_drawer(scene::VolumeDrawer drawer) {
  QSettings().setValue(drawer_setting(), text_of(drawer));
}

}  // namespace bodkin::app
