using Harvester.Geometry;

namespace Harvester.Simulation.People;

/// <summary>Where the limbs of one side end, in the model's frame, metres.</summary>
/// <param name="FingerTips">The tips of the fingers.</param>
/// <param name="FootForward">Unit vector from the heel to the toes.</param>
internal readonly record struct LimbEnds(Vector3D FingerTips, Vector3D FootForward);
