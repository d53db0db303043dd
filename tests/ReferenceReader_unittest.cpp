#include "gr2to/io/ReferenceReader.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/io/LabelImageReader.h"
#include "support/plainPng.h"

namespace
{
using namespace gr2to;
using test::plainPng;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

std::string raw(std::initializer_list<int> bytes)
{
    std::string text;
    for (const int b : bytes) text += static_cast<char>(b);
    return text;
}

class ReferenceReader : public testing::Test
{
 protected:
    void SetUp() override
    {
        m_folder = fs::temp_directory_path() / ("gr2to-reference-" + std::to_string(::getpid()));
        fs::create_directories(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    fs::path put(const std::string& name, const std::string& bytes) const
    {
        writeFile(m_folder / name, bytes);
        return m_folder / name;
    }
    /** Writes a 2 x 1 image of the labels 3 and 7 with an annotation. */
    fs::path annotated(const std::string& json) const
    {
        put("lab.gt_labels.png", plainPng({2, 1, 8, 0}, raw({3, 7})));
        return put("lab.gt.json", json);
    }
    static std::string messageOf(const std::function<void()>& action)
    {
        try {
            action();
        } catch (const InputError& e) {
            return e.what();
        }
        return "nothing was thrown";
    }
    std::string complaint(const std::string& json) const
    {
        const auto path = annotated(json);
        return messageOf([&] { readReference(path); });
    }
    std::string complaintAboutImage(const std::string& bytes) const
    {
        const auto path = put("bad.png", bytes);
        const auto message = messageOf([&] { readLabelImage(path); });
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        return message;
    }

    fs::path m_folder;
};

std::string interfaceJson(const std::string& interface)
{
    return R"({"resolution_m": 0.05, "interfaces": [)" + interface + "]}";
}
}  // namespace

TEST_F(ReferenceReader, greyImagesKeepTheirLabelsAndTurnUpsideUp)
{
    const auto bytes8 = put("a.png", plainPng({2, 2, 8, 0}, raw({1, 0, 255, 4})));
    EXPECT_THAT(readLabelImage(bytes8).labels.ids, ElementsAre(255, 4, 1, 0));
    EXPECT_TRUE(readLabelImage(bytes8).values.empty());
    const auto bytes16 = put("b.png", plainPng({2, 1, 16, 0}, raw({1, 2, 255, 255})));
    EXPECT_THAT(readLabelImage(bytes16).labels.ids, ElementsAre(258, 65535));
    const auto bits2 = put("c.png", plainPng({4, 1, 2, 0}, raw({0x1B})));
    EXPECT_THAT(readLabelImage(bits2).labels.ids, ElementsAre(0, 1, 2, 3));
}

TEST_F(ReferenceReader, coloursBecomeLabelsInAscendingOrder)
{
    const auto path = put("a.png", plainPng({4, 1, 8, 2}, raw({9, 0, 1, 0, 0, 0, 0, 9, 2, 9, 0, 1})));
    const auto image = readLabelImage(path);
    EXPECT_THAT(image.labels.ids, ElementsAre(2, 0, 1, 2));
    EXPECT_THAT(image.values, ElementsAre(0u, 0x000902u, 0x090001u));
}

TEST_F(ReferenceReader, palettesGiveTheirIndicesAndTransparencyIsIgnored)
{
    const auto palette = put("a.png", plainPng({2, 1, 8, 3}, raw({2, 0}), raw({0, 0, 0, 5, 5, 5, 5, 5, 5})));
    EXPECT_THAT(readLabelImage(palette).labels.ids, ElementsAre(2, 0));
    const auto greyAlpha = put("b.png", plainPng({2, 1, 8, 4}, raw({6, 0, 7, 255})));
    EXPECT_THAT(readLabelImage(greyAlpha).labels.ids, ElementsAre(6, 7));
    const auto rgba = put("c.png", plainPng({2, 1, 8, 6}, raw({0, 0, 6, 0, 0, 0, 5, 9})));
    EXPECT_THAT(readLabelImage(rgba).values, ElementsAre(0u, 5u, 6u));
}

TEST_F(ReferenceReader, brokenImagesAreRefusedInOneLine)
{
    EXPECT_THAT(messageOf([&] { readLabelImage(m_folder / "none.png"); }), HasSubstr("does not exist"));
    EXPECT_THAT(messageOf([&] { readLabelImage(m_folder); }), HasSubstr("folder"));
    EXPECT_THAT(complaintAboutImage("P5 2 2 255 abcd"), HasSubstr("not a PNG"));
    EXPECT_THAT(complaintAboutImage("short"), HasSubstr("not a PNG"));
    const auto good = plainPng({2, 2, 8, 0}, raw({1, 2, 3, 4}));
    for (const std::size_t size : {8u, 20u, 40u, 45u, 50u})
        EXPECT_THAT(complaintAboutImage(good.substr(0, size)), HasSubstr("damaged")) << size << " bytes";
    auto flipped = good;
    flipped[45] = static_cast<char>(flipped[45] ^ 1);
    EXPECT_THAT(complaintAboutImage(flipped), HasSubstr("damaged"));
    EXPECT_THAT(complaintAboutImage(plainPng({1, 1, 16, 2}, raw({0, 0, 0, 0, 0, 0}))),
                HasSubstr("16 bits a colour"));
}

TEST_F(ReferenceReader, hugeSizesAreRefusedBeforeMemoryIsTaken)
{
    EXPECT_THAT(complaintAboutImage(plainPng({30000, 30000, 16, 0}, "")), HasSubstr("too short"));
    EXPECT_THAT(complaintAboutImage(plainPng({65536, 65536, 8, 0}, "")), HasSubstr("32767 a side"));
}

TEST_F(ReferenceReader, moreColoursThanPlacesAreRefused)
{
    std::string rows;
    for (int i = 0; i < 257 * 256; ++i) rows += raw({i >> 16, (i >> 8) & 255, i & 255});
    EXPECT_THAT(complaintAboutImage(plainPng({256, 257, 8, 2}, rows)),
                AllOf(HasSubstr("65791"), HasSubstr("65535")));
}

TEST_F(ReferenceReader, annotationIsFoundFromEitherFile)
{
    const auto json =
        annotated(R"({"resolution_m": 0.1, "size_px": [2, 1], "doors_reliable": false, "interfaces": [
        {"kind": "door", "a": 7, "b": 3, "mid_px": [0.5, 1], "width_m": 0.8},
        {"kind": "slit", "a": 3, "b": 7, "mid_px": [0, 0], "width_m": 0},
        {"kind": "opening", "a": 3, "b": 7, "mid_px": [0, 0], "width_m": 3}]})");
    for (const auto& path : {json, m_folder / "lab.gt_labels.png"}) {
        const auto reference = readReference(path);
        EXPECT_THAT(reference.labels.ids, ElementsAre(3, 7));
        EXPECT_EQ(reference.resolution_m, 0.1);
        EXPECT_FALSE(reference.doorsReliable);
        ASSERT_EQ(reference.interfaces.value().size(), 3u);
        const auto& door = reference.interfaces->front();
        EXPECT_EQ(door.kind, InterfaceKind::Door);
        EXPECT_EQ(door.a, 3);
        EXPECT_EQ(door.b, 7);
        EXPECT_EQ(door.mid_px, Eigen::Vector2d(0.5, 1));
        EXPECT_EQ(door.width_m, 0.8);
        EXPECT_EQ(reference.interfaces->at(1).kind, InterfaceKind::Slit);
        EXPECT_EQ(reference.interfaces->at(2).kind, InterfaceKind::Opening);
    }
}

