using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Csv;

/// <summary>The table drive.csv: a row for each frame of a recorded drive, with its action.</summary>
internal static class CsvDriveTable
{
    /// <summary>Name of the file.</summary>
    public const string FileName = "drive.csv";

    /// <summary>Name of its part.</summary>
    public const string Part = "drive";

    private const int ControlDecimals = 6;
    private const int SecondDecimals = 6;
    private const int IndicatorDecimals = 6;
    private const int MetreDecimals = 4;
    private const int InertialDecimals = 5;

    /// <summary>Its columns.</summary>
    public static string[] Columns { get; } =
    [
        "frame",
        "split",
        "image",
        "time_seconds",
        "driver",
        "disturbed",
        "steering",
        "throttle",
        "brake",
        "answer_seconds",
        "applied_steering",
        "applied_throttle",
        "applied_brake",
        "target_speed",
        "target_right",
        "route",
        "route_metres",
        "speed",
        .. AxisColumns("acceleration"),
        .. AxisColumns("angular_rate"),
        "lanes_known",
        .. IndicatorTable.All.Select(indicator => $"torcs_{indicator.Name}"),
    ];

    /// <summary>The row of a frame.</summary>
    public static IEnumerable<string> Fields(ExportFrame frame, DriveLabel drive, string image)
    {
        LanesLabel? lanes = frame.Label.Lanes;
        return
        [
            Numbers.Text(frame.Index),
            CsvText.Of(frame.Split),
            image,
            Text(frame.Label.TimeSeconds, SecondDecimals),
            JsonName.Of(drive.Driver),
            drive.IsDisturbed ? "1" : "0",
            .. Texts(drive.Controls),
            Text(drive.AnswerSeconds, SecondDecimals),
            .. Texts(drive.Applied),
            Text(drive.Target?.SpeedMetresPerSecond, MetreDecimals),
            Text(drive.Target?.RightMetres, MetreDecimals),
            CsvText.Of(drive.Route),
            Text(drive.RouteMetres, MetreDecimals),
            Text(drive.SpeedMetresPerSecond, MetreDecimals),
            .. Texts(drive.Acceleration),
            .. Texts(drive.AngularRate),
            lanes is { Status: LaneStatus.Known } ? "1" : "0",
            .. IndicatorOrder.Values(lanes?.TorcsEquivalent ?? LaneIndicators.Unknown).Select(value => Text(value, IndicatorDecimals)),
        ];
    }

    private static string[] AxisColumns(string name) => [$"{name}_right", $"{name}_forward", $"{name}_up"];

    private static string[] Texts(DriveControls? controls) =>
        [Text(controls?.Steering, ControlDecimals), Text(controls?.Throttle, ControlDecimals), Text(controls?.Brake, ControlDecimals)];

    private static string[] Texts(Vector3D? vector) =>
        [Text(vector?.X, InertialDecimals), Text(vector?.Y, InertialDecimals), Text(vector?.Z, InertialDecimals)];

    /// <summary>Unknown values are empty fields.</summary>
    private static string Text(double? value, int decimals) => value is { } known ? InvariantNumber.Format(known, decimals) : "";
}
