using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>A scripted camera of the test game.</summary>
internal sealed class GameCamera
{
    public required float VerticalFovDegrees { get; set; }

    /// <summary>Its pose while it is not attached.</summary>
    public required Pose Pose { get; init; }

    public bool IsActive { get; set; }

    public int AttachedTo { get; set; }

    public Vector3D Offset { get; set; }

    /// <summary>Its orientation in the frame of what it is attached to.</summary>
    public Axes Turn { get; set; } = Axes.Identity;
}
