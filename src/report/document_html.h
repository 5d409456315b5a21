#pragma once

#include <string>

#include "report/document.h"

namespace bodkin::report {

// The document as one self-contained HTML page: style and images are embedded, it refers to nothing outside.
std::string html_of(const Document& document);

}  // namespace bodkin::report
