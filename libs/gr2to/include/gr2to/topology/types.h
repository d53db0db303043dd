#pragma once

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gr2to/grid/PlaceImage.h"

namespace gr2to
{
/** A position in the map frame [m] with its covariance [m^2]. */
struct UncertainPoint
{
    mrpt::math::TPoint3D mean{0, 0, 0};
    mrpt::math::CMatrixDouble33 covariance;  //!< zero when default-constructed
};

/** A direction of unit length in the map frame with its covariance (in the tangent plane). */
struct UncertainNormal
{
    mrpt::math::TPoint3D mean{1, 0, 0};
    mrpt::math::CMatrixDouble33 covariance;
};

/** Length and height [m] of an upright plane with their covariance [m^2]; a height that was not measured is
 * absent. */
struct PlaneSize
{
    double length_m = 0.0;
    std::optional<double> height_m;
    /** [ll lh; lh hh]; the entries of an absent height are zero. */
    mrpt::math::CMatrixDouble22 covariance;
};

/** Delimitation of a place: w = (X, V, L, S, e), eq. (3) of the paper. */
struct Wall
{
    std::uint32_t id = 0;        //!< unique in the map, from 1
    UncertainPoint position;     //!< X: centre of mass
    UncertainNormal normal;      //!< V: unit normal, pointing out of the place
    PlaneSize size;              //!< L
    double curvatureLength = 0;  //!< S: curvature along the length [1/m], 0 is flat
    double curvatureHeight = 0;  //!< S: curvature along the height [1/m], 0 is flat
    bool real = false;           //!< e: true for a brick wall, false for a virtual one
};

/** Visual appearance from one position: v = (J, X, La, t), eq. (4). */
struct View
{
    std::string image;         //!< J: path of the image file, relative to the map's file
    UncertainPoint position;   //!< X: centre of acquisition
    double apertureX_rad = 0;  //!< La: horizontal angular aperture
    double apertureY_rad = 0;  //!< La: vertical angular aperture
    double time_s = 0;         //!< t: seconds since 1970-01-01 UTC
};

/** What a person would call the place; other kinds may come. */
enum class PlaceKind : std::uint8_t
{
    Room = 0,
    Corridor = 1
};

/** A vertex of the map: p = {SP, W, V, A_r, X_c}, eq. (2). */
struct Place
{
    PlaceId id = 0;  //!< unique, from 1; the value of its cells in `places.png`
    PlaceKind kind = PlaceKind::Room;
    std::vector<std::string> words;        //!< SP
    std::vector<Wall> walls;               //!< W, in the order of the boundary
    std::vector<View> views;               //!< V
    double area_m2 = 0;                    //!< A_r: area of its free cells
    mrpt::math::TPoint3D center{0, 0, 0};  //!< X_c
    std::vector<mrpt::math::TPoint2D>
        boundary;  //!< simple polygon [m], counter-clockwise, not repeating its first vertex
};

/** o of eq. (6): the last state seen. */
enum class DoorState : std::uint8_t
{
    Unknown = 0,
    Open = 1,
    Closed = 2
};

/** D = (X, Ld, e, o, I), eq. (6). */
struct Doorway
{
    UncertainPoint position;               //!< X: centre of mass
    PlaneSize size;                        //!< Ld: length is the clear width between the jambs
    bool real = false;                     //!< e: true for a door, false for a virtual opening
    DoorState state = DoorState::Unknown;  //!< o
    std::optional<View> view;              //!< I
};

/** An edge of the map: {SD, D}, eq. (5). Several may join the same two places. */
struct Connection
{
    std::uint32_t id = 0;            //!< unique in the map, from 1
    PlaceId from = 0;                //!< the smaller place id
    PlaceId to = 0;                  //!< the larger place id
    std::vector<std::string> words;  //!< SD
    Doorway doorway;                 //!< D
};

bool operator==(const Wall& a, const Wall& b);
bool operator==(const View& a, const View& b);
bool operator==(const Place& a, const Place& b);
bool operator==(const Doorway& a, const Doorway& b);
bool operator==(const Connection& a, const Connection& b);
}  // namespace gr2to
