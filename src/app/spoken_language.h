#pragma once

#include <QString>
#include <QStringList>

namespace bodkin::app {

// The language of the window. Translations are in share/bodkin/translations.

// Codes accepted by speak(), "en" first.
QStringList languages();

// The stored choice, else the system's language if there is a translation, else English.
QString usual_language();

// Stores the result of usual_language().
void choose_language(const QString& code);

// For all texts created from now on. Throws InputError for an unknown code.
void speak(const QString& code);

// The last code accepted by speak(); initially "en".
QString spoken_language();

}  // namespace bodkin::app
