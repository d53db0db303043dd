#include <algorithm>
#include <cctype>
#include <charconv>

#include "StrictXml.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/text.h"

namespace gr2to
{
namespace
{
/** Says what is not well-formed and where. */
class Complainer
{
 public:
    Complainer(std::string_view text, const std::string& file) : m_text(text), m_file(file) {}

    [[noreturn]] void fail(std::size_t byte, const std::string& complaint) const
    {
        byte = std::min(byte, m_text.size());
        const auto line =
            1 + std::count(m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
        throw InputError(m_file + ": line " + std::to_string(line) + " (byte " + std::to_string(byte) +
                         ") is not well-formed XML: " + complaint);
    }

 private:
    std::string_view m_text;
    const std::string& m_file;
};

bool startsWith(std::string_view text, std::string_view prefix)
{
    return text.substr(0, prefix.size()) == prefix;
}

/** What stands between `&` and `;`: one of XML's five names or the number of a character that text may hold.
 */
bool isReference(std::string_view body)
{
    if (!startsWith(body, "#"))
        return body == "amp" || body == "lt" || body == "gt" || body == "quot" || body == "apos";
    body.remove_prefix(1);
    const bool hex = startsWith(body, "x");
    if (hex) body.remove_prefix(1);
    std::uint32_t code = 0;
    const char* end = body.data() + body.size();
    const auto result = std::from_chars(body.data(), end, code, hex ? 16 : 10);
    return result.ec == std::errc() && result.ptr == end && isTextCharacter(code);
}

/** The parser leaves references that it does not know as they stand; a strict reader must not. */
void checkReferences(std::string_view text, const Complainer& complainer)
{
    constexpr std::pair<std::string_view, std::string_view> RAW[] = {
        {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};
    for (std::size_t at = text.find_first_of("<&"); at != std::string_view::npos;
         at = text.find_first_of("<&", at))
    {
        const std::string_view rest = text.substr(at);
        if (rest.front() == '&') {
            constexpr std::size_t LONGEST = 12;
            const std::size_t semicolon = rest.substr(0, LONGEST).find(';');
            if (semicolon == std::string_view::npos || !isReference(rest.substr(1, semicolon - 1)))
                complainer.fail(at, excerpt(rest.substr(0, std::min(semicolon, LONGEST - 1) + 1)) +
                                        " is not a reference to a character; a plain & is written &amp;");
        }
        std::size_t next = at + 1;
        for (const auto& [open, close] : RAW)
            if (startsWith(rest, open)) {
                const std::size_t end = rest.find(close, open.size());
                if (end == std::string_view::npos) return;  // the parser says so
                next = at + end + close.size();
            }
        at = next;
    }
}

bool isUtf8Name(std::string name)
{
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name.empty() || name == "utf-8" || name == "utf8" || name == "us-ascii";
}

/** What is wrong with a node that stands beside or is the root element; null when nothing is. */
const char* complaintAbout(pugi::xml_node node, bool first)
{
    switch (node.type()) {
        case pugi::node_element:
            return first ? nullptr : "there is a second root element";
        case pugi::node_doctype:
            return "a document type declaration is not supported; remove it";
        case pugi::node_declaration:
            return isUtf8Name(node.attribute("encoding").value())
                       ? nullptr
                       : "the encoding must be UTF-8; convert the file";
        default: {
            const bool blank =
                std::string_view(node.value()).find_first_not_of(" \t\r\n") == std::string_view::npos;
            return blank ? nullptr : "there is text outside the root element";
        }
    }
}
}  // namespace

pugi::xml_node parseStrictXml(pugi::xml_document& document, std::string_view text, const std::string& file)
{
    const Complainer complainer(text, file);
    if (const std::size_t good = textPrefix(text); good < text.size())
        complainer.fail(good, "it is not UTF-8 text without control characters");
    checkReferences(text, complainer);

    // Blank text is kept because a word may be blank; fragments are allowed so that text beside the root
    // shows.
    const unsigned options = pugi::parse_default | pugi::parse_ws_pcdata | pugi::parse_declaration |
                             pugi::parse_doctype | pugi::parse_fragment;
    const std::size_t start = startsWith(text, "\xEF\xBB\xBF") ? 3 : 0;
    const auto byteOf = [start](std::ptrdiff_t offset) {
        return start + static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
    };
    const auto result =
        document.load_buffer(text.data() + start, text.size() - start, options, pugi::encoding_utf8);
    if (!result) complainer.fail(byteOf(result.offset), result.description());

    pugi::xml_node root;
    for (const auto node : document.children()) {
        if (const char* complaint = complaintAbout(node, !root))
            complainer.fail(byteOf(node.offset_debug()), complaint);
        if (node.type() == pugi::node_element) root = node;
    }
    if (!root) complainer.fail(text.size(), "there is no root element");
    return root;
}
}  // namespace gr2to
