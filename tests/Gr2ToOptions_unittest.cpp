#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <set>

#include "gr2to/pipeline/Gr2To.h"
#include "support/messageOf.h"

using namespace gr2to;
using testing::AllOf;
using testing::HasSubstr;

namespace
{
std::string complaintOfKey(const std::string& key, const std::string& value = "1")
{
    return test::messageOf<std::invalid_argument>([&] {
        Gr2ToOptions options;
        options.set(key, value);
    });
}

Gr2ToOptions fromIni(const std::string& text)
{
    mrpt::config::CConfigFileMemory ini;
    ini.setContent(text);
    Gr2ToOptions options;
    options.loadFrom(ini);
    return options;
}
}  // namespace

TEST(Gr2ToOptions, defaultPresetIsWhatAFreshObjectHas)
{
    EXPECT_EQ(Gr2ToOptions::presets(), (std::vector<std::string>{"default", "paper"}));
    Gr2ToOptions fresh, preset = Gr2ToOptions::preset("default");
    const auto a = fresh.tables(), b = preset.tables();
    for (std::size_t t = 0; t < a.size(); ++t) {
        const auto left = a[t]->fields(), right = b[t]->fields();
        for (std::size_t k = 0; k < left.size(); ++k)
            EXPECT_EQ(left[k].valueText(), right[k].valueText()) << a[t]->section() << "." << left[k].name;
    }
}

TEST(Gr2ToOptions, paperMeasuresToOccupiedCellsAndKeepsOneDoorPerCandidate)
{
    const Gr2ToOptions paper = Gr2ToOptions::preset("paper");
    EXPECT_FALSE(paper.distance.unknown_is_obstacle);
    EXPECT_TRUE(paper.place.one_door_per_candidate);
    EXPECT_TRUE(Gr2ToOptions::preset("default").distance.unknown_is_obstacle);
    EXPECT_FALSE(Gr2ToOptions::preset("default").place.one_door_per_candidate);
}

TEST(Gr2ToOptions, unknownPresetNamesTheNearest)
{
    EXPECT_THAT(test::messageOf<std::invalid_argument>([] { Gr2ToOptions::preset("papper"); }),
                AllOf(HasSubstr("'papper'"), HasSubstr("'paper'")));
}

TEST(Gr2ToOptions, everyOptionCanBeSetByItsKeyToItsOwnText)
{
    Gr2ToOptions options;
    std::set<std::string> keys;
    for (OptionTable* table : options.tables())
        for (const OptionField& field : table->fields()) {
            const std::string key = table->section() + "." + field.name, text = field.valueText();
            EXPECT_TRUE(keys.insert(key).second) << key << " is there twice";
            options.set(key, text);
            EXPECT_EQ(field.valueText(), text) << key;
            EXPECT_FALSE(field.meaning.empty()) << key;
        }
    EXPECT_GE(keys.size(), 9u);
}

TEST(Gr2ToOptions, unknownKeysNameTheNearest)
{
    EXPECT_THAT(complaintOfKey("door.max_widht"), HasSubstr("'door.max_width'"));
    EXPECT_THAT(complaintOfKey("dor.min_width"), HasSubstr("'door.min_width'"));
    EXPECT_THAT(complaintOfKey("min_width"), HasSubstr("unknown option 'min_width'"));
    EXPECT_THAT(complaintOfKey(""), HasSubstr("unknown option ''"));
}

TEST(Gr2ToOptions, badValuesAreRefusedByName)
{
    EXPECT_THAT(complaintOfKey("door.max_width", "wide"), HasSubstr("max_width"));
    EXPECT_THAT(complaintOfKey("door.max_width", "nan"), HasSubstr("max_width"));
    EXPECT_THAT(complaintOfKey("delimitation.real_wall_ratio", "1.2"), HasSubstr("real_wall_ratio"));
}

TEST(Gr2ToOptions, iniFileIsRead)
{
    const Gr2ToOptions options =
        fromIni("[door]\nmin_width = 0.6 // m\nmax_width = 1.2\n[distance]\nunknown_is_obstacle = no\n");
    EXPECT_EQ(options.door.min_width, 0.6);
    EXPECT_EQ(options.door.max_width, 1.2);
    EXPECT_FALSE(options.distance.unknown_is_obstacle);
    EXPECT_EQ(options.place.min_radius, TPlaceOptions().min_radius);
}

TEST(Gr2ToOptions, iniFileWithUnknownKeysOrContradictionsIsRefused)
{
    const auto complaint = [](const std::string& text) {
        return test::messageOf<std::invalid_argument>([&] { fromIni(text); });
    };
    EXPECT_THAT(complaint("[door]\nmin_with = 0.6\n"), HasSubstr("'door.min_width'"));
    EXPECT_THAT(complaint("[doors]\nmin_width = 0.6\n"), HasSubstr("'door.min_width'"));
    EXPECT_THAT(complaint("[door]\nmin_width = 2\nmax_width = 1\n"), HasSubstr("must exceed"));
}

TEST(Gr2ToOptions, pipelineChecksItsOptions)
{
    Gr2ToOptions options;
    options.door.max_width = 0.4;
    EXPECT_THAT(test::messageOf<std::invalid_argument>([&] { Gr2To pipeline(options); }),
                HasSubstr("door.max_width"));
}
