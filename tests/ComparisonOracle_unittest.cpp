#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "gr2to/base/files.h"
#include "gr2to/compare/Comparison.h"
#include "gr2to/io/LabelImageReader.h"
#include "gr2to/io/ReferenceReader.h"

namespace
{
using namespace gr2to;
using nlohmann::json;
namespace fs = std::filesystem;

const fs::path kData = GR2TO_EVALUATION_DATA;
const fs::path kEvaluation = kData / ".." / "eval";
const std::string kPython = "/usr/bin/python3";

/** One answer to be scored by both programs. */
struct Job
{
    std::string set;
    std::string map;
    std::string variant;
    std::string answer;  //!< file name without its ending
    ComparisonScores scores;
};

struct Answer
{
    PlaceImage places;
    PredictedGraph graph;
};

int uniform(std::mt19937& random, int low, int high)
{
    return std::uniform_int_distribution<int>(low, high)(random);
}

/** Distinct numbers for the labels 1..n, some rooms sharing one (merged) and some having none (missed). */
std::vector<PlaceId> renumber(std::mt19937& random, std::size_t n)
{
    std::vector<PlaceId> numbers(n + 1, 0);
    for (std::size_t label = 1; label <= n; ++label)
        numbers[label] =
            static_cast<PlaceId>(1 + (label * 97 + static_cast<std::size_t>(uniform(random, 0, 40))) % 60000);
    for (std::size_t k = 0; k < n / 5; ++k)
        numbers[static_cast<std::size_t>(uniform(random, 1, static_cast<int>(n)))] =
            numbers[static_cast<std::size_t>(uniform(random, 1, static_cast<int>(n)))];
    if (n > 3) numbers[static_cast<std::size_t>(uniform(random, 1, static_cast<int>(n)))] = 0;
    return numbers;
}

/** For two of three labels a column that cuts through its region, 0 for the others. */
std::vector<int> cutColumns(std::mt19937& random, const PlaceImage& truth, PlaceId highest)
{
    std::vector<int> left(highest + 1U, truth.width), right(highest + 1U, 0), cut(highest + 1U, 0);
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            const PlaceId room = truth.at({x, y});
            left[room] = std::min(left[room], x);
            right[room] = std::max(right[room], x);
        }
    for (std::size_t room = 1; room < cut.size(); ++room)
        if (left[room] < right[room] && uniform(random, 0, 2) > 0)
            cut[room] = uniform(random, left[room], right[room]);
    return cut;
}

/** Rooms merged, cut along random lines, eroded, grown and speckled: an answer as wrong as real ones are. */
PlaceImage perturb(std::mt19937& random, const PlaceImage& truth)
{
    const auto highest = *std::max_element(truth.ids.begin(), truth.ids.end());
    const auto numbers = renumber(random, highest);
    const auto cutColumn = cutColumns(random, truth, highest);
    const int shift = uniform(random, 0, 6);
    PlaceImage places(truth.width, truth.height);
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            const PlaceId room = truth.at({std::min(x + shift, truth.width - 1), std::max(y - shift, 0)});
            PlaceId number = numbers[room];
            if (number != 0 && x < cutColumn[room]) number = static_cast<PlaceId>(number + 7);
            places.ids[places.index({x, y})] = number;
        }
    for (int k = 0; k < 60; ++k)  // squares of up to 144 cells, of which some are specks
    {
        const int side = uniform(random, 1, 12), left = uniform(random, 0, truth.width - side),
                  low = uniform(random, 0, truth.height - side);
        const auto number =
            static_cast<PlaceId>(uniform(random, 0, 3) == 0 ? 0 : uniform(random, 60500, 60530));
        for (int y = low; y < low + side; ++y)
            for (int x = left; x < left + side; ++x) places.ids[places.index({x, y})] = number;
    }
    return places;
}

