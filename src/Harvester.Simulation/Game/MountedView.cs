using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>What the camera of the simulated game is set to.</summary>
/// <param name="Mount">Its pose on the car.</param>
/// <param name="VerticalFovDegrees">Vertical field of view, degrees.</param>
/// <param name="Aspect">Width divided by height of its picture.</param>
/// <param name="Lens">The distortion of its lens.</param>
internal sealed record MountedView(Pose Mount, double VerticalFovDegrees, double Aspect, RenderLens Lens);
