using Harvester.Geometry;
using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Rigs;

/// <summary>A camera of a rig.</summary>
/// <param name="Name">Its name, which is that of its view.</param>
/// <param name="Mount">Its pose relative to the rig's origin, in the vehicle's axes: x right, y forward, z up; metres.</param>
/// <param name="VerticalFovDegrees">Vertical field of view without the lens, degrees, 1 to 170.</param>
/// <param name="Image">Size of its images, pixels.</param>
/// <param name="Lens">Its lens.</param>
public sealed record RigCamera(string Name, Pose Mount, double VerticalFovDegrees, ImageSize Image, Lens Lens);
