using Google.Protobuf.Reflection;
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
    public const string ActionSchema = OwnSchema.Package + ".DriveAction";
    public const string TickSchema = OwnSchema.Package + ".DriveTick";
    public const string ImuSchema = OwnSchema.Package + ".Imu";

    private const string ControlsSchema = OwnSchema.Package + ".DriveControls";
    private const string VectorSchema = "foxglove.Vector3";

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

    /// <summary>The schemas.</summary>
    public static FileDescriptorProto[] Describe() =>
        [
            OwnSchema.File(ControlsSchema, OwnSchema.Number("steering", 1), OwnSchema.Number("throttle", 2), OwnSchema.Number("brake", 3)),
            OwnSchema.File(
                ActionSchema,
                OwnSchema.Time(1),
                OwnSchema.Text("driver", 2),
                OwnSchema.Message("controls", 3, ControlsSchema),
                OwnSchema.OptionalNumber("answer_seconds", 4),
                OwnSchema.Message("applied", 5, ControlsSchema),
                OwnSchema.Boolean("disturbed", 6),
                OwnSchema.Text("route", 7),
                OwnSchema.OptionalNumber("route_metres", 8),
                OwnSchema.Number("speed", 9),
                OwnSchema.OptionalNumber("target_speed", 10),
                OwnSchema.OptionalNumber("target_left", 11)
            ),
            OwnSchema.File(
                TickSchema,
                OwnSchema.Time(1),
                OwnSchema.Text("driver", 2),
                OwnSchema.Number("speed", 3),
                OwnSchema.Message("applied", 4, ControlsSchema)
            ),
            OwnSchema.File(
                ImuSchema,
                OwnSchema.Time(1),
                OwnSchema.Text("frame_id", 2),
                OwnSchema.Message("angular_velocity", 3, VectorSchema),
                OwnSchema.Message("linear_acceleration", 4, VectorSchema)
            ),
        ];

    private static byte[] Action(DriveLabel drive, long nanoseconds) =>
        ProtoMessage.Of(message =>
        {
            FoxgloveMessages.Time(message, 1, nanoseconds);
            message.Text(2, JsonName.Of(drive.Driver));
            Controls(message, 3, drive.Controls);
            Optional(message, 4, drive.AnswerSeconds);
            Controls(message, 5, drive.Applied);
            message.Integer(6, drive.IsDisturbed ? 1 : 0).Text(7, drive.Route ?? "");
            Optional(message, 8, drive.RouteMetres);
            message.Number(9, drive.SpeedMetresPerSecond);
            Optional(message, 10, drive.Target?.SpeedMetresPerSecond);
            Optional(message, 11, -drive.Target?.RightMetres);
        });

    private static byte[] Tick(DriveTick tick, long nanoseconds) =>
        ProtoMessage.Of(message =>
        {
            FoxgloveMessages.Time(message, 1, nanoseconds);
            message.Text(2, JsonName.Of(tick.Driver)).Number(3, tick.SpeedMetresPerSecond);
            Controls(message, 4, tick.Applied);
        });

    private static byte[] Imu(Vector3D acceleration, Vector3D rate, long nanoseconds) =>
        ProtoMessage.Of(message =>
        {
            FoxgloveMessages.Time(message, 1, nanoseconds);
            message.Text(2, FoxgloveMessages.Ego);
            Vector(message, 3, rate);
            Vector(message, 4, acceleration);
        });

    /// <summary>A vector along the car's right, forward and up, as x forward, y left, z up.</summary>
    private static void Vector(ProtoMessage message, int field, Vector3D ofCar) =>
        message.Message(field, vector => vector.Number(1, ofCar.Y).Number(2, -ofCar.X).Number(3, ofCar.Z));

    private static void Controls(ProtoMessage message, int field, DriveControls? controls)
    {
        if (controls is { } set)
        {
            message.Message(field, inner => inner.Number(1, set.Steering).Number(2, set.Throttle).Number(3, set.Brake));
        }
    }

    private static void Optional(ProtoMessage message, int field, double? number)
    {
        if (number is { } known)
        {
            message.NumberOrZero(field, known);
        }
    }
}
