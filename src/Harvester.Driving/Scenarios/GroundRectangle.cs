using Harvester.Geometry;

namespace Harvester.Driving.Scenarios;

/// <summary>The rectangle that a body covers on the ground.</summary>
/// <param name="Middle">Metres, world.</param>
/// <param name="Forward">Unit vector of its length.</param>
/// <param name="HalfLength">Metres.</param>
/// <param name="HalfWidth">Metres.</param>
internal readonly record struct GroundRectangle(Vector2D Middle, Vector2D Forward, double HalfLength, double HalfWidth)
{
    /// <summary>The rectangle of a body around its origin.</summary>
    public static GroundRectangle Of(Pose pose, double halfLength, double halfWidth)
    {
        Vector3D forward = new Vector3D(pose.Axes.Forward.X, pose.Axes.Forward.Y, 0).Normalized();
        return new(new Vector2D(pose.Position.X, pose.Position.Y), new Vector2D(forward.X, forward.Y), halfLength, halfWidth);
    }

    /// <summary>The rectangle with more room on every side.</summary>
    public GroundRectangle Grown(double margin) => this with { HalfLength = HalfLength + margin, HalfWidth = HalfWidth + margin };

    /// <summary>Whether two rectangles overlap: no direction of their sides separates them.</summary>
    public bool Overlaps(GroundRectangle other)
    {
        GroundRectangle self = this;
        Vector2D apart = other.Middle - Middle;
        return new[] { Forward, Left(Forward), other.Forward, Left(other.Forward) }.All(axis =>
            Math.Abs(apart.Dot(axis)) <= self.Reach(axis) + other.Reach(axis)
        );
    }

    private static Vector2D Left(Vector2D forward) => new(-forward.Y, forward.X);

    private double Reach(Vector2D axis) => (HalfLength * Math.Abs(Forward.Dot(axis))) + (HalfWidth * Math.Abs(Forward.Cross(axis)));
}
