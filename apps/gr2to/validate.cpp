#include <iostream>

#include "Command.h"
#include "describe.h"
#include "gr2to/mrpt/archive.h"
#include "json.h"
#include "parse.h"

namespace gr2to::cli
{
namespace
{
class Validate : public Command
{
 public:
    std::string name() const override { return "validate"; }
    std::string arguments() const override { return "FILE [--json]"; }
    std::string summary() const override { return "check a topological map"; }
    std::string description() const override
    {
        return "Checks a topological map: that FILE (topomap.xml, or a .gr2to archive) can be read with "
               "nothing "
               "unknown, missing or out of order in it, and that the map keeps the model's rules, such as "
               "unit "
               "normals, positive areas and symmetric covariances. Prints 'valid', or a line for each rule "
               "that is "
               "broken and exits with 2.\n\n"
               "To check an XML file against its schema alone: xmllint --noout --schema topomap.xsd FILE, "
               "with the "
               "schema that is installed in share/gr2to.";
    }
    void declare(CLI::App& app) override
    {
        addOption(app, "FILE", m_file, "", "The map, or a folder that 'gr2to extract' wrote.")->required();
        app.add_flag("--json", m_json, "Print JSON instead of text.");
    }
    int run() override
    {
        const auto file = mapFileIn(m_file);
        const auto findings = loadTopologicalMap(file).validate();
        if (m_json)
            std::cout << jsonText(
                {{"file", file.string()}, {"valid", findings.empty()}, {"findings", findings}});
        else if (findings.empty())
            std::cout << file.string() << ": valid\n";
        else
            for (const auto& finding : findings) std::cout << file.string() << ": " << finding << '\n';
        return findings.empty() ? kDone : kBadUsage;
    }

 private:
    std::string m_file;
    bool m_json = false;
};
}  // namespace

std::unique_ptr<Command> makeValidate()
{
    return std::make_unique<Validate>();
}
}  // namespace gr2to::cli
