using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>A scripted camera of the test game.</summary>
internal sealed class GameCamera
{
    public required float VerticalFovDegrees { get; init; }

    /// <summary>Its pose while it is not attached.</summary>
    public required Pose Pose { get; init; }

    public bool IsActive { get; set; }

    public int AttachedTo { get; set; }

    public Vector3D Offset { get; set; }
}
