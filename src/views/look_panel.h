#pragma once

#include <QWidget>

#include "scene/look_file.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QTreeWidget;
class QTreeWidgetItem;

namespace bodkin::views {

// The parts of the patient in 3-D, surface by surface and structure by structure: a tick shows or hides one, opacity
// and colour are those of the selected row. Below, the looks saved with the case. Emits the person's requests; View3d
// executes them.
class LookPanel : public QWidget {
  Q_OBJECT
 public:
  // `place`: prefix of the object names: "practise" for "practise.parts".
  explicit LookPanel(const QString& place, QWidget* parent);

  // Null: none. The surfaces must stay as long as they are set.
  void set_surfaces(const scene::PatientSurfaces* surfaces);
  void set_look(const scene::Look& look);
  void set_saved(const scene::CaseLooks& looks);

 signals:
  void closed();  // by Escape
  void look_requested(const bodkin::scene::Look& look);
  void saved_look_requested(const QString& name);
  void save_requested(const QString& name, bool with_view, bool opens_with);
  void remove_requested(const QString& name);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QPushButton* button(const char* name, const QString& text, const QString& tip);
  QWidget* make_colours();
  QWidget* make_saved();
  void refresh();
  void refresh_item(QTreeWidgetItem& item, const scene::PatientSurface& surface, const std::string& section);
  void refresh_chosen();
  // Of the selected row.
  void request_change(const scene::PartLook& change);
  void request_visibility(const QTreeWidgetItem& item);
  void choose_colour();

  QString place_;
  const scene::PatientSurfaces* surfaces_ = nullptr;
  scene::Look look_;
  QTreeWidget* parts_;
  QLabel* percent_;
  QSlider* opacity_;
  QComboBox* saved_;
  QLineEdit* name_ = nullptr;
  QCheckBox *with_view_ = nullptr, *opens_with_ = nullptr;
};

}  // namespace bodkin::views
