#include "gr2to/io/RawlogReader.h"

#include <mrpt/obs/CRawlog.h>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "io/ArchiveObjects.h"
#include "io/Gridmap.h"
#include "io/Gzip.h"
#include "io/errorText.h"

namespace gr2to
{
using mrpt::serialization::CSerializable;

struct RawlogReader::State
{
    std::string name;
    std::string bytes;
    std::unique_ptr<io::ArchiveObjects> objects;
    std::string trouble;            //!< of the compressed data
    mrpt::obs::CRawlog::Ptr whole;  //!< when the file holds one object with all entries
    std::size_t nextOfWhole = 0;
};

namespace
{
/** Unpacks what can be unpacked. \return what was wrong with the rest */
std::string unpackInto(std::string& out, const std::string& packed, const std::string& name)
{
    constexpr std::size_t mostBytes = std::size_t{8} << 30U;
    try {
        io::GzipReader gzip(packed, name);
        gzip.readUpTo(out, mostBytes);
        if (!gzip.finished()) throw InputError(name + " unpacks to more than 8 GiB; split the rawlog");
    } catch (const InputError& error) {
        if (out.empty() || out.size() >= mostBytes) throw;
        return error.what();
    }
    return "";
}
}  // namespace

RawlogReader::RawlogReader(const std::filesystem::path& path) : m_state(std::make_unique<State>())
{
    State& state = *m_state;
    state.name = io::pathInQuotes(path);
    state.bytes = readFile(path);
    if (io::isGzip(state.bytes)) {
        std::string unpacked;
        state.trouble = unpackInto(unpacked, state.bytes, state.name);
        state.bytes = std::move(unpacked);
    }
    const auto header = io::archiveHeader(state.bytes);
    const std::string kind = header ? io::kindOfClass(header->className) : "";
    if (!header || kind == "a simplemap" || kind == "a 3D map" || header->className == "COccupancyGridMap2D")
        throw InputError(state.name + " is no rawlog" + (kind.empty() ? "" : " but " + kind) +
                         "; name a file of MRPT's actions and observations");
    state.objects = std::make_unique<io::ArchiveObjects>(state.bytes, state.name);
}

RawlogReader::~RawlogReader() = default;

CSerializable::Ptr RawlogReader::next()
{
    State& state = *m_state;
    if (state.whole && state.nextOfWhole < state.whole->size()) {
        ++m_entries;
        return state.whole->getAsGeneric(state.nextOfWhole++);
    }
    const auto stop = [&](const std::string& reason) {
        m_warning = reason + "; the " + std::to_string(m_entries) + " entries before, " +
                    std::to_string(state.objects->position()) + " of " + std::to_string(state.bytes.size()) +
                    " unpacked bytes, are used";
        return nullptr;
    };
    if (!m_warning.empty()) return nullptr;
    if (state.objects->atEnd()) return state.trouble.empty() ? nullptr : stop(state.trouble);
    CSerializable::Ptr object;
    try {
        object = state.objects->next();
    } catch (const io::EarlyEnd&) {
        return stop(state.name + " ends within entry " + std::to_string(m_entries + 1));
    } catch (const InputError& error) {
        if (const auto foreign = io::foreignClassAt(state.objects->rest())) throw;
        return stop(error.what());
    }
    state.whole = std::dynamic_pointer_cast<mrpt::obs::CRawlog>(object);
    if (state.whole) return next();
    ++m_entries;
    return object;
}

double RawlogReader::progress() const
{
    return static_cast<double>(m_state->objects->position()) / static_cast<double>(m_state->bytes.size());
}
}  // namespace gr2to
