#pragma once

namespace gr2to
{
/** One of the two regions at a border. */
struct BorderSide
{
    double openness = 1;        //!< length of the border over the longest walk parallel to it on this side
    double area_m2 = 0;         //!< of the region
    double radius_m = 0;        //!< of its largest circle
    double rectangularity = 1;  //!< see RegionSets
};

/** What a border between two regions looks like. */
struct BorderMeasures
{
    BorderSide smaller, larger;      //!< by area
    double unionRectangularity = 1;  //!< of both regions together
    double length_m = 0;             //!< of the longest straight part
    double total_m = 0;              //!< of all parts
    double shorterFin_m = 0;         //!< wall in line with the border at its ends, see CutEnd
    double longerFin_m = 0;
    bool solidEnd = false;  //!< the border ends at something as deep as wide
    bool lintel = false;    //!< a 3D map shows a lintel over it
};

struct MouthRules
{
    double openness = 0.35;  //!< of the more closed side of a mouth, at most
    double contrast = 0.5;   //!< radius of the narrower region over that of the wider, at most
};

/** Log odds that people see two places where a border parts two regions [nat]: positive for two, negative
 * for one.
 *
 * A sum of evidence, each term a measure that needs no map's scale but the metre: a lintel, a
 * narrow passage or a wall's end in line with the border speak for it, a space that is as open as it is wide,
 * furniture at the border's end and a whole that is as good a rectangle as its parts against it. The weights
 * are those of a logistic regression on decisions that annotated buildings settle; doc/algorithm.md tells
 * how.
 */
double borderEvidence(const BorderMeasures& border, const MouthRules& mouth);
}  // namespace gr2to