TEST_F(ReferenceReader, aLabelImageAloneHasNoInterfaces)
{
    const auto path = put("other.png", plainPng({2, 1, 8, 0}, raw({1, 2})));
    EXPECT_FALSE(readReference(path).interfaces);
    EXPECT_TRUE(readReference(path).doorsReliable);
}

TEST_F(ReferenceReader, interfacesNameColoursByTheirPackedValue)
{
    put("rgb.gt_labels.png", plainPng({2, 1, 8, 2}, raw({1, 0, 0, 2, 0, 0})));
    put("rgb.gt.json",
        interfaceJson(R"({"kind": "door", "a": 65536, "b": 131072, "mid_px": [0, 0], "width_m": 1})"));
    const auto reference = readReference(m_folder / "rgb.gt.json");
    EXPECT_EQ(reference.interfaces.value().at(0).a, 1);
    EXPECT_EQ(reference.interfaces.value().at(0).b, 2);
}

TEST_F(ReferenceReader, brokenAnnotationsNameTheCulprit)
{
    EXPECT_THAT(complaint("{"), HasSubstr("not valid JSON"));
    EXPECT_THAT(complaint("[]"), HasSubstr("must be an object"));
    EXPECT_THAT(complaint("{}"), HasSubstr("has no 'resolution_m'"));
    EXPECT_THAT(complaint(R"({"resolution_m": 0.05})"), HasSubstr("has no 'interfaces'"));
    EXPECT_THAT(complaint(R"({"resolution_m": -1, "interfaces": []})"),
                HasSubstr("resolution_m must be positive"));
    EXPECT_THAT(complaint(R"({"resolution_m": "x", "interfaces": []})"),
                HasSubstr("resolution_m must be a number"));
    EXPECT_THAT(complaint(R"({"resolution_m": 1, "interfaces": 4})"), HasSubstr("interfaces must be a list"));
    EXPECT_THAT(complaint(R"({"resolution_m": 1, "size_px": [9, 9], "interfaces": []})"), HasSubstr("2 x 1"));
    EXPECT_THAT(complaint(R"({"resolution_m": 1, "doors_reliable": 1, "interfaces": []})"),
                HasSubstr("true or false"));
    EXPECT_THAT(complaint(interfaceJson("3")), HasSubstr("interfaces[0] must be an object"));
    const auto with = [](const std::string& kind, const std::string& a, const std::string& mid,
                         const std::string& width) {
        return interfaceJson(R"({"kind": )" + kind + R"(, "a": )" + a + R"(, "b": 7, "mid_px": )" + mid +
                             R"(, "width_m": )" + width + "}");
    };
    EXPECT_THAT(complaint(with(R"("door")", "3", "[1, 2]", "0.5")), HasSubstr("nothing was thrown"));
    EXPECT_THAT(complaint(with(R"("gate")", "3", "[1, 2]", "0.5")),
                HasSubstr("interfaces[0].kind must be one of"));
    EXPECT_THAT(complaint(with("1", "3", "[1, 2]", "0.5")), HasSubstr("interfaces[0].kind must be a text"));
    for (const std::string label : {"0", "-3", "3.5", "4", "1e300", "99999"})
        EXPECT_THAT(complaint(with(R"("door")", label, "[1, 2]", "0.5")),
                    HasSubstr("interfaces[0].a must be a label"));
    EXPECT_THAT(complaint(with(R"("door")", "7", "[1, 2]", "0.5")), HasSubstr("two different rooms"));
    EXPECT_THAT(complaint(with(R"("door")", "3", "[1]", "0.5")),
                HasSubstr("interfaces[0].mid_px must be a list of two"));
    EXPECT_THAT(complaint(with(R"("door")", "3", "[1, 2]", "-0.5")),
                HasSubstr("width_m must not be negative"));
    EXPECT_THAT(complaint(with(R"("door")", "3", "[1, 2]", "1e999")), HasSubstr("not valid JSON"));
}

TEST_F(ReferenceReader, missingHalvesAreNamed)
{
    const auto alone = put("alone.gt.json", "{}");
    EXPECT_THAT(messageOf([&] { readReference(alone); }), HasSubstr("'alone.gt_labels.png' beside it"));
    EXPECT_THAT(messageOf([&] { readReference(m_folder / "x.json"); }), HasSubstr("NAME.gt.json"));
}
