using Harvester.Geometry;
using Harvester.Sessions.Faces;

namespace Harvester.Play.Surveys.Faces;

/// <summary>A face or head as measured by rays.</summary>
/// <param name="Min">Rear, left, lower corner in the model's frame, metres.</param>
/// <param name="Max">Front, right, upper corner, metres.</param>
/// <param name="Facing">The direction in which it looks.</param>
/// <param name="IsWholeModel">Whether nothing narrower, such as a post, was found beside it: rays may then hit a mere box around the
/// model.</param>
internal sealed record MeasuredFace(Vector3D Min, Vector3D Max, Facing Facing, bool IsWholeModel);