/** Doors moved by up to some 1.4 m, lost, doubled and invented; edges of the truth and wrong ones. */
PredictedGraph perturbGraph(std::mt19937& random, const ReferenceAnnotation& truth, const PlaceImage& places)
{
    PredictedGraph graph;
    const auto placeAt = [&](const Eigen::Vector2d& px) {
        return places.at(
            {std::clamp(static_cast<int>(px.x()) + uniform(random, -25, 25), 0, places.width - 1),
             std::clamp(places.height - 1 - static_cast<int>(px.y()) + uniform(random, -25, 25), 0,
                        places.height - 1)});
    };
    for (const auto& i : *truth.interfaces)
        for (int copy = uniform(random, 0, 2); copy > 0; --copy) {
            const Eigen::Vector2d jitter(uniform(random, -1000, 1000) / 50.0,
                                         uniform(random, -1000, 1000) / 50.0);
            graph.doors.push_back(
                {i.mid_px + jitter, uniform(random, 0, 3) == 0 ? 0.0 : uniform(random, 5, 15) / 10.0});
            graph.edges.emplace_back(placeAt(i.mid_px), placeAt(i.mid_px));
        }
    for (int k = 0; k < 10; ++k) {
        const Eigen::Vector2d anywhere(uniform(random, 0, places.width), uniform(random, 0, places.height));
        graph.doors.push_back({anywhere, 0.9});
        graph.edges.emplace_back(placeAt(anywhere), static_cast<PlaceId>(uniform(random, 60499, 60531)));
    }
    graph.edges.erase(std::remove_if(graph.edges.begin(), graph.edges.end(),
                                     [](const auto& e) { return e.first == 0 || e.second == 0; }),
                      graph.edges.end());
    return graph;
}

/** The truth itself, all rooms as one place, nothing at all, or a seeded perturbation. */
Answer answerOf(const ReferenceAnnotation& truth, int kind, std::mt19937& random)
{
    Answer answer{truth.labels, {}};
    if (kind == 0)
        for (const auto& i : *truth.interfaces) {
            answer.graph.edges.emplace_back(i.b, i.a);
            if (i.kind == InterfaceKind::Door) answer.graph.doors.push_back({i.mid_px, i.width_m});
        }
    if (kind == 1)
        for (auto& id : answer.places.ids) id = id != 0 ? PlaceId{1} : PlaceId{0};
    if (kind == 2) std::fill(answer.places.ids.begin(), answer.places.ids.end(), PlaceId{0});
    if (kind < 3) return answer;
    answer.places = perturb(random, truth.labels);
    answer.graph = perturbGraph(random, truth, answer.places);
    return answer;
}

/** Sixteen-bit PGM, which the Python side reads as it is. */
std::string pgm(const PlaceImage& image)
{
    std::string bytes = "P5 " + std::to_string(image.width) + " " + std::to_string(image.height) + " 65535\n";
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x) {
            bytes += static_cast<char>(image.at({x, y}) >> 8U);
            bytes += static_cast<char>(image.at({x, y}) & 0xFFU);
        }
    return bytes;
}

std::string graphJson(const PredictedGraph& graph)
{
    json doors = json::array(), edges = json::array();
    for (const auto& d : graph.doors)
        doors.push_back({{"x_px", d.mid_px.x()}, {"y_px", d.mid_px.y()}, {"width_m", d.width_m}});
    for (const auto& [a, b] : graph.edges) edges.push_back({a, b});
    return json{{"doors", doors}, {"edges", edges}}.dump();
}

ClassifiedGrid readGrid(const fs::path& path)
{
    constexpr PlaceId kFreeFrom = 250;
    const PlaceImage grey = readLabelImage(path).labels;
    ClassifiedGrid grid(grey.width, grey.height, GridFrame{}, CellState::Occupied);
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (grey.ids[i] >= kFreeFrom) grid[i] = CellState::Free;
    return grid;
}

/** Runs the reference program over all answers in one process: one line of JSON each. */
std::vector<json> scoresOfOracle(const fs::path& folder, const std::vector<Job>& jobs)
{
    std::ostringstream list;
    for (const auto& job : jobs)
        list << job.set << ' ' << job.map << ' ' << job.variant << ' ' << job.answer << '\n';
    writeFile(folder / "jobs.txt", list.str());
    writeFile(folder / "driver.py", R"(import json, sys
from pathlib import Path
evaluation, data, folder = (Path(p) for p in sys.argv[1:4])
sys.path.insert(0, str(evaluation))
import evaluate
for line in (folder / 'jobs.txt').read_text().splitlines():
    group, name, variant, answer = line.split()
    labels, graph = folder / (answer + '.pgm'), folder / (answer + '.json')
    print(json.dumps(evaluate.evaluate(data / group, name, variant, labels, graph)))
)");
    const auto quoted = [](const fs::path& path) { return " '" + path.string() + "'"; };
    const std::string command = kPython + " -B" + quoted(folder / "driver.py") + quoted(kEvaluation) +
                                quoted(kData) + quoted(folder) + " >" + quoted(folder / "scores.txt");
    if (std::system(command.c_str()) != 0) throw std::runtime_error("the reference program failed");
    std::istringstream lines(readFile(folder / "scores.txt"));
    std::vector<json> scores;
    for (std::string line; std::getline(lines, line);) scores.push_back(json::parse(line));
    return scores;
}

