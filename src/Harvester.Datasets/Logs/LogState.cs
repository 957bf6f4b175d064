using Harvester.Geometry;

namespace Harvester.Datasets.Logs;

/// <summary>A thing of a log at one step: its box, which is upright, and its velocity.</summary>
/// <param name="Centre">Centre of the box, metres, world.</param>
/// <param name="Length">Size along its heading, metres.</param>
/// <param name="Width">Size across, metres.</param>
/// <param name="Height">Size upwards, metres.</param>
/// <param name="Heading">Direction of its front on the ground, radians counter-clockwise from the x axis, -π to π.</param>
/// <param name="Velocity">On the ground, metres per second, world.</param>
internal readonly record struct LogState(Vector3D Centre, double Length, double Width, double Height, double Heading, Vector2D Velocity)
{
    /// <summary>The state between two others: positions and sizes linearly, the heading over the smaller angle.</summary>
    /// <param name="before">The earlier state.</param>
    /// <param name="after">The later state.</param>
    /// <param name="part">0 for the earlier one to 1 for the later one.</param>
    public static LogState Between(LogState before, LogState after, double part)
    {
        double Mix(double from, double to) => from + ((to - from) * part);
        double turn = Math.IEEERemainder(after.Heading - before.Heading, 2 * Math.PI);
        return new LogState(
            before.Centre + ((after.Centre - before.Centre) * part),
            Mix(before.Length, after.Length),
            Mix(before.Width, after.Width),
            Mix(before.Height, after.Height),
            Math.IEEERemainder(before.Heading + (turn * part), 2 * Math.PI),
            new Vector2D(Mix(before.Velocity.X, after.Velocity.X), Mix(before.Velocity.Y, after.Velocity.Y))
        );
    }
}
