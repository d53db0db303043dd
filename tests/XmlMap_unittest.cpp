#include "gr2to/io/XmlMap.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "gr2to/base/errors.h"
#include "support/brokenXml.h"
#include "support/messageOf.h"
#include "support/randomTopologicalMap.h"
#include "support/someTopologicalMap.h"

namespace gr2to::test
{
namespace
{
using testing::HasSubstr;
using testing::Not;

std::string writingMessage(const TopologicalMap& map)
{
    return messageOf<std::invalid_argument>([&] { toXml(map); });
}

std::string readingMessage(const std::string& text)
{
    return messageOf<InputError>([&] { fromXml(text, "a.xml"); });
}

/** Reads hostile text: an InputError of one line is as good as a map. \return whether it was read */
bool readOrRefuse(const std::string& text)
{
    try {
        fromXml(text, "a.xml");
        return true;
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
        EXPECT_THAT(error.what(), testing::StartsWith("a.xml: "));
        return false;
    }
}
}  // namespace

TEST(XmlMap, roundTripLosesNothing)
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        const TopologicalMap map = randomTopologicalMap(seed);
        const std::string xml = toXml(map);
        EXPECT_TRUE(fromXml(xml, "a.xml") == map) << "seed " << seed;
        EXPECT_EQ(toXml(fromXml(xml, "a.xml")), xml) << "seed " << seed;
    }
}

TEST(XmlMap, writesWhatItReads)
{
    EXPECT_EQ(toXml(fromXml(completeXml(), "a.xml")), completeXml());
}

TEST(XmlMap, readsEveryAttribute)
{
    const TopologicalMap map = fromXml(completeXml(), "a.xml");
    EXPECT_THAT(map.validate(), testing::IsEmpty());
    EXPECT_EQ(map.frame, "map");
    EXPECT_EQ(map.resolution_m, 0.05);
    EXPECT_EQ(map.source, "office.yaml");
    const Place& place = map.place(3);
    EXPECT_EQ(place.kind, PlaceKind::Room);
    EXPECT_EQ(place.area_m2, 22.23);
    EXPECT_THAT(place.words, testing::ElementsAre("Sam's office", "<desk> & chair"));
    EXPECT_EQ(place.center, mrpt::math::TPoint3D(1, 2, 0));
    EXPECT_EQ(place.boundary.at(2), mrpt::math::TPoint2D(4, 3.5));
    const Wall& wall = place.walls.at(0);
    EXPECT_EQ(wall.id, 12u);
    EXPECT_TRUE(wall.real);
    EXPECT_EQ(wall.position.covariance(1, 0), 0.125);
    EXPECT_EQ(wall.position.covariance(2, 2), 1);
    EXPECT_EQ(wall.normal.mean.y, -1);
    EXPECT_EQ(wall.size.height_m, 2.5);
    EXPECT_EQ(wall.size.covariance(1, 0), 0.25);
    EXPECT_EQ(wall.curvatureLength, 0.1);
    EXPECT_EQ(place.walls.at(1).size.height_m, std::nullopt);
    EXPECT_EQ(place.views.at(0).time_s, 1700000000.25);
    EXPECT_EQ(place.views.at(0).apertureX_rad, 1.5);
    EXPECT_EQ(map.place(5).kind, PlaceKind::Corridor);
    const auto connections = map.connections();
    ASSERT_EQ(connections.size(), 2u);
    EXPECT_EQ(connections[0].doorway.state, DoorState::Open);
    EXPECT_EQ(connections[0].doorway.size.length_m, 0.92);
    EXPECT_EQ(connections[0].doorway.view->image, "views/7.png");
    EXPECT_FALSE(connections[1].doorway.real);
    EXPECT_FALSE(connections[1].doorway.view.has_value());
}

TEST(XmlMap, keepsTextThatXmlIsEagerToChange)
{
    TopologicalMap map = someMap();
    map.source = " a\tb\nc\rd  \"e\" 'f' <g> &amp; ";
    map.place(3).words = {"", " ", "\n", "a\n b\t", "]]>", "&#65;"};
    EXPECT_TRUE(fromXml(toXml(map), "a.xml") == map);
}

TEST(XmlMap, readsCommentsCharacterDataAndOtherLineEnds)
{
    std::string text = BrokenXml{"Sam's office", "Sam&#39;s<!-- who? --><![CDATA[ off]]>ice", ""}.text();
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
    const TopologicalMap map = fromXml("\xEF\xBB\xBF" + text + "<!-- end -->", "a.xml");
    EXPECT_TRUE(map == fromXml(completeXml(), "a.xml"));
}

TEST(XmlMap, putsTheEndsOfAConnectionIntoOrder)
{
    const BrokenXml swapped{"from=\"3\" to=\"5\"", "from=\"5\" to=\"3\"", ""};
    EXPECT_TRUE(fromXml(swapped.text(), "a.xml") == fromXml(completeXml(), "a.xml"));
}

TEST(XmlMap, refusesWhatIsNotOfTheFormat)
{
    for (const BrokenXml& broken : foreignXml())
        EXPECT_EQ(readingMessage(broken.text()), "a.xml: " + broken.complaint) << broken.replacement;
    EXPECT_EQ(readingMessage("<gpx/>"), "a.xml: gpx: the root element must be topological_map");
    EXPECT_EQ(readingMessage("<topological_map/>"),
              "a.xml: topological_map: attribute version = '' must be 1.0, the version that can be read");
}

