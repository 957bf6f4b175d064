using Harvester.Geometry;

namespace Harvester.Capture.Events;

/// <summary>A road user at one reading.</summary>
/// <param name="Seconds">The game's time, seconds.</param>
/// <param name="Pose">Position of the model's origin and orientation, metres, world.</param>
/// <param name="Box">Its footprint.</param>
/// <param name="Velocity">Metres per second, world.</param>
/// <param name="YawRate">Turning rate, rad/s, positive to the left; 0 for people, whose facing does not steer them.</param>
internal sealed record UserReading(double Seconds, Pose Pose, BodyBox Box, Vector3D Velocity, double YawRate)
{
    /// <summary>Horizontal velocity, m/s.</summary>
    public Vector2D Ground => new(Velocity.X, Velocity.Y);

    /// <summary>Horizontal speed, m/s.</summary>
    public double Speed => Ground.Length;

    /// <summary>Middle of its footprint, at its lowest height, metres, world.</summary>
    public Vector3D Foot => new(Box.Centre.X, Box.Centre.Y, Box.Bottom);

    /// <summary>How its footprint goes on.</summary>
    public GroundMotion Motion => new(Box, new Vector2D(Pose.Position.X, Pose.Position.Y), Ground, YawRate);
}
