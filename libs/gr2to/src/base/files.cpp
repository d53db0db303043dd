#include "gr2to/base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "gr2to/base/errors.h"

namespace gr2to
{
namespace fs = std::filesystem;

namespace
{
std::string reason()
{
    return std::generic_category().message(errno);
}

/** Closes on every way out; close() itself is checked by the caller through release(). */
class Descriptor
{
 public:
    explicit Descriptor(int fd) : m_fd(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (m_fd >= 0) ::close(m_fd);
    }
    int get() const { return m_fd; }
    int release() { return std::exchange(m_fd, -1); }

 private:
    int m_fd;
};

/** Permissions do not tell all: a file system may be of a kind that takes no files. */
void tryToCreate(const fs::path& path, const fs::path& folder)
{
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    if (file.get() >= 0)
        ::unlink(path.c_str());
    else if (errno == ENOSPC || errno == EDQUOT)
        throw OutputError("cannot create '" + path.string() + "': " + reason());
    else
        throw InputError("the output folder '" + folder.string() + "' takes no files: " + reason());
}
}  // namespace

void writeFile(const fs::path& path, std::string_view bytes)
{
    const auto fail = [&](const char* what) {
        throw OutputError("cannot " + std::string(what) + " '" + path.string() + "': " + reason());
    };
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.get() < 0) fail("create");
    while (!bytes.empty()) {
        const auto written = ::write(file.get(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("write");
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::close(file.release()) != 0) fail("finish writing");
}

std::string readFile(const fs::path& path)
{
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::exists(status)) throw InputError("'" + path.string() + "' does not exist");
    if (fs::is_directory(status)) throw InputError("'" + path.string() + "' is a folder; name a file in it");
    if (fs::is_character_file(status) || fs::is_block_file(status) || fs::is_socket(status))
        throw InputError("'" + path.string() + "' is a device, not a file; name a file or a pipe");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError("'" + path.string() + "' cannot be opened: " + reason());
    std::string bytes;
    if (const auto size = fs::file_size(path, error); !error) bytes.reserve(size);
    char buffer[1 << 16];
    while (in.read(buffer, sizeof buffer) || in.gcount() > 0)
        bytes.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (in.bad()) throw InputError("'" + path.string() + "' cannot be read: " + reason());
    if (bytes.empty()) throw InputError("'" + path.string() + "' is empty");
    return bytes;
}

OutputTransaction::~OutputTransaction()
{
    std::error_code ignored;
    for (const auto& file : m_files) fs::remove(file.temporary, ignored);
    for (auto folder = m_foldersMade.rbegin(); folder != m_foldersMade.rend(); ++folder)
        fs::remove(folder->path, ignored);  // only when empty
}

fs::path OutputTransaction::stage(const fs::path& target)
{
    std::error_code error;
    if (fs::is_directory(target, error))
        throw InputError("'" + target.string() + "' is a folder; name a file to write");
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::vector<fs::path> missing;
    for (fs::path p = folder; !p.empty() && !fs::exists(p, error); p = p.parent_path()) missing.push_back(p);
    for (auto p = missing.rbegin(); p != missing.rend(); ++p) {
        if (!fs::create_directory(*p, error) || error)
            throw InputError("the output folder '" + p->string() + "' cannot be made: " + error.message());
        m_foldersMade.push_back({*p, UnfinishedOutput(*p)});
    }
    if (!fs::is_directory(folder, error)) throw InputError("'" + folder.string() + "' is not a folder");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw InputError("the output folder '" + folder.string() + "' is not writable: " + reason());
    fs::path temporary = folder / ("." + target.filename().string() + ".part-" + std::to_string(::getpid()));
    tryToCreate(temporary, folder);
    m_files.push_back({temporary, target, UnfinishedOutput(temporary)});
    return temporary;
}

void OutputTransaction::commit()
{
    for (const auto& file : m_files) {
        std::error_code error;
        fs::rename(file.temporary, file.target, error);
        if (error)
            throw OutputError("cannot rename '" + file.temporary.string() + "' to '" + file.target.string() +
                              "': " + error.message());
    }
    m_files.clear();
    m_foldersMade.clear();
}
}  // namespace gr2to
