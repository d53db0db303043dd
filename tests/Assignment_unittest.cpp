#include "gr2to/compare/Assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

namespace
{
using gr2to::assignRows;
using gr2to::kUnassigned;
using gr2to::SparseCosts;

using Matrix = std::vector<std::vector<double>>;

Matrix dense(const SparseCosts& costs)
{
    Matrix matrix(costs.rows, std::vector<double>(costs.columns, costs.otherwise));
    for (const auto& e : costs.entries) matrix[e.row][e.column] = e.cost;
    return matrix;
}

double costOf(const SparseCosts& costs, const std::vector<std::size_t>& columnOf)
{
    const Matrix matrix = dense(costs);
    double sum = 0;
    for (std::size_t row = 0; row < columnOf.size(); ++row)
        if (columnOf[row] != kUnassigned) sum += matrix[row][columnOf[row]];
    return sum;
}

/** Tries every assignment of the table's longer side. */
double leastCost(const SparseCosts& costs)
{
    const Matrix matrix = dense(costs);
    std::vector<std::size_t> order(std::max(costs.rows, costs.columns));
    std::iota(order.begin(), order.end(), std::size_t{0});
    double least = std::numeric_limits<double>::infinity();
    do {
        double sum = 0;
        for (std::size_t k = 0; k < std::min(costs.rows, costs.columns); ++k)
            sum += costs.rows <= costs.columns ? matrix[k][order[k]] : matrix[order[k]][k];
        least = std::min(least, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    return least;
}

SparseCosts randomCosts(std::mt19937& random, std::size_t rows, std::size_t columns, int levels)
{
    SparseCosts costs{rows, columns, 0.0, {}};
    std::uniform_int_distribution<int> level(-levels, levels);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column)
            if (const int value = level(random); value % 2 == 0)
                costs.entries.push_back({row, column, value * 0.25});
    std::shuffle(costs.entries.begin(), costs.entries.end(), random);
    return costs;
}
}  // namespace

TEST(Assignment, costsAsLittleAsTheBestOfAllAssignments)
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        std::mt19937 random(seed);
        std::uniform_int_distribution<std::size_t> side(1, 6);
        // Few levels make many ties.
        const auto costs = randomCosts(random, side(random), side(random), seed % 2 == 0 ? 3 : 100000);
        const auto columnOf = assignRows(costs);
        ASSERT_EQ(columnOf.size(), costs.rows);
        EXPECT_NEAR(costOf(costs, columnOf), leastCost(costs), 1e-9) << "seed " << seed;
        std::set<std::size_t> used(columnOf.begin(), columnOf.end());
        used.erase(kUnassigned);
        EXPECT_EQ(used.size(), std::min(costs.rows, costs.columns)) << "seed " << seed;
    }
}

TEST(Assignment, emptySidesHaveNoPairs)
{
    EXPECT_TRUE(assignRows({0, 0, 0.0, {}}).empty());
    EXPECT_TRUE(assignRows({0, 3, 0.0, {}}).empty());
    EXPECT_EQ(assignRows({2, 0, 0.0, {}}), (std::vector<std::size_t>{kUnassigned, kUnassigned}));
}

TEST(Assignment, aGreedyChoiceIsGivenUpForABetterSum)
{
    // Row 0 likes column 0 best, but row 1 can take nothing else.
    const SparseCosts costs{2, 2, 10.0, {{0, 0, 1.0}, {0, 1, 2.0}, {1, 0, 1.0}}};
    EXPECT_EQ(assignRows(costs), (std::vector<std::size_t>{1, 0}));
}

TEST(Assignment, manyPlacesAgainstManyRoomsNeedNoDenseTable)
{
    constexpr std::size_t kSide = 3000;
    SparseCosts costs{kSide, kSide, 0.0, {}};
    for (std::size_t row = 0; row < kSide; ++row) {
        costs.entries.push_back({row, (row + 7) % kSide, -0.9});
        costs.entries.push_back({row, (row + 8) % kSide, -0.1});
    }
    const auto columnOf = assignRows(costs);
    for (std::size_t row = 0; row < kSide; ++row) ASSERT_EQ(columnOf[row], (row + 7) % kSide);
}

TEST(Assignment, refusesEntriesOutsideAndEndlessCosts)
{
    EXPECT_THROW(assignRows({1, 1, 0.0, {{1, 0, 0.0}}}), std::invalid_argument);
    EXPECT_THROW(assignRows({1, 1, 0.0, {{0, 1, 0.0}}}), std::invalid_argument);
    EXPECT_THROW(assignRows({1, 1, 0.0, {{0, 0, std::numeric_limits<double>::infinity()}}}),
                 std::invalid_argument);
    EXPECT_THROW(assignRows({1, 1, std::numeric_limits<double>::quiet_NaN(), {}}), std::invalid_argument);
}
