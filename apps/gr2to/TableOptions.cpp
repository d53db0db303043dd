#include "TableOptions.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "gr2to/pipeline/Gr2To.h"
#include "iniFile.h"
#include "parse.h"

namespace gr2to::cli
{
namespace
{
const std::string kTablesGroup = "Options of ";

/** Stands for the value in help: `M` for metres, `yes|no`, `N` for a bare number. */
std::string metavarOf(const OptionField& field)
{
    if (std::holds_alternative<bool*>(field.value) || !field.choices.empty()) return field.typeText();
    if (std::holds_alternative<std::string*>(field.value)) return "TEXT";
    if (field.unit.empty()) return "N";
    std::string metavar = field.unit;
    std::transform(metavar.begin(), metavar.end(), metavar.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return std::holds_alternative<std::optional<double>*>(field.value) ? metavar + "|auto" : metavar;
}

std::string namesOf(const OptionTable& table, const OptionField& field)
{
    std::string flag = flagOf(table, field);
    for (const char* shortened : {"resolution", "z-min", "z-max"})
        for (const char* prefix : {"--input-", "--compression-"})
            if (flag == std::string(prefix) + shortened) return std::string("--") + shortened + "," + flag;
    return flag;
}
}  // namespace

std::string flagOf(const OptionTable& table, const OptionField& field)
{
    std::string flag = "--" + table.section() + "-" + field.name;
    std::replace(flag.begin(), flag.end(), '_', '-');
    return flag;
}

std::vector<std::pair<std::string, std::string>> presetValues(const std::string& section,
                                                              const OptionField& field)
{
    std::vector<std::pair<std::string, std::string>> values;
    for (const auto& preset : Gr2ToOptions::presets()) {
        Gr2ToOptions options = Gr2ToOptions::preset(preset);
        for (OptionTable* table : options.tables())
            for (const OptionField& other : table->fields())
                if (table->section() == section && other.name == field.name &&
                    other.valueText() != field.valueText())
                    values.emplace_back(preset, other.valueText());
    }
    return values;
}

std::string termsOf(const OptionTable& table, const OptionField& field)
{
    std::string terms;
    if (!field.unit.empty()) terms += "unit " + field.unit + ", ";
    if (!field.rangeText().empty()) terms += "range " + field.rangeText() + ", ";
    terms += "default " + field.valueText();
    for (const auto& [preset, value] : presetValues(table.section(), field))
        terms.append(", ").append(value).append(" with preset ").append(preset);
    return "(" + terms + ")";
}

void TableOptions::declare(CLI::App& app)
{
    addOption(app, "-c,--config", m_config, "FILE",
              "Read options from an ini file: a line [section], then lines name = value, named as below. "
              "Options on the command line win over the file.");
    app.add_option("--set", m_assignments,
                   "Set an option by the name that it has in a configuration file; may be repeated.")
        ->type_name("SECTION.NAME=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    for (OptionTable* table : m_tables)
        for (const OptionField& field : table->fields()) {
            CLI::Option* option = app.add_option(namesOf(*table, field),
                                                 CLI::callback_t([](const CLI::results_t&) { return true; }),
                                                 field.meaning + " " + termsOf(*table, field));
            option->type_name(metavarOf(field))
                ->expected(1)
                ->group(kTablesGroup + "section [" + table->section() + "]");
            m_rows.push_back({table, field.name, option});
        }
}

void TableOptions::apply()
{
    if (!m_config.empty()) applyFile();
    applyCommandLine();
    for (const OptionTable* table : m_tables) table->check();
}

bool TableOptions::given() const
{
    return !m_config.empty() || !m_assignments.empty() ||
           std::any_of(m_rows.begin(), m_rows.end(), [](const Row& row) { return row.option->count() > 0; });
}

void TableOptions::set(const std::string& key, const std::string& value)
{
    std::vector<std::string> known;
    for (OptionTable* table : m_tables)
        for (const OptionField& field : table->fields()) {
            known.push_back(table->section() + "." + field.name);
            if (known.back() == key) {
                m_names.insert(key);
                return table->set(field.name, value);
            }
        }
    throw std::invalid_argument("unknown option '" + key + "'; did you mean '" + nearestWord(key, known) +
                                "'?");
}

void TableOptions::applyFile()
{
    for (const IniEntry& entry : readIniFile(m_config)) try
        {
            set(entry.key, entry.value);
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("'" + m_config + "', line " + std::to_string(entry.line) + ": " +
                                        error.what());
        }
}

void TableOptions::applyCommandLine()
{
    std::set<std::string> given;
    const auto setOnce = [&](const std::string& key, const std::string& value) {
        if (!given.insert(key).second)
            throw std::invalid_argument("option '" + key +
                                        "' is given twice on the command line; give it once");
        set(key, value);
    };
    for (const Row& row : m_rows)
        if (row.option->count() > 0)
            setOnce(row.table->section() + "." + row.name, row.option->results().front());
    for (const std::string& assignment : m_assignments) {
        const auto equals = assignment.find('=');
        if (equals == std::string::npos)
            throw std::invalid_argument(
                "--set '" + assignment +
                "' has no '='; write it as section.name=value, for example door.max_width=1.2");
        setOnce(assignment.substr(0, equals), assignment.substr(equals + 1));
    }
}
}  // namespace gr2to::cli
