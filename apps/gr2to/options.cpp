#include <iostream>

#include "Command.h"
#include "TableOptions.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/mrpt/simplemap.h"
#include "gr2to/pipeline/Gr2To.h"
#include "gr2to/view/Overlay.h"

namespace gr2to::cli
{
namespace
{
/** A `|` would end the cell of a Markdown table. */
std::string cell(const std::string& text)
{
    std::string out;
    for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
    return out;
}

std::string presetCell(const std::string& preset, const OptionTable& table, const OptionField& field)
{
    for (const auto& [name, value] : presetValues(table.section(), field))
        if (name == preset) return value;
    return field.valueText();
}

std::string fieldRow(const OptionTable& table, const OptionField& field)
{
    std::string row = "| `" + field.name + "` | " + cell(field.typeText()) + " |";
    for (const auto& preset : Gr2ToOptions::presets()) row += " " + presetCell(preset, table, field) + " |";
    return row + " " + field.unit + " | " + field.rangeText() + " | " + cell(field.meaning) + " |\n";
}

std::string section(OptionTable& table)
{
    std::string head = "\n## [" + table.section() + "]\n\n| name | type |";
    std::string rule = "|---|---|";
    for (const auto& preset : Gr2ToOptions::presets()) {
        head += " " + preset + " |";
        rule += "---|";
    }
    std::string text = head + " unit | range | meaning |\n" + rule + "---|---|---|\n";
    for (const OptionField& field : table.fields()) text += fieldRow(table, field);
    return text;
}

const char* const INTRODUCTION =
    R"(# Parameters

Every option of `gr2to extract`, with its value in each preset. Lengths are in metres whatever the grid's resolution. An option
can be given in three ways; a later one of this list wins:

1. `--preset NAME` sets all of them at once;
2. `-c FILE.ini`, an ini file as MRPT reads it, sets those that it names:

   ```ini
   [door]
   max_width = 1.2
   ```
3. `--door-max-width 1.2`, or `--set door.max_width=1.2`, on the command line sets one.

An unknown name is an error that tells the nearest known one; so is a value outside its range. `[input]` and `[scans]` are
also options of `gr2to info` and `gr2to compare`; `--resolution` is short for `--input-resolution`, `--z-min` and
`--z-max` for `--compression-z-min` and `--compression-z-max`.

`gr2to options --markdown` prints this page.
)";

class Options : public Command
{
 public:
    std::string name() const override { return "options"; }
    std::string arguments() const override { return "[--markdown]"; }
    std::string summary() const override { return "print the options of all stages"; }
    std::string description() const override
    {
        return "Prints every option with its default, as an ini file for 'gr2to extract -c', or as the page "
               "doc/parameters.md.";
    }
    bool hidden() const override { return true; }
    void declare(CLI::App& app) override
    {
        app.add_flag("--markdown", m_markdown, "Print a page of tables.");
    }
    int run() override
    {
        if (m_markdown) std::cout << INTRODUCTION;
        TGridReaderOptions reader;
        Gr2ToOptions stages;
        TOverlayOptions overlay;
        std::vector<OptionTable*> tables = stages.tables();
        TSimplemapOptions simplemap;
        tables.insert(tables.begin(), {&reader, &reader.scans});
        tables.insert(tables.end(), {&simplemap, &overlay});
        for (OptionTable* table : tables) std::cout << (m_markdown ? section(*table) : iniSection(*table));
        return kDone;
    }

 private:
    static std::string iniSection(OptionTable& table)
    {
        std::string text = "[" + table.section() + "]\n";
        for (const OptionField& field : table.fields())
            text += "# " + field.meaning + " " + termsOf(table, field) + "\n" + field.name + " = " +
                    field.valueText() + "\n";
        return text + "\n";
    }

    bool m_markdown = false;
};
}  // namespace

std::unique_ptr<Command> makeOptions()
{
    return std::make_unique<Options>();
}
}  // namespace gr2to::cli
