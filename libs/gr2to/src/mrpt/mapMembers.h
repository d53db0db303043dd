#pragma once

#include "gr2to/topology/types.h"

/** The members of each type in the order of the archive, for reading and writing alike, so that the two
 * cannot drift apart. An archive is callable with a number, a flag or text, and has `enumerator`, `list` and
 * `optional`. Changing anything here needs a new MAP_ARCHIVE_VERSION.
 */
namespace gr2to::archived
{
template <class Archive, class T>
void point3D(Archive& archive, T& point)
{
    archive(point.x);
    archive(point.y);
    archive(point.z);
}

template <class Archive, class Matrix>
void matrix(Archive& archive, Matrix& entries)
{
    for (int row = 0; row < entries.rows(); ++row)
        for (int column = 0; column < entries.cols(); ++column) archive(entries(row, column));
}

/** For UncertainPoint and UncertainNormal. */
template <class Archive, class T>
void uncertain(Archive& archive, T& value)
{
    point3D(archive, value.mean);
    matrix(archive, value.covariance);
}

template <class Archive, class T>
void size(Archive& archive, T& value)
{
    archive(value.length_m);
    archive.optional(value.height_m, [&](auto& height) { archive(height); });
    matrix(archive, value.covariance);
}

template <class Archive, class T>
void wall(Archive& archive, T& value)
{
    archive(value.id);
    uncertain(archive, value.position);
    uncertain(archive, value.normal);
    size(archive, value.size);
    archive(value.curvatureLength);
    archive(value.curvatureHeight);
    archive(value.real);
}

template <class Archive, class T>
void view(Archive& archive, T& value)
{
    archive(value.image);
    uncertain(archive, value.position);
    archive(value.apertureX_rad);
    archive(value.apertureY_rad);
    archive(value.time_s);
}

template <class Archive, class T>
void words(Archive& archive, T& values)
{
    archive.list(values, [&](auto& word) { archive(word); });
}

template <class Archive, class T>
void place(Archive& archive, T& value)
{
    archive(value.id);
    archive.enumerator(value.kind, PlaceKind::Corridor);
    words(archive, value.words);
    archive.list(value.walls, [&](auto& one) { wall(archive, one); });
    archive.list(value.views, [&](auto& one) { view(archive, one); });
    archive(value.area_m2);
    point3D(archive, value.center);
    archive.list(value.boundary, [&](auto& vertex) {
        archive(vertex.x);
        archive(vertex.y);
    });
}

template <class Archive, class T>
void connection(Archive& archive, T& value)
{
    archive(value.id);
    archive(value.from);
    archive(value.to);
    words(archive, value.words);
    auto& doorway = value.doorway;
    uncertain(archive, doorway.position);
    size(archive, doorway.size);
    archive(doorway.real);
    archive.enumerator(doorway.state, DoorState::Closed);
    archive.optional(doorway.view, [&](auto& one) { view(archive, one); });
}
}  // namespace gr2to::archived
