#include "serializeMap.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "gr2to/base/errors.h"
#include "mapMembers.h"

namespace gr2to
{
namespace
{
using mrpt::serialization::CArchive;

class Writer
{
 public:
    explicit Writer(CArchive& out) : m_out(out) {}

    void operator()(double value) { m_out << value; }
    void operator()(std::uint16_t value) { m_out << value; }
    void operator()(std::uint32_t value) { m_out << value; }
    void operator()(bool value) { m_out << static_cast<std::uint8_t>(value ? 1 : 0); }
    void operator()(const std::string& text)
    {
        count(text.size());
        if (!text.empty()) m_out.WriteBuffer(text.data(), text.size());
    }
    template <class E>
    void enumerator(E value, E last)
    {
        if (value > last)
            throw std::invalid_argument("the map cannot be archived: a place's kind or a door's state is " +
                                        std::to_string(static_cast<int>(value)) + ", which has no meaning");
        m_out << static_cast<std::uint8_t>(value);
    }
    template <class T, class Each>
    void list(const std::vector<T>& items, Each each)
    {
        count(items.size());
        for (const T& item : items) each(item);
    }
    template <class T, class Each>
    void optional(const std::optional<T>& item, Each each)
    {
        (*this)(item.has_value());
        if (item) each(*item);
    }
    void count(std::size_t size)
    {
        if (size > std::numeric_limits<std::uint32_t>::max())
            throw std::invalid_argument(
                "the map cannot be archived: a list or text has more than 2^32 - 1 items");
        m_out << static_cast<std::uint32_t>(size);
    }

 private:
    CArchive& m_out;
};

class Reader
{
 public:
    Reader(CArchive& in, const std::string& name) : m_in(in), m_name(name) {}

    [[noreturn]] void fail(const std::string& complaint) const
    {
        throw InputError(m_name + ": " + complaint);
    }

    void operator()(double& value) { number(value); }
    void operator()(std::uint16_t& value) { number(value); }
    void operator()(std::uint32_t& value) { number(value); }
    void operator()(bool& value)
    {
        std::uint8_t byte = 0;
        number(byte);
        if (byte > 1) fail("the archive is corrupt: a flag is " + std::to_string(byte) + ", not 0 or 1");
        value = byte == 1;
    }
    /** Grows with what is really there, so that a corrupt length cannot claim all memory. */
    void operator()(std::string& text)
    {
        constexpr std::size_t CHUNK = 1U << 16U;
        text.clear();
        for (std::size_t left = count(); left > 0;) {
            const std::size_t size = std::min(left, CHUNK);
            text.resize(text.size() + size);
            checkWhole(bytes(&text[text.size() - size], size), size);
            left -= size;
        }
    }
    template <class E>
    void enumerator(E& value, E last)
    {
        std::uint8_t byte = 0;
        number(byte);
        value = static_cast<E>(byte);
        if (value > last)
            fail("the archive is corrupt: a place's kind or a door's state is " + std::to_string(byte));
    }
    template <class T, class Each>
    void list(std::vector<T>& items, Each each)
    {
        items.clear();
        for (std::uint32_t left = count(); left > 0; --left) each(items.emplace_back());
    }
    template <class T, class Each>
    void optional(std::optional<T>& item, Each each)
    {
        bool present = false;
        (*this)(present);
        if (!present) return;
        T value{};
        each(value);
        item = std::move(value);
    }
    std::uint32_t count()
    {
        std::uint32_t size = 0;
        number(size);
        return size;
    }

 private:
    template <class T>
    void number(T& value)
    {
        checkWhole(endOr([&] { return m_in.ReadBufferFixEndianness(&value, 1); }), sizeof value);
    }
    std::size_t bytes(char* target, std::size_t size)
    {
        return endOr([&] { return m_in.ReadBuffer(target, size); });
    }
    /** MRPT throws at the end of the stream, but returns a part when a part is there. */
    template <class Read>
    static std::size_t endOr(Read read)
    {
        try {
            return read();
        } catch (const std::logic_error&) {
            return 0;
        }
    }
    void checkWhole(std::size_t read, std::size_t wanted) const
    {
        if (read != wanted) fail("the archive is truncated or corrupt: it ends inside the map; make it anew");
    }

    CArchive& m_in;
    const std::string& m_name;
};

void readPlaces(Reader& reader, TopologicalMap& map)
{
    for (std::uint32_t left = reader.count(); left > 0; --left) {
        Place place;
        archived::place(reader, place);
        if (place.id == 0 || map.places().count(place.id) != 0)
            reader.fail("the archive is corrupt: place id " + std::to_string(place.id) +
                        " is 0 or there twice");
        map.addPlace(std::move(place));
    }
}

void readConnections(Reader& reader, TopologicalMap& map)
{
    std::set<std::uint32_t> ids;
    for (std::uint32_t left = reader.count(); left > 0; --left) {
        Connection connection;
        archived::connection(reader, connection);
        const bool ends = map.places().count(connection.from) != 0 &&
                          map.places().count(connection.to) != 0 && connection.from != connection.to;
        if (connection.id == 0 || !ids.insert(connection.id).second)
            reader.fail("the archive is corrupt: connection id " + std::to_string(connection.id) +
                        " is 0 or there twice");
        if (!ends)
            reader.fail("the archive is corrupt: connection " + std::to_string(connection.id) +
                        " does not join two different places of the map");
        map.addConnection(std::move(connection));
    }
}
}  // namespace

void writeMap(CArchive& out, const TopologicalMap& map)
{
    Writer writer(out);
    writer(map.frame);
    writer(map.resolution_m);
    writer(map.source);
    writer.count(map.places().size());
    for (const auto& [id, place] : map.places()) archived::place(writer, place);
    const auto connections = map.connections();
    writer.count(connections.size());
    for (const Connection& connection : connections) archived::connection(writer, connection);
}

TopologicalMap readMap(CArchive& in, std::uint8_t version, const std::string& name)
{
    Reader reader(in, name);
    if (version > MAP_ARCHIVE_VERSION)
        reader.fail("the map is stored in version " + std::to_string(version) +
                    ", this library reads up to version " + std::to_string(GRID_ARCHIVE_VERSION) +
                    "; read it with a newer gr2to");
    TopologicalMap map;
    reader(map.frame);
    reader(map.resolution_m);
    reader(map.source);
    readPlaces(reader, map);
    readConnections(reader, map);
    return map;
}
}  // namespace gr2to
