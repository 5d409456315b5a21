#pragma once

#include <string>

#include "report/document.h"

namespace bodkin::report {

// The document as the bytes of a PDF file on pages of A4, for printing and archiving: its text is text and its plots
// are lines. Tables repeat their heads on every page. Parts folded away in the HTML page are left out. Throws
// SystemError when memory is short.
std::string pdf_of(const Document& document);

}  // namespace bodkin::report
