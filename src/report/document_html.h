#pragma once

#include <string>

#include "report/document.h"

namespace bodkin::report {

// The document as one HTML page that stands alone: style and pictures lie inside, it refers to nothing outside.
std::string html_of(const Document& document);

}  // namespace bodkin::report
