// The card with Bodkin's version and its libraries.
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

#include "app/pages/cards.h"
#include "scene/library_version.h"
#include <Eigen/Core>
#include <fmt/core.h>

namespace bodkin::app {

using namespace views;

std::vector<std::pair<QString, QString>> AboutCard::versions() {
  const auto of_three = [](int major, int minor, int patch) {
    return QStringLiteral("%1.%2.%3").arg(major).arg(minor).arg(patch);
  };
  return {{QStringLiteral("Bodkin"), QStringLiteral(BODKIN_VERSION)},
          {QStringLiteral("Qt"), QString::fromLatin1(qVersion())},
          {QStringLiteral("VTK"), QString::fromStdString(scene::vtk_version())},
          {QStringLiteral("ITK"), QStringLiteral(BODKIN_ITK_VERSION)},
          {QStringLiteral("Eigen"), of_three(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {QStringLiteral("fmt"), of_three(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
          {tr("Compiler"), QStringLiteral(BODKIN_COMPILER)},
          {tr("System"), QSysInfo::prettyProductName() + QStringLiteral(", ") + QSysInfo::currentCpuArchitecture()}};
}

AboutCard::AboutCard(QWidget* parent) : Card("about", parent) {
  add_label("title")->setText(QStringLiteral("Bodkin"));
  add_label("plain")->setText(
      tr("A simulator and trainer for needle procedures: forces, images and training. For training, not for "
         "treatment."));
  QString table = QStringLiteral("<table>"), plain;
  for (const auto& [name, version] : versions()) {
    table += QStringLiteral("<tr><td style='padding-right:18px'>%1</td><td><b>%2</b></td></tr>")
                 .arg(name.toHtmlEscaped(), version.toHtmlEscaped());
    plain += name + QLatin1Char(' ') + version + QLatin1Char('\n');
  }
  QLabel* const rows_of_versions = add_label("plain");
  rows_of_versions->setObjectName(QStringLiteral("about.versions"));
  rows_of_versions->setTextFormat(Qt::RichText);
  rows_of_versions->setText(table + QStringLiteral("</table>"));
  rows_of_versions->setTextInteractionFlags(Qt::TextSelectableByMouse);
  add_label("second")->setText(tr("Free software under the Apache License 2.0, without any warranty."));
  auto* const row = new QHBoxLayout;
  row->addStretch(1);
  connect(add_button(row, "about.copy", tr("Copy"), tr("Copy the versions as text, for a bug report"), false),
          &QPushButton::clicked, this, [plain] { QApplication::clipboard()->setText(plain); });
  connect(add_button(row, "about.close", tr("Close"), tr("Back (Esc)"), true), &QPushButton::clicked, this,
          &AboutCard::closed);
  rows()->addLayout(row);
}

void AboutCard::mousePressEvent(QMouseEvent*) {
  emit closed();
}

}  // namespace bodkin::app
