#pragma once

#include <optional>

#include "gr2to/compare/ContingencyTable.h"

namespace gr2to
{
/** Coverage of rooms by segments and the reverse; all values in [0, 1], 1 is best.
 *
 * With R the rooms, S the segments of more than 100 cells and |.| the number of cells:
 *     recall    = mean over R of max over S |r n s| / |r|
 *     precision = mean over S of max over R |r n s| / |s|
 * A map that is cut too finely loses recall, one that joins rooms loses precision.
 * Source: Bormann et al., Room segmentation: survey, implementation, and analysis, ICRA 2016, section VI.
 */
struct BormannScores
{
    double recall = 0;
    double precision = 0;
    double recallByCells = 0;     //!< the same means weighted by the rooms' areas
    double precisionByCells = 0;  //!< the same means weighted by the segments' areas
    /** Recall of a perfect answer on this grid, below 1 where furniture covers the rooms; absent without a
     * grid. */
    std::optional<double> recallCeiling;
};

/** Mean Matthews correlation, precision and recall over segments, in the manner of the MAORIS evaluation.
 *
 * Only cells labelled in both images count. Segments in order of their largest overlap each take the room
 * that they overlap most and that none has taken yet; a segment with no such room takes the one it overlaps
 * least. Each pair scores, with tp = |r n s|, fp = |s| - tp, fn = |r| - tp and N cells in all, precision = tp
 * / (tp + fp),  recall = tp / (tp + fn), mcc = (tp tn - fp fn) / sqrt((tp + fp) (tp + fn) (tn + fp) (tn +
 * fn)),  tn = N - (fp - |r|), and each room left over scores 0 once for every segment that touches it. That
 * tn exceeds the true negatives by 2 |r| is how the published figures were computed and is kept, so that
 * figures compare; MatchedScores::mcc counts properly. Source: Mielle, Magnusson, Lilienthal, A method to
 * segment maps from different modalities using free space layout
 * - MAORIS, ICRA 2018, and the evaluation program published with it.
 */
struct MaorisScores
{
    double mcc = 0;        //!< in [-1, 1]
    double precision = 0;  //!< in [0, 1]
    double recall = 0;     //!< in [0, 1]
};

/** Rooms and segments paired one to one so that the sum of IoU = |r n s| / |r u s| is largest, on free cells.
 *
 * Without a grid all cells labelled in either image count as free.
 * Source: Kuhn, The Hungarian method, 1955 (pairing); Matthews, 1975 (correlation coefficient).
 */
struct MatchedScores
{
    double meanIou = 0;  //!< mean over rooms, an unpaired room counts 0; in [0, 1]
    /** Mean Matthews correlation over the rooms and the segments of more than 100 cells that stay unpaired;
     * unpaired ones count 0. In [-1, 1]. */
    double mcc = 0;
    double iouOverHalf = 0;  //!< share of the rooms whose IoU is at least 0.5
    int rooms = 0;           //!< rooms that have free cells
    int segments = 0;        //!< segments of more than 100 free cells
    int countError = 0;      //!< segments - rooms
    /** Rooms of which at least two segments hold a tenth or more each, being themselves mostly (>= 0.5) in
     * the room. */
    int splitRooms = 0;
    int mergingSegments = 0;  //!< segments that hold half or more of at least two rooms
    std::optional<double>
        labelledFree;  //!< share of the free cells that lie in a segment; absent without a grid
};

/** \param all     overlaps of the whole images
 *  \param onFree  overlaps on the free cells of the grid at hand, for the ceiling; none leaves it out */
BormannScores bormannScores(const ContingencyTable& all, const ContingencyTable* onFree = nullptr);

/** \param all  overlaps of the whole images */
MaorisScores maorisScores(const ContingencyTable& all);

/** \param onFree    overlaps on free cells, or of the whole images when no grid is known
 *  \param gridKnown  whether the cells counted are all the free cells there are */
MatchedScores matchedScores(const ContingencyTable& onFree, bool gridKnown);
}  // namespace gr2to