TEST(XmlMap, refusesWhatIsNotWellFormedWithLineAndByte)
{
    for (const BrokenXml& broken : malformedXml())
        EXPECT_EQ(readingMessage(broken.text()), "a.xml: " + broken.complaint) << broken.replacement;
}

TEST(XmlMap, countsTheByteOrderMarkInPositions)
{
    EXPECT_EQ(readingMessage("\xEF\xBB\xBF<a/>b"),
              "a.xml: line 1 (byte 7) is not well-formed XML: there is text outside the root element");
    EXPECT_EQ(readingMessage("\xEF\xBB\xBF\n<a></b>"),
              "a.xml: line 2 (byte 9) is not well-formed XML: Start-end tags mismatch");
}

TEST(XmlMap, refusesToWriteWhatXmlCannotHold)
{
    const std::string start = "the map cannot be written as XML: ";
    TopologicalMap map = someMap();
    map.place(3).walls[1].position.mean.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(writingMessage(map),
              start + "places/place[id=3]/walls/wall[2]/position: x = nan must be finite");
    map = someMap([](Connection& c) { c.doorway.size.length_m = std::numeric_limits<double>::infinity(); });
    EXPECT_EQ(writingMessage(map),
              start + "connections/connection[id=7]/doorway/size: length = inf must be finite");
    map = someMap([](Connection& c) { c.doorway.state = static_cast<DoorState>(9); });
    EXPECT_EQ(writingMessage(map), start + "connections/connection[id=7]/doorway: state = 9 has no name");
    map = someMap();
    map.place(1).kind = static_cast<PlaceKind>(9);
    EXPECT_EQ(writingMessage(map), start + "places/place[id=1]: kind = 9 has no name");
    map = someMap();
    map.place(1).walls[0].normal.covariance(1, 0) = 2;
    EXPECT_EQ(writingMessage(map),
              start +
                  "places/place[id=1]/walls/wall[1]/normal: cov is not symmetric: 0 differs "
                  "from its mirror image 2");
    map = someMap();
    map.place(1).words = {"ok", "a\rb"};
    EXPECT_EQ(writingMessage(map),
              start + "places/place[id=1]/words/word[2]: 'a?b' must be UTF-8 without control characters");
    map = someMap();
    map.source = "caf\xE9";
    EXPECT_THAT(writingMessage(map), HasSubstr("topological_map: source = 'caf\xE9' must be UTF-8"));
}

TEST(XmlMap, survivesEveryPrefix)
{
    const std::string text = completeXml();
    const std::size_t end = text.rfind('>') + 1;
    for (std::size_t size = 0; size < end; ++size)
        EXPECT_FALSE(readOrRefuse(text.substr(0, size))) << "prefix of " << size << " bytes";
    EXPECT_TRUE(readOrRefuse(text.substr(0, end)));
}

TEST(XmlMap, survivesMutations)
{
    const std::string alphabet("<>/=\"'&;#! x0-\xC3\x00", 16);
    int read = 0;
    int refused = 0;
    for (unsigned seed = 0; seed < 4000; ++seed) {
        std::mt19937 random(seed);
        const auto below = [&](std::size_t end) {
            return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
        };
        std::string text = completeXml();
        for (std::size_t i = below(3) + 1; i > 0; --i) {
            const std::size_t at = below(text.size());
            const std::size_t length = std::min(below(20), text.size() - at);
            if (const std::size_t kind = below(3); kind == 0)
                text[at] = alphabet[below(alphabet.size())];
            else if (kind == 1)
                text.erase(at, length);
            else
                text.insert(below(text.size()), text.substr(at, length));
        }
        SCOPED_TRACE("seed " + std::to_string(seed));
        ++(readOrRefuse(text) ? read : refused);
    }
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 0);
}

TEST(XmlMap, refusesHugeAndHostileText)
{
    std::string deep;
    for (int i = 0; i < 1000000; ++i) deep += "<a>";
    EXPECT_FALSE(readOrRefuse(deep));
    for (int i = 0; i < 1000000; ++i) deep += "</a>";
    EXPECT_FALSE(readOrRefuse(deep));
    EXPECT_FALSE(readOrRefuse("<" + std::string(1000000, 'a') + "/>"));
    EXPECT_FALSE(readOrRefuse("<a b='" + std::string(1000000, 'a') + "'/>"));
    EXPECT_FALSE(readOrRefuse("<topological_map version='" + std::string(1000000, '1') + "'/>"));
    EXPECT_FALSE(readOrRefuse(std::string(1000000, '<')));
    EXPECT_FALSE(readOrRefuse(std::string(1000000, '&')));
    EXPECT_FALSE(readOrRefuse("<!DOCTYPE a " + std::string(1000000, '[')));
    std::string bomb = "<!DOCTYPE a [<!ENTITY b0 \"lol\">";
    for (int i = 1; i < 30; ++i)
        bomb += "<!ENTITY b" + std::to_string(i) + " \"&b" + std::to_string(i - 1) + ";&b" +
                std::to_string(i - 1) + ";\">";
    EXPECT_FALSE(readOrRefuse(bomb + "]><topological_map version='1.0' source='&b29;'/>"));
}

TEST(XmlMap, missingFilesAreInputErrors)
{
    EXPECT_THAT(messageOf<InputError>([] { readXml("/nowhere/topomap.xml"); }),
                HasSubstr("/nowhere/topomap.xml"));
}
}  // namespace gr2to::test
