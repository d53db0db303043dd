#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace gr2to
{
/** An element of which nothing is overlooked: attributes and children that no one asked for are errors.
 *
 * Every complaint is an InputError of the form `file: path/of/element: complaint`.
 */
class StrictElement
{
 public:
    /** \param file  name of the file, which must outlive the element */
    StrictElement(const std::string& file, pugi::xml_node node) : m_file(&file), m_node(node) {}

    [[noreturn]] void fail(const std::string& complaint) const;
    std::string name() const { return m_node.name(); }

    /** Checks that all of the first and none but these attributes are there, each once. */
    void expectAttributes(std::initializer_list<std::string_view> required,
                          std::initializer_list<std::string_view> optional = {}) const;
    std::string text(const char* attribute) const;
    double number(const char* attribute) const;
    std::optional<double> optionalNumber(const char* attribute) const;
    /** As many finite numbers as the list must have; nothing when the attribute is absent. */
    std::vector<double> optionalNumbers(const char* attribute, std::size_t count) const;
    /** A whole number from 1 to `largest`. */
    std::uint32_t id(const char* attribute, std::uint32_t largest) const;
    bool flag(const char* attribute) const;
    /** Index of the value among the choices. */
    std::size_t choice(const char* attribute, std::initializer_list<std::string_view> choices) const;

    /** Child elements: exactly these, in this order; no text beside them. */
    std::vector<StrictElement> sequence(std::initializer_list<std::string_view> names) const;
    /** Child elements that all have this name; no text beside them. */
    std::vector<StrictElement> list(std::string_view name) const;
    bool hasChild(const char* name) const { return static_cast<bool>(m_node.child(name)); }
    /** The text of an element without child elements; no attributes. */
    std::string content() const;

 private:
    std::vector<StrictElement> childElements() const;

    const std::string* m_file;
    pugi::xml_node m_node;
};

/** Parses a whole UTF-8 file. Comments and processing instructions are skipped.
 * \return its root element's node
 * \throws InputError  with line and byte: not well-formed, not UTF-8, an undefined entity, a document type
 * declaration
 */
pugi::xml_node parseStrictXml(pugi::xml_document& document, std::string_view text, const std::string& file);

/** A finite number that fills the text, blanks around it aside. */
std::optional<double> parseFiniteNumber(std::string_view text);
/** Pieces between XML's white space. */
std::vector<std::string_view> splitAtBlanks(std::string_view text);
}  // namespace gr2to
