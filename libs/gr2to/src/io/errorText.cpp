#include "io/errorText.h"

#include <charconv>

namespace gr2to::io
{
std::string inQuotes(std::string_view text)
{
    constexpr std::size_t longest = 300;
    std::string out = "'";
    for (const char c : text.substr(0, longest))
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return out + (text.size() > longest ? "...'" : "'");
}

std::string numberText(double value)
{
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string firstSentence(std::string_view message)
{
    constexpr std::string_view label = "Message:";
    if (const auto at = message.find(label); at != std::string_view::npos)
        message.remove_prefix(at + label.size());
    const auto start = message.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return "no reason given";
    message.remove_prefix(start);
    return std::string(message.substr(0, message.find_first_of("\r\n")));
}
}  // namespace gr2to::io
