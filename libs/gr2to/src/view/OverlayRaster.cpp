#include "OverlayRaster.h"

#include <algorithm>
#include <cmath>

#include "gr2to/view/Palette.h"

namespace gr2to::view
{
namespace
{
constexpr double kRimShade = 0.66;  // of the tint, where a place meets another
constexpr double kHatchPeriod_px = 9.0;
constexpr double kStripe_px = 3.0;

/** What one pixel shows before it gets a colour; a place's id, or one of the states that have none. */
using Content = std::uint32_t;
constexpr Content kFree = 0, kUnknown = 0x10000U, kOccupied = 0x10001U, kRemoved = 0x10002U;
constexpr std::size_t kContents = kRemoved + 1;

std::uint32_t pack(Rgb c)
{
    return (std::uint32_t{c.red} << 16U) | (std::uint32_t{c.green} << 8U) | c.blue;
}

/** Places have free cells, and those of things that the filter took away. */
bool isRemoved(CellState state, PlaceId id)
{
    return id != 0 && state != CellState::Free;
}

/** Pools square blocks of cells, one row of blocks at a time, by majority voting in one pass (Boyer and
 * Moore). */
class BlockPool
{
 public:
    BlockPool(const OverlayInput& input, const TOverlayOptions& options, const Layout& layout)
        : m_input(input),
          m_showGrid(options.grid),
          m_showPlaces(options.places && !input.places.ids.empty()),
          m_showRemoved(options.removed && !input.places.ids.empty()),
          m_window(layout.window),
          m_block(layout.reduce),
          m_votes(columns(layout)),
          m_row(columns(layout))
    {
    }

    /** Contents of the blocks of one row, counted from the top. */
    const std::vector<Content>& row(int fromTop)
    {
        std::fill(m_votes.begin(), m_votes.end(), Vote{});
        const int top = m_window.bottom + m_window.height - 1 - fromTop * m_block;
        for (int y = top; y > top - m_block && y >= m_window.bottom; --y) addCells(y);
        std::transform(m_votes.begin(), m_votes.end(), m_row.begin(),
                       [](const Vote& v) { return v.result(); });
        return m_row;
    }

 private:
    struct Vote
    {
        Content candidate = kFree;
        std::uint32_t lead = 0;
        std::int64_t knownLead = 0;  // known cells minus unknown ones
        bool occupied = false;
        bool removed = false;

        Content result() const
        {
            if (occupied) return kOccupied;
            if (removed) return kRemoved;
            return knownLead < 0 ? kUnknown : candidate;
        }
        void add(Content id)
        {
            if (lead == 0) candidate = id;
            lead = candidate == id ? lead + 1 : lead - 1;
        }
    };

    static std::size_t columns(const Layout& layout)
    {
        const int pixels = (layout.window.width - 1) / layout.reduce + 1;
        return static_cast<std::size_t>(pixels);
    }

    void addCells(int y)
    {
        const CellState* states = m_input.grid.row(y);
        const PlaceId* ids = m_showPlaces || m_showRemoved
                                 ? m_input.places.ids.data() + m_input.places.index({0, y})
                                 : nullptr;
        const int last = m_window.left + m_window.width;
        int x = m_window.left;
        for (Vote& vote : m_votes)
            for (const int end = std::min(last, x + m_block); x < end; ++x) {
                if (m_showRemoved && isRemoved(states[x], ids[x])) {
                    vote.removed = true;
                    ++vote.knownLead;
                    continue;
                }
                const Content id = m_showPlaces ? ids[x] : kFree;
                if (m_showGrid && states[x] == CellState::Occupied) vote.occupied = true;
                if (m_showGrid && states[x] == CellState::Unknown && id == kFree)
                    --vote.knownLead;
                else {
                    ++vote.knownLead;
                    vote.add(id);
                }
            }
    }

