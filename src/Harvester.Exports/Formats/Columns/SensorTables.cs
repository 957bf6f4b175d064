using System.Text.Json;

namespace Harvester.Exports.Formats.Columns;

/// <summary>The tables of what sensors other than cameras measured.</summary>
internal static class SensorTables
{
    private static readonly TableField Frame = TableField.Key("frame", row => row.Frame.Frame);

    /// <summary>A row for each LiDAR of a moment.</summary>
    public static LabelTable Lidar { get; } =
        new(
            "lidar",
            "the points of a LiDAR at a moment",
            [
                Frame,
                TableField.Of("sensor", ColumnKind.Word, "sensor"),
                TableField.Of("file", ColumnKind.Text, "file"),
                TableField.Of("points", ColumnKind.Integer, "points"),
                TableField.Of("rays_cast", ColumnKind.Integer, "raysCast"),
            ],
            (frame, label) => FrameTables.Items(frame, label, "lidar")
        );

    /// <summary>A row for each radar of a moment; its lists have an entry for each detection.</summary>
    public static LabelTable Radar { get; } =
        new(
            "radar",
            "the detections of a radar at a moment, by range; all lists are of one length",
            [
                Frame,
                TableField.Of("sensor", ColumnKind.Word, "sensor"),
                TableField.Of("rays_cast", ColumnKind.Integer, "raysCast"),
                TableField.Of("ranges", ColumnKind.Numbers, "ranges", "m"),
                TableField.Of("azimuths_degrees", ColumnKind.Numbers, "azimuthsDegrees", "degrees, sensor"),
                TableField.Of("elevations_degrees", ColumnKind.Numbers, "elevationsDegrees", "degrees, sensor"),
                TableField.Of("radial_velocities", ColumnKind.Numbers, "radialVelocities", "m/s"),
                TableField.Of("ground_velocities", ColumnKind.Numbers, "groundVelocities", "m/s"),
                TableField.Of("cross_sections", ColumnKind.Numbers, "crossSections", "dBsm"),
                TableField.Of("objects", ColumnKind.Integers, "objects"),
                TableField.Of("origins", ColumnKind.Integers, "origins"),
            ],
            (frame, label) => FrameTables.Items(frame, label, "radar")
        );

    /// <summary>A row for each frame with samples of the inertial unit; its lists have one or three entries for each sample.</summary>
    public static LabelTable Imu { get; } =
        new(
            "imu",
            "the samples of the inertial unit since the frame before, with three rates and forces for each time",
            [
                Frame,
                TableField.Of("times_seconds", ColumnKind.Numbers, "timesSeconds", "s"),
                TableField.Of("angular_rates", ColumnKind.Numbers, "angularRates", "rad/s, car"),
                TableField.Of("specific_forces", ColumnKind.Numbers, "specificForces", "m/s^2, car"),
            ],
            (frame, label) => LabelTable.At(label, "imu") is { ValueKind: JsonValueKind.Object } imu ? [new TableRow(frame, imu)] : []
        );

    /// <summary>A row for each frame with samples of the satellite receiver; its lists have one or three entries for each sample.</summary>
    public static LabelTable Gnss { get; } =
        new(
            "gnss",
            "the samples of the satellite receiver since the frame before, with three numbers of positions and velocities for each time",
            [
                Frame,
                TableField.Of("times_seconds", ColumnKind.Numbers, "timesSeconds", "s"),
                TableField.Of("positions", ColumnKind.Numbers, "positions", "degrees and m, WGS 84"),
                TableField.Of("velocities", ColumnKind.Numbers, "velocities", "m/s, world"),
            ],
            (frame, label) => LabelTable.At(label, "gnss") is { ValueKind: JsonValueKind.Object } gnss ? [new TableRow(frame, gnss)] : []
        );
}