bool oracleCanRun()
{
    const std::string command = kPython + " -c 'import numpy, scipy, skimage, PIL' 2>/dev/null";
    return fs::exists(kEvaluation / "evaluate.py") && fs::exists(kData / "ipa") &&
           std::system(command.c_str()) == 0;
}

/** Every figure of the reference program must be ours too. */
int compareFigures(const json& expected, const ComparisonScores& scores, const std::string& name)
{
    const json ours = json::parse(toJson(scores)).flatten(), theirs = expected.flatten();
    int figures = 0;
    for (const auto& [key, value] : theirs.items()) {
        if (value.is_null()) {
            EXPECT_FALSE(ours.contains(key)) << name << ' ' << key;
            continue;
        }
        if (!ours.contains(key)) {
            ADD_FAILURE() << name << " lacks " << key;
            continue;
        }
        EXPECT_NEAR(ours.at(key).get<double>(), value.get<double>(), 1e-9) << name << ' ' << key;
        ++figures;
    }
    return figures;
}
}  // namespace

TEST(ComparisonOracle, allFiguresEqualTheReferenceProgramsOnPerturbedAnnotations)
{
    if (!oracleCanRun())
        GTEST_SKIP() << "needs the evaluation data beside the repository and Python with numpy, scipy, "
                        "skimage and PIL";
    const fs::path folder = fs::temp_directory_path() / ("gr2to-oracle-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::vector<std::array<std::string, 3>> maps{{"ipa", "Freiburg52_scan", "clean"},
                                                       {"ipa", "Freiburg52_scan", "furnitures"},
                                                       {"ipa", "lab_ipa", "clean"},
                                                       {"ipa", "office_b", "furnitures"},
                                                       {"ipa", "NLB", "trashbins"},
                                                       {"homes", "home_0059fae8fb", "clean"},
                                                       {"homes", "home_0059fae8fb", "furnitures"},
                                                       {"homes", "home_1620d2affe", "furnitures"},
                                                       {"homes", "home_01704fabb5", "clean"},
                                                       {"rose", "rose_map15", "clean"},
                                                       {"rose", "rose_freiburg_building79", "clean"}};
    constexpr int kAnswers = 7;  // four of them seeded
    std::vector<Job> jobs;
    for (const auto& [set, map, variant] : maps) {
        const auto truth = readReference(kData / set / (map + ".gt.json"));
        const auto grid = readGrid(kData / set / (map + "." + variant + ".png"));
        for (int kind = 0; kind < kAnswers; ++kind) {
            std::mt19937 random(static_cast<unsigned>(jobs.size()));
            const Answer answer = answerOf(truth, kind, random);
            const std::string name = "answer" + std::to_string(jobs.size());
            writeFile(folder / (name + ".pgm"), pgm(answer.places));
            writeFile(folder / (name + ".json"), graphJson(answer.graph));
            jobs.push_back({set, map, variant, name, compareMaps(answer.places, answer.graph, truth, &grid)});
        }
    }
    const auto expected = scoresOfOracle(folder, jobs);
    fs::remove_all(folder);
    ASSERT_EQ(expected.size(), jobs.size());
    int figures = 0, splits = 0, merges = 0;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        splits += jobs[k].scores.matched.splitRooms;
        merges += jobs[k].scores.matched.mergingSegments;
        figures += compareFigures(expected[k], jobs[k].scores,
                                  jobs[k].map + "." + jobs[k].variant + " seed " + std::to_string(k));
    }
    constexpr int kFiguresEach = 29;  // 30 with the widths of doors
    EXPECT_GE(figures, kFiguresEach * static_cast<int>(jobs.size()));
    EXPECT_GT(splits, 0) << "the answers are too easy";
    EXPECT_GT(merges, 0) << "the answers are too easy";
}
