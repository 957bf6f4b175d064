using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>What never changes about a model.</summary>
/// <param name="Class">What kind of thing it is.</param>
/// <param name="Name">Its name, or its hash as 0xXXXXXXXX.</param>
/// <param name="Min">Rear, left, lower corner in its own frame, metres.</param>
/// <param name="Max">Front, right, upper corner in its own frame, metres.</param>
public sealed record ModelFacts(ObjectClass Class, string Name, Vector3D Min, Vector3D Max);
