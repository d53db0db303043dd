#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gr2to/base/OptionTable.h"

namespace gr2to::cli
{
/** `door.max_width` is `--door-max-width` on the command line. */
std::string flagOf(const OptionTable& table, const OptionField& field);

/** Unit, range and default of a field in words, with what other presets set it to. */
std::string termsOf(const OptionTable& table, const OptionField& field);

/** What the presets other than the default one set a field to, by the preset's name; only where it differs.
 */
std::vector<std::pair<std::string, std::string>> presetValues(const std::string& section,
                                                              const OptionField& field);

/** The options of tables on a command line: `--section-name VALUE` for each row, `--set section.name=VALUE`
 * and a configuration file.
 *
 * An option on the command line wins over the file; the tables' values from before win over neither.
 */
class TableOptions
{
 public:
    /** \param tables  outlive this object, which writes to them */
    explicit TableOptions(std::vector<OptionTable*> tables) : m_tables(std::move(tables)) {}

    void declare(CLI::App& app);
    /** Writes what was given into the tables and checks them.
     * \throws std::invalid_argument  unknown key (the nearest is named), bad value, an option given twice
     * \throws InputError             the file cannot be read
     */
    void apply();
    /** Whether anything was given on the command line. */
    bool given() const;
    /** Names of the options that apply() has set, `section.name`, in order. */
    const std::set<std::string>& names() const { return m_names; }

 private:
    struct Row
    {
        OptionTable* table = nullptr;
        std::string name;
        const CLI::Option* option = nullptr;
    };

    void set(const std::string& key, const std::string& value);
    void applyFile();
    void applyCommandLine();

    std::vector<OptionTable*> m_tables;
    std::vector<Row> m_rows;
    std::vector<std::string> m_assignments;
    std::string m_config;
    std::set<std::string> m_names;
};
}  // namespace gr2to::cli
