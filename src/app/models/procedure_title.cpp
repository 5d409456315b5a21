#include "app/models/procedure_title.h"

#include <algorithm>
#include <cctype>
#include <exception>

#include "training/procedure_file.h"

namespace bodkin::app {

std::string procedure_title(const std::string& name) {
  try {
    return training::find_shipped_procedure(name).title;
  } catch (const std::exception&) {  // not one of ours, or its file is missing: its use reports it
  }
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

}  // namespace bodkin::app
