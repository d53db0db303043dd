#include "gr2to/base/text.h"

#include <charconv>

namespace gr2to
{
namespace
{
constexpr std::uint32_t INVALID = 0xFFFFFFFF;

/** Takes one code point off the front; INVALID when the bytes are not UTF-8. */
std::uint32_t takeCodePoint(std::string_view& bytes)
{
    const auto lead = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    if (lead < 0x80) return lead;
    const std::size_t followers = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
    if (lead < 0xC2 || lead > 0xF4 || bytes.size() < followers) return INVALID;
    std::uint32_t code = lead & (0x3FU >> followers);
    for (std::size_t i = 0; i < followers; ++i) {
        const auto follower = static_cast<unsigned char>(bytes[i]);
        if ((follower & 0xC0U) != 0x80U) return INVALID;
        code = (code << 6U) | (follower & 0x3FU);
    }
    bytes.remove_prefix(followers);
    constexpr std::uint32_t SMALLEST[] = {0, 0x80, 0x800, 0x10000};
    return code < SMALLEST[followers] ? INVALID : code;
}
}  // namespace

std::string countText(std::size_t count, const std::string& singular)
{
    return std::to_string(count) + " " + singular + (count == 1 ? "" : "s");
}

std::string numberText(double value)
{
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
}

bool isTextCharacter(std::uint32_t codePoint)
{
    if (codePoint < 0x20) return codePoint == '\t' || codePoint == '\n' || codePoint == '\r';
    const bool surrogate = codePoint >= 0xD800 && codePoint <= 0xDFFF;
    return codePoint <= 0x10FFFF && !surrogate && codePoint != 0xFFFE && codePoint != 0xFFFF;
}

std::size_t textPrefix(std::string_view bytes)
{
    std::string_view rest = bytes;
    while (!rest.empty()) {
        const std::size_t start = bytes.size() - rest.size();
        if (!isTextCharacter(takeCodePoint(rest))) return start;
    }
    return bytes.size();
}

bool hasControlCharacter(std::string_view text)
{
    while (!text.empty()) {
        const std::uint32_t code = takeCodePoint(text);
        if (code < 0x20 || (code >= 0x7F && code <= 0x9F)) return true;
    }
    return false;
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t LONGEST = 40;
    std::size_t end = text.size();
    if (end > LONGEST) {
        end = LONGEST;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    }
    std::string result = "'";
    for (const char c : text.substr(0, end))
        result += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    return result + (end < text.size() ? "...'" : "'");
}
}  // namespace gr2to
