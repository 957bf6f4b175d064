using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of the satellite receiver, whose samples are in the label line.</summary>
public sealed class GnssChannel : FrameChannel
{
    private const string TimesKey = "timesSeconds";
    private const string PositionsKey = "positions";
    private const string VelocitiesKey = "velocities";
    private const int DegreeDecimals = 10;
    private const int VelocityDecimals = 5;
    private const int Axes = 3;

    /// <inheritdoc />
    public override string Key => "gnss";

    /// <inheritdoc />
    public override string FileKind => "gnss";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [];

    /// <inheritdoc />
    public override ChannelSwitch Switch { get; } =
        new("Gnss", "what a satellite receiver in the vehicle reports ten times a second: latitude, longitude, altitude and velocity");

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<GnssLabel>();

    /// <inheritdoc />
    public override IChannelLabel Read(IJsonFields frame)
    {
        IJsonFields gnss = frame.Fields(Key);
        double[] times = gnss.Numbers(TimesKey);
        double[] positions = gnss.Numbers(PositionsKey);
        double[] velocities = gnss.Numbers(VelocitiesKey);
        if (positions.Length != Axes * times.Length || velocities.Length != Axes * times.Length)
        {
            throw gnss.Refusal(
                FormattableString.Invariant(
                    $"gnss has {times.Length} times, {positions.Length} numbers of positions and {velocities.Length} of velocities, "
                ) + "not three of each a time."
            );
        }

        return new GnssLabel([
            .. times.Select(
                (time, at) =>
                    new GnssSample(
                        time,
                        positions[Axes * at],
                        positions[(Axes * at) + 1],
                        positions[(Axes * at) + 2],
                        new Vector3D(velocities[Axes * at], velocities[(Axes * at) + 1], velocities[(Axes * at) + 2])
                    )
            ),
        ]);
    }

    internal override void Append(JsonText json, IChannelLabel label)
    {
        IReadOnlyList<GnssSample> samples = ((GnssLabel)label).Samples;
        json.BeginObject().Key(TimesKey).BeginArray();
        foreach (GnssSample sample in samples)
        {
            json.Number(sample.TimeSeconds, LabelDecimals.Seconds);
        }

        json.EndArray().Key(PositionsKey).BeginArray();
        foreach (GnssSample sample in samples)
        {
            json.Number(sample.LatitudeDegrees, DegreeDecimals)
                .Number(sample.LongitudeDegrees, DegreeDecimals)
                .Number(sample.Altitude, LabelDecimals.Metres);
        }

        json.EndArray().Key(VelocitiesKey).BeginArray();
        foreach (GnssSample sample in samples)
        {
            json.Number(sample.Velocity.X, VelocityDecimals)
                .Number(sample.Velocity.Y, VelocityDecimals)
                .Number(sample.Velocity.Z, VelocityDecimals);
        }

        json.EndArray().EndObject();
    }
}
