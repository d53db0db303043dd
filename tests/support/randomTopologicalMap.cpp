#include "support/randomTopologicalMap.h"

#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace gr2to::test
{
namespace
{
class MapMaker
{
 public:
    explicit MapMaker(unsigned seed) : m_random(seed) {}

    TopologicalMap make()
    {
        TopologicalMap map;
        map.frame = chance(0.5) ? "map" : word();
        map.resolution_m = oddPositive();
        map.source = chance(0.3) ? "" : word() + ".yaml";
        std::vector<PlaceId> ids;
        PlaceId id = 0;
        for (std::size_t i = below(7); i > 0; --i) {
            id = static_cast<PlaceId>(id + 1 + below(3));
            ids.push_back(id);
            map.addPlace(place(id));
        }
        if (ids.size() < 2) return map;
        for (std::size_t i = below(6); i > 0; --i) addConnections(map, ids);
        return map;
    }

 private:
    std::size_t below(std::size_t end)
    {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(m_random);
    }
    bool chance(double odds) { return std::bernoulli_distribution(odds)(m_random); }
    double uniform(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }

    double oddNumber()
    {
        constexpr double ODD[] = {0.1 + 0.2,
                                  1e-300,
                                  std::numeric_limits<double>::denorm_min(),
                                  std::numeric_limits<double>::max(),
                                  std::numeric_limits<double>::epsilon(),
                                  0.0,
                                  -0.0,
                                  1.0 / 3,
                                  123456789012345678.0,
                                  5e22};
        if (chance(0.6)) return uniform(-50, 50);
        return (chance(0.5) ? 1 : -1) * ODD[below(std::size(ODD))];
    }
    double oddPositive()
    {
        const double number = std::abs(oddNumber());
        return number > 0 ? number : 0.05;
    }

    std::string word()
    {
        const char* const WORDS[] = {"Sam's office",
                                     "<kitchen> & \"bath\"",
                                     "]]>",
                                     "&amp;",
                                     "caf\xC3\xA9",
                                     "\xE5\x8E\xA8\xE6\x88\xBF",
                                     "\xF0\x9F\x9A\xAA",
                                     " ",
                                     "  two  spaces  ",
                                     "<!-- no comment -->",
                                     "charger"};
        return WORDS[below(std::size(WORDS))];
    }
    std::vector<std::string> words()
    {
        std::vector<std::string> result(below(3));
        for (auto& one : result) one = word();
        return result;
    }

    /** Of the form a a^T, or a diagonal of extreme entries, or zero; exactly symmetric. */
    template <class Matrix>
    Matrix covariance()
    {
        Matrix result;
        result.setZero();
        if (chance(0.2)) return result;
        const bool extreme = chance(0.3);
        double factor[3] = {uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)};
        for (int row = 0; row < result.rows(); ++row)
            for (int column = row; column < result.cols(); ++column) {
                const double product = factor[row] * factor[column] + (row == column ? 0.1 : 0);
                const double entry = !extreme ? product : row == column ? oddPositive() : 0.0;
                result(row, column) = result(column, row) = entry;
            }
        return result;
    }

    mrpt::math::TPoint3D point() { return {oddNumber(), oddNumber(), oddNumber()}; }
    UncertainPoint position() { return {point(), covariance<mrpt::math::CMatrixDouble33>()}; }
    PlaneSize size()
    {
        PlaneSize result;
        result.length_m = oddPositive();
        result.covariance = covariance<mrpt::math::CMatrixDouble22>();
        if (chance(0.5))
            result.height_m = oddPositive();
        else
            result.covariance(0, 1) = result.covariance(1, 0) = result.covariance(1, 1) = 0;
        return result;
    }
    View view()
    {
        return {"views/" + word() + ".png", position(), uniform(0, 2 * M_PI), uniform(0, 2 * M_PI),
                chance(0.3) ? 0.0 : oddNumber()};
    }
    Wall wall()
    {
        Wall result;
        result.id = ++m_wallId;
        result.position = position();
        const double angle = uniform(-4, 4);
        result.normal = {{std::cos(angle), std::sin(angle), 0}, covariance<mrpt::math::CMatrixDouble33>()};
        result.size = size();
        result.curvatureLength = chance(0.5) ? 0.0 : oddNumber();
        result.curvatureHeight = chance(0.5) ? 0.0 : oddNumber();
        result.real = chance(0.5);
        return result;
    }
    /** A simple polygon: its vertices in the order of their directions from a point inside. */
    decltype(Place::boundary) star(std::size_t vertices)
    {
        decltype(Place::boundary) polygon;
        for (std::size_t k = 0; k < vertices; ++k) {
            const double angle =
                6.28318530717958647693 * static_cast<double>(k) / static_cast<double>(vertices);
            const double radius = 1 + static_cast<double>(below(1000)) / 7;
            polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
        return polygon;
    }
    Place place(PlaceId id)
    {
        Place result;
        result.id = id;
        result.kind = chance(0.5) ? PlaceKind::Room : PlaceKind::Corridor;
        result.words = words();
        for (std::size_t i = below(4); i > 0; --i) result.walls.push_back(wall());
        for (std::size_t i = below(3); i > 0; --i) result.views.push_back(view());
        result.area_m2 = oddPositive();
        result.center = point();
        if (chance(0.8)) result.boundary = star(3 + below(6));
        return result;
    }
    /** One connection, or two or three parallel ones, with ids that do not follow the order of their ends. */
    void addConnections(TopologicalMap& map, const std::vector<PlaceId>& ids)
    {
        const std::size_t from = below(ids.size());
        const std::size_t to = (from + 1 + below(ids.size() - 1)) % ids.size();
        for (std::size_t i = 1 + below(3); i > 0; --i) {
            m_connectionId += 1 + static_cast<std::uint32_t>(below(4));
            Connection connection;
            connection.id = 1000000 - m_connectionId;
            connection.from = ids[from];
            connection.to = ids[to];
            connection.words = words();
            connection.doorway.position = position();
            connection.doorway.size = size();
            connection.doorway.real = chance(0.5);
            connection.doorway.state = static_cast<DoorState>(below(3));
            if (chance(0.4)) connection.doorway.view = view();
            map.addConnection(std::move(connection));
        }
    }

    std::mt19937 m_random;
    std::uint32_t m_wallId = 0;
    std::uint32_t m_connectionId = 0;
};
}  // namespace

TopologicalMap randomTopologicalMap(unsigned seed)
{
    return MapMaker(seed).make();
}
}  // namespace gr2to::test
