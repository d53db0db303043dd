#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace gr2to
{
/** A chain of points with fewer vertices, close to the chain and beside the same area.
 *
 * Vertices are chosen by Douglas and Peucker's rule. Then each one that is not pinned moves so that its sides
 * have as much of the chain's area on their left as on their right: along a wall askew to the grid, whose
 * cells form steps, a side runs through the middle of the steps. The first and the last point of an open
 * chain stay; a jog between one of them and a straight stretch stays a jog, however small.
 */
class SimplifiedArc
{
 public:
    /** \param chain  at least two points; a closed one, at least four, repeats the first at the end and lives
     * on as long as this \param tolerance  largest distance of a left-out point from its side [cells] */
    SimplifiedArc(const std::vector<Eigen::Vector2d>& chain, bool closed, double tolerance);

    /** At least two; a closed chain repeats the first at the end. */
    const std::vector<Eigen::Vector2d>& vertices() const { return m_vertices; }
    /** How many sides there are. */
    std::size_t sides() const { return m_vertices.size() - 1; }

    /** Asks for a side closer to the chain: its ends go back to where they are on the chain, and if they are
     * there already, it gets a vertex more. A side of the chain stays as it is. Holds after update(). */
    void refine(std::size_t side);
    /** Asks for half the tolerance everywhere. Holds after update(). */
    void tighten();
    void update();

 private:
    void choose(std::size_t first, std::size_t last);
    bool hasJogs(std::size_t first, std::size_t last, double distance) const;
    bool isReached(std::size_t first, std::size_t last, double distance, int splits) const;
    std::size_t farthest(std::size_t first, std::size_t last, double* distance) const;
    double lean(std::size_t side) const;
    Eigen::Vector2d shiftOf(std::size_t vertex, const std::vector<double>& leans) const;
    void place();

    const std::vector<Eigen::Vector2d>* m_chain;
    bool m_closed;
    double m_tolerance;
    std::vector<bool> m_kept;           //!< of the chain's points
    std::vector<bool> m_pinned;         //!< of the chain's points
    std::vector<std::size_t> m_chosen;  //!< the kept points
    std::vector<Eigen::Vector2d> m_vertices;
};
}  // namespace gr2to
