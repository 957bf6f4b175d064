using Google.Protobuf;
using Google.Protobuf.Reflection;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// The message of the lane indicators: the time, the 13 values, and the car's speed. A value that is not active is absent. Its fields have
/// the names of <see cref="IndicatorTable"/>.
/// </summary>
internal static class IndicatorMessage
{
    private static readonly FieldDescriptor[] Fields =
    [
        .. IndicatorTable.All.Select(indicator => Gtaharvest.LaneIndicators.Descriptor.FindFieldByName(indicator.Name)),
    ];

    /// <summary>Writes the message.</summary>
    public static byte[] Of(FrameLabel label, LanesLabel lanes, long nanoseconds) =>
        Of(
            IndicatorTable.All.Select(indicator => indicator.Of(lanes.Indicators) is { IsValid: true } known ? known.Value : (double?)null),
            label.Ego.Velocity.Length,
            nanoseconds
        );

    /// <summary>Writes the indicators by which a driver answered, all of them, as it had them.</summary>
    public static byte[] Of(IReadOnlyList<double> answered, double speed, long nanoseconds) =>
        Of(answered.Select(value => (double?)value), speed, nanoseconds);

    private static byte[] Of(IEnumerable<double?> values, double speed, long nanoseconds)
    {
        var message = new Gtaharvest.LaneIndicators { Timestamp = MessageTime.Of(nanoseconds), Speed = speed };
        foreach ((FieldDescriptor field, double? value) in Fields.Zip(values))
        {
            if (value is { } known)
            {
                field.Accessor.SetValue(message, known);
            }
        }

        return message.ToByteArray();
    }
}
