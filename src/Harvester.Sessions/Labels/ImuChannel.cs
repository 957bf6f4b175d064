using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of the inertial unit. It has no files: its samples are in the label line, like the motion between frames.</summary>
public sealed class ImuChannel : FrameChannel
{
    private const string TimesKey = "timesSeconds";
    private const string RatesKey = "angularRates";
    private const string ForcesKey = "specificForces";
    private const int RateDecimals = 9;
    private const int ForceDecimals = 7;
    private const int Axes = 3;

    /// <inheritdoc />
    public override string Key => "imu";

    /// <inheritdoc />
    public override string FileKind => "imu";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [];

    /// <inheritdoc />
    public override ChannelSwitch Switch { get; } =
        new("Imu", "what an inertial unit in the vehicle measures at every tick: angular rate and specific force");

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<ImuLabel>();

    /// <inheritdoc />
    public override IChannelLabel Read(IJsonFields frame)
    {
        IJsonFields imu = frame.Fields(Key);
        double[] times = imu.Numbers(TimesKey);
        double[] rates = imu.Numbers(RatesKey);
        double[] forces = imu.Numbers(ForcesKey);
        if (rates.Length != Axes * times.Length || forces.Length != Axes * times.Length)
        {
            throw imu.Refusal(
                FormattableString.Invariant(
                    $"imu has {times.Length} times, {rates.Length} numbers of rates and {forces.Length} of forces, "
                ) + "not three of each a time."
            );
        }

        return new ImuLabel([.. times.Select((time, index) => new ImuSample(time, VectorAt(rates, index), VectorAt(forces, index)))]);
    }

    internal override void Append(JsonText json, IChannelLabel label)
    {
        IReadOnlyList<ImuSample> samples = ((ImuLabel)label).Samples;
        json.BeginObject().Key(TimesKey).BeginArray();
        foreach (ImuSample sample in samples)
        {
            json.Number(sample.TimeSeconds, LabelDecimals.Seconds);
        }

        json.EndArray();
        Append(json.Key(RatesKey), samples.Select(static sample => sample.AngularRate), RateDecimals);
        Append(json.Key(ForcesKey), samples.Select(static sample => sample.SpecificForce), ForceDecimals);
        json.EndObject();
    }

    private static void Append(JsonText json, IEnumerable<Vector3D> vectors, int decimals)
    {
        json.BeginArray();
        foreach (Vector3D vector in vectors)
        {
            json.Number(vector.X, decimals).Number(vector.Y, decimals).Number(vector.Z, decimals);
        }

        json.EndArray();
    }

    private static Vector3D VectorAt(double[] numbers, int index) =>
        new(numbers[Axes * index], numbers[(Axes * index) + 1], numbers[(Axes * index) + 2]);
}
