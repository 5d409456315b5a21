// The patient's appearance in the 3-D view: presets, parts, and the looks saved with the case.
#include <QPushButton>
#include <algorithm>

#include "views/language.h"
#include "views/look_panel.h"
#include "views/view3d.h"

#include "core/error.h"

namespace bodkin::views {

namespace {

constexpr double look_flight = 0.35;                               // s
constexpr int panel_top = 52, panel_gap = 4, tallest_panel = 470;  // pixels

}  // namespace

void View3d::make_look_panel(const QString& place) {
  parts_button_ = new QPushButton(tr("Parts"), this);
  parts_button_->setObjectName(place + QStringLiteral(".parts"));
  parts_button_->setAccessibleName(tr("Parts"));
  parts_button_->setToolTip(tr("Show or hide each part, its opacity and colour, looks saved with the patient (O)"));
  parts_button_->setCheckable(true);
  parts_button_->setFocusPolicy(Qt::NoFocus);
  connect(parts_button_, &QPushButton::clicked, this, &View3d::show_parts);
  panel_ = new LookPanel(place, this);
  panel_->hide();
  connect(panel_, &LookPanel::closed, this, [this] { show_parts(false); });
  connect(panel_, &LookPanel::look_requested, this, &View3d::set_look);
  connect(panel_, &LookPanel::saved_look_requested, this,
          [this](const QString& name) { show_saved_look(name.toStdString()); });
  connect(panel_, &LookPanel::save_requested, this, &View3d::save_look);
  connect(panel_, &LookPanel::remove_requested, this, &View3d::remove_look);
}

void View3d::place_look_panel() {
  const int tall = std::max(0, std::min(tallest_panel, height() - panel_top - 12));
  panel_->setGeometry(width() - panel_->width() - panel_gap, panel_top, panel_->width(), tall);
}

void View3d::set_preset(scene::Preset preset) {
  set_look(scene::with_preset(look_, preset));
}

void View3d::set_outside_only(bool only) {
  if (only == outside_only_) return;
  outside_only_ = only;
  for (QPushButton* button : buttons_) button->setVisible(!only);
  parts_button_->setVisible(!only);
  show_parts(false);
  set_preset(only ? scene::Preset::skin : scene::Preset::cut_away);
}

void View3d::set_look(const scene::Look& requested) {
  const scene::Look look = outside_only_ ? scene::Look{scene::Preset::skin, {}} : requested;
  const bool other = look.preset != look_.preset;
  look_ = look;
  for (std::size_t i = 0; i < buttons_.size(); ++i) buttons_[i]->setChecked(scene::presets[i] == look_.preset);
  for (scene::SoftwareView* scene : scenes()) scene->set_look(look_);
  panel_->set_look(look_);
  if (other) emit preset_changed(look_.preset);
}

void View3d::show_parts(bool shown) {
  if (outside_only_) shown = false;
  parts_button_->setChecked(shown);
  panel_->setVisible(shown);
  if (!shown) return setFocus(Qt::OtherFocusReason);
  place_look_panel();
  panel_->raise();
  panel_->setFocus(Qt::OtherFocusReason);
}

// An invalid file of looks must not prevent showing the patient.
void View3d::open_looks_of_case() {
  panel_->set_surfaces(&scene_->surfaces());
  saved_looks_ = {};
  try {
    if (!patient_->folder.empty()) saved_looks_ = scene::read_looks(patient_->folder);
  } catch (const std::exception& error) {
    show_message(in_words(error.what()));
  }
  panel_->set_saved(saved_looks_);
  panel_->set_look(look_);
  if (!opens_as_saved_) return;
  if (const scene::NamedLook* const first = saved_looks_.find(saved_looks_.opens_with)) {
    set_look(first->look);
    if (first->camera) {
      camera_ = *first->camera;
      scene_->set_camera(camera_);
    }
  } else if (!look_.changed.empty()) {
    set_look({look_.preset, {}});  // of another patient
  }
}

void View3d::show_saved_look(const std::string& name) {
  const scene::NamedLook* const saved = saved_looks_.find(name);
  if (saved == nullptr) return;
  set_look(saved->look);
  if (!saved->camera) return;
  flight_.emplace(camera_, *saved->camera, look_flight);
  flight_began_ = clock_;
}

void View3d::save_look(const QString& name, bool with_view, bool opens_with) {
  if (!scene_) return;
  if (name.isEmpty()) return show_message(tr("Give the look a name first"));
  scene::NamedLook look{name.toStdString(), look_, std::nullopt};
  if (with_view) look.camera = camera_;
  scene::CaseLooks looks = saved_looks_;
  const auto same = std::find_if(looks.looks.begin(), looks.looks.end(),
                                 [&look](const scene::NamedLook& each) { return each.name == look.name; });
  if (opens_with) {
    looks.opens_with = look.name;
  } else if (looks.opens_with == look.name) {
    looks.opens_with.clear();
  }
  if (same == looks.looks.end()) {
    looks.looks.push_back(std::move(look));
  } else {
    *same = std::move(look);
  }
  if (write_saved_looks(std::move(looks))) show_message(tr("\"%1\" is saved with the patient").arg(name));
}

void View3d::remove_look(const QString& name) {
  scene::CaseLooks looks = saved_looks_;
  const std::string wanted = name.toStdString();
  if (std::erase_if(looks.looks, [&wanted](const scene::NamedLook& look) { return look.name == wanted; }) == 0)
    return;
  if (looks.opens_with == wanted) looks.opens_with.clear();
  write_saved_looks(std::move(looks));
}

bool View3d::write_saved_looks(scene::CaseLooks looks) {
  try {
    scene::write_looks(looks, patient_->folder);
  } catch (const SystemError& error) {
    show_message(in_words(error.what()));
    return false;
  }
  saved_looks_ = std::move(looks);
  panel_->set_saved(saved_looks_);
  return true;
}

}  // namespace bodkin::views
