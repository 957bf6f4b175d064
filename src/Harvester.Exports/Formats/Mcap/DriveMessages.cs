using Google.Protobuf;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// The messages of a recorded drive: the action that answered a frame, at the time of the frame, and each tick up to the next frame, at its
/// own time. Directions are those of the ego: x forward, y left, z up.
/// </summary>
internal static class DriveMessages
{
    /// <summary>The messages of an action, in order of their channels.</summary>
    /// <param name="drive">The action.</param>
    /// <param name="nanoseconds">Time of its frame.</param>
    /// <param name="timeOf">Turns the time of a tick, seconds, into nanoseconds.</param>
    public static IEnumerable<McapMessage> Of(DriveLabel drive, long nanoseconds, Func<double, long> timeOf)
    {
        yield return new McapMessage(McapChannel.Action, Action(drive, nanoseconds));
        if (drive.Indicators is { } indicators)
        {
            yield return new McapMessage(
                McapChannel.AnsweredIndicators,
                IndicatorMessage.Of(indicators, drive.SpeedMetresPerSecond, nanoseconds)
            );
        }

        foreach (DriveTick tick in drive.Ticks)
        {
            long time = timeOf(tick.TimeSeconds);
            yield return new McapMessage(McapChannel.Tick, Tick(tick, time)) { Nanoseconds = time };
        }

        foreach (DriveTick tick in drive.Ticks)
        {
            if (tick is { Acceleration: { } acceleration, AngularRate: { } rate })
            {
                long time = timeOf(tick.TimeSeconds);
                yield return new McapMessage(McapChannel.Imu, Imu(acceleration, rate, time)) { Nanoseconds = time };
            }
        }
    }

    private static byte[] Action(DriveLabel drive, long nanoseconds)
    {
        var message = new Gtaharvest.DriveAction
        {
            Timestamp = MessageTime.Of(nanoseconds),
            Driver = JsonName.Of(drive.Driver),
            Controls = Controls(drive.Controls),
            Applied = Controls(drive.Applied),
            Disturbed = drive.IsDisturbed,
            Route = drive.Route ?? "",
            Speed = drive.SpeedMetresPerSecond,
        };

        // Assigned where they are known: what is absent differs from 0.
        if (drive.AnswerSeconds is { } answer)
        {
            message.AnswerSeconds = answer;
        }

        if (drive.RouteMetres is { } route)
        {
            message.RouteMetres = route;
        }

        if (drive.Target?.SpeedMetresPerSecond is { } speed)
        {
            message.TargetSpeed = speed;
        }

        if (drive.Target?.RightMetres is { } right)
        {
            message.TargetLeft = -right;
        }

        return message.ToByteArray();
    }

    private static byte[] Tick(DriveTick tick, long nanoseconds) =>
        new Gtaharvest.DriveTick
        {
            Timestamp = MessageTime.Of(nanoseconds),
            Driver = JsonName.Of(tick.Driver),
            Speed = tick.SpeedMetresPerSecond,
            Applied = Controls(tick.Applied),
        }.ToByteArray();

    private static byte[] Imu(Vector3D acceleration, Vector3D rate, long nanoseconds) =>
        new Gtaharvest.Imu
        {
            Timestamp = MessageTime.Of(nanoseconds),
            FrameId = FoxgloveMessages.Ego,
            AngularVelocity = Vector(rate),
            LinearAcceleration = Vector(acceleration),
        }.ToByteArray();

    /// <summary>A vector along the car's right, forward and up, as x forward, y left, z up.</summary>
    private static Foxglove.Vector3 Vector(Vector3D ofCar) =>
        new()
        {
            X = ofCar.Y,
            Y = -ofCar.X,
            Z = ofCar.Z,
        };

    private static Gtaharvest.DriveControls? Controls(DriveControls? controls) =>
        controls is { } set
            ? new()
            {
                Steering = set.Steering,
                Throttle = set.Throttle,
                Brake = set.Brake,
            }
            : null;
}
