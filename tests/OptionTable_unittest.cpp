#include "gr2to/base/OptionTable.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <sstream>

namespace
{
struct TDoorLikeOptions : gr2to::OptionTable
{
    double min_width = 0.6;
    double max_width = 1.2;
    int samples = 8;
    bool strict = true;
    std::string mode = "fast";
    std::optional<double> height;

    std::string section() const override { return "door"; }
    std::vector<gr2to::OptionField> fields() override
    {
        return {{"min_width", &min_width, "m", "Narrowest door.", 0.1, 5},
                {"max_width", &max_width, "m", "Widest door.", 0.1, 5},
                {"samples", &samples, "", "Samples on the circle.", 4, 64},
                {"strict", &strict, "", "Whether ties fail."},
                {"mode", &mode, "", "How.", 0, 0, {"fast", "exact"}},
                {"height", &height, "m", "Height of the lintel; auto: as measured.", 1, 3}};
    }
    void checkRules() const override
    {
        if (max_width <= min_width) throw std::invalid_argument("door.max_width must exceed door.min_width");
    }
};

std::string messageOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}
}  // namespace

TEST(OptionTable, loadsEveryTypeFromAnIniSection)
{
    mrpt::config::CConfigFileMemory ini;
    ini.setContent("[door]\nmin_width = 0.7\nsamples = 16\nstrict = no\nmode = exact\n");
    TDoorLikeOptions options;
    options.loadFrom(ini);
    EXPECT_EQ(options.min_width, 0.7);
    EXPECT_EQ(options.samples, 16);
    EXPECT_FALSE(options.strict);
    EXPECT_EQ(options.mode, "exact");
    EXPECT_EQ(options.max_width, 1.2);
}

TEST(OptionTable, savingAndLoadingLosesNothing)
{
    TDoorLikeOptions options;
    options.min_width = 0.1 + 0.2;
    mrpt::config::CConfigFileMemory ini;
    options.saveToConfigFile(ini, "door");
    TDoorLikeOptions read;
    read.loadFrom(ini);
    EXPECT_EQ(read.min_width, options.min_width);
}

TEST(OptionTable, unknownKeyNamesTheNearest)
{
    TDoorLikeOptions options;
    EXPECT_THAT(messageOf([&] { options.set("max_widht", "1"); }), testing::HasSubstr("'door.max_width'"));
}

TEST(OptionTable, badValuesAreNamedWithTheirRule)
{
    TDoorLikeOptions options;
    EXPECT_THAT(messageOf([&] { options.set("min_width", "wide"); }),
                testing::AllOf(testing::HasSubstr("door.min_width"), testing::HasSubstr("number")));
    EXPECT_THAT(messageOf([&] { options.set("min_width", "9"); }), testing::HasSubstr("[0.1, 5]"));
    EXPECT_THAT(messageOf([&] { options.set("min_width", "nan"); }), testing::HasSubstr("[0.1, 5]"));
    EXPECT_THAT(messageOf([&] { options.set("mode", "slow"); }), testing::HasSubstr("fast|exact"));
    EXPECT_THAT(messageOf([&] { options.set("samples", "8.5"); }), testing::HasSubstr("integer"));
}

TEST(OptionTable, rulesBetweenFieldsAreChecked)
{
    TDoorLikeOptions options;
    options.max_width = 0.5;
    EXPECT_THAT(messageOf([&] { options.check(); }), testing::HasSubstr("must exceed"));
}

TEST(OptionTable, dumpNamesEveryFieldWithItsUnit)
{
    std::ostringstream out;
    TDoorLikeOptions().dumpToTextStream(out);
    EXPECT_THAT(out.str(), testing::HasSubstr("door.max_width = 1.2 m\n"));
}

TEST(OptionTable, aNumberThatIsNotGivenReadsAutoAndRoundTrips)
{
    TDoorLikeOptions options;
    const auto heightText = [&] { return options.fields().back().valueText(); };
    EXPECT_EQ(heightText(), "auto");
    EXPECT_NO_THROW(options.check());
    options.set("height", "2.05");
    EXPECT_EQ(options.height, 2.05);
    EXPECT_EQ(heightText(), "2.05");
    options.set("height", "auto");
    EXPECT_FALSE(options.height.has_value());
    EXPECT_THAT(messageOf([&] { options.set("height", "9"); }), testing::HasSubstr("[1, 3]"));
    EXPECT_THAT(messageOf([&] { options.set("height", "nan"); }), testing::HasSubstr("[1, 3]"));
    EXPECT_THAT(messageOf([&] { options.set("height", "tall"); }), testing::HasSubstr("number|auto"));
}
