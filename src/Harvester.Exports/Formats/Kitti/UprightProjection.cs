using Harvester.Geometry;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>The box around a cuboid's projection.</summary>
/// <param name="Box">The box, pixels.</param>
/// <param name="PixelsPerMetre">
/// How far the centre of the box moves when the cuboid moves right and down in the camera's frame: the mean of those of the corners that
/// lie on its sides.
/// </param>
internal readonly record struct UprightProjection(Box2D Box, Vector2D PixelsPerMetre);
