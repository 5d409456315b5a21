#pragma once

#include <QString>
#include <QStringList>

namespace bodkin::app {

// The language that the window speaks. The files of languages lie in share/bodkin/translations.

// Codes, "en" first: those that speak() takes.
QStringList languages();

// What was chosen in the window before, else the system's language where there is one of it, else English.
QString usual_language();

// What usual_language() gives from now on.
void choose_language(const QString& code);

// For all texts that are made from now on. Throws InputError when there is no language of that code.
void speak(const QString& code);

// The code that speak() took last, "en" before.
QString spoken_language();

}  // namespace bodkin::app
