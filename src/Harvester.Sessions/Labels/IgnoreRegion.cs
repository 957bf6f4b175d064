using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>
/// A region of an image that shows, or may show, an object without a label. A detection there is neither right nor wrong, and detectors
/// should not learn from it.
/// </summary>
/// <param name="Reason">Why the object has no label.</param>
/// <param name="Class">The class of the object.</param>
/// <param name="Box2D">The box around its cuboid's part inside the image, pixels.</param>
/// <param name="DistanceMetres">Distance from the camera's position to the cuboid's centre, metres.</param>
public sealed record IgnoreRegion(IgnoreReason Reason, ObjectClass Class, Box2D Box2D, double DistanceMetres);
