using Harvester.Geometry;

namespace Harvester.Play.Surveys.Faces;

/// <summary>A model on the stage.</summary>
/// <param name="Handle">The entity's handle.</param>
/// <param name="Pose">Position of the model's origin (metres, world) and orientation.</param>
/// <param name="Min">Rear, left, lower corner of the model's box in its own frame, metres.</param>
/// <param name="Max">Front, right, upper corner, metres.</param>
/// <param name="Heads">Positions of the bones traffic_light_0, traffic_light_1 and so on, in the model's frame, metres; empty for a
/// sign.</param>
public sealed record StagedModel(int Handle, Pose Pose, Vector3D Min, Vector3D Max, IReadOnlyList<Vector3D> Heads);
