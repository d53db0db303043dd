#include <iostream>

#include "Command.h"
#include "help.h"

namespace gr2to::cli
{
namespace
{
/** Text as troff prints it literally: hyphens are minus signs, so that options can be copied and searched. */
std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    return out;
}

/** Paragraphs; no line starts with a character that troff takes for a request. */
std::string paragraphs(const std::string& text)
{
    std::string out;
    for (const char c : escaped(text)) {
        const bool atLineStart = out.empty() || out.back() == '\n';
        if (atLineStart && c == '\n') {
            out += ".PP\n";
            continue;
        }
        if (atLineStart && (c == '.' || c == '\'')) out += "\\&";
        out += c;
    }
    return out;
}

std::string optionEntry(const CLI::Option& option)
{
    return ".TP\n.B " + escaped(optionSyntax(option)) + "\n" + paragraphs(option.get_description()) + "\n";
}

std::string commandSection(Command& command)
{
    CLI::App app("", "gr2to " + command.name());
    command.declare(app);
    std::string text = ".SS \"gr2to " + escaped(command.name() + " " + command.arguments()) + "\"\n" +
                       paragraphs(command.description()) + "\n";
    for (const auto& [group, options] : optionGroups(app)) {
        text += ".PP\n" + escaped(group) + ":\n";
        for (const CLI::Option* option : options) text += optionEntry(*option);
    }
    return text;
}

class Man : public Command
{
 public:
    std::string name() const override { return "man"; }
    std::string arguments() const override { return ""; }
    std::string summary() const override { return "print the man page"; }
    std::string description() const override
    {
        return "Prints the man page, gr2to.1, in troff's man macros.";
    }
    bool hidden() const override { return true; }
    void declare(CLI::App&) override {}
    int run() override
    {
        std::cout << ".TH GR2TO 1 \"\" \"gr2to " GR2TO_VERSION "\" \"User Commands\"\n"
                  << ".SH NAME\ngr2to \\- topological maps of places, doors and walls from occupancy grids\n"
                  << ".SH SYNOPSIS\n";
        const Commands commands = allCommands();
        for (const auto& command : commands)
            if (!command->hidden())
                std::cout << ".B gr2to " << escaped(command->name()) << "\n"
                          << escaped(command->arguments()) << "\n.br\n";
        std::cout << ".SH COMMANDS\n";
        for (const auto& command : commands)
            if (!command->hidden()) std::cout << commandSection(*command);
        std::cout << ".SH EXIT STATUS\n"
                  << paragraphs(kExitCodes) << "\nErrors go to standard error, one line each.\n"
                  << ".SH EXAMPLES\n.nf\ngr2to extract office.yaml \\-o out\n"
                  << "gr2to extract plan.png \\-\\-resolution 0.05 \\-\\-door\\-max\\-width 1.2\n"
                  << "gr2to info out/topomap.xml\n"
                  << "gr2to compare out office.gt_labels.png \\-\\-grid office.yaml\n.fi\n";
        return kDone;
    }
};
}  // namespace

std::unique_ptr<Command> makeMan()
{
    return std::make_unique<Man>();
}
}  // namespace gr2to::cli
