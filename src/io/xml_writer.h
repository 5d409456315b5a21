#pragma once

#include <memory>
#include <string>

#include "core/geometry.h"

namespace bodkin::io {

// Writes an XML document, element by element. Texts are made valid: what is not UTF-8 or not allowed in XML becomes
// U+FFFD. Throws SystemError when memory runs out.
class XmlWriter {
 public:
  XmlWriter();
  XmlWriter(XmlWriter&&) noexcept;
  ~XmlWriter();

  void open(const std::string& element);
  void close();
  // The shortest text that reads back to the same bits.
  void attribute(const std::string& name, double value);
  void attribute(const std::string& name, int value);
  void attribute(const std::string& name, bool value);
  void attribute(const std::string& name, const std::string& value);
  void attribute(const std::string& name, const char* value) { attribute(name, std::string(value)); }
  // Nothing for an empty value.
  void optional(const std::string& name, const std::string& value);
  void text_element(const std::string& element, const std::string& text);
  void coordinates(const char* const (&names)[3], const Vec3& vector);

  // The whole document; the writer is used up.
  std::string finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bodkin::io
