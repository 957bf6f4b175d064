namespace Harvester.Geometry.Motion;

/// <summary>The motion of a body between the moments of two pictures.</summary>
/// <param name="Kind">How it moves.</param>
/// <param name="From">Its pose in the world at the moment of the pixel's picture; for rigid bodies only.</param>
/// <param name="To">Its pose in the world at the moment of the other picture; for rigid bodies only.</param>
public readonly record struct BodyMotion(BodyMotionKind Kind, Pose From = default, Pose To = default)
{
    /// <summary>A body that stands still in the world.</summary>
    public static BodyMotion Static => default;

    /// <summary>A body that is rigid.</summary>
    public static BodyMotion Rigid(Pose from, Pose to) => new(BodyMotionKind.Rigid, from, to);
}
