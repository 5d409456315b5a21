#include "views/look_panel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "views/language.h"
#include "views/open_case.h"

namespace bodkin::views {

namespace {

constexpr int part_role = Qt::UserRole,
              section_role = Qt::UserRole + 1;   // number of the surface; name of the section
constexpr int swatch = 20, swatch_in_list = 12;  // pixels
constexpr double least_opacity = 0.05;           // below it a shown part cannot be told from a hidden one

// Distinguishable with any colour vision (theme.cpp).
constexpr std::array<QRgb, 10> swatches = {0xE9DEC6, 0xE0B596, 0xD8202C, 0xD09500, 0xEDEF34,
                                           0x399283, 0x56B4E9, 0x9D4FC6, 0xCC79A7, 0x8A5878};

QIcon icon_of(QRgb colour, int size) {
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QColor(0x98, 0xA4, 0xB3));
  painter.setBrush(QColor(colour));
  painter.drawRoundedRect(QRectF(0.5, 0.5, size - 1.0, size - 1.0), 3.0, 3.0);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // else it is tinted in the row that is chosen
  return icon;
}

QLabel* small_heading(const QString& text) {
  auto* made = new QLabel(text);
  made->setProperty("role", QStringLiteral("label"));
  return made;
}

}  // namespace

LookPanel::LookPanel(const QString& place, QWidget* parent)
    : QWidget(parent),
      place_(place),
      parts_(new QTreeWidget),
      percent_(small_heading(QString())),
      opacity_(new QSlider(Qt::Horizontal)),
      saved_(new QComboBox) {
  setObjectName(QStringLiteral("panel"));  // the style sheet's
  setAttribute(Qt::WA_StyledBackground);
  setFixedWidth(272);
  setFocusProxy(parts_);
  setProperty("keeps_keys", true);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(12, 10, 12, 12);
  rows->setSpacing(6);
  parts_->setObjectName(place + QStringLiteral(".parts.list"));
  parts_->viewport()->setObjectName(place + QStringLiteral(".parts.rows"));
  parts_->setAccessibleName(tr("Parts of the patient"));
  parts_->setToolTip(tr("Tick the parts to show; opacity and colour below belong to the chosen row"));
  parts_->setHeaderHidden(true);
  parts_->setFrameShape(QFrame::NoFrame);
  parts_->setIndentation(16);
  parts_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(parts_, &QTreeWidget::itemChanged, this,
          [this](const QTreeWidgetItem* item) { request_visibility(*item); });
  connect(parts_, &QTreeWidget::currentItemChanged, this, [this] { refresh_chosen(); });
  rows->addWidget(parts_, 1);
  auto* shade = new QHBoxLayout;
  opacity_->setObjectName(place + QStringLiteral(".parts.opacity"));
  opacity_->setAccessibleName(tr("Opacity"));
  opacity_->setToolTip(tr("Opacity of the part that is chosen"));
  opacity_->setRange(0, 100);
  connect(opacity_, &QSlider::valueChanged, this, [this](int value) {
    scene::PartLook change;
    change.opacity = 0.01 * value;
    if (*change.opacity >= least_opacity) change.shown = true;
    request_change(change);
  });
  shade->addWidget(small_heading(tr("Opacity")));
  shade->addWidget(opacity_, 1);
  percent_->setMinimumWidth(34);
  percent_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  shade->addWidget(percent_);
  rows->addLayout(shade);
  rows->addWidget(make_colours());
  rows->addWidget(make_saved());
}

QPushButton* LookPanel::button(const char* name, const QString& text, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(place_ + QStringLiteral(".parts.") + QLatin1String(name));
  made->setAccessibleName(text.isEmpty() ? tip : text);
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::TabFocus);
  return made;
}

