#include "gr2to/io/CapturedViews.h"

#include <mrpt/img/CImage.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <unistd.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/base/interruption.h"

namespace gr2to
{
namespace fs = std::filesystem;

namespace
{
/** What an observation says about its image, whatever its class. */
struct Shot
{
    const mrpt::img::CImage* image = nullptr;
    const mrpt::img::TCamera* camera = nullptr;
    mrpt::poses::CPose3D pose;  //!< of the camera on the robot
};

std::optional<Shot> shotOf(const mrpt::obs::CObservation& observation)
{
    if (const auto* plain = dynamic_cast<const mrpt::obs::CObservationImage*>(&observation))
        return Shot{&plain->image, &plain->cameraParams, plain->cameraPose};
    const auto* depth = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&observation);
    if (depth == nullptr || !depth->hasIntensityImage) return {};
    return Shot{&depth->intensityImage, &depth->cameraParamsIntensity, depth->sensorPose};
}

/** The bytes of an image as PNG; MRPT writes images to files only. */
std::string encoded(const mrpt::img::CImage& image)
{
    std::string name = (fs::temp_directory_path() / "gr2to-XXXXXX.png").string();
    const int file = ::mkstemps(name.data(), 4);
    if (file < 0) throw OutputError("cannot make a temporary file '" + name + "'");
    ::close(file);
    const UnfinishedOutput whenStopped(name);
    const bool done = image.saveToFile(name);
    std::string bytes = done ? readFile(name) : "";
    fs::remove(name);
    if (!done) throw OutputError("cannot write a temporary image '" + name + "'");
    return bytes;
}

bool readImage(const mrpt::img::CImage& image, const fs::path& folder, CapturedView& captured)
{
    if (!image.isExternallyStored()) {
        captured.bytes = encoded(image);
        captured.ending = ".png";
        return true;
    }
    const fs::path file = folder / image.getExternalStorageFile();
    try {
        captured.bytes = readFile(file);
    } catch (const InputError&) {
        return false;
    }
    captured.ending = file.extension().string();
    return true;
}

/** Exactly symmetric and without the negative eigenvalues that rounding leaves. */
mrpt::math::CMatrixDouble33 soundCovariance(const mrpt::math::CMatrixDouble66& covariance)
{
    Eigen::Matrix3d block;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            block(row, column) = (covariance(row, column) + covariance(column, row)) / 2;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(block);
    if (solver.eigenvalues().minCoeff() < 0)
        block = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
                solver.eigenvectors().transpose();
    mrpt::math::CMatrixDouble33 sound;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            sound(row, column) = block(std::max(row, column), std::min(row, column));
    return sound;
}

double aperture(double pixels, double focalLength_px)
{
    return focalLength_px > 0 && pixels > 0 ? 2 * std::atan(pixels / 2 / focalLength_px) : 0;
}

void describe(const Shot& shot, const mrpt::poses::CPose3DPDF& robot, View& view)
{
    mrpt::poses::CPose3DPDFGaussian at;
    at.copyFrom(robot);
    at += mrpt::poses::CPose3DPDFGaussian(shot.pose);
    view.position.mean = at.mean.translation();
    view.position.covariance = soundCovariance(at.cov);
    view.apertureX_rad = aperture(shot.camera->ncols, shot.camera->fx());
    view.apertureY_rad = aperture(shot.camera->nrows, shot.camera->fy());
}
}  // namespace

std::vector<CapturedView> viewsOf(const mrpt::maps::CSimpleMap& map, const fs::path& folder,
                                  std::size_t& missing)
{
    std::vector<CapturedView> views;
    missing = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        const auto [pose, frame] = map.get(i);
        for (const auto& observation : *frame) {
            const auto shot = shotOf(*observation);
            if (!shot) continue;
            CapturedView captured;
            if (!readImage(*shot->image, folder, captured)) {
                ++missing;
                continue;
            }
            describe(*shot, *pose, captured.view);
            if (observation->timestamp != INVALID_TIMESTAMP)
                captured.view.time_s = mrpt::Clock::toDouble(observation->timestamp);
            views.push_back(std::move(captured));
        }
    }
    return views;
}
}  // namespace gr2to
