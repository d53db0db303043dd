#include "MappedRawlog.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "gr2to/base/errors.h"

namespace gr2to::cli
{
namespace fs = std::filesystem;

namespace
{
constexpr const char* kProgram = "gr2to-rawlog";

/** Beside this program where it is installed, or where it is built; else its bare name, for the PATH. */
std::string pathOfProgram()
{
    std::error_code ignored;
    const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const fs::path& place : {here / kProgram, here.parent_path() / kProgram / kProgram})
        if (fs::is_regular_file(place, ignored)) return place.string();
    return kProgram;
}

fs::path makeFolder()
{
    std::string name = (fs::temp_directory_path() / "gr2to-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw OutputError("cannot make a temporary folder '" + name + "': " + std::strerror(errno));
    return name;
}

/** A child process whose standard error comes to us. */
class Child
{
 public:
    explicit Child(std::vector<std::string> arguments)
    {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
        std::vector<char*> argv;
        argv.reserve(arguments.size() + 1);
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        const int failure = posix_spawnp(&m_id, argv[0], &actions, nullptr, argv.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[1]);
        m_errors = ends[0];
        if (failure == 0) return;
        close(m_errors);
        throw InputError(std::string("rawlogs are mapped by the program ") + kProgram +
                         ", which is neither beside gr2to nor on the PATH; build it with MRPT's SLAM library "
                         "(package libmrpt-slam-dev), or give the .simplemap that it makes elsewhere");
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() { close(m_errors); }

    /** Passes on what it says until it ends. \return its last error message, without its name */
    std::string listen() const
    {
        std::string line, error;
        char c = 0;
        while (read(m_errors, &c, 1) == 1) {
            line += c;
            if (c == '\n') error = passOn(line, error);
            if (c == '\n' || c == '%' || c == 'K') {  // ends of a line, of the bar, and of what wipes it
                if (line[0] == '\r') std::cerr << line << std::flush;
                line.clear();
            }
        }
        return error;
    }
    /** \return its exit code \throws std::runtime_error  a signal ended it */
    int wait() const
    {
        int status = 0;
        while (waitpid(m_id, &status, 0) < 0 && errno == EINTR) {
        }
        if (WIFEXITED(status)) return WEXITSTATUS(status);
        throw std::runtime_error(std::string(kProgram) + " was ended by signal " +
                                 std::to_string(WTERMSIG(status)));
    }

 private:
    static std::string passOn(const std::string& line, const std::string& errorBefore)
    {
        const std::string error = std::string(kProgram) + ": error: ", warning = std::string(kProgram) + ": ";
        if (line.rfind(error, 0) == 0) return line.substr(error.size(), line.size() - error.size() - 1);
        if (line.rfind(warning, 0) == 0)
            std::cerr << "gr2to: " << line.substr(warning.size());
        else if (line[0] != '\r')
            std::cerr << line;
        return errorBefore;
    }

    pid_t m_id = 0;
    int m_errors = -1;
};
}  // namespace

MappedRawlog::MappedRawlog(const fs::path& rawlog, const Options& options)
    : m_folder(makeFolder()), m_folderWhenStopped(m_folder), m_fileWhenStopped(simplemap())
{
    std::vector<std::string> arguments = {pathOfProgram(), rawlog.string(), "-o", simplemap().string()};
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty()) arguments.insert(arguments.end(), {option, value});
    };
    add("-c", options.config);
    add("--plugins", options.plugins);
    arguments.emplace_back(options.quiet || isatty(STDERR_FILENO) == 0 ? "-q" : "--progress");
    try {
        constexpr int BAD_INPUT = 2;
        const Child child(std::move(arguments));
        const std::string error = child.listen();
        const int code = child.wait();
        if (code == BAD_INPUT) throw InputError(error);
        if (code != 0)
            throw std::runtime_error(error.empty() ? std::string(kProgram) + " failed without a word"
                                                   : error);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
        throw;
    }
}

MappedRawlog::~MappedRawlog()
{
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
}
}  // namespace gr2to::cli