QWidget* LookPanel::make_colours() {
  auto* made = new QWidget;
  auto* row = new QHBoxLayout(made);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (const QRgb colour : swatches) {
    const QString name = QColor(colour).name();
    auto* patch = button(qPrintable(QStringLiteral("colour.") + name.mid(1)), QString(), tr("Colour %1").arg(name));
    patch->setProperty("role", QStringLiteral("flat"));
    patch->setStyleSheet(QStringLiteral("padding: 0;"));
    patch->setIcon(icon_of(colour, swatch));
    patch->setIconSize(QSize(swatch, swatch));
    patch->setFixedSize(swatch + 1, swatch + 2);
    connect(patch, &QPushButton::clicked, this, [this, colour] {
      scene::PartLook change;
      change.colour = colour & 0xFFFFFFU;
      request_change(change);
    });
    row->addWidget(patch);
  }
  auto* other = button("colour.other", QStringLiteral("…"), tr("Any other colour"));
  other->setAccessibleName(tr("Any other colour"));
  other->setStyleSheet(QStringLiteral("padding: 0;"));
  other->setFixedSize(swatch, swatch + 2);
  connect(other, &QPushButton::clicked, this, &LookPanel::choose_colour);
  row->addWidget(other);
  return made;
}

QWidget* LookPanel::make_saved() {
  auto* made = new QWidget;
  auto* rows = new QVBoxLayout(made);
  rows->setContentsMargins(0, 4, 0, 0);
  rows->setSpacing(6);
  rows->addWidget(small_heading(tr("Looks saved with this patient")));
  auto* first = new QHBoxLayout;
  saved_->setObjectName(place_ + QStringLiteral(".parts.saved"));
  saved_->setAccessibleName(tr("Looks saved with this patient"));
  saved_->setToolTip(tr("Choose a look that was saved with this patient"));
  connect(saved_, qOverload<int>(&QComboBox::activated), this,
          [this](int) { emit saved_look_requested(saved_->currentData().toString()); });
  first->addWidget(saved_, 1);
  auto* remove = button("remove", tr("Delete"), tr("Delete this look from the patient"));
  connect(remove, &QPushButton::clicked, this, [this] { emit remove_requested(saved_->currentData().toString()); });
  first->addWidget(remove);
  rows->addLayout(first);
  auto* second = new QHBoxLayout;
  name_ = new QLineEdit;
  name_->setObjectName(place_ + QStringLiteral(".parts.name"));
  name_->setAccessibleName(tr("Name of the look"));
  name_->setToolTip(tr("Name of this look; a look that already has this name is replaced"));
  name_->setPlaceholderText(tr("Name"));
  name_->setMaxLength(100);
  second->addWidget(name_, 1);
  auto* save = button("save", tr("Save"), tr("Save this look with the patient, under this name"));
  const auto save_it = [this] {
    emit save_requested(name_->text().trimmed(), with_view_->isChecked(), opens_with_->isChecked());
  };
  connect(save, &QPushButton::clicked, this, save_it);
  connect(name_, &QLineEdit::returnPressed, this, save_it);
  second->addWidget(save);
  rows->addLayout(second);
  with_view_ = new QCheckBox(tr("with this direction of view"));
  with_view_->setObjectName(place_ + QStringLiteral(".parts.with_view"));
  with_view_->setToolTip(tr("The look also keeps the direction of view"));
  opens_with_ = new QCheckBox(tr("the patient opens with it"));
  opens_with_->setObjectName(place_ + QStringLiteral(".parts.opens_with"));
  opens_with_->setToolTip(tr("The patient is shown like this when opened again"));
  for (QCheckBox* box : {with_view_, opens_with_}) {
    box->setAccessibleName(box->text());
    rows->addWidget(box);
  }
  return made;
}

void LookPanel::set_surfaces(const scene::PatientSurfaces* surfaces) {
  const QSignalBlocker quiet(parts_);
  parts_->clear();
  surfaces_ = surfaces;
  if (surfaces_ == nullptr) return;
  for (std::size_t i = 0; i < surfaces_->parts.size(); ++i) {
    const scene::PatientSurface& surface = surfaces_->parts[i];
    const auto add = [&](QTreeWidgetItem* item, const std::string& name, const std::string& section) {
      item->setText(0, in_words(readable_structure(name)));
      item->setData(0, part_role, static_cast<int>(i));
      item->setData(0, section_role, QString::fromStdString(section));
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
      return item;
    };
    QTreeWidgetItem* const whole = add(new QTreeWidgetItem(parts_), surface.name, {});
    for (const scene::SurfaceSection& section : surface.sections) {
      const bool rest = section.name == surface.name;
      if (!rest) add(new QTreeWidgetItem(whole), section.name, section.name);
    }
    whole->setExpanded(surface.sections.size() <= 6);
  }
  parts_->setCurrentItem(parts_->topLevelItem(0));
  refresh();
}

void LookPanel::set_look(const scene::Look& look) {
  look_ = look;
  refresh();
}

