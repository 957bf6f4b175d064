namespace Harvester.Simulation.Rendering;

/// <summary>A linear function X·x + Y·y + W over an image.</summary>
internal readonly record struct ScreenLine(double X, double Y, double W)
{
    /// <summary>Zero on the line through two points, positive to the right of the way from one to the other on the screen.</summary>
    public ScreenLine(in Vector4 from, in Vector4 to)
        : this(from.Y - to.Y, to.X - from.X, (from.X * to.Y) - (from.Y * to.X))
    {
    }

    public double At(double x, double y) => (X * x) + (Y * y) + W;
}
