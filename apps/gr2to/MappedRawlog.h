#pragma once

#include <filesystem>
#include <string>

#include "gr2to/base/interruption.h"

namespace gr2to::cli
{
/** A rawlog as the simplemap that the program `gr2to-rawlog` makes of it, in a folder that goes with this
 * object.
 *
 * The program is looked for beside this one, then on the PATH. It is one of its own because MRPT's SLAM
 * library brings window toolkits along. Its warnings and its progress go on to standard error.
 */
class MappedRawlog
{
 public:
    struct Options
    {
        std::string config;   //!< file for `gr2to-rawlog -c`; may be empty
        std::string plugins;  //!< for `gr2to-rawlog --plugins`; may be empty
        bool quiet = false;
    };

    /** \throws InputError  the program is not there, or refuses the rawlog
     * \throws std::runtime_error  it fails
     */
    MappedRawlog(const std::filesystem::path& rawlog, const Options& options);
    MappedRawlog(const MappedRawlog&) = delete;
    MappedRawlog& operator=(const MappedRawlog&) = delete;
    ~MappedRawlog();

    std::filesystem::path simplemap() const { return m_folder / "mapped.simplemap"; }

 private:
    std::filesystem::path m_folder;
    UnfinishedOutput m_folderWhenStopped;
    UnfinishedOutput m_fileWhenStopped;
};
}  // namespace gr2to::cli
