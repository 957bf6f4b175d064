using Google.Protobuf.Reflection;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// The message of the lane indicators: the time, the 13 values in the order of <see cref="IndicatorTable"/>, and the car's speed. A value
/// that is not active is absent.
/// </summary>
internal static class IndicatorMessage
{
    public const string SchemaName = OwnSchema.Package + ".LaneIndicators";

    private const int TimestampField = 1;
    private const int FirstIndicatorField = 2;

    private static int SpeedField => FirstIndicatorField + IndicatorTable.Count;

    /// <summary>Writes the message.</summary>
    public static byte[] Of(FrameLabel label, LanesLabel lanes, long nanoseconds) =>
        ProtoMessage.Of(message =>
        {
            FoxgloveMessages.Time(message, TimestampField, nanoseconds);
            for (int i = 0; i < IndicatorTable.Count; i++)
            {
                if (IndicatorTable.All[i].Of(lanes.Indicators) is { IsValid: true } indicator)
                {
                    message.NumberOrZero(FirstIndicatorField + i, indicator.Value);
                }
            }

            message.Number(SpeedField, label.Ego.Velocity.Length);
        });

    /// <summary>Writes the indicators by which a driver answered, all of them, as it had them.</summary>
    public static byte[] Of(IReadOnlyList<double> answered, double speed, long nanoseconds) =>
        ProtoMessage.Of(message =>
        {
            FoxgloveMessages.Time(message, TimestampField, nanoseconds);
            for (int i = 0; i < answered.Count; i++)
            {
                message.NumberOrZero(FirstIndicatorField + i, answered[i]);
            }

            message.Number(SpeedField, speed);
        });

    /// <summary>The schema.</summary>
    public static FileDescriptorProto Describe() =>
        OwnSchema.File(
            SchemaName,
            [
                OwnSchema.Time(TimestampField),
                .. IndicatorTable.All.Select((indicator, index) => OwnSchema.OptionalNumber(indicator.Name, FirstIndicatorField + index)),
                OwnSchema.Number("speed", SpeedField),
            ]
        );
}
