using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>The channel of the detections of radars, which are in the label line.</summary>
public sealed class RadarsChannel : FrameChannel
{
    private const int MaxObject = 65_535;
    private const int CrossSectionDecimals = 2;
    private const int VelocityDecimals = 7;
    private const int AngleDecimals = 7;
    private const int RangeDecimals = 5;

    /// <inheritdoc />
    public override string Key => "radar";

    /// <inheritdoc />
    public override string FileKind => "radar";

    /// <inheritdoc />
    public override IReadOnlyList<string> Folders { get; } = [];

    /// <inheritdoc />
    public override IChannelLabel? LabelIn(ChannelLabels labels) => labels?.Get<RadarsLabel>();

    /// <inheritdoc />
    public override IChannelLabel? Read(IJsonFields frame) =>
        frame.List(Key) is { Count: > 0 } scans ? new RadarsLabel([.. scans.Select(ReadScan)]) : null;

    internal override void Append(JsonText json, IChannelLabel label)
    {
        json.BeginArray();
        foreach (RadarScan scan in ((RadarsLabel)label).Scans)
        {
            json.BeginObject().Key("sensor").String(scan.Sensor).Key("raysCast").Integer(scan.RaysCast);
            Append(json, "ranges", scan, RangeDecimals, static each => each.Range);
            Append(json, "azimuthsDegrees", scan, AngleDecimals, static each => each.AzimuthDegrees);
            Append(json, "elevationsDegrees", scan, AngleDecimals, static each => each.ElevationDegrees);
            Append(json, "radialVelocities", scan, VelocityDecimals, static each => each.RadialVelocity);
            Append(json, "groundVelocities", scan, VelocityDecimals, static each => each.GroundVelocity);
            Append(json, "crossSections", scan, CrossSectionDecimals, static each => each.CrossSection);
            Append(json, "objects", scan, 0, static each => each.Object);
            Append(json, "origins", scan, 0, static each => (int)each.Origin);
            json.EndObject();
        }

        json.EndArray();
    }

    private static void Append(JsonText json, string key, RadarScan scan, int decimals, Func<RadarDetection, double> valueOf)
    {
        json.Key(key).BeginArray();
        foreach (RadarDetection detection in scan.Detections)
        {
            json.Number(valueOf(detection), decimals);
        }

        json.EndArray();
    }

    private static RadarScan ReadScan(IJsonFields scan)
    {
        double[] ranges = scan.Numbers("ranges");
        double[] azimuths = Column("azimuthsDegrees");
        double[] elevations = Column("elevationsDegrees");
        double[] velocities = Column("radialVelocities");
        double[] ground = Column("groundVelocities");
        double[] sections = Column("crossSections");
        double[] objects = Column("objects");
        double[] origins = Column("origins");
        if (Array.Exists(objects, static id => id != Math.Floor(id) || id is < 0 or > MaxObject))
        {
            throw scan.Refusal("objects of radar must be ids of objects, or 0.");
        }

        if (Array.Exists(origins, static origin => origin != Math.Floor(origin) || origin is < 0 or > (int)RadarOrigin.Clutter))
        {
            throw scan.Refusal("origins of radar must be 0, 1 or 2.");
        }

        return new RadarScan(
            scan.Text("sensor"),
            scan.Integer("raysCast"),
            [
                .. ranges.Select(
                    (range, at) =>
                        new RadarDetection(
                            range,
                            azimuths[at],
                            elevations[at],
                            velocities[at],
                            ground[at],
                            sections[at],
                            (int)objects[at],
                            (RadarOrigin)(int)origins[at]
                        )
                ),
            ]
        );

        double[] Column(string key) =>
            scan.Numbers(key) is var numbers && numbers.Length == ranges.Length
                ? numbers
                : throw scan.Refusal($"{key} of radar must have a number for each of its ranges.");
    }
}
