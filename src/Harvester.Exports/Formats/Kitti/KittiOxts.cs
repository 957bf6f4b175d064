using Harvester.Geometry;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>The 30 values of KITTI's inertial and navigation unit at a frame, which stands for one at the model's origin.</summary>
internal static class KittiOxts
{
    private const double EarthRadius = 6_378_137;
    private const double Gravity = 9.81;
    private const double DegreesPerRadian = 180 / Math.PI;
    private const int DegreeDecimals = 12;
    private const int Decimals = 9;

    /// <summary>What the unit reports of its reception: 4 of the position's modes is a good one, of 10 satellites.</summary>
    private const string Reception = "4 10 4 4 0";

    /// <summary>The line of a frame.</summary>
    public static string Line(ExportFrame frame)
    {
        IReadOnlyList<EgoReading> track = EgoTrack.Of(EgoTrack.SamplesOf(frame.Label));
        EgoReading now = track[^1];
        Axes body = now.Pose.Axes;
        Vector3D place = now.Pose.Position;
        Vector3D velocity = frame.Label.Ego.Velocity;

        // The accelerometer feels gravity too. The unit's level axes are those of the heading.
        Vector3D felt = now.Acceleration + EgoTrack.InBody(body, new Vector3D(0, 0, Gravity));
        var level = Axes.FromHeading(Angles.HeadingDegrees(body.Forward));
        Vector3D levelAcceleration = EgoTrack.InBody(level, OutOfBody(body, felt));
        Vector3D levelRate = EgoTrack.InBody(level, OutOfBody(body, now.RotationRate));

        // R = Rz(yaw) Ry(pitch) Rx(roll) from forward, left, up to east, north, up.
        double yaw = Math.Atan2(body.Forward.Y, body.Forward.X);
        double pitch = -Math.Asin(Math.Clamp(body.Forward.Z, -1, 1));
        double roll = Math.Atan2(-body.Right.Z, body.Up.Z);
        Vector3D levelVelocity = EgoTrack.InBody(level, velocity);
        return string.Join(
            ' ',
            Numbers.Row(DegreeDecimals, Latitude(place.Y), place.X / EarthRadius * DegreesPerRadian),
            Numbers.Row(
                Decimals,
                [
                    place.Z,
                    roll,
                    pitch,
                    yaw,
                    velocity.Y,
                    velocity.X,
                    levelVelocity.X,
                    levelVelocity.Y,
                    levelVelocity.Z,
                    .. Of(felt),
                    .. Of(levelAcceleration),
                    .. Of(now.RotationRate),
                    .. Of(levelRate),
                    0,
                    0,
                ]
            ),
            Reception
        );
    }

    /// <summary>The latitude whose Mercator projection is so far north of the equator.</summary>
    private static double Latitude(double north) => ((2 * Math.Atan(Math.Exp(north / EarthRadius))) - (Math.PI / 2)) * DegreesPerRadian;

    private static Vector3D OutOfBody(Axes body, Vector3D vector) => body.ToWorld(new Vector3D(-vector.Y, vector.X, vector.Z));

    private static double[] Of(Vector3D vector) => [vector.X, vector.Y, vector.Z];
}
