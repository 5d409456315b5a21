#pragma once

#include <memory>
#include <string>

#include "core/geometry.h"

namespace bodkin::io {

// Writes an XML document, element by element. Invalid UTF-8 and characters not allowed in XML become U+FFFD. Throws
// SystemError when memory runs out.
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
  // No attribute for an empty value.
  void optional(const std::string& name, const std::string& value);
  void text_element(const std::string& element, const std::string& text);
  void coordinates(const char* const (&names)[3], const Vec3& vector);

  // The whole document; the writer must not be used afterwards.
  std::string finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bodkin::io
