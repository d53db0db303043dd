#include "gr2to/compare/RoomScores.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "compare/ratios.h"
#include "gr2to/compare/Assignment.h"

namespace gr2to
{
namespace
{
using Overlap = ContingencyTable::Overlap;
using Region = ContingencyTable::Region;

/** Segments up to this size are specks, no attempt at a room (the ICRA 2016 evaluation's threshold). */
constexpr std::size_t kSpeckCells = 100;
constexpr double kMostly = 0.5;    //!< from here on a region lies mostly in another
constexpr double kSizeable = 0.1;  //!< share of a room from which a piece of it counts as one

bool isSpeck(const Region& region)
{
    return region.cells <= kSpeckCells;
}

/** The outcome of one segment standing for one room, in cells. */
struct Confusion
{
    double truePositives;
    double falsePositives;
    double falseNegatives;
    double trueNegatives;
};

double matthewsCorrelation(const Confusion& c)
{
    const double tp = c.truePositives, fp = c.falsePositives, tn = c.trueNegatives, fn = c.falseNegatives;
    return ratio(tp * tn - fp * fn, std::sqrt((tp + fp) * (tp + fn) * (tn + fp) * (tn + fn)));
}

double asReal(std::size_t count)
{
    return static_cast<double>(count);
}

/** Mean over regions of best / area, and the same weighted by area. */
struct Coverage
{
    double mean = 0;
    double byCells = 0;
};

Coverage coverageOf(const std::vector<Region>& regions, const std::vector<std::size_t>& best, bool withSpecks)
{
    double shares = 0;
    std::size_t count = 0, covered = 0, area = 0;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (!withSpecks && isSpeck(regions[i])) continue;
        shares += ratio(best[i], regions[i].cells);
        covered += best[i];
        area += regions[i].cells;
        ++count;
    }
    return {ratio(shares, asReal(count)), ratio(covered, area)};
}

/** Recall of an answer that labels the free cells of every room just as the reference does. */
double recallCeiling(const std::vector<Region>& rooms, const std::vector<Region>& freeParts)
{
    double shares = 0;
    auto part = freeParts.begin();
    for (const auto& room : rooms) {
        while (part != freeParts.end() && part->id < room.id) ++part;
        if (part != freeParts.end() && part->id == room.id && !isSpeck(*part))
            shares += ratio(part->cells, room.cells);
    }
    return ratio(shares, asReal(rooms.size()));
}
}  // namespace

BormannScores bormannScores(const ContingencyTable& all, const ContingencyTable* onFree)
{
    std::vector<std::size_t> bestOfSegment(all.segments().size(), 0), bestOfRoom(all.rooms().size(), 0);
    for (const auto& o : all.overlaps()) {
        if (isSpeck(all.segments()[o.segment])) continue;
        bestOfSegment[o.segment] = std::max(bestOfSegment[o.segment], o.cells);
        bestOfRoom[o.room] = std::max(bestOfRoom[o.room], o.cells);
    }
    const Coverage recall = coverageOf(all.rooms(), bestOfRoom, true);
    const Coverage precision = coverageOf(all.segments(), bestOfSegment, false);
    BormannScores scores{recall.mean, precision.mean, recall.byCells, precision.byCells, {}};
    if (onFree) scores.recallCeiling = recallCeiling(all.rooms(), onFree->rooms());
    return scores;
}

namespace
{
/** Greedy association of MaorisScores: overlaps that stand for a pair, one for each segment that touches a
 * room. */
std::vector<Overlap> associate(const ContingencyTable& table, std::vector<bool>& roomTaken)
{
    // The overlaps of a segment, largest first; the segments by their largest overlap.
    std::vector<std::vector<Overlap>> candidates;
    for (const auto& o : table.overlaps()) {
        if (candidates.empty() || candidates.back().front().segment != o.segment) candidates.emplace_back();
        candidates.back().push_back(o);
    }
    for (auto& of : candidates)
        std::stable_sort(of.begin(), of.end(),
                         [](const auto& a, const auto& b) { return a.cells > b.cells; });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.front().cells > b.front().cells; });
    std::vector<Overlap> pairs;
    for (const auto& of : candidates) {
        const auto open =
            std::find_if(of.begin(), of.end(), [&](const auto& o) { return !roomTaken[o.room]; });
        pairs.push_back(open != of.end() ? *open : of.back());
        roomTaken[pairs.back().room] = true;
    }
    return pairs;
}
}  // namespace

