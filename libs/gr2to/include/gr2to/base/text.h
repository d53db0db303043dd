#pragma once

#include <string>
#include <string_view>

namespace gr2to
{
/** Shortest text that reads back to exactly the same number. */
std::string numberText(double value);

/** Whether bytes are UTF-8 made only of characters that XML can hold.
 *
 * Refused are broken or overlong sequences, surrogates, U+FFFE, U+FFFF, and controls below U+0020 other than
 * tab, line feed and carriage return.
 */
bool isText(std::string_view bytes);

/** Whether UTF-8 text has a control character: U+0000 to U+001F (tab and line ends among them), U+007F to
 * U+009F. */
bool hasControlCharacter(std::string_view text);

/** Foreign text for a one-line message: in quotes, cut to about forty bytes, control characters as '?'. */
std::string quoted(std::string_view text);
}  // namespace gr2to
