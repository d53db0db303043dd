#include "gr2to/io/OctreeReader.h"

#include <octomap/OcTree.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <streambuf>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/base/text.h"
#include "io/errorText.h"

namespace gr2to
{
namespace
{
constexpr std::string_view kBinaryMark = "# Octomap OcTree binary file";
constexpr std::string_view kFullMark = "# Octomap OcTree file";
constexpr int kDepth = 16;  // of every OcTree

struct Header
{
    bool binary = false;  //!< `.bt`, else `.ot`
    std::string id;
    std::string size;
    double resolution_m = 0;
    std::size_t dataAt = 0;
};

[[noreturn]] void refuse(const std::string& name, const std::string& what)
{
    throw InputError(name + " is an OctoMap file " + what);
}

Header readHeader(const std::string& bytes, const std::string& name)
{
    Header header;
    header.binary = bytes.compare(0, kBinaryMark.size(), kBinaryMark) == 0;
    for (std::size_t begin = 0; begin < bytes.size();) {
        const std::size_t end = bytes.find('\n', begin);
        if (end == std::string::npos) break;
        std::istringstream line(bytes.substr(begin, end - begin));
        begin = end + 1;
        std::string key;
        line >> key;
        if (key == "data") {
            header.dataAt = begin;
            break;
        }
        if (key == "id") line >> header.id;
        if (key == "size") line >> header.size;
        if (key == "res") line >> header.resolution_m;
    }
    if (header.dataAt == 0)
        refuse(
            name,
            "whose header does not end in a line 'data'; it is truncated or damaged: save or copy it again");
    if (header.id != "OcTree")
        refuse(name, "of the tree type " + excerpt(header.id) +
                         "; only trees of type OcTree are read: convert it, for "
                         "example with OctoMap's convert_octree");
    if (!(header.resolution_m >= 1e-4 && header.resolution_m <= 100))
        refuse(name,
               "whose resolution 'res' is not a number from 0.0001 to 100 m; it is damaged: save it again");
    return header;
}

/** Walks over the nodes as they are stored: a node, then its children's branches in order. */
class NodeCounter
{
 public:
    NodeCounter(std::string_view data, const Header& header, const std::string& name)
        : m_data(data), m_header(header), m_name(name)
    {
    }

    std::size_t nodes() const { return m_nodes; }
    std::size_t bytes() const
    {
        return m_nodes * sizeof(octomap::OcTreeNode) + m_branches * 8 * sizeof(octomap::OcTreeNode*);
    }

    /** \throws InputError  the nodes are not those that the header announces */
    void check()
    {
        if (m_header.size == "0" && m_data.empty()) return;
        visit(0);
        if (m_at != m_data.size())
            refuse(m_name, "with " + std::to_string(m_data.size() - m_at) +
                               " bytes behind its last node; it is damaged: save or copy it again");
        if (m_header.size != std::to_string(m_nodes))
            refuse(m_name, "that announces " + excerpt(m_header.size) + " nodes but holds " +
                               std::to_string(m_nodes) + "; it is damaged: save or copy it again");
    }

 private:
    void visit(int depth)
    {
        ++m_nodes;
        m_header.binary ? visitBinary(depth) : visitFull(depth);
    }

    /** Two bits a child: 0 unknown, 1 and 2 leaves, 3 a branch. */
    void visitBinary(int depth)
    {
        const unsigned children = byte() | (byte() << 8);
        enterBranch(depth, true);
        if (children == 0)
            refuse(m_name, "with a branch that holds nothing; it is damaged: save or copy it again");
        for (int k = 0; k < 8; ++k) {
            const unsigned child = (children >> (2 * k)) & 3;
            if (child == 3)
                visit(depth + 1);
            else
                m_nodes += child != 0 ? 1 : 0;
        }
    }

    /** Log-odds, then a bit a child. */
    void visitFull(int depth)
    {
        float logOdds = 0;
        unsigned char raw[sizeof(logOdds)];
        for (unsigned char& b : raw) b = static_cast<unsigned char>(byte());
        std::memcpy(&logOdds, raw, sizeof(logOdds));
        if (!std::isfinite(logOdds))
            refuse(m_name, "with a node whose occupancy is not a number; it is damaged: save it again");
        const unsigned children = byte();
        enterBranch(depth, children != 0);
        for (int k = 0; k < 8; ++k)
            if ((children >> k) & 1) visit(depth + 1);
    }

    void enterBranch(int depth, bool hasChildren)
    {
        m_branches += hasChildren ? 1 : 0;
        if (hasChildren && depth >= kDepth)
            refuse(m_name, "with branches more than " + std::to_string(kDepth) +
                               " nodes deep; it is damaged: save or copy it again");
    }

    unsigned byte()
    {
        if (m_at >= m_data.size())
            refuse(m_name, "that ends after " + std::to_string(m_nodes) + " of " + excerpt(m_header.size) +
                               " nodes; it is truncated: save or copy it again");
        return static_cast<unsigned char>(m_data[m_at++]);
    }

    std::string_view m_data;
    const Header& m_header;
    const std::string& m_name;
    std::size_t m_at = 0;
    std::size_t m_nodes = 0;
    std::size_t m_branches = 0;
};

/** Lets a stream read bytes where they are. */
class Bytes : public std::streambuf
{
 public:
    explicit Bytes(std::string& bytes, std::size_t from)
    {
        setg(bytes.data(), bytes.data() + from, bytes.data() + bytes.size());
    }
};
}  // namespace

bool isOctree(std::string_view bytes)
{
    return bytes.substr(0, kBinaryMark.size()) == kBinaryMark ||
           bytes.substr(0, kFullMark.size()) == kFullMark;
}

bool isOctreeFile(const std::filesystem::path& path)
{
    std::string start(kBinaryMark.size(), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(file.gcount()));
    return isOctree(start);
}

OctreeFile readOctree(const std::filesystem::path& path)
{
    const std::string name = io::pathInQuotes(path);
    std::string bytes = readFile(path);
    if (!isOctree(bytes))
        throw InputError(name + " is no OctoMap file (.bt or .ot); check that it is the right file");
    const Header header = readHeader(bytes, name);
    NodeCounter counter(std::string_view(bytes).substr(header.dataAt), header, name);
    counter.check();
    OctreeFile file;
    file.tree = std::make_shared<octomap::OcTree>(header.resolution_m);
    file.format = header.binary ? "OctoMap binary octree (.bt)" : "OctoMap octree (.ot)";
    file.resolution_m = header.resolution_m;
    file.nodes = counter.nodes();
    file.bytes = counter.bytes();
    if (header.dataAt == bytes.size()) return file;
    Bytes buffer(bytes, header.dataAt);
    std::istream data(&buffer);
    if (header.binary)
        file.tree->readBinaryData(data);
    else
        file.tree->readData(data);
    return file;
}
}  // namespace gr2to
