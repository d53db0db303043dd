#pragma once

#include <mrpt/config/CLoadableOptions.h>

#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace gr2to
{
/** One row of an option table: everything that loading, dumping, checking, `--help` and the docs need to
 * know. */
struct OptionField
{
    /** A `std::optional` is for a number that is worked out when it is not given; its text is then `auto`. */
    using Value = std::variant<double*, int*, bool*, std::string*, std::optional<double>*>;

    std::string name;     //!< for example `max_width`; its full key is `section.name`
    Value value;          //!< the member that holds it
    std::string unit;     //!< `m`, `m2`, `deg`, `ratio`, `cells`; empty for switches, counts and names
    std::string meaning;  //!< one sentence
    double minimum = -std::numeric_limits<double>::infinity();  //!< inclusive
    double maximum = std::numeric_limits<double>::infinity();   //!< inclusive
    std::vector<std::string> choices = {};                      //!< of a name; empty when anything goes

    std::string valueText() const;  //!< shortest text that reads back to the same value
    std::string typeText() const;   //!< `number`, `number|auto`, `integer`, `yes|no` or the choices
    std::string rangeText() const;  //!< for example `[0, 1]`; empty when unbounded
};

/** Base of every option struct: one table, from which all else follows.
 *
 * A derived struct has plain public members with defaults, names its section and lists its fields; rules that
 * involve two fields go into `checkRules()`.
 */
class OptionTable : public mrpt::config::CLoadableOptions
{
 public:
    virtual std::string section() const = 0;
    /** The table; `value` points into this object. */
    virtual std::vector<OptionField> fields() = 0;

    /** Sets one field from text; `name` without the section.
     * \throws std::invalid_argument  unknown name (the message names the nearest), unreadable or out-of-range
     * value
     */
    void set(const std::string& name, const std::string& text);
    /** Checks ranges, then the rules between fields.
     * \throws std::invalid_argument  naming the field, its value, the rule and the remedy
     */
    void check() const;

    /** Reads every key of the section. \throws std::invalid_argument  as set() and check() */
    void loadFromConfigFile(const mrpt::config::CConfigFileBase& source, const std::string& section) override;
    /** Loads the section of this table's own name. */
    void loadFrom(const mrpt::config::CConfigFileBase& source) { loadFromConfigFile(source, section()); }
    void saveToConfigFile(mrpt::config::CConfigFileBase& target, const std::string& section) const override;
    void dumpToTextStream(std::ostream& out) const override;

 protected:
    OptionTable() = default;
    OptionTable(const OptionTable&) = default;
    OptionTable& operator=(const OptionTable&) = default;
    OptionTable(OptionTable&&) = default;
    OptionTable& operator=(OptionTable&&) = default;
    ~OptionTable() override = default;

    virtual void checkRules() const {}
};

/** The candidate that is nearest to a word by edit distance; empty when there is no candidate. */
std::string nearestWord(const std::string& word, const std::vector<std::string>& candidates);
}  // namespace gr2to
