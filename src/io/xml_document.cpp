#include "io/xml_document.h"

#include <optional>
#include <set>

#include <fmt/format.h>
#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <libxml/tree.h>
#include <libxml/xmlerror.h>
#include <libxml/xmlschemas.h>

#include "core/error.h"
#include "io/resources.h"
#include "io/xml_expectations.h"

namespace bodkin::io {

namespace {

constexpr std::size_t schema_limit = 1 << 20;  // bytes
constexpr int deepest = 16;

template <typename T, void (*release)(T*)>
struct Release {
  void operator()(T* object) const { release(object); }
};
using ParserContext = std::unique_ptr<xmlParserCtxt, Release<xmlParserCtxt, xmlFreeParserCtxt>>;
using Document = std::unique_ptr<xmlDoc, Release<xmlDoc, xmlFreeDoc>>;
using Schema = std::unique_ptr<xmlSchema, Release<xmlSchema, xmlSchemaFree>>;
using SchemaParser = std::unique_ptr<xmlSchemaParserCtxt, Release<xmlSchemaParserCtxt, xmlSchemaFreeParserCtxt>>;
using SchemaValidator = std::unique_ptr<xmlSchemaValidCtxt, Release<xmlSchemaValidCtxt, xmlSchemaFreeValidCtxt>>;

void release_text(xmlChar* text) {
  xmlFree(text);
}
using Text = std::unique_ptr<xmlChar, Release<xmlChar, release_text>>;

std::string not_a_schema(const std::string& name) {
  return fmt::format("{} is not a valid XML schema; install Bodkin again", shared_file(name).string());
}

std::string_view view(const xmlChar* text) {
  return text == nullptr ? std::string_view() : std::string_view(reinterpret_cast<const char*>(text));
}

// Attribute values and text come as a list of nodes; without entities every one of them is text.
std::string text_of(const xmlNode* first) {
  std::string text;
  for (const xmlNode* node = first; node != nullptr; node = node->next) {
    if (node->type == XML_TEXT_NODE || node->type == XML_CDATA_SECTION_NODE) text += view(node->content);
  }
  return text;
}

// The results of the parser's callbacks.
struct ParseFault {
  bool document_type = false;
  std::optional<int> line;
  int code = 0;
  std::string message;
};

ParseFault& fault_of(void* context) {
  return *static_cast<ParseFault*>(static_cast<xmlParserCtxt*>(context)->_private);
}

void refuse_document_type(void* context, const xmlChar*, const xmlChar*, const xmlChar*) {
  ParseFault& fault = fault_of(context);
  fault.document_type = true;
  fault.line = xmlSAX2GetLineNumber(context);
  xmlStopParser(static_cast<xmlParserCtxt*>(context));
}

void keep_first_parse_error(void* context, xmlErrorPtr error) {
  ParseFault& fault = fault_of(context);
  if (fault.line || error->level < XML_ERR_ERROR) return;
  fault.line = error->line;
  fault.code = error->code;
  fault.message = error->message == nullptr ? "" : error->message;
}

Document parse(std::string_view text, const std::string& origin, bool lines) {
  ParserContext context(xmlNewParserCtxt());
  if (!context) throw SystemError("out of memory while reading XML");
  ParseFault fault;
  context->_private = &fault;
  context->sax->internalSubset = refuse_document_type;
  context->sax->serror = keep_first_parse_error;
  // UTF-8 whatever the document declares: one encoding suffices, and the decoders of others remain unreachable.
  Document document(xmlCtxtReadMemory(context.get(), text.data(), static_cast<int>(text.size()), nullptr, "UTF-8",
                                      XML_PARSE_NONET | XML_PARSE_NOCDATA | XML_PARSE_BIG_LINES | XML_PARSE_COMPACT));
  if (fault.document_type) {
    fail_at(origin, lines ? *fault.line : 0,
            "a document type (<!DOCTYPE ...>) is not allowed; remove it and any entities it declares");
  }
  if (fault.line) fail_at(origin, lines ? *fault.line : 0, plain_parse_error(fault.code, fault.message));
  if (!document || xmlDocGetRootElement(document.get()) == nullptr)
    fail_at(origin, lines ? 1 : 0, "the file is not XML");
  return document;
}

// Copies a tree whose names may have prefixes, which it drops.
XmlElement copy(const xmlNode* node, bool lines) {
  XmlElement element;
  element.name = view(node->name);
  element.line = lines ? static_cast<int>(xmlGetLineNo(node)) : 0;
  element.text = text_of(node->children);
  for (const xmlAttr* attribute = node->properties; attribute != nullptr; attribute = attribute->next) {
    element.attributes.emplace_back(view(attribute->name), text_of(attribute->children));
  }
  for (const xmlNode* child = node->children; child != nullptr; child = child->next) {
    if (child->type == XML_ELEMENT_NODE) element.children.push_back(copy(child, lines));
  }
  return element;
}

// Refuses features unused by Bodkin files: deep nesting, and namespaces, through which a document could have its own
// schemas loaded.
void refuse_excess(const xmlNode* node, const std::string& origin, bool lines, int depth) {
  const int line = lines ? static_cast<int>(xmlGetLineNo(node)) : 0;
  const std::string_view name = view(node->name);
  if (depth > deepest) fail_at(origin, line, fmt::format("<{}> is nested deeper than {} levels", name, deepest));
  if (node->ns != nullptr || node->nsDef != nullptr) {
    fail_at(origin, line,
            fmt::format("<{}> uses an XML namespace; these files have none, so remove every xmlns and prefix", name));
  }
  for (const xmlAttr* attribute = node->properties; attribute != nullptr; attribute = attribute->next) {
    if (attribute->ns != nullptr) {
      fail_at(origin, line,
              fmt::format("<{}> has the attribute {}:{}, but attributes with a prefix are not allowed", name,
                          view(attribute->ns->prefix), view(attribute->name)));
    }
  }
  for (const xmlNode* child = node->children; child != nullptr; child = child->next) {
    if (child->type == XML_ELEMENT_NODE) refuse_excess(child, origin, lines, depth + 1);
  }
}

// A schema's document with its included documents inserted, each once (`read` holds their names).
Document schema_document(const std::string& name, std::set<std::string>& read) {
  read.insert(name);
  const std::string text = read_text_file(shared_file(name), schema_limit);
  ParserContext context(xmlNewParserCtxt());
  Document document(context ? xmlCtxtReadMemory(context.get(), text.data(), static_cast<int>(text.size()), nullptr,
                                                "UTF-8", XML_PARSE_NONET | XML_PARSE_NOERROR)
                            : nullptr);
  xmlNode* root = document ? xmlDocGetRootElement(document.get()) : nullptr;
  if (root == nullptr) throw SystemError(not_a_schema(name));
  for (xmlNode *node = root->children, *next = nullptr; node != nullptr; node = next) {
    next = node->next;
    if (node->type != XML_ELEMENT_NODE || view(node->name) != "include") continue;
    const Text location(xmlGetNoNsProp(node, reinterpret_cast<const xmlChar*>("schemaLocation")));
    const std::string other(view(location.get()));
    if (!read.contains(other)) {
      const Document included = schema_document(other, read);
      for (const xmlNode* part = xmlDocGetRootElement(included.get())->children; part != nullptr; part = part->next) {
        if (part->type != XML_ELEMENT_NODE) continue;
        // Next to the old node, so that prefixes keep their meaning.
        xmlNode* copied = xmlDocCopyNode(const_cast<xmlNode*>(part), document.get(), 1);
        if (copied == nullptr) throw SystemError("out of memory while reading the schema " + name);
        xmlAddPrevSibling(node, copied);
      }
    }
    xmlUnlinkNode(node);
    xmlFreeNode(node);
  }
  xmlReconciliateNs(document.get(), root);
  return document;
}

struct ValidityFault {
  bool found = false;
  int line = 0;
  SchemaError error;
};

void keep_first_validity_error(void* user, xmlErrorPtr error) {
  ValidityFault& fault = *static_cast<ValidityFault*>(user);
  if (fault.found) return;
  fault.found = true;
  fault.line = error->line;
  fault.error = {error->code, error->message == nullptr ? "" : error->message, {}, {}, {}, {}};
  const auto* node = static_cast<const xmlNode*>(error->node);
  if (node != nullptr && node->type == XML_ATTRIBUTE_NODE) node = node->parent;
  if (node == nullptr || node->type != XML_ELEMENT_NODE) return;
  fault.line = static_cast<int>(xmlGetLineNo(node));
  fault.error.element = view(node->name);
  if (node->parent != nullptr) fault.error.parent = view(node->parent->name);
  fault.error.text = text_of(node->children);
  for (const xmlAttr* attribute = node->properties; attribute != nullptr; attribute = attribute->next) {
    fault.error.attributes.emplace_back(view(attribute->name), text_of(attribute->children));
  }
}

void ignore_schema_error(void*, xmlErrorPtr) {}

}  // namespace

struct XmlSchema::Impl {
  Schema schema;
  SchemaExpectations expectations;
};

XmlSchema::XmlSchema(const std::string& name) {
  std::set<std::string> read;
  const Document document = schema_document(name, read);
  SchemaExpectations expectations(copy(xmlDocGetRootElement(document.get()), true));
  // From text again: a schema keeps parts of its source document.
  xmlChar* written = nullptr;
  int size = 0;
  xmlDocDumpMemory(document.get(), &written, &size);
  const Text text(written);
  SchemaParser parser(text ? xmlSchemaNewMemParserCtxt(reinterpret_cast<const char*>(written), size) : nullptr);
  if (!parser) throw SystemError("out of memory while reading the schema " + name);
  xmlSchemaSetParserStructuredErrors(parser.get(), ignore_schema_error, nullptr);
  Schema schema(xmlSchemaParse(parser.get()));
  if (!schema) throw SystemError(not_a_schema(name));
  impl_ = std::make_unique<Impl>(Impl{std::move(schema), std::move(expectations)});
}

XmlSchema::XmlSchema(XmlSchema&&) noexcept = default;
XmlSchema::~XmlSchema() = default;

XmlElement XmlSchema::read(std::string_view document, const std::string& origin, const XmlReading& how) const {
  if (document.empty()) throw InputError(fmt::format("{}: the file is empty", origin));
  const Document parsed = parse(document, origin, how.lines);
  const xmlNode* root = xmlDocGetRootElement(parsed.get());
  refuse_excess(root, origin, how.lines, 1);
  if (!how.root.empty() && view(root->name) != how.root) {
    fail_at(origin, how.lines ? static_cast<int>(xmlGetLineNo(root)) : 0, misplaced_root(view(root->name)));
  }
  SchemaValidator validator(xmlSchemaNewValidCtxt(impl_->schema.get()));
  if (!validator) throw SystemError("out of memory while checking " + origin);
  ValidityFault fault;
  xmlSchemaSetValidStructuredErrors(validator.get(), keep_first_validity_error, &fault);
  const int outcome = xmlSchemaValidateDoc(validator.get(), parsed.get());
  if (fault.found) fail_at(origin, how.lines ? fault.line : 0, impl_->expectations.plain(fault.error));
  if (outcome != 0) throw SystemError(fmt::format("{}: the schema check failed to run", origin));
  return copy(root, how.lines);
}

}  // namespace bodkin::io
