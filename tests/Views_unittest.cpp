#include <gmock/gmock.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <cmath>

#include "gr2to/base/files.h"
#include "gr2to/io/CapturedViews.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/simplemap.h"
#include "gr2to/pipeline/Gr2To.h"
#include "support/cli.h"
#include "support/rawlogs.h"

namespace gr2to::test
{
namespace
{
namespace fs = std::filesystem;

mrpt::obs::CObservationImage::Ptr picture(std::uint8_t grey)
{
    auto image = mrpt::obs::CObservationImage::Create();
    image->image.resize(40, 20, mrpt::img::CH_GRAY);
    for (unsigned y = 0; y < 20; ++y)
        for (unsigned x = 0; x < 40; ++x) image->image.at<std::uint8_t>(x, y) = grey;
    image->cameraParams.ncols = 40;
    image->cameraParams.nrows = 20;
    image->cameraParams.setIntrinsicParamsFromValues(20, 20, 20, 10);
    image->cameraPose = mrpt::poses::CPose3D(0.5, 0, 1.2, 0, 0, 0);
    image->timestamp = mrpt::Clock::fromDouble(1.5e9);
    image->sensorLabel = "camera";
    return image;
}

/** The keyframes of roomsGrid()'s two places, each with a picture taken half a metre ahead of it, the robot
 * being turned to the left. */
mrpt::maps::CSimpleMap keyframesWithPictures()
{
    const Extraction extraction = Gr2To().extract(roomsGrid());
    const auto plain = toSimplemap(extraction.map, extraction.grid);
    mrpt::maps::CSimpleMap map;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const auto [pdf, frame] = plain.get(i);
        map.insert(*pdf, *frame);
        auto turned = mrpt::poses::CPose3DPDFGaussian::Create();
        turned->mean = mrpt::poses::CPose3D(pdf->getMeanVal().x(), pdf->getMeanVal().y(), 0, M_PI / 2, 0, 0);
        turned->cov(0, 0) = 0.01;
        turned->cov(1, 1) = 0.02;
        turned->cov(3, 3) = 0.04;  // yaw
        auto pictures = mrpt::obs::CSensoryFrame::Create();
        pictures->insert(picture(static_cast<std::uint8_t>(50 + 100 * i)));
        map.insert(turned, pictures);
    }
    return map;
}
}  // namespace

TEST(Views, haveTheCamerasPoseApertureAndTime)
{
    const auto map = keyframesWithPictures();
    std::size_t missing = 99;
    const auto views = viewsOf(map, ".", missing);
    EXPECT_EQ(missing, 0u);
    ASSERT_EQ(views.size(), 2u);
    const auto robot = std::get<0>(map.get(1))->getMeanVal();
    const View& view = views[0].view;
    EXPECT_NEAR(view.position.mean.x, robot.x(), 1e-9);
    EXPECT_NEAR(view.position.mean.y, robot.y() + 0.5, 1e-9) << "ahead of a robot that looks along y";
    EXPECT_NEAR(view.position.mean.z, 1.2, 1e-9);
    EXPECT_NEAR(view.position.covariance(0, 0), 0.01 + 0.5 * 0.5 * 0.04, 1e-9)
        << "and its yaw's, by the lever";
    EXPECT_NEAR(view.position.covariance(1, 1), 0.02, 1e-9);
    EXPECT_NEAR(view.apertureX_rad, M_PI / 2, 1e-9);
    EXPECT_NEAR(view.apertureY_rad, 2 * std::atan(0.5), 1e-9);
    EXPECT_EQ(view.time_s, 1.5e9);
    EXPECT_EQ(views[0].ending, ".png");
    EXPECT_THAT(views[0].bytes, testing::StartsWith("\x89PNG"));
    EXPECT_NE(views[0].bytes, views[1].bytes);
}

TEST(Views, imagesOutsideOfTheFileAreTakenAsTheyAre)
{
    const TempFolder folder;
    folder.write("there.jpg", "a picture");
    mrpt::maps::CSimpleMap map;
    for (const char* name : {"there.jpg", "missing.jpg"}) {
        auto image = mrpt::obs::CObservationImage::Create();
        image->image.setExternalStorage(name);
        mrpt::obs::CSensoryFrame frame;
        frame.insert(image);
        map.insert(mrpt::poses::CPose3DPDFGaussian(), frame);
    }
    std::size_t missing = 0;
    const auto views = viewsOf(map, folder.path(), missing);
    ASSERT_EQ(views.size(), 1u);
    EXPECT_EQ(missing, 1u);
    EXPECT_EQ(views[0].bytes, "a picture");
    EXPECT_EQ(views[0].ending, ".jpg");
    EXPECT_EQ(views[0].view.apertureX_rad, 0) << "no focal length is stated";
}

TEST(Views, extractGivesEachPlaceThoseTakenInsideIt)
{
    const TempFolder folder;
    folder.write("a.simplemap", encodeSimplemap(keyframesWithPictures()));
    const CliRun run = runCli(folder.path(), {"extract", "a.simplemap", "--resolution", "0.1", "-o", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const TopologicalMap map = readXml(folder.path() / "out/topomap.xml");
    EXPECT_TRUE(map.validate().empty());
    ASSERT_EQ(map.places().size(), 2u);
    for (const auto& [id, place] : map.places()) {
        ASSERT_EQ(place.views.size(), 1u);
        EXPECT_EQ(place.views[0].image, "views/" + std::to_string(id) + "_0.png");
        EXPECT_THAT(readFile(folder.path() / "out" / place.views[0].image), testing::StartsWith("\x89PNG"));
        EXPECT_LT(std::hypot(place.views[0].position.mean.x - place.center.x,
                             place.views[0].position.mean.y - place.center.y),
                  2.0);
    }
    ASSERT_EQ(runCli(folder.path(),
                     {"extract", "a.simplemap", "--resolution", "0.1", "-o", "none", "--scans-views", "no"})
                  .code,
              0);
    EXPECT_FALSE(fs::exists(folder.path() / "none/views"));
    mrpt::maps::CSimpleMap again;
    ASSERT_TRUE(again.loadFromFile((folder.path() / "out/topomap.simplemap").string()));
    std::size_t missing = 0;
    EXPECT_EQ(viewsOf(again, folder.path() / "out", missing).size(), 2u) << "the keyframes have them too";
}

TEST(Views, imagesOfARawlogComeAlong)
{
#ifndef GR2TO_RAWLOG
    GTEST_SKIP() << "gr2to-rawlog is not built: MRPT's SLAM library (package libmrpt-slam-dev) is missing";
#endif
    const TempFolder folder;
    const auto image = picture(128);
    image->timestamp = mrpt::Clock::fromDouble(1e9 + 100);
    folder.write("walk.rawlog", walkThroughRooms(20) + archiveOf({image.get()}));
    const CliRun run = runCli(folder.path(), {"extract", "walk.rawlog"});
    ASSERT_EQ(run.code, 0) << run.err;
    std::size_t views = 0;
    const TopologicalMap map = readXml(folder.path() / "walk/topomap.xml");
    for (const auto& [id, place] : map.places())
        for (const View& view : place.views) {
            ++views;
            EXPECT_NEAR(view.position.mean.x, 19 * 0.2 + 0.5, 0.3) << "where the walk ended";
            EXPECT_EQ(view.time_s, 1e9 + 100);
        }
    EXPECT_EQ(views, 1u);
}
}  // namespace gr2to::test
