using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of the points of LiDARs, a file for each.</summary>
public sealed class SweepsChannel : FrameChannel
{
    /// <inheritdoc />
    public override string Key => "lidar";

    /// <inheritdoc />
    public override string FileKind => "lidar";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [FramePaths.Lidar];

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<SweepsLabel>();

    /// <inheritdoc />
    public override IChannelLabel? Read(IJsonFields frame) =>
        frame.List(Key) is { Count: > 0 } sweeps ? new SweepsLabel([.. sweeps.Select(ReadSweep)]) : null;

    internal override void Append(JsonText json, IChannelLabel label)
    {
        json.BeginArray();
        foreach (SweepLabel sweep in ((SweepsLabel)label).Sweeps)
        {
            json.BeginObject()
                .Key("sensor")
                .String(sweep.Sensor)
                .Key("file")
                .String(sweep.File)
                .Key("points")
                .Integer(sweep.Points)
                .Key("raysCast")
                .Integer(sweep.RaysCast)
                .EndObject();
        }

        json.EndArray();
    }

    private static SweepLabel ReadSweep(IJsonFields sweep) =>
        new(sweep.Text("sensor"), FileNames.Sweep(sweep, "file"), sweep.Integer("points"), sweep.Integer("raysCast"));
}
