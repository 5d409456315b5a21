// The window's commands, from a key, a button, the palette or a script.
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <array>

#include "app/main_window.h"
#include "app/models/station_patient.h"
#include "app/pages/cards.h"
#include "app/pages/palette.h"
#include "app/pages/practise.h"
#include "app/pages/tour.h"
#include "views/theme.h"
#include "views/top_bar.h"

#include "core/error.h"
#include "io/probe_library_file.h"

namespace bodkin::app {

using namespace views;

void MainWindow::follow(const std::string& server, const std::filesystem::path& patient) {
  link::ClientSettings settings = link::parse_server(server, "--connect");
  settings.largest_queue = std::size_t{1} << 16U;      // commands alone
  settings.silence = std::chrono::milliseconds(3000);  // three of the messages that say "I live"
  const std::array<std::filesystem::path, 2> here = {std::filesystem::current_path(),
                                                     practice_.cases().built_in_folder().parent_path()};
  practice_.follow(settings, patient.empty() ? patient_of_station(settings, here) : patient);
}

void MainWindow::run(Command command) {
  switch (command) {
    case Command::show_keys:
      keys_->show_keys(scopes_of_keys());
      keys_->setGeometry(rect());
      keys_->setVisible(!keys_->isVisible());
      return keys_->raise();
    case Command::back:
      if (palette_->isVisible()) return palette_->hide();
      if (keys_->isVisible()) return keys_->hide();
      if (about_->isVisible()) return about_->hide();
      if (page_ != nullptr && page_->press(QKeySequence(Qt::Key_Escape))) return;  // it has closed something itself
      if (page_ != nullptr) return show_page(shown_ != nullptr ? PageId::practise : PageId::start);
      if (practice_.state() == State::preparing) return practice_.cancel();
      if (practice_.state() == State::ended && results_->isHidden()) return results_->show();
      if (practice_.state() == State::ended) return practice_.leave();
      return practice_.pause(practice_.state() != State::paused);
    case Command::open_patient:
      return choose_patient();
    case Command::save_picture:
      return save_picture();
    case Command::full_screen:
      return isFullScreen() ? showNormal() : showFullScreen();
    case Command::toggle_theme:
      return apply_theme(!Theme::now().is_dark);
    case Command::leave_program:
      close();
      return;
    case Command::show_palette:
      return show_palette();
    case Command::toggle_sound:
      sounds_.toggle();
      return practice_.show_message(!sounds_.is_on() ? tr("Sound is off.").toStdString()
                                    : sounds_.can_play()
                                        ? tr("Sound is on.").toStdString()
                                        : tr("Sound is on, but there is no pw-play, paplay or aplay to play "
                                             "it with.")
                                              .toStdString());
    case Command::tour:
      return begin_tour();
    case Command::next_view:
      return practise_->focus_next(false);
    case Command::previous_view:
      return practise_->focus_next(true);
    case Command::begin:
      return practise_procedure(QString::fromUtf8(built_in_patient().procedure.data()));
    case Command::hold:
      return practice_.toggle_hold();
    case Command::push_in:
    case Command::push_in_finely:
      return practice_.hold_key(1, command == Command::push_in_finely);
    case Command::draw_out:
    case Command::draw_out_finely:
      return practice_.hold_key(-1, command == Command::draw_out_finely);
    case Command::turn_back:
    case Command::turn_clockwise:
      return practice_.hold_turn(command == Command::turn_clockwise ? 1 : -1);
    case Command::withdraw:
      return practice_.withdraw();
    case Command::leave_needle:
      return practice_.leave_needle();
    case Command::take_out_needle:
      return practice_.take_out_left_needle();
    case Command::press_plunger:
      return practice_.press_plunger(true);
    case Command::turn_finger:
      return practice_.turn(station::StationCommand::turn_finger);
    case Command::turn_stylet:
      return practice_.turn(station::StationCommand::turn_stylet);
    case Command::turn_manometer:
      return practice_.turn(station::StationCommand::turn_manometer);
    case Command::turn_breath:
      return practice_.turn(station::StationCommand::turn_breath);
    case Command::again:
      return another_attempt();
    case Command::end:
      return practice_.end();
    case Command::arm:
      return practice_.arm();
    case Command::move_body:
      return show_moving(!practise_->view3d().workspace());
    case Command::undo_body:
      practice_.undo_body();
      return show_moving(practise_->view3d().workspace().has_value());
    case Command::reset_body:
      practice_.reset_body();
      return show_moving(practise_->view3d().workspace().has_value());
    case Command::show_numbers:
      return practise_->toggle_numbers();
    case Command::show_ladder:
      return practise_->toggle_ladder();
    case Command::show_dock:
      return practise_->toggle_dock();
    case Command::toggle_ultrasound:
      return show_ultrasound(!has_ultrasound_);
    case Command::toggle_volume:
      return show_volume();
    case Command::fill:
      return practise_->toggle_fill();
    case Command::of_the_view:
    case Command::of_the_page:
      return;
  }
}

void MainWindow::connect_other_hand() {
  OtherHandBar* const other_hand = &practise_->other_hand();
  connect(practise_, &PractisePage::message_requested, this,
          [this](const QString& words) { practice_.show_message(words.toStdString()); });
  connect(other_hand, &OtherHandBar::finger_turned, this, [this] { run(Command::turn_finger); });
  connect(other_hand, &OtherHandBar::stylet_turned, this, [this] { run(Command::turn_stylet); });
  connect(other_hand, &OtherHandBar::manometer_turned, this, [this] { run(Command::turn_manometer); });
  connect(other_hand, &OtherHandBar::breath_turned, this, [this] { run(Command::turn_breath); });
  connect(other_hand, &OtherHandBar::plunger_pressed, this, [this](bool on) { practice_.press_plunger(on); });
  connect(other_hand, &OtherHandBar::filling_chosen, this, [this](bool air) {
    practice_.fill_syringe(air ? anatomy::SyringeFilling::air : anatomy::SyringeFilling::saline);
  });
}

void MainWindow::show_about() {
  about_->setGeometry(rect());
  about_->show();
  about_->raise();
}

void MainWindow::practise_procedure(const QString& name) {
  const PracticePatient* const patient = find_practice_patient(name.toStdString());
  if (patient == nullptr) return;
  if (patient->with_ultrasound && practice_.state() == State::no_case) {
    asked_ultrasound_.reset();
    has_ultrasound_ = true;  // from the first attempt on
    practice_.set_ultrasound(usual_ultrasound(true));
    bar_->set_ultrasound(true);
  }
  practice_.choose_practice(*patient);
}

void MainWindow::show_moving(bool on) {
  if (on && !is_attempt(practice_.state())) return;
  const bool begins = on && !practise_->view3d().workspace();
  if (begins && needle_is_down(practice_.state()))
    return practice_.show_message(tr("Draw the needle out of the body first, then move the body.").toStdString());
  std::optional<View3d::Workspace> workspace;
  if (on) workspace = View3d::Workspace{practice_.body_place().middle, practice_.body_place().rotation};
  practise_->show_moving(workspace);
  if (begins) practice_.show_message(tr("Drag to turn the body, right drag to move it. G ends.").toStdString());
}

// With the probe lengthwise beside the planned way of the needle, which then lies in the slice.
station::UltrasoundChoice MainWindow::usual_ultrasound(bool has_path) {
  station::UltrasoundChoice choice;
  choice.probe = io::find_probe("C5-2");
  choice.settings.depth = 90.0;
  choice.request.view = has_path ? imaging::ScanView::needle : imaging::ScanView::paramedian;
  return choice;
}

void MainWindow::show_volume() {
  if (!practise_->may_show_volume())
    return practice_.show_message(tr("This stage of the plan is done without the volume.").toStdString());
  practise_->toggle_volume();
}

void MainWindow::show_ultrasound(bool on) {
  if (shown_ == nullptr) on = false;
  if (on && stage_ && !stage_->aids.ultrasound) {
    bar_->set_ultrasound(has_ultrasound_);
    return practice_.show_message(tr("This stage of the plan is done without ultrasound.").toStdString());
  }
  std::optional<station::UltrasoundChoice> choice;
  try {
    if (on && asked_ultrasound_) {
      choice = asked_ultrasound_;
    } else if (on) {
      choice = usual_ultrasound(shown_->description().procedure.path.has_value());
    }
    practise_->show_ultrasound(choice);
    practice_.set_ultrasound(choice);
    has_ultrasound_ = on;
  } catch (const InputError& error) {  // no skin there
    practice_.show_message(error.what());
  }
  bar_->set_ultrasound(has_ultrasound_);
}

void MainWindow::choose_patient() {
  if (practice_.state() != State::no_case && practice_.state() != State::ended) return practice_.pause(true);
  QMenu kinds(this);
  kinds.setObjectName(QStringLiteral("open.menu"));
  QAction* const folder = kinds.addAction(tr("A folder: a case, or DICOM images"));
  QAction* const file = kinds.addAction(tr("A file: NIfTI, NRRD, MetaImage, or one DICOM image"));
  QAction* const chosen = kinds.exec(mapToGlobal(QPoint(width() / 3, height() / 3)));
  QString path;
  if (chosen == folder) path = QFileDialog::getExistingDirectory(this, folder->text());
  if (chosen == file) {
    path = QFileDialog::getOpenFileName(this, file->text(), {},
                                        tr("Images (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm);;All files (*)"));
  }
  if (!path.isEmpty()) open(path.toStdString());
}

void MainWindow::show_palette() {
  if (palette_->isVisible()) return palette_->hide();
  std::vector<Palette::Entry> entries;
  for (const Page* page : more_pages_) {
    const PageId id = page->id();
    entries.push_back({tr("go to: %1").arg(name_of(page->scope())), {}, [this, id] { show_page(id); }});
  }
  entries.push_back({tr("go to: Practise"), {}, [this] { show_page(PageId::practise); }});
  // Not commands that last while a key is held.
  std::vector<Command> listed = {Command::of_the_view,     Command::of_the_page,    Command::show_palette,
                                 Command::push_in,         Command::push_in_finely, Command::draw_out,
                                 Command::draw_out_finely, Command::turn_back,      Command::turn_clockwise,
                                 Command::press_plunger};
  for (const KeyScope scope : chain_of(page_scope())) {
    for (const KeyBinding& binding : key_table()) {
      const Command command = binding.command;
      if (binding.scope != scope || std::find(listed.begin(), listed.end(), command) != listed.end()) continue;
      listed.push_back(command);
      entries.push_back({text_of(binding), QLatin1String(binding.keys), [this, command] { run(command); }});
    }
  }
  palette_->setGeometry(rect());
  palette_->show_entries(std::move(entries));
}

void MainWindow::begin_tour() {
  if (practice_.state() != State::no_case) return;
  tour_->begin();
  practice_.choose_built_in();
}

void MainWindow::save_picture() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString name = QDateTime::currentDateTime().toString(QStringLiteral("'bodkin' yyyy-MM-dd hh.mm.ss'.png'"));
  const QString file = folder + QLatin1Char('/') + name;
  const bool saved = QDir().mkpath(folder) && grab().save(file);
  const QString words =
      saved ? tr("Saved as %1") : tr("%1 cannot be written; is there room, and may you write there?");
  practice_.show_message(words.arg(file).toStdString());
}

void MainWindow::apply_theme(bool dark) {
  Theme::use(dark);
  qApp->setStyleSheet(Theme::now().style_sheet());
  theme_changed_ = true;
  QSettings().setValue(QStringLiteral("dark"), dark);
  update();
}

}  // namespace bodkin::app