void LookPanel::refresh() {
  if (surfaces_ == nullptr) return;
  const QSignalBlocker quiet(parts_);
  for (int i = 0; i < parts_->topLevelItemCount(); ++i) {
    QTreeWidgetItem& whole = *parts_->topLevelItem(i);
    const scene::PatientSurface& surface = surfaces_->parts[static_cast<std::size_t>(i)];
    refresh_item(whole, surface, {});
    int shown = 0;
    for (int j = 0; j < whole.childCount(); ++j) {
      QTreeWidgetItem& part = *whole.child(j);
      refresh_item(part, surface, part.data(0, section_role).toString().toStdString());
      shown += part.checkState(0) == Qt::Checked ? 1 : 0;
    }
    if (shown > 0 && shown < whole.childCount()) whole.setCheckState(0, Qt::PartiallyChecked);
  }
  refresh_chosen();
}

void LookPanel::refresh_item(QTreeWidgetItem& item, const scene::PatientSurface& surface,
                             const std::string& section) {
  const scene::Appearance now = scene::appearance(look_, surface, section);
  item.setCheckState(0, now.drawn() ? Qt::Checked : Qt::Unchecked);
  item.setIcon(0, icon_of(now.colour, swatch_in_list));
}

void LookPanel::refresh_chosen() {
  const QTreeWidgetItem* const item = parts_->currentItem();
  if (item == nullptr || surfaces_ == nullptr) return;
  const auto number = static_cast<std::size_t>(item->data(0, part_role).toInt());
  const scene::Appearance now =
      scene::appearance(look_, surfaces_->parts[number], item->data(0, section_role).toString().toStdString());
  const QSignalBlocker quiet(opacity_);
  opacity_->setValue(now.shown ? qRound(100.0F * now.opacity) : 0);
  percent_->setText(QStringLiteral("%1 %").arg(opacity_->value()));
}

void LookPanel::request_change(const scene::PartLook& change) {
  const QTreeWidgetItem* const item = parts_->currentItem();
  if (item == nullptr || surfaces_ == nullptr) return;
  const scene::PatientSurface& surface = surfaces_->parts[static_cast<std::size_t>(item->data(0, part_role).toInt())];
  const std::string section = item->data(0, section_role).toString().toStdString();
  scene::PartLook whole = change;
  whole.name = section.empty() ? surface.name : section;
  emit look_requested(scene::changed(look_, surface, whole));
}

void LookPanel::request_visibility(const QTreeWidgetItem& item) {
  if (surfaces_ == nullptr) return;
  const scene::PatientSurface& surface = surfaces_->parts[static_cast<std::size_t>(item.data(0, part_role).toInt())];
  const std::string section = item.data(0, section_role).toString().toStdString();
  scene::PartLook change{section.empty() ? surface.name : section, item.checkState(0) != Qt::Unchecked, {}, {}};
  // A ticked part must be visible, even if the preset or the slider had made it invisible.
  const float opacity = scene::appearance(look_, surface, section).opacity;
  if (*change.shown && opacity < static_cast<float>(least_opacity)) change.opacity = 1.0;
  emit look_requested(scene::changed(look_, surface, change));
}

void LookPanel::choose_colour() {
  auto* dialog = new QColorDialog(this);
  dialog->setObjectName(place_ + QStringLiteral(".parts.colour.dialog"));
  dialog->setOption(QColorDialog::DontUseNativeDialog);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& colour) {
    scene::PartLook change;
    change.colour = colour.rgb() & 0xFFFFFFU;
    request_change(change);
  });
  dialog->show();
}

void LookPanel::set_saved(const scene::CaseLooks& looks) {
  const QString before = saved_->currentData().toString();
  saved_->clear();
  for (const scene::NamedLook& look : looks.looks) {
    const QString name = QString::fromStdString(look.name);
    saved_->addItem(look.name == looks.opens_with ? tr("%1 (opens with it)").arg(name) : name, name);
  }
  saved_->setCurrentIndex(std::max(0, saved_->findData(before)));
  saved_->setEnabled(!looks.looks.empty());
}

void LookPanel::keyPressEvent(QKeyEvent* event) {
  // A list or a text receives its keys itself, not the view below.
  event->accept();
  if (event->key() == Qt::Key_Escape || event->key() == Qt::Key_O) emit closed();
}

}  // namespace bodkin::views
