#include "io/xml_writer.h"

#include <fmt/format.h>
#include <libxml/xmlwriter.h>

#include "core/error.h"
#include "io/text_encoding.h"

namespace bodkin::io {

namespace {

const xmlChar* xml(const std::string& text) {
  return reinterpret_cast<const xmlChar*>(text.c_str());
}

// libxml2's writer fails for one reason only.
void done(int outcome) {
  if (outcome < 0) throw SystemError("out of memory while writing XML");
}

struct FreeBuffer {
  void operator()(xmlBuffer* buffer) const { xmlBufferFree(buffer); }
};
struct FreeWriter {
  void operator()(xmlTextWriter* writer) const { xmlFreeTextWriter(writer); }
};

}  // namespace

struct XmlWriter::Impl {
  std::unique_ptr<xmlBuffer, FreeBuffer> buffer{xmlBufferCreate()};
  std::unique_ptr<xmlTextWriter, FreeWriter> writer{buffer ? xmlNewTextWriterMemory(buffer.get(), 0) : nullptr};
};

XmlWriter::XmlWriter() : impl_(std::make_unique<Impl>()) {
  if (!impl_->writer) throw SystemError("out of memory while writing XML");
  done(xmlTextWriterSetIndent(impl_->writer.get(), 1));
  done(xmlTextWriterSetIndentString(impl_->writer.get(), xml("  ")));
  done(xmlTextWriterStartDocument(impl_->writer.get(), nullptr, "UTF-8", nullptr));
}

XmlWriter::XmlWriter(XmlWriter&&) noexcept = default;
XmlWriter::~XmlWriter() = default;

void XmlWriter::open(const std::string& element) {
  done(xmlTextWriterStartElement(impl_->writer.get(), xml(element)));
}

void XmlWriter::close() {
  done(xmlTextWriterEndElement(impl_->writer.get()));
}

void XmlWriter::attribute(const std::string& name, const std::string& value) {
  done(xmlTextWriterWriteAttribute(impl_->writer.get(), xml(name), xml(valid_text(value))));
}

void XmlWriter::attribute(const std::string& name, double value) {
  attribute(name, fmt::format("{}", value));
}

void XmlWriter::attribute(const std::string& name, int value) {
  attribute(name, fmt::format("{}", value));
}

void XmlWriter::attribute(const std::string& name, bool value) {
  attribute(name, value ? "true" : "false");
}

void XmlWriter::optional(const std::string& name, const std::string& value) {
  if (!value.empty()) attribute(name, value);
}

void XmlWriter::text_element(const std::string& element, const std::string& text) {
  done(xmlTextWriterWriteElement(impl_->writer.get(), xml(element), xml(valid_text(text))));
}

void XmlWriter::coordinates(const char* const (&names)[3], const Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) attribute(names[axis], vector[axis]);
}

std::string XmlWriter::finish() {
  done(xmlTextWriterEndDocument(impl_->writer.get()));
  impl_->writer.reset();  // flushes
  return {reinterpret_cast<const char*>(xmlBufferContent(impl_->buffer.get())),
          static_cast<std::size_t>(xmlBufferLength(impl_->buffer.get()))};
}

}  // namespace bodkin::io
