using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.People;

/// <summary>A body at one moment, in the model's frame: x right, y forward, z up, metres; the origin is at the hips when upright.</summary>
/// <param name="Skeleton">The joints.</param>
/// <param name="Right">What the right limbs need beyond the joints.</param>
/// <param name="Left">The same of the left.</param>
/// <param name="ChestRight">Unit vector to the right of the shoulders.</param>
/// <param name="ChestForward">Unit vector forward of the shoulders.</param>
/// <param name="FaceForward">Unit vector in which the face looks.</param>
internal sealed record BodyPose(
    Skeleton Skeleton,
    LimbEnds Right,
    LimbEnds Left,
    Vector3D ChestRight,
    Vector3D ChestForward,
    Vector3D FaceForward
);
