#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gr2to
{
/** `1 door`, `2 doors`. */
std::string countText(std::size_t count, const std::string& singular);

/** Shortest text that reads back to exactly the same number. */
std::string numberText(double value);

/** Whether text may hold the character, which is what XML can hold: no surrogates, no U+FFFE, no U+FFFF, and
 * below U+0020 only tab, line feed and carriage return. */
bool isTextCharacter(std::uint32_t codePoint);

/** How many bytes from the start are UTF-8 (nothing broken or overlong) of such characters. */
std::size_t textPrefix(std::string_view bytes);
inline bool isText(std::string_view bytes)
{
    return textPrefix(bytes) == bytes.size();
}

/** Whether UTF-8 text has a control character: U+0000 to U+001F (tab and line ends among them), U+007F to
 * U+009F. */
bool hasControlCharacter(std::string_view text);

/** Foreign text for a one-line message: in quotes, cut to about forty bytes, control characters as '?'. */
std::string excerpt(std::string_view text);
}  // namespace gr2to