MaorisScores maorisScores(const ContingencyTable& all)
{
    std::vector<double> segmentCells(all.segments().size(), 0), roomCells(all.rooms().size(), 0);
    double total = 0;
    for (const auto& o : all.overlaps()) {
        segmentCells[o.segment] += asReal(o.cells);
        roomCells[o.room] += asReal(o.cells);
        total += asReal(o.cells);
    }
    std::vector<bool> roomTaken(all.rooms().size(), false);
    MaorisScores sum;
    const auto pairs = associate(all, roomTaken);
    for (const auto& pair : pairs) {
        const double tp = asReal(pair.cells), room = roomCells[pair.room];
        const double fp = segmentCells[pair.segment] - tp, fn = room - tp;
        sum.mcc += matthewsCorrelation({tp, fp, fn, total - (fp - room)});
        sum.precision += tp / (tp + fp);
        sum.recall += tp / (tp + fn);
    }
    const auto missed = std::count_if(all.overlaps().begin(), all.overlaps().end(),
                                      [&](const auto& o) { return !roomTaken[o.room]; });
    const double count = asReal(pairs.size()) + static_cast<double>(missed);
    return {ratio(sum.mcc, count), ratio(sum.precision, count), ratio(sum.recall, count)};
}

namespace
{
double unionCells(const ContingencyTable& table, const Overlap& o)
{
    return asReal(table.segments()[o.segment].cells + table.rooms()[o.room].cells - o.cells);
}

/** The overlaps of the pairs whose sum of IoU is largest. */
std::vector<Overlap> matchByIou(const ContingencyTable& table)
{
    SparseCosts costs{table.segments().size(), table.rooms().size(), 0.0, {}};
    for (const auto& o : table.overlaps())
        costs.entries.push_back({o.segment, o.room, -asReal(o.cells) / unionCells(table, o)});
    const auto roomOf = assignRows(costs);
    std::vector<Overlap> pairs;
    std::copy_if(table.overlaps().begin(), table.overlaps().end(), std::back_inserter(pairs),
                 [&](const auto& o) { return roomOf[o.segment] == o.room; });
    return pairs;
}

void countSplitsAndMerges(const ContingencyTable& table, MatchedScores& scores)
{
    std::vector<int> pieces(table.rooms().size(), 0), swallowed(table.segments().size(), 0);
    for (const auto& o : table.overlaps()) {
        const double inRoom = ratio(o.cells, table.rooms()[o.room].cells);
        const double inSegment = ratio(o.cells, table.segments()[o.segment].cells);
        if (inRoom >= kSizeable && inSegment >= kMostly) ++pieces[o.room];
        if (inRoom >= kMostly) ++swallowed[o.segment];
    }
    const auto several = [](int n) { return n >= 2; };
    scores.splitRooms = static_cast<int>(std::count_if(pieces.begin(), pieces.end(), several));
    scores.mergingSegments = static_cast<int>(std::count_if(swallowed.begin(), swallowed.end(), several));
}
}  // namespace

MatchedScores matchedScores(const ContingencyTable& onFree, bool gridKnown)
{
    const auto& segments = onFree.segments();
    const auto& rooms = onFree.rooms();
    const double total = asReal(gridKnown ? onFree.countedCells() : onFree.labelledCells());
    double iouSum = 0, mccSum = 0, good = 0;
    std::vector<bool> paired(segments.size(), false);
    for (const auto& pair : matchByIou(onFree)) {
        const double tp = asReal(pair.cells), joint = unionCells(onFree, pair);
        const double iou = tp / joint;
        iouSum += iou;
        if (iou >= kMostly) ++good;
        mccSum += matthewsCorrelation({tp, asReal(segments[pair.segment].cells) - tp,
                                       asReal(rooms[pair.room].cells) - tp, total - joint});
        paired[pair.segment] = true;
    }
    MatchedScores scores;
    int unpaired = 0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
        if (isSpeck(segments[s])) continue;
        ++scores.segments;
        if (!paired[s]) ++unpaired;
    }
    scores.rooms = static_cast<int>(rooms.size());
    scores.countError = scores.segments - scores.rooms;
    scores.meanIou = ratio(iouSum, scores.rooms);
    scores.iouOverHalf = ratio(good, scores.rooms);
    scores.mcc = ratio(mccSum, scores.rooms + unpaired);
    countSplitsAndMerges(onFree, scores);
    if (gridKnown) scores.labelledFree = ratio(onFree.segmentCells(), onFree.countedCells());
    return scores;
}
}  // namespace gr2to