    const OverlayInput& m_input;
    bool m_showGrid, m_showPlaces, m_showRemoved;
    CellWindow m_window;
    int m_block;
    std::vector<Vote> m_votes;
    std::vector<Content> m_row;
};

/** Colours of all contents, looked up rather than computed for every pixel. */
class Paint
{
 public:
    Paint(const OverlayInput& input, const Layout& layout)
        : m_plain(kContents),
          m_rim(kContents),
          m_corridor(kContents, false),
          m_period(std::max(4, static_cast<int>(std::lround(kHatchPeriod_px * layout.unit)))),
          m_stripe(std::max(1, static_cast<int>(std::lround(kStripe_px * layout.unit))))
    {
        for (Content id = 0; id < kUnknown; ++id) {
            const Rgb tint = placeColor(static_cast<PlaceId>(id));
            m_plain[id] = pack(tint);
            m_rim[id] = pack(id == 0 ? tint : darker(tint, kRimShade));
        }
        m_plain[kUnknown] = m_rim[kUnknown] = pack(palette::unknown);
        m_plain[kOccupied] = m_rim[kOccupied] = pack(palette::occupied);
        m_plain[kRemoved] = m_rim[kRemoved] = pack(palette::removed);
        for (const auto& [id, place] : input.map.places()) m_corridor[id] = place.kind == PlaceKind::Corridor;
    }

    std::uint32_t at(Content content, bool rim, int x, int y) const
    {
        if (rim) return m_rim[content];
        if (m_corridor[content] && (x + y) % m_period < m_stripe) return shaded(m_plain[content]);
        return m_plain[content];
    }

 private:
    static std::uint32_t shaded(std::uint32_t color)
    {
        const Rgb rgb{static_cast<std::uint8_t>(color >> 16U),
                      static_cast<std::uint8_t>((color >> 8U) & 0xFFU),
                      static_cast<std::uint8_t>(color & 0xFFU)};
        return pack(darker(rgb, kCorridorShade));
    }

    std::vector<std::uint32_t> m_plain, m_rim;
    std::vector<bool> m_corridor;
    int m_period, m_stripe;
};

bool isPlace(Content c)
{
    return c != kFree && c < kUnknown;
}
bool isRim(Content c, Content other)
{
    return c != other && isPlace(c) && isPlace(other);
}

/** Writes the pixel rows of one row of blocks; a rim pixel is the last one before another place. */
void paintRow(const std::vector<Content>& row, const std::vector<Content>& below, const Paint& paint,
              int enlarge, int firstY, Raster& raster)
{
    for (int dy = 0; dy < enlarge; ++dy) {
        const int y = firstY + dy;
        std::uint32_t* out =
            raster.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool rimBelow = dy == enlarge - 1 && isRim(row[i], below[i]);
            const bool rimRight = i + 1 < row.size() && isRim(row[i], row[i + 1]);
            for (int dx = 0; dx < enlarge; ++dx) {
                const int x = static_cast<int>(i) * enlarge + dx;
                out[x] = paint.at(row[i], rimBelow || (rimRight && dx == enlarge - 1), x, y);
            }
        }
    }
}
}  // namespace

bool showsRemoved(const OverlayInput& input, const TOverlayOptions& options)
{
    if (!options.removed) return false;
    for (std::size_t i = 0; i < input.places.ids.size(); ++i)
        if (isRemoved(input.grid[i], input.places.ids[i])) return true;
    return false;
}

Raster drawCells(const OverlayInput& input, const TOverlayOptions& options, const Layout& layout)
{
    Raster raster{layout.mapWidth, layout.mapHeight, {}};
    raster.pixels.resize(static_cast<std::size_t>(layout.mapWidth) *
                         static_cast<std::size_t>(layout.mapHeight));
    BlockPool pool(input, options, layout);
    const Paint paint(input, layout);
    const int rows = layout.mapHeight / layout.enlarge;
    std::vector<Content> row = pool.row(0);
    for (int r = 0; r < rows; ++r) {
        const std::vector<Content> below = r + 1 < rows ? pool.row(r + 1) : row;
        paintRow(row, below, paint, layout.enlarge, r * layout.enlarge, raster);
        row = below;
    }
    return raster;
}
}  // namespace gr2to::view
