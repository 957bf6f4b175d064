using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>A scripted camera of the test game.</summary>
internal sealed class GameCamera
{
    public required float VerticalFovDegrees { get; init; }

    /// <summary>Where it stands as long as it is attached to nothing.</summary>
    public required Pose Pose { get; init; }

    public bool IsActive { get; set; }

    public int AttachedTo { get; set; }

    public Vector3D Offset { get; set; }
}
