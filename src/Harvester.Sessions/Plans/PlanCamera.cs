using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Plans;

/// <summary>A camera of a plan: a single one, or the file of a rig.</summary>
/// <param name="Name">Its name within the plan.</param>
/// <param name="Image">Size of the images, pixels; of no meaning with a rig.</param>
/// <param name="VerticalFovDegrees">Vertical field of view, degrees; of no meaning with a rig.</param>
/// <param name="RigFile">Path of a rig file relative to the plan's folder, with forward slashes; null for a single camera.</param>
public sealed record PlanCamera(string Name, ImageSize Image, double VerticalFovDegrees, string? RigFile);
