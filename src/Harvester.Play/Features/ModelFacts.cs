using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>The constant properties of a model.</summary>
/// <param name="Class">Its class.</param>
/// <param name="Name">Its name, or its hash as 0xXXXXXXXX.</param>
/// <param name="Min">Rear, left, lower corner in its own frame, metres.</param>
/// <param name="Max">Front, right, upper corner in its own frame, metres.</param>
public sealed record ModelFacts(ObjectClass Class, string Name, Vector3D Min, Vector3D Max);
