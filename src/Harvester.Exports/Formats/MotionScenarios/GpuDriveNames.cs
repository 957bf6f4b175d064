using Harvester.Datasets.Logs;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>The words and numbers of GPUDrive's files.</summary>
internal static class GpuDriveNames
{
    /// <summary>The value of positions, headings and velocities that are not known.</summary>
    public const double Invalid = -10000;

    /// <summary>Number of the first kind of road line, whose paint is unknown, and of the first of road edge.</summary>
    private const int FirstLine = 5;
    private const int FirstEdge = 14;

    /// <summary>The words for lights, by WOMD's numbers.</summary>
    public static IReadOnlyList<string> Lights { get; } =
    ["unknown", "arrow_stop", "arrow_caution", "arrow_go", "stop", "caution", "go", "flashing_stop", "flashing_caution"];

    /// <summary>The words for what moves.</summary>
    public static IReadOnlyDictionary<string, TrafficLogKind> Kinds { get; } =
        new Dictionary<string, TrafficLogKind>(StringComparer.Ordinal)
        {
            ["vehicle"] = TrafficLogKind.Vehicle,
            ["pedestrian"] = TrafficLogKind.Pedestrian,
            ["cyclist"] = TrafficLogKind.Cyclist,
        };

    /// <summary>The words for parts of the map.</summary>
    public static IReadOnlyDictionary<string, LogFeatureKind> Features { get; } =
        new Dictionary<string, LogFeatureKind>(StringComparer.Ordinal)
        {
            ["lane"] = LogFeatureKind.Lane,
            ["road_line"] = LogFeatureKind.RoadLine,
            ["road_edge"] = LogFeatureKind.RoadEdge,
            ["stop_sign"] = LogFeatureKind.StopSign,
            ["crosswalk"] = LogFeatureKind.Crosswalk,
            ["speed_bump"] = LogFeatureKind.SpeedBump,
            ["driveway"] = LogFeatureKind.Driveway,
        };

    /// <summary>The number of a part of the map, which says its kind and type.</summary>
    public static int ElementOf(LogFeatureKind kind, int type) =>
        kind switch
        {
            LogFeatureKind.Lane => type,
            LogFeatureKind.RoadLine => FirstLine + type,
            LogFeatureKind.RoadEdge => FirstEdge + type,
            LogFeatureKind.StopSign => 17,
            LogFeatureKind.Crosswalk => 18,
            LogFeatureKind.SpeedBump => 19,
            _ => 20,
        };

    /// <summary>WOMD's number of a type, from that of GPUDrive; 0 if it has none.</summary>
    public static int TypeOf(LogFeatureKind kind, int element) =>
        Enumerable.Range(0, MaxTypeOf(kind) + 1).FirstOrDefault(type => ElementOf(kind, type) == element);

    /// <summary>WOMD's greatest number of a type.</summary>
    public static int MaxTypeOf(LogFeatureKind kind) =>
        kind switch
        {
            LogFeatureKind.Lane => 3,
            LogFeatureKind.RoadLine => 8,
            LogFeatureKind.RoadEdge => 2,
            _ => 0,
        };
}
